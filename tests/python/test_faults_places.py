# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every verb that writes, to what is no regular file.

Guaranteed: exit status 2 and one message, or the whole output; what is there stays, and nothing else
is left in the folder.
"""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from pathlib import Path

from conftest import SCENE, Girdle, Refuses, expect_one_message, with_scene
from faults import WRITERS, command, every_writer, named, names_below


@every_writer
def test_a_folder_in_the_place_of_the_file_is_refused(
    refuses: Refuses, generated: Path, tmp_path: Path, writer: str
) -> None:
    (tmp_path / named(writer)).mkdir()
    refuses(*command(writer, named(writer), generated), because=(named(writer), "cannot be written"))


@every_writer
def test_a_link_stays_and_its_target_is_replaced(
    girdle: Girdle, generated: Path, tmp_path: Path, writer: str
) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "target").write_text("earlier\n")
    (tmp_path / named(writer)).symlink_to("elsewhere/target")
    assert girdle(*command(writer, named(writer), generated)).code == 0
    assert (tmp_path / named(writer)).is_symlink()
    assert (tmp_path / "elsewhere" / "target").read_bytes() != b"earlier\n"
    assert names_below(tmp_path) == {named(writer), "elsewhere", "elsewhere/target"}


@every_writer
def test_a_device_without_room_is_refused(
    girdle: Girdle, generated: Path, tmp_path: Path, writer: str
) -> None:
    (tmp_path / named(writer)).symlink_to("/dev/full")
    finished = girdle(*command(writer, named(writer), generated))
    expect_one_message(finished, "cannot be written|ffmpeg cannot make the video")
    assert names_below(tmp_path) == {named(writer)}


@every_writer
def test_a_pipe_is_written_to_and_stays(girdle: Girdle, generated: Path, tmp_path: Path, writer: str) -> None:
    pipe = tmp_path / named(writer)
    assert girdle(*command(writer, named(writer, "file"), generated)).code == 0
    os.mkfifo(pipe)
    read: list[bytes] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
    reader.start()
    finished = girdle(*command(writer, named(writer), generated))
    reader.join()
    if writer == "simulate video":  # it is written twice, which a pipe cannot be
        expect_one_message(finished, "ffmpeg cannot make the video")
    else:
        assert finished.code == 0, finished.message
        assert read == [(tmp_path / named(writer, "file")).read_bytes()]
    assert names_below(tmp_path) == {named(writer), named(writer, "file")}


def test_nobody_can_lay_a_link_in_the_way_of_a_temporary_file(girdle: Girdle, tmp_path: Path) -> None:
    """Names by the number of the process could be foreseen."""
    (tmp_path / "kept").write_text("kept\n")
    with subprocess.Popen(["true"]) as latest:
        for number in range(1, 300):
            (tmp_path / f"out.csv.{latest.pid + number}.part").symlink_to("kept")
    assert girdle(*WRITERS["solve"], "out.csv").code == 0
    assert (tmp_path / "kept").read_text() == "kept\n"


def test_a_reader_that_ends_early_ends_the_program_quietly(program: Path, generated: Path) -> None:
    words = with_scene(("simulate", SCENE, "--elevation", "15:90", "--seconds", "2", "--out", "-"), generated)
    with subprocess.Popen(
        ["env", "--default-signal", str(program), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout
        assert process.stderr
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait() == -signal.SIGPIPE
