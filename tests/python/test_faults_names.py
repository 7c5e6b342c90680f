# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every verb that writes, to names that programs stumble over."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import Girdle, Refuses
from faults import command, every_writer, named

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
