# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Clang with its own standard library compiles what solves and reads, and gets the same numbers."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "data" / "ludewig2009_destepped.csv"


def run(*command: str | Path) -> str:
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def poses(build: Path) -> list[list[str]]:
    program = build / "tests" / "solved_poses"
    return [line.split() for line in run(program, TABLE).splitlines()]


def test_clang_with_its_own_library_finds_the_same_poses() -> None:
    cmake = os.environ["GIRDLE_CMAKE"]
    run(cmake, "--preset", "clang")
    run(cmake, "--build", "--preset", "clang")
    build = ROOT / "build" / "clang"
    # It is that library, and not GCC's.
    assert "libc++.so" in run("ldd", build / "tests" / "solved_poses")
    found = poses(build)
    wanted = poses(Path(os.environ["GIRDLE_BUILD_DIR"]))
    assert len(found) == len(wanted) == 3 * 25 * 27
    # Compilers may differ in the last digits where they order sums of products otherwise.
    for line, wanted_line in zip(found, wanted, strict=True):
        assert line[0] == wanted_line[0]
        assert len(line) == len(wanted_line)
        for number, wanted_number in zip(line[1:], wanted_line[1:], strict=True):
            assert abs(float(number) - float(wanted_number)) < 1e-12, (line, wanted_line)
