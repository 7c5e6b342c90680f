# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The program's smooth rhythm against the reference, which was written from the equations alone."""

from __future__ import annotations

import csv
import itertools
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from conftest import TWELVE_DIGITS, RunProgram
from reference_rhythm import COORDINATES, JOINT_SEQUENCES, Array, Position, multiply
from reference_smooth import (
    AxialFrom,
    Closure,
    Extent,
    SmoothPoses,
    SmoothRhythm,
    angles_between_deg,
    as_seen_from,
    direction_deg,
    isb_humerus,
    lowest_plane_deg,
    reached,
    read_joint_ranges,
)
from reference_smooth import apart_deg as reference_apart_deg

SEED = 20090201
RANDOM_POSES = 2500

# Two implementations in double precision differ by 1e-9 or so: the reference takes differences
# where the rule has a derivative in it.
AGREEMENT_DEG = 1e-6
# A knot has no rule in it, only the way to a rotation vector and back, and the printed digits.
TABLE_DEG = 1e-9
# An arc cosine of nearly one, a legitimate way to write a small distance, costs as much.
DISTANCE_DEG = 1e-5
# Velocities (deg/deg) against differences.
RATE = 1e-6
# Beside a border, far enough to survive printing, near enough to be no other place.
NUDGE_DEG = 1e-9
# On the circle behind the body rounding decides on which side a pose is; this far away it does not.
ON_CIRCLE_DEG = 1e-8
BESIDE_REACH_DEG = 1e-6
# Differences of the answer to a direction out of reach do not see the limit, nor a change of the
# rule's form, from this far away (deg).
KINK_DEG = 1e-3

# Where the rule changes, ends or stops being measured. The reach has a corner at 62.5; beyond it
# the answer changes its form at 55, 90 and 115, and opposite to the middle, at plane 200.
BORDER_ELEVATIONS_DEG = (0.0, 15.0, 55.0, 62.5, 90.0, 115.0, 120.0, 135.0, 150.0, 180.0)
BORDER_PLANES_DEG = (-160.0, -135.0, -95.0, -30.0, 0.0, 40.0, 90.0, 135.0, 240.0)
BEYOND_ELEVATIONS_DEG = (5.0, 50.0, 100.0, 130.0, 175.0)
BEYOND_PLANES_DEG = (-350.0, -170.0, -115.0, 20.0, 150.0, 180.0, 300.0)

# The plane over its limits, the axial turn over that of the joint, the offsets as far
# as they may be typed, which is over the joint's limits.
RANDOM_RANGES_DEG = {
    "elevation_deg": (0.0, 180.0),
    "plane_deg": (-180.0, 220.0),
    "axial_deg": (-90.0, 90.0),
    "shrug_deg": (-15.0, 35.0),
    "protraction_deg": (-25.0, 30.0),
}

CASES: list[tuple[Closure, Extent]] = [("exact", "whole"), ("exact", "clamp"), ("table", "clamp")]


