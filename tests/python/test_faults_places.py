# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every verb that writes, into places where it cannot or should not write.

Guaranteed: exit status 2 and one message, or the whole file; an earlier file stays whole; nothing
else is left in the folder.
"""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import REFUSED, SCENE, Girdle, Refuses, contents, expect_one_message, with_scene
from faults import MEBIBYTE, names_below, run_limited
from reference_rhythm import DATABASE

LANDMARKS = DATABASE.parent / "landmarks.csv"
# Each verb that writes a file, up to the file's name.
WRITERS = {
    "solve": ("solve", "--elevation", "0:150:1", "--plane", "0", "--out"),
    "simulate": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out"),
    "simulate controls": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-controls"),
    "simulate picture": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-picture"),
    "simulate video": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-video"),
    "render": ("render", SCENE, "--out"),
    "compare": ("compare", "--out"),
    "smooth-table": ("smooth-table", "--in", str(DATABASE), "--out"),
    "fit-thorax": ("fit-thorax", "--out"),
}
SUFFIXES = {"simulate picture": ".png", "simulate video": ".mp4", "render": ".png"}
every_writer = pytest.mark.parametrize("writer", WRITERS)


def named(writer: str, stem: str = "out") -> str:
    return stem + SUFFIXES.get(writer, ".csv")


def command(writer: str, name: str, generated: Path) -> list[str]:
    words = with_scene(WRITERS[writer], generated)
    # A name that begins with a dash belongs to its option by the sign between them.
    return [*words[:-1], f"{words[-1]}={name}"]


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


@every_writer
def test_a_file_beyond_the_largest_size_is_refused(
    program: Path, generated: Path, tmp_path: Path, writer: str
) -> None:
    (tmp_path / named(writer)).write_text("earlier\n")
    result = run_limited(
        program,
        *command(writer, named(writer), generated),
        folder=tmp_path,
        limits={resource.RLIMIT_FSIZE: 100},
    )
    assert result.returncode == REFUSED, result.stderr
    assert result.stderr.startswith("girdle: ")
    assert names_below(tmp_path) == {named(writer)}
    assert (tmp_path / named(writer)).read_text() == "earlier\n"


def test_a_model_beyond_the_largest_size_is_refused(program: Path, tmp_path: Path) -> None:
    """The scene is smaller than the limit, and not written without its model."""
    result = run_limited(
        program,
        *("generate", "--out", "new/model"),
        folder=tmp_path,
        limits={resource.RLIMIT_FSIZE: 8000},
    )
    assert result.returncode == REFUSED, result.stderr
    assert "shoulder_right.xml: cannot be written: File too large" in result.stderr
    assert names_below(tmp_path) == set()


@every_writer
@pytest.mark.parametrize("limit_mebibytes", [40, 60, 100])
def test_too_little_memory_leaves_the_earlier_file(
    program: Path, generated: Path, tmp_path: Path, writer: str, limit_mebibytes: int
) -> None:
    """The program may have enough, or not even be loaded; what counts is the file."""
    (tmp_path / named(writer)).write_text("earlier\n")
    result = run_limited(
        program,
        *command(writer, named(writer), generated),
        folder=tmp_path,
        limits={resource.RLIMIT_AS: limit_mebibytes * MEBIBYTE},
    )
    assert names_below(tmp_path) == {named(writer)}
    is_earlier = (tmp_path / named(writer)).read_bytes() == b"earlier\n"
    assert is_earlier == (result.returncode != 0)


@every_writer
def test_a_folder_of_temporary_files_is_not_needed(
    program: Path, generated: Path, tmp_path: Path, writer: str
) -> None:
    (tmp_path / "work").mkdir()
    result = subprocess.run(
        [program, *command(writer, named(writer), generated)],
        cwd=tmp_path / "work",
        env={**os.environ, "TMPDIR": str(tmp_path / "absent")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    assert names_below(tmp_path) == {"work", f"work/{named(writer)}"}


NAMES = {
    "a blank": "a b",
    "quotes": "a'b\"c",
    "a line end": "a\nb",
    "umlauts": "Schlüsselbein_ä",
    "no UTF-8": os.fsdecode(b"a\xff"),
    "a leading dash": "-a",
    "a backslash": "a\\b",
    "what a shell expands": "$(a)*",
}


@every_writer
@pytest.mark.parametrize("stem", NAMES.values(), ids=NAMES.keys())
def test_a_strange_name_is_written_as_it_is(
    program: Path, generated: Path, tmp_path: Path, writer: str, stem: str
) -> None:
    result = subprocess.run(
        [program, *command(writer, named(writer, stem), generated)],
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    assert os.listdir(tmp_path) == [named(writer, stem)]


READ_NAMES = {what: stem for what, stem in NAMES.items() if what != "a backslash"}


@pytest.mark.parametrize("stem", READ_NAMES.values(), ids=READ_NAMES.keys())
def test_a_model_in_a_folder_of_a_strange_name_is_read(program: Path, tmp_path: Path, stem: str) -> None:
    for words in (
        ["generate", f"--out={stem}"],
        ["render", f"./{stem}/scene.xml", "--out", "picture.png"],
    ):
        result = subprocess.run([program, *words], cwd=tmp_path, capture_output=True, check=False)
        assert result.returncode == 0, result.stderr


def test_a_model_that_mujoco_looks_for_elsewhere_is_refused(
    girdle: Girdle, refuses: Refuses, tmp_path: Path
) -> None:
    assert girdle("generate", "--out", NAMES["a backslash"]).code == 0
    because = ("takes a backslash in a path for a slash", "Rename")
    refuses("render", "a\\b/scene.xml", "--out", "picture.png", because=because)


@pytest.fixture(params=["64k"])
def small_disk(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Path]:
    """A disk with room for so much."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={request.param}", "tmpfs", disk],
        capture_output=True,
        text=True,
        check=False,
    )
    if mounted.returncode != 0:
        pytest.skip(f"no small disk can be mounted here: {mounted.stderr.strip()}")
    yield disk
    subprocess.run(["umount", disk], check=True)


