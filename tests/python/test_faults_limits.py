# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every verb that writes, with too little of what the system gives.

Guaranteed: an earlier file stays whole, and nothing else is left in the folder.
"""

from __future__ import annotations

import os
import resource
import subprocess
from pathlib import Path

import pytest
from conftest import REFUSED
from faults import MEBIBYTE, command, every_writer, named, names_below, run_limited


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
