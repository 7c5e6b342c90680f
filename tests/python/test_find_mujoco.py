# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Which MuJoCo a build takes, and which it refuses."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

CMAKE = os.environ["GIRDLE_CMAKE"]
ROOT = Path(__file__).resolve().parents[2]
TOP = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
TIMEOUT_S = 60

# What the top CMakeLists asks for, so that the two cannot part.
ASKED = re.findall(r"^ *find_package\(MuJoCo .*\)$", TOP, re.MULTILINE)

PROJECT = f"""
cmake_minimum_required(VERSION 3.25)
project(Finds LANGUAGES CXX)
list(APPEND CMAKE_MODULE_PATH {ROOT}/scripts/cmake)
{chr(10).join(ASKED)}
message(STATUS "took ${{MuJoCo_VERSION}} from ${{MuJoCo_SOURCE}}")
"""


def release(folder: Path, version: str) -> Path:
    """The files of an unpacked release, empty but for the version."""
    major, minor, patch = map(int, version.split("."))
    header = folder / "include" / "mujoco" / "mujoco.h"
    header.parent.mkdir(parents=True)
    header.write_text(f"#define mjVERSION_HEADER {major * 1_000_000 + minor * 1_000 + patch}\n")
    library = folder / "lib" / f"libmujoco.so.{version}"
    library.parent.mkdir()
    library.touch()
    return folder


def configure(folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    (folder / "CMakeLists.txt").write_text(PROJECT)
    kept = {name: value for name, value in os.environ.items() if name != "MUJOCO_ROOT"}
    return subprocess.run(
        [CMAKE, "-S", folder, "-B", folder / "build"],
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
        env={**kept, **environment},
    )


def test_the_question_is_read_from_the_build() -> None:
    assert len(ASKED) == 1, ASKED


@pytest.mark.parametrize("version", ["4.0.1", "4.2.0"])
def test_the_one_that_is_asked_for_and_later_ones_are_taken(tmp_path: Path, version: str) -> None:
    root = release(tmp_path / "mujoco", version)
    finished = configure(tmp_path, MUJOCO_ROOT=str(root))
    assert finished.returncode == 0, finished.stderr
    assert f"took {version} from root" in finished.stdout


def test_an_older_one_is_refused_with_the_version_that_is_needed(tmp_path: Path) -> None:
    root = release(tmp_path / "mujoco", "4.0.0")
    finished = configure(tmp_path, MUJOCO_ROOT=str(root))
    assert finished.returncode != 0
    message = " ".join(finished.stderr.split())
    assert re.search(r'unsuitable version "4.0.0".*at least "4.0.1"', message), message


@pytest.mark.parametrize(
    ("versions", "taken"),
    [
        (("mujoco-core-4.0.1", "mujoco-3.17.0"), "4.0.1"),
        (("mujoco-core-4.0.0", "mujoco-4.0.1", "mujoco-3.17.0"), "4.0.1"),
        (("mujoco-4.0.1", "mujoco-core-4.10.0", "mujoco-core-4.9.0"), "4.10.0"),
    ],
)
def test_of_those_fetched_the_newest_good_one_is_taken(
    tmp_path: Path, versions: tuple[str, ...], taken: str
) -> None:
    for name in versions:
        release(tmp_path / "build" / "engine" / name, name.split("-")[-1])
    finished = configure(tmp_path)
    assert finished.returncode == 0, finished.stderr
    assert f"took {taken} from fetched" in finished.stdout
