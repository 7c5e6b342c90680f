# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Two versions of MuJoCo move the same model in the same way."""

from __future__ import annotations

import csv
import math
import re
import subprocess
from pathlib import Path

import pytest
from conftest import PROGRAM_TIMEOUT_S, path_from_environment

MODELS = Path(__file__).resolve().parents[2] / "model"

DURATION_S = 10.0
TIMESTEP_S = 0.002

# Commands far apart, with turns about the arm's own axis and an end behind the frontal plane.
MOTION = """\
time_s,elevation_deg,plane_deg,axial_deg
0,0,0,0
2,150,0,0
4,90,90,20
6,30,-30,-20
8,120,70,0
10,0,0,0
"""

# The engines do the same sums in an order of their own. Rounding of 1e-16 rad does not grow in
# damped joints that are held by servos; an algorithm that differs would show from 1e-6 on.
SAME_RAD = 1e-6


@pytest.fixture(scope="module")
def other_program() -> Path:
    return path_from_environment(
        "GIRDLE_OTHER_PROGRAM", "the girdle program built for the other MuJoCo", executable=True
    )


def output_of(*command: str | Path) -> str:
    return subprocess.run(
        command, capture_output=True, text=True, timeout=PROGRAM_TIMEOUT_S, check=True
    ).stdout


def engine_version(program: Path, folder: Path) -> str:
    """What `generate` says of the MuJoCo that loads its model."""
    found = re.search(r"MuJoCo (\d+\.\d+\.\d+) loads it", output_of(program, "generate", "--out", folder))
    assert found
    return found[1]


def joint_angles_rad(program: Path, model: Path, folder: Path) -> list[list[float]]:
    """The joints at every step."""
    motion, trace = folder / "motion.csv", folder / "trace.csv"
    motion.write_text(MOTION)
    output_of(program, "simulate", model, "--motion", motion, "--trace", trace)
    with trace.open() as file:
        rows = list(csv.DictReader(file))
    names = [name[len("target_") :] for name in rows[0] if name.startswith("target_")]
    assert names, "the trace holds no joint"
    return [[math.radians(float(row[name])) for name in names] for row in rows]


def test_the_other_build_runs_another_mujoco(
    program: Path, other_program: Path, tmp_path: Path
) -> None:
    """Otherwise the test below would compare a version with itself."""
    versions = {engine_version(each, tmp_path) for each in (program, other_program)}
    assert len(versions) == 2, versions


@pytest.mark.parametrize("family", ["shoulder_tree", "shoulder_loop"])
@pytest.mark.parametrize("scene", ["scene.xml", "scene_both.xml", "scene_position.xml"])
def test_both_versions_of_mujoco_take_the_arm_the_same_way(
    family: str, scene: str, program: Path, other_program: Path, tmp_path: Path
) -> None:
    model = MODELS / family / scene
    here = joint_angles_rad(program, model, tmp_path)
    there = joint_angles_rad(other_program, model, tmp_path)
    assert len(here) == len(there) == round(DURATION_S / TIMESTEP_S) + 1
    for step, (ours, theirs) in enumerate(zip(here, there, strict=True)):
        assert ours == pytest.approx(theirs, rel=0, abs=SAME_RAD), f"step {step}"
    # Of a model that stands still the two would agree whatever they did.
    assert max(abs(row[-1] - here[0][-1]) for row in here) > math.radians(30)