@dataclass(frozen=True)
class Solution:
    """All poses as the reference and as the program have them."""

    commands: dict[str, Array]
    expected: SmoothPoses
    expected_rates: dict[str, dict[str, Array]]
    smooth: SmoothRhythm
    extent: Extent
    answers: dict[str, Array]

    def place(self, n: int) -> str:
        return ", ".join(f"{name} {float(values[n])!r}" for name, values in self.commands.items())

    @property
    def seen_planes_deg(self) -> Array:
        return as_seen_from(self.commands["plane_deg"], 20.0)

    @property
    def on_circle(self) -> Array:
        """Poses on the lower limit of the plane, where that changes with elevation."""
        elevation_deg = self.commands["elevation_deg"]
        limits_deg = [
            lowest_plane_deg(elevation_deg + aside) for aside in (-ON_CIRCLE_DEG, 0.0, ON_CIRCLE_DEG)
        ]
        plane_deg = self.seen_planes_deg
        circle = (elevation_deg > 62.5 - ON_CIRCLE_DEG) & (elevation_deg < 115.5)
        return circle & (
            (plane_deg > np.min(limits_deg, axis=0) - ON_CIRCLE_DEG)
            & (plane_deg < np.max(limits_deg, axis=0) + ON_CIRCLE_DEG)
        )

    @property
    def is_reached(self) -> Array:
        """The direction, with the elevation brought back between hanging and straight up."""
        elevation_deg, plane_deg = self.commands["elevation_deg"], self.commands["plane_deg"]
        if self.extent == "clamp":
            return (
                (elevation_deg >= 15.0)
                & (elevation_deg <= 120.0)
                & (np.abs(as_seen_from(plane_deg, 45.0) - 45.0) <= 45.0)
            )
        within = (elevation_deg >= 0.0) & (elevation_deg <= 180.0)
        return within & reached(elevation_deg, self.seen_planes_deg)

    def on_kink(self, command: str) -> Array:
        """Poses that are not reached, where what answers them turns a corner along a command."""
        elevation_deg, plane_deg = self.commands["elevation_deg"], self.commands["plane_deg"]
        near_ends = np.minimum(np.abs(elevation_deg), np.abs(180.0 - elevation_deg)) < KINK_DEG

        def answer(aside_deg: float) -> Array:
            up_deg, across_deg = (aside_deg, 0.0) if command == "elevation" else (0.0, aside_deg)
            return np.stack(
                self.smooth.answerable(elevation_deg + up_deg, plane_deg + across_deg, self.extent)
            )

        ahead = (answer(KINK_DEG) - answer(0.0)) / KINK_DEG
        behind = (answer(0.0) - answer(-KINK_DEG)) / KINK_DEG
        turns = np.abs(ahead - behind).max(axis=0) > 0.01 * (1.0 + np.abs(ahead).max(axis=0))
        return ~self.is_reached & (near_ends | turns)


def make_commands() -> dict[str, Array]:
    """Random ones, some out of reach; all knots; on, beside and far beyond every border."""
    random = np.random.default_rng(SEED)
    columns = [random.uniform(*range_deg, RANDOM_POSES) for range_deg in RANDOM_RANGES_DEG.values()]

    poses = list(itertools.product(np.arange(15.0, 121.0, 5.0), (0.0, 40.0, 90.0)))
    nudges_deg = (-NUDGE_DEG, 0.0, NUDGE_DEG)
    poses += [
        (elevation + up, plane + forward)
        for elevation, plane in itertools.product(BORDER_ELEVATIONS_DEG, BORDER_PLANES_DEG)
        for up, forward in itertools.product(nudges_deg, nudges_deg)
    ]
    poses += [(e, random.uniform(-95.0, 135.0)) for e in BORDER_ELEVATIONS_DEG for _ in range(10)]
    poses += [(random.uniform(0.0, 180.0), p) for p in BORDER_PLANES_DEG for _ in range(10)]
    poses += [
        (elevation, lowest_plane_deg(elevation) + beside)
        for elevation in np.arange(0.0, 181.0, 5.0)
        for beside in (-BESIDE_REACH_DEG, 0.0, BESIDE_REACH_DEG)
    ]
    poses += [
        pose
        for elevation, plane in itertools.product(BEYOND_ELEVATIONS_DEG, BEYOND_PLANES_DEG)
        for pose in ((elevation, plane), (elevation, 40.0), (70.0, plane))
    ]
    elevations_deg, planes_deg = np.array(poses).T
    # Files hold elevations from hanging to straight up.
    elevations_deg = np.clip(elevations_deg, 0.0, 180.0)
    plain = [elevations_deg, planes_deg, *(np.zeros(len(poses)) for _ in columns[2:])]
    return {name: np.concatenate(pair) for name, *pair in zip(RANDOM_RANGES_DEG, columns, plain, strict=True)}


