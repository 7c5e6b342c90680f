# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Verbs that write onto a disk without room, and into a folder where one file cannot be replaced.

Guaranteed: exit status 2 and one message; earlier files stay whole, all or none of those that belong
together are new, and nothing else is left.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import SCENE, Girdle, contents, expect_one_message, with_scene
from faults import named, names_below


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