# Those whose output is larger than the disk.
LARGE = {
    "solve": ("solve", "--elevation", "0:150:0.1", "--plane", "0", "--out"),
    "simulate": ("simulate", SCENE, "--elevation", "15:90", "--seconds", "1", "--out"),
    "simulate controls": ("simulate", SCENE, "--elevation", "15:90", "--seconds", "2", "--out-controls"),
    "render": ("render", SCENE, "--size", "2000x2000", "--out"),
}


@pytest.mark.parametrize("writer", LARGE)
def test_a_full_disk_leaves_the_earlier_file(
    girdle: Girdle, generated: Path, small_disk: Path, writer: str
) -> None:
    place = small_disk / named(writer)
    place.write_text("earlier\n")
    finished = girdle(*with_scene(LARGE[writer], generated), place)
    expect_one_message(finished, "No space left on device|are free there", "Choose")
    assert names_below(small_disk) == {named(writer)}
    assert place.read_text() == "earlier\n"


def test_a_full_disk_gets_no_scene_without_its_model(girdle: Girdle, small_disk: Path) -> None:
    filler = small_disk / "filler"
    filler.write_bytes(bytes(40 * 1024))
    finished = girdle("generate", "--side", "both", "--out", small_disk / "model")
    expect_one_message(finished, "No space left on device", "Choose")
    assert names_below(small_disk) == {"filler"}


@pytest.mark.parametrize("small_disk", ["512k"], indirect=True)
def test_a_full_disk_keeps_the_earlier_model(girdle: Girdle, small_disk: Path) -> None:
    assert girdle("generate", "--out", small_disk).code == 0
    before = contents(small_disk)
    room = os.statvfs(small_disk)
    (small_disk / "filler").write_bytes(bytes(room.f_bavail * room.f_frsize))
    finished = girdle("generate", "--stature", "1.9", "--out", small_disk)
    expect_one_message(finished, "No space left on device", "Choose")
    (small_disk / "filler").unlink()
    assert contents(small_disk) == before


def test_a_file_that_cannot_be_replaced_puts_all_back(girdle: Girdle, tmp_path: Path) -> None:
    """The scene comes last: the model is already in its place when the scene cannot be."""
    folder = tmp_path / "model"
    assert girdle("generate", "--out", folder).code == 0
    held = subprocess.run(["chattr", "+i", folder / "scene.xml"], capture_output=True, text=True, check=False)
    if held.returncode != 0:
        pytest.skip(f"no file can be made immutable here: {held.stderr.strip()}")
    try:
        before = contents(folder)
        finished = girdle("generate", "--stature", "1.9", "--out", folder)
        expect_one_message(finished, r"scene\.xml: cannot be written", "Choose")
        assert contents(folder) == before
    finally:
        subprocess.run(["chattr", "-i", folder / "scene.xml"], check=True)


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