def solve_file(
    run_program: RunProgram,
    directory: Path,
    commands: dict[str, Array],
    closure: Closure,
    extent: Extent,
    *words: str,
) -> dict[str, Array]:
    """The program's answers, a column each; those that are not numbers are left out."""
    poses_path, angles_path = directory / "poses.csv", directory / "angles.csv"
    with poses_path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(commands)
        poses = zip(*commands.values(), strict=True)
        writer.writerows([repr(float(value)) for value in pose] for pose in poses)
    model = ("--interpolation", "smooth", "--table", "measured")
    how = ("--closure", closure, "--range", extent, "--derivatives", *TWELVE_DIGITS, *words)
    run_program("solve", "--in", poses_path, "--out", angles_path, *model, *how)
    with angles_path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name != "origin"}


# Of the random poses, that many.
AXIAL_POSES = 500
# Half a turn from the middle of the window a turn is as near to one end as to the other, and
# opposite to what answers there is no smallest rotation: rounding decides.
UNDECIDED_DEG = 1e-3
OPPOSITE_DEG = 1.0


@pytest.mark.parametrize("zero", ["isb", "swing"])
@pytest.mark.parametrize(("closure", "extent"), CASES)
def test_axial_turns_from_other_zeros_agree_with_the_reference(
    run_program: RunProgram,
    smooth: SmoothRhythm,
    tmp_path: Path,
    zero: AxialFrom,
    closure: Closure,
    extent: Extent,
) -> None:
    random = np.random.default_rng(SEED)
    ranges_deg = {**RANDOM_RANGES_DEG, "axial_deg": (-400.0, 400.0)}
    commands = {name: random.uniform(*range_deg, AXIAL_POSES) for name, range_deg in ranges_deg.items()}
    answers = solve_file(run_program, tmp_path, commands, closure, extent, "--axial-from", zero)
    asked = (commands["elevation_deg"], commands["plane_deg"])
    turn_deg = smooth.axial_on_rhythm_deg(*asked, commands["axial_deg"], zero, closure, extent)
    expected = smooth.solve(**{**commands, "axial_deg": turn_deg}, closure=closure, extent=extent)
    own = smooth.solve(*asked, closure=closure, extent=extent)
    in_window_deg = np.abs(own.angles_deg["gh_axial"] + turn_deg + 45.0)
    way_deg = reference_apart_deg(
        direction_deg(np.clip(asked[0], 0.0, 180.0), asked[1]),
        direction_deg(own.elevation_deg, own.plane_deg),
    )
    counts = (in_window_deg < 180.0 - UNDECIDED_DEG) & (way_deg < 180.0 - OPPOSITE_DEG)
    assert counts.sum() > 0.98 * AXIAL_POSES
    for coordinate in COORDINATES:
        errors_deg = apart_deg(answers[f"{coordinate}_deg"], expected.angles_deg[coordinate])
        assert errors_deg[counts].max() < AGREEMENT_DEG, coordinate
    assert np.abs(answers["used_axial_deg"] - expected.axial_deg)[counts].max() < AGREEMENT_DEG
    if closure == "exact":
        q_TH = multiply(
            multiply(expected.rotations["sc"], expected.rotations["ac"]), expected.rotations["gh"]
        )
        again = isb_humerus(expected.elevation_deg, expected.plane_deg, answers["used_axial_isb_deg"])
        assert angles_between_deg(again, q_TH)[counts].max() < AGREEMENT_DEG


@pytest.fixture(scope="module")
def smooth(database: list[Position]) -> SmoothRhythm:
    return SmoothRhythm(database, read_joint_ranges())


@pytest.fixture(scope="module", params=CASES, ids="-".join)
def solution(
    request: pytest.FixtureRequest,
    run_program: RunProgram,
    smooth: SmoothRhythm,
    tmp_path_factory: pytest.TempPathFactory,
) -> Solution:
    closure, extent = request.param
    commands = make_commands()
    answers = solve_file(run_program, tmp_path_factory.mktemp("solve"), commands, closure, extent)
    return Solution(
        commands,
        smooth.solve(**commands, closure=closure, extent=extent),
        smooth.rates(**commands, closure=closure, extent=extent),
        smooth,
        extent,
        answers,
    )


