# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The published method in the program against the reference, which was written from the equations.

What the program does unless told otherwise is held against its reference in test_smooth_agreement.
"""

from __future__ import annotations

import csv
import itertools
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import TWELVE_DIGITS, RunProgram
from reference_rhythm import (
    COORDINATES,
    ST_COORDINATES,
    Position,
    ReferenceRhythm,
    ShoulderPose,
)

SEED = 20090201
RANDOM_POSES = 1000
POSES_PER_EDGE = 4
INTERPOLATIONS = ("squad", "slerp")
PUBLISHED = ("--interpolation", "squad", "--closure", "table")

# Two implementations in double precision differ by 1e-12 or so. An arc cosine of nearly one, a
# legitimate way to write equation (1), costs up to 1e-6 deg and is not what this is about.
AGREEMENT_DEG = 1e-6
# A knot has no interpolation in it, only the way to a quaternion and back, and the printed digits.
TABLE_DEG = 1e-9
# A quotient of small numbers, rounded once or twice.
WEIGHT = 1e-12
# Beside an edge, far enough to survive printing, near enough to be no other place.
NUDGE_DEG = 1e-9

SOLVED_COLUMNS = [
    *(f"{angle}_deg" for angle in (*COORDINATES, *ST_COORDINATES)),
    *("clamped", "used_elevation_deg", "used_plane_deg", "distance_deg", "origin"),
    *("used_axial_deg", "used_axial_isb_deg", "used_shrug_deg", "used_protraction_deg"),
]


@dataclass(frozen=True)
class Solution:
    """One pose as the reference and as the program have it."""

    elevation_deg: float
    plane_deg: float
    expected: ShoulderPose
    answer: dict[str, str]

    def errors_deg(self) -> dict[str, float]:
        return {
            coordinate: float(self.answer[f"{coordinate}_deg"]) - expected_deg
            for coordinate, expected_deg in self.expected.angles_deg.items()
        }


def make_poses(reference: ReferenceRhythm) -> list[tuple[float, float]]:
    """Random ones, some of them outside; all knots; on, below and above every edge of a cell."""
    random = np.random.default_rng(SEED)
    elevations_deg, planes_deg = reference.elevations_deg, reference.planes_deg
    poses = [(random.uniform(0.0, 140.0), random.uniform(-30.0, 110.0)) for _ in range(RANDOM_POSES)]
    poses += [(elevation, plane) for plane in planes_deg for elevation in elevations_deg]
    for nudge_deg in (-NUDGE_DEG, 0.0, NUDGE_DEG):
        for _ in range(POSES_PER_EDGE):
            for low, high in itertools.pairwise(planes_deg):
                poses += [(e + nudge_deg, random.uniform(low, high)) for e in elevations_deg]
            for low, high in itertools.pairwise(elevations_deg):
                poses += [(random.uniform(low, high), p + nudge_deg) for p in planes_deg]
    return poses


def write_csv(path: Path, header: list[str], rows: list[list[str]]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def read_csv(path: Path) -> tuple[list[str], list[dict[str, str]]]:
    with path.open(newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    return list(reader.fieldnames or []), rows


@pytest.fixture(scope="module", params=INTERPOLATIONS)
def solutions(
    request: pytest.FixtureRequest,
    run_program: RunProgram,
    reference: ReferenceRhythm,
    tmp_path_factory: pytest.TempPathFactory,
) -> list[Solution]:
    directory = tmp_path_factory.mktemp(request.param)
    poses_path, angles_path = directory / "poses.csv", directory / "angles.csv"
    poses = make_poses(reference)
    header = ["elevation_deg", "plane_deg"]
    write_csv(poses_path, header, [[repr(float(value)) for value in pose] for pose in poses])
    method = ("--interpolation", request.param, "--closure", "table", *TWELVE_DIGITS)
    run_program("solve", "--in", poses_path, "--out", angles_path, *method)
    answered_header, answers = read_csv(angles_path)
    assert answered_header == header + SOLVED_COLUMNS
    assert len(answers) == len(poses)
    return [
        Solution(elevation, plane, reference.solve(elevation, plane, request.param), answer)
        for (elevation, plane), answer in zip(poses, answers, strict=True)
    ]


def test_the_answers_stand_in_the_order_of_the_questions(solutions: list[Solution]) -> None:
    for s in solutions:
        asked = (s.elevation_deg, s.plane_deg)
        carried = (float(s.answer["elevation_deg"]), float(s.answer["plane_deg"]))
        assert carried == asked


@pytest.mark.parametrize("coordinate", COORDINATES)
def test_the_program_agrees_with_the_reference(solutions: list[Solution], coordinate: str) -> None:
    worst = max(solutions, key=lambda s: abs(s.errors_deg()[coordinate]))
    assert abs(worst.errors_deg()[coordinate]) < AGREEMENT_DEG, (
        f"elevation {worst.elevation_deg!r}, plane {worst.plane_deg!r}: {coordinate} is "
        f"{worst.answer[f'{coordinate}_deg']}, expected {worst.expected.angles_deg[coordinate]!r}"
    )


def test_the_program_clamps_the_same_poses(solutions: list[Solution]) -> None:
    wrong = [
        (s.elevation_deg, s.plane_deg, s.answer["clamped"])
        for s in solutions
        if s.answer["clamped"] != str(int(s.expected.clamped))
    ]
    assert not wrong
    assert {s.answer["clamped"] for s in solutions} == {"0", "1"}


def test_the_program_passes_through_every_table_position(
    solutions: list[Solution], database: list[Position]
) -> None:
    answers = {(s.plane_deg, s.elevation_deg): s.answer for s in solutions}
    for p in database:
        answer = answers[p.plane_deg, p.elevation_deg]
        angles_deg = {c: float(answer[f"{c}_deg"]) for c in COORDINATES}
        assert angles_deg == pytest.approx(p.angles_deg(), abs=TABLE_DEG), p


def test_columns_may_stand_in_any_order_and_further_ones_are_carried_along(
    run_program: RunProgram, reference: ReferenceRhythm, tmp_path: Path
) -> None:
    header = ["trial", "plane_deg", "note", "elevation_deg"]
    rows = [["7", "50", "slow", "23"], ["8", "12.5", "", "101"]]
    write_csv(tmp_path / "poses.csv", header, rows)
    files = ("--in", tmp_path / "poses.csv", "--out", tmp_path / "angles.csv")
    run_program("solve", *files, *PUBLISHED)

    answered_header, answers = read_csv(tmp_path / "angles.csv")
    assert answered_header == header + SOLVED_COLUMNS
    assert [(a["trial"], a["note"]) for a in answers] == [("7", "slow"), ("8", "")]
    for (_, plane, _, elevation), answer in zip(rows, answers, strict=True):
        expected_deg = reference.solve(float(elevation), float(plane)).angles_deg
        angles_deg = {c: float(answer[f"{c}_deg"]) for c in COORDINATES}
        assert angles_deg == pytest.approx(expected_deg, abs=AGREEMENT_DEG)


def solve_one(run_program: RunProgram, elevation_deg: float, plane_deg: float) -> dict[str, Any]:
    pose = ("--elevation", elevation_deg, "--plane", plane_deg)
    return json.loads(run_program("solve", *pose, *PUBLISHED, "--json"))


def joint_angles(answer: dict[str, Any]) -> dict[str, float]:
    return {c: answer["angles_deg"][c] for c in COORDINATES}


def test_the_papers_example_lies_in_its_cell(run_program: RunProgram) -> None:
    cell = solve_one(run_program, 23, 50)["cell"]
    assert cell["elevation_from_deg"] == 20
    assert cell["elevation_to_deg"] == 25
    assert cell["plane_from_deg"] == 40
    assert cell["plane_to_deg"] == 90
    assert cell["elevation_weight"] == pytest.approx(3 / 5, abs=WEIGHT)
    assert cell["plane_weight"] == pytest.approx(10 / 50, abs=WEIGHT)


def test_one_pose_says_how_it_was_solved(run_program: RunProgram, reference: ReferenceRhythm) -> None:
    answer = solve_one(run_program, 23, 50)
    assert answer["interpolation"] == "squad"
    assert answer["closure"] == "table"
    assert answer["range"] == "clamp"
    assert answer["clamped"] is False
    assert (answer["elevation_deg"], answer["plane_deg"]) == (23, 50)
    expected_deg = reference.solve(23.0, 50.0).angles_deg
    assert joint_angles(answer) == pytest.approx(expected_deg, abs=AGREEMENT_DEG)


def test_one_pose_outside_the_table_says_that_it_is_clamped(
    run_program: RunProgram, reference: ReferenceRhythm
) -> None:
    answer = solve_one(run_program, 130, 50)
    assert answer["clamped"] is True
    expected_deg = reference.solve(120.0, 50.0).angles_deg
    assert joint_angles(answer) == pytest.approx(expected_deg, abs=AGREEMENT_DEG)
