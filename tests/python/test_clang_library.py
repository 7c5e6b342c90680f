# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Clang with its own standard library compiles what solves and reads, and the plugin, and gets the
same numbers."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FINGERPRINT = ROOT / "scripts" / "fingerprint"
TABLE = ROOT / "data" / "ludewig2009_smoothed.csv"


def run(*command: str | Path) -> str:
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def clang_build() -> Path:
    cmake = os.environ["GIRDLE_CMAKE"]
    run(cmake, "--preset", "clang")
    run(cmake, "--build", "--preset", "clang")
    build = ROOT / "build" / "clang"
    # It is that library, and not GCC's.
    for made in ("tests/pose_bits", "tests/solved_poses", "libgirdle_rhythm.so"):
        assert "libc++.so" in run("ldd", build / made)
    return build


def poses(build: Path) -> list[list[str]]:
    program = build / "tests" / "solved_poses"
    return [line.split() for line in run(program, TABLE).splitlines()]


def test_clang_with_its_own_library_finds_the_same_poses(clang_build: Path) -> None:
    found = poses(clang_build)
    wanted = poses(Path(os.environ["GIRDLE_BUILD_DIR"]))
    assert len(found) == len(wanted) == 3 * 25 * 27
    assert found == wanted


def test_clang_gets_the_same_bits(clang_build: Path) -> None:
    """Of many poses, and of the models' steps with the plugin."""
    assert run(FINGERPRINT, clang_build) == run(FINGERPRINT, os.environ["GIRDLE_BUILD_DIR"])