def apart_deg(a: Array, b: Array) -> Array:
    """The difference of two angles, whole turns left out."""
    return np.abs(np.remainder(a - b + 180.0, 360.0) - 180.0)


def test_the_answers_stand_in_the_order_of_the_questions(solution: Solution) -> None:
    for name, asked in solution.commands.items():
        assert np.array_equal(solution.answers[name], asked), name


@pytest.mark.parametrize("coordinate", COORDINATES)
def test_the_program_agrees_with_the_reference(solution: Solution, coordinate: str) -> None:
    expected_deg = solution.expected.angles_deg[coordinate]
    answered_deg = solution.answers[f"{coordinate}_deg"]
    errors_deg = apart_deg(answered_deg, expected_deg)
    worst = int(np.argmax(errors_deg))
    assert errors_deg[worst] < AGREEMENT_DEG, (
        f"{solution.place(worst)}: {coordinate} is {answered_deg[worst]:.17g}, "
        f"expected {expected_deg[worst]:.17g}"
    )


def test_the_axial_angle_stays_in_its_window(solution: Solution) -> None:
    axial_deg = solution.answers["gh_axial_deg"]
    assert axial_deg.min() > -225.0
    assert axial_deg.max() <= 135.0


def test_the_program_uses_another_command_for_the_same_poses(solution: Solution) -> None:
    answered = solution.answers["clamped"]
    wrong = np.flatnonzero((answered != solution.expected.clamped) & ~solution.on_circle)
    assert not wrong.size, [solution.place(n) for n in wrong[:5]]
    assert set(answered) == {0.0, 1.0}


def test_the_program_knows_how_far_away_the_measurements_are(solution: Solution) -> None:
    answered_deg, expected_deg = solution.answers["distance_deg"], solution.expected.distance_deg
    worst = int(np.argmax(np.abs(answered_deg - expected_deg)))
    assert abs(answered_deg[worst] - expected_deg[worst]) < DISTANCE_DEG, (
        f"{solution.place(worst)}: {answered_deg[worst]:.17g}, expected {expected_deg[worst]:.17g}"
    )


@pytest.mark.parametrize("command", ["elevation", "plane"])
@pytest.mark.parametrize("joint", JOINT_SEQUENCES)
def test_the_velocities_are_those_of_the_rotations(solution: Solution, joint: str, command: str) -> None:
    expected = solution.expected_rates[joint][command]
    answered = np.stack([solution.answers[f"{joint}_w_{command}_{axis}"] for axis in "xyz"])
    # Where GH stops the offsets the program's rates take them as constant, and say so. On a kink
    # of the answer one side's are as right as the other's.
    counts = ~solution.on_circle & ~solution.on_kink(command) & ~solution.expected.gh_stops
    assert counts.sum() > RANDOM_POSES / 2
    # Out of reach rates are up to ten times as large, and the error of differences with them.
    size = 1.0 + np.where(solution.is_reached, 0.0, np.abs(expected).max(axis=0))
    errors = np.where(counts, np.abs(answered - expected).max(axis=0) / size, 0.0)
    worst = int(np.argmax(errors))
    assert errors[worst] < RATE, (
        f"{solution.place(worst)}: {answered[:, worst]}, expected {expected[:, worst]}"
    )


def test_the_program_passes_through_every_table_position(
    run_program: RunProgram, database: list[Position], tmp_path: Path
) -> None:
    commands = {
        "elevation_deg": np.array([p.elevation_deg for p in database]),
        "plane_deg": np.array([p.plane_deg for p in database]),
    }
    answers = solve_file(run_program, tmp_path, commands, "table", "clamp")
    for n, p in enumerate(database):
        angles_deg = {c: answers[f"{c}_deg"][n] for c in COORDINATES}
        assert angles_deg == pytest.approx(p.angles_deg(), abs=TABLE_DEG), p
