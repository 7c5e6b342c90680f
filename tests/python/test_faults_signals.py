# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every verb that writes, interrupted or killed at any moment.

Guaranteed: each file is the earlier one or the new one, whole. After SIGINT, SIGTERM and SIGHUP no
temporary file is left. Moments are drawn with a fixed seed, from the start of the program to a
little beyond its usual end; whichever part of its work a signal meets, the result has to be right.
"""

from __future__ import annotations

import random
import signal
import subprocess
import time
from pathlib import Path

import pytest
from conftest import PROGRAM_TIMEOUT_S, SCENE, contents, with_scene
from reference_rhythm import DATABASE

SEED = 20261201
MOMENTS = 8
# What each verb is told, and the files that it writes.
WRITERS = {
    "solve": (("solve", "--elevation", "0:150:0.1", "--plane", "0", "--out", "a.csv"), ["a.csv"]),
    "simulate": (
        ("simulate", SCENE, "--elevation", "15:90", "--seconds", "1", "--out", "a.csv"),
        ["a.csv"],
    ),
    "simulate video": (
        ("simulate", SCENE, "--elevation", "15:30", "--seconds", "0.2", "--out-video", "a.mp4"),
        ["a.mp4"],
    ),
    "render": (("render", SCENE, "--out", "a.png"), ["a.png"]),
    "compare": (("compare", "--out", "a.csv"), ["a.csv"]),
    "smooth-table": (("smooth-table", "--in", str(DATABASE), "--out", "a.csv"), ["a.csv"]),
    "fit-thorax": (("fit-thorax", "--out", "a.csv"), ["a.csv"]),
    "generate": (("generate", "--out", "."), ["scene.xml", "shoulder_right.xml"]),
}


def run_until(command: list[str], folder: Path, sent: signal.Signals | None, moment_s: float) -> int:
    # Whoever runs the tests in the background has SIGINT ignored, and children inherit that.
    process = subprocess.Popen(
        ["env", "--default-signal", *command],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    if sent is not None:
        try:
            process.wait(moment_s)
        except subprocess.TimeoutExpired:
            process.send_signal(sent)
    return process.wait(PROGRAM_TIMEOUT_S)


@pytest.mark.parametrize("writer", WRITERS)
@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_a_signal_at_any_moment_leaves_whole_files(
    program: Path, generated: Path, tmp_path: Path, writer: str, sent: signal.Signals
) -> None:
    words, files = WRITERS[writer]
    command = [str(program), *with_scene(words, generated)]
    new = tmp_path / "new"
    new.mkdir()
    begin_s = time.monotonic()
    assert run_until(command, new, None, 0) == 0
    usual_s = time.monotonic() - begin_s
    whole = contents(new)
    assert set(whole) == set(files)
    moments = random.Random(f"{SEED} {writer} {sent}")
    for number in range(MOMENTS):
        folder = tmp_path / str(number)
        folder.mkdir()
        for file in files:
            (folder / file).write_text("earlier\n")
        before = contents(folder)
        moment_s = moments.uniform(0, 1.1 * usual_s)
        code = run_until(command, folder, sent, moment_s)
        after = contents(folder)
        for file in files:
            assert after[file] in (before[file], whole[file]), (moment_s, file)
        if code == 0:
            assert after == whole, moment_s
        if sent != signal.SIGKILL:
            assert set(after) == set(files), (moment_s, after)
            # All files of one run, or all earlier ones.
            assert after in (before, whole), (moment_s, code)
