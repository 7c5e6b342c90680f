# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""MuJoCo 4.0.0 gives the reports of 4.0.1: the program runs with either library.

Their structs are alike, and our models are so small that the fault of 4.0.0, which is in the
factorisation of sparse matrices, does not meet them.
"""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from shared_results import SharedResults

ROOT = Path(__file__).resolve().parents[2]
FOUR_ZERO_ZERO = ROOT / "build" / "engine" / "mujoco-4.0.0" / "mujoco" / "libmujoco.so.4.0.0"
SCENES = sorted((ROOT / "model").glob("*/scene*.xml"))
TIMEOUT_S = 120


def output_of(program: Path, *words: str | Path, **environment: str) -> str:
    finished = subprocess.run(
        [program, *words],
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=True,
        env={**os.environ, **environment},
    )
    assert finished.stderr == ""
    return finished.stdout


@pytest.fixture(scope="module")
def library_path(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A folder that has 4.0.0 under the name that the program asks for."""
    folder = tmp_path_factory.mktemp("engine")
    (folder / "libmujoco.so.4.0.1").symlink_to(FOUR_ZERO_ZERO)
    return str(folder)


def test_the_other_library_is_used(program: Path, library_path: str, tmp_path: Path) -> None:
    """Otherwise the tests below compare a version with itself."""
    environments: dict[str, dict[str, str]] = {
        "4.0.1": {},
        "4.0.0": {"LD_LIBRARY_PATH": library_path},
    }
    for version, environment in environments.items():
        said = output_of(program, "generate", "--out", tmp_path / version, **environment)
        assert re.findall(r"MuJoCo (\S+) loads it", said) == [version]


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_committed_model_has_the_same_report(
    scene: Path, program: Path, shared: SharedResults, library_path: str
) -> None:
    there = output_of(program, "verify", scene, "--json", LD_LIBRARY_PATH=library_path)
    here = shared.verify(scene).text
    assert there.replace('"mujoco": "4.0.0"', '"mujoco": "4.0.1"') == here
    assert '"passed": true' in there
