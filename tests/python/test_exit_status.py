# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""How the program ends where it is not the user's fault; the other ends are tested with the verbs."""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
from pathlib import Path

import pytest
from faults import MEBIBYTE, run_limited

USED_UP = 4
TABLE = Path(__file__).resolve().parents[2] / "data" / "ludewig2009.csv"


def test_help_says_what_each_exit_status_means(program: Path) -> None:
    result = subprocess.run([program, "--help"], capture_output=True, text=True, check=True)
    text = " ".join(result.stdout.split())
    assert "0 all is well, 1 a residual" in text
    assert "2 the command line or a file cannot be used, 3 a fault of Girdle, 4 the memory" in text


def test_memory_that_is_used_up_is_not_called_bad_input(program: Path, tmp_path: Path) -> None:
    table = tmp_path / "table.csv"
    names = next(line for line in TABLE.read_text().splitlines() if not line.startswith("#"))
    zeros = ",0" * names.replace(",origin", "").count(",")
    with table.open("w") as file:
        file.write(names.replace(",origin", "") + "\n")
        # A plane of far more elevations than a table has, which are kept until the next plane.
        file.writelines(f"0,{i / 10_000}{zeros[2:]}\n" for i in range(1_000_000))

    words = ("solve", "--table", table, "--elevation", "30", "--plane", "0")
    result = run_limited(program, *words, folder=tmp_path, limits={resource.RLIMIT_AS: 100 * MEBIBYTE})
    assert result.returncode == USED_UP, result.stderr
    assert result.stdout == ""
    assert result.stderr.startswith("girdle: the memory is used up. ")


# Between what the program needs to start and what the model takes. Where the limit is depends on
# the libraries of the machine.
def test_memory_that_mujoco_lacks_is_not_called_bad_input(program: Path, tmp_path: Path) -> None:
    subprocess.run([program, "generate", "--out", tmp_path], capture_output=True, check=True)
    command = ["simulate", "scene.xml", "--elevation", "15:16", "--seconds", "0.01", "--out", "-"]
    said = []
    for limit in range(40, 120, 4):
        limits = {resource.RLIMIT_AS: limit * MEBIBYTE}
        result = run_limited(program, *command, folder=tmp_path, limits=limits)
        if "allocate" in result.stderr or result.returncode == USED_UP:
            said.append((result.returncode, result.stderr))
    assert said
    for status, text in said:
        assert status == USED_UP, text
        assert text.startswith("girdle: the memory is used up. ")


@pytest.fixture(scope="module")
def strange_folder(program: Path, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A folder with a model and a table whose names no JSON can hold: they are not UTF-8."""
    folder = os.fsencode(tmp_path_factory.mktemp("strange")) + b"/\xff"
    subprocess.run([program, "generate", "--out", folder], capture_output=True, check=True)
    shutil.copy(os.fsencode(TABLE), folder + b"/table.csv")
    return folder


@pytest.mark.parametrize(
    ("command", "file", "note"),
    [
        (["generate", "--out"], b"", b""),
        (
            ["simulate", "--elevation", "15:16", "--seconds", "0.01", "--out", "/dev/null"],
            b"/scene.xml",
            b"girdle: wrote /dev/null: 6 rows\n",
        ),
        (["fit-thorax", "--table"], b"/table.csv", b""),
        (["verify"], b"/scene.xml", b""),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_names_that_are_not_utf_8_are_no_fault(
    program: Path, strange_folder: bytes, command: list[str], file: bytes, note: bytes
) -> None:
    result = subprocess.run(
        [program, *command, strange_folder + file, "--json"], capture_output=True, check=False
    )
    assert (result.returncode, result.stderr) == (0, note)
    assert "\N{REPLACEMENT CHARACTER}" in json.dumps(json.loads(result.stdout), ensure_ascii=False)
