# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`scripts/fingerprint`: the bits of solved poses and of the models' steps are the committed ones."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import REFUSED

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "fingerprint"
COMMITTED = ROOT / "tests" / "fingerprint.txt"
FAILED = 1


def fingerprint(build: Path | str, script: Path = SCRIPT) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-B", str(script), str(build)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


@pytest.fixture(scope="module")
def printed() -> dict[str, str]:
    finished = fingerprint(os.environ["GIRDLE_BUILD_DIR"])
    assert (finished.returncode, finished.stderr) == (0, "")
    return dict(line.split() for line in finished.stdout.splitlines())


def test_the_bits_are_the_committed_ones(printed: dict[str, str]) -> None:
    """After a change that is meant: scripts/fingerprint > tests/fingerprint.txt"""
    assert printed == dict(line.split() for line in COMMITTED.read_text().splitlines())


def test_every_committed_model_is_stepped(printed: dict[str, str]) -> None:
    scenes = [path.relative_to(ROOT).as_posix() for path in ROOT.glob("model/*/scene*.xml")]
    counted = "model/shoulder_tree/shoulder_right.xml,axial_from=isb"
    assert sorted(printed) == sorted(["poses", "sweep", *scenes, counted, "all"])
    # Skins cost the physics nothing, and change nothing; all other models are different ones.
    different = [name for name in printed if not name.startswith("model/shoulder_skin/")]
    assert len({printed[name] for name in different}) == len(different)


def test_the_last_line_is_of_all_others(printed: dict[str, str]) -> None:
    *lines, (last, found) = printed.items()
    whole = "".join(f"{name} {bits}\n" for name, bits in lines)
    assert (last, found) == ("all", hashlib.sha256(whole.encode()).hexdigest())


def test_another_rounding_of_the_math_library_changes_last_places_alone() -> None:
    """glibc's own sine without fused multiplication and addition, where the processor has it."""
    program = Path(os.environ["GIRDLE_BUILD_DIR"]) / "tests" / "pose_bits"
    without = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2"}
    numbers = []
    for environment in ({}, without):
        bits = subprocess.run(
            [str(program), "random", "0"],
            stdout=subprocess.PIPE,
            check=True,
            timeout=120,
            env={**os.environ, **environment},
        ).stdout
        numbers.append(np.frombuffer(bits, np.float64))
    assert numbers[0].size == 10_000 * (3 * (9 + 5 + 1 + 1) + 18)
    assert np.abs(numbers[0] - numbers[1]).max() < 1e-14


def build_with(tmp_path: Path, program: str) -> Path:
    """A build without the plugin whose poses come from a script."""
    made = tmp_path / "tests" / "pose_bits"
    made.parent.mkdir()
    made.write_text(f"#!/bin/sh\n{program}\n")
    made.chmod(0o755)
    return tmp_path


def test_other_bits_on_four_threads_are_an_error(tmp_path: Path) -> None:
    finished = fingerprint(build_with(tmp_path, 'echo "$1 $(($2 / 4))"'))
    assert (finished.returncode, finished.stdout) == (FAILED, "")
    assert finished.stderr.endswith("one by one (0) and many at once differ\n")


def test_a_build_without_the_plugin_has_no_models(tmp_path: Path) -> None:
    finished = fingerprint(build_with(tmp_path, 'echo "$1"'))
    assert (finished.returncode, finished.stderr) == (0, "")
    assert [line.split()[0] for line in finished.stdout.splitlines()] == ["poses", "sweep", "all"]


def test_a_build_that_is_not_there_is_refused(tmp_path: Path) -> None:
    finished = fingerprint(tmp_path)
    assert (finished.returncode, finished.stdout) == (REFUSED, "")
    assert "pose_bits is not there. Run scripts/test first" in finished.stderr
