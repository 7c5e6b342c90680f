# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Two programs that write into one folder at a time.

Guaranteed: what is there in the end is what one of them wrote, whole, and no temporary file.
"""

from __future__ import annotations

import fcntl
import os
import subprocess
from pathlib import Path

import pytest
from conftest import Girdle, contents

ROUNDS = 8


def start(program: Path, folder: Path, *words: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen([program, *words], cwd=folder, stdout=subprocess.DEVNULL)


def test_two_models_in_one_folder_are_not_mixed(program: Path, girdle: Girdle, tmp_path: Path) -> None:
    """Their scenes differ too: each has the light and the floor of its own size."""
    kinds = [
        ("generate", "--stature", "1.5", "--skin", "implicit"),
        ("generate", "--stature", "2", "--skin", "implicit"),
    ]
    wholes = []
    for number, kind in enumerate(kinds):
        assert girdle(*kind, "--out", f"whole{number}").code == 0
        wholes.append(contents(tmp_path / f"whole{number}"))
    assert all(wholes[0][name] != wholes[1][name] for name in wholes[0]), "a mixture would not be seen"
    for _ in range(ROUNDS):
        running = [start(program, tmp_path, *kind, "--out", "both") for kind in kinds]
        assert [process.wait() for process in running] == [0, 0]
        assert contents(tmp_path / "both") in wholes


@pytest.mark.parametrize("option", ["--out", "--out-controls"])
def test_two_programs_that_write_one_file_leave_that_of_one(
    program: Path, generated: Path, tmp_path: Path, option: str
) -> None:
    words = ("simulate", str(generated / "scene.xml"), "--seconds", "0.05", "--elevation")
    wholes = []
    for motion in ("15:16", "15:17"):
        assert start(program, tmp_path, *words, motion, option, "a.csv").wait() == 0
        wholes.append((tmp_path / "a.csv").read_bytes())
    assert wholes[0] != wholes[1]
    for _ in range(ROUNDS):
        running = [start(program, tmp_path, *words, motion, option, "a.csv") for motion in ("15:16", "15:17")]
        assert [process.wait() for process in running] == [0, 0]
        assert (tmp_path / "a.csv").read_bytes() in wholes
        assert os.listdir(tmp_path) == ["a.csv"]


def test_a_folder_that_another_program_holds_is_waited_for(program: Path, tmp_path: Path) -> None:
    folder = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(folder, fcntl.LOCK_EX)
    with start(program, tmp_path, "generate", "--out", ".") as process:
        # It has written nothing while it waits; with the lock gone it goes on.
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(1)
        assert os.listdir(tmp_path) == []
        os.close(folder)
        assert process.wait() == 0
    assert sorted(os.listdir(tmp_path)) == ["scene.xml", "shoulder_right.xml"]
