# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle smooth-table`: the committed table is what it makes, and holds what its fit promises."""

from __future__ import annotations

import csv
import itertools
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Girdle, Refuses
from reference_rhythm import (
    DATABASE,
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    ST_COORDINATES,
    Array,
    euler_from_quaternion,
    exp,
    inverse,
    log,
    multiply,
    quaternion_from_euler,
    rotation_angle_deg,
)

SMOOTHED = DATABASE.with_name("ludewig2009_smoothed.csv")
JOINTS = tuple(JOINT_SEQUENCES)
PLANES = (0, 40, 90)
ELEVATIONS = tuple(range(15, 125, 5))
# The rows that were measured with bone pins begin here.
FIRST_PINNED = ELEVATIONS.index(30)

# What the fit minimises: the weight of third differences, and the share of it for GH below 30.
PENALTY = 10.0
GH_LOW_SHARE = 0.005

MOST_MOVED_DEG = 0.75
MOST_BENT_DEG = 0.4
# The humerus turns most of all, and about every axis.
MOST_BENT_GH_DEG = 0.45
# Of an angle in the file: half of its last decimal.
ROUNDED_DEG = 0.00005

Rows = list[dict[str, str]]


def read_rows(path: Path) -> Rows:
    lines = path.read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def rotations(rows: Rows, joint: str, plane: int) -> list[Array]:
    columns = [f"{coordinate}_deg" for coordinate in JOINT_COORDINATES[joint]]
    return [
        quaternion_from_euler(JOINT_SEQUENCES[joint], [float(row[column]) for column in columns])
        for row in rows
        if float(row["plane_deg"]) == plane
    ]


def rotation_vector(a: Array, b: Array) -> Array:
    """The short way from a to b as axis times angle (rad)."""
    way = multiply(inverse(a), b)
    return 2.0 * log(way if way[0] >= 0.0 else -way)


def ways(series: list[Array]) -> Array:
    return np.array([rotation_vector(a, b) for a, b in itertools.pairwise(series)])


def bends_deg(series: list[Array]) -> Array:
    """Second differences along the rows, each as the length of a rotation vector."""
    return np.degrees(np.linalg.norm(np.diff(ways(series), axis=0), axis=1))


def euler_bends_deg(series: list[Array], joint: str) -> Array:
    angles = [euler_from_quaternion(JOINT_SEQUENCES[joint], q) for q in series]
    return np.abs(np.diff(np.array(angles), 2, axis=0)).max(axis=1)


def moves_deg(joint: str, plane: int) -> Array:
    before = rotations(read_rows(DATABASE), joint, plane)
    after = rotations(read_rows(SMOOTHED), joint, plane)
    return np.array([rotation_angle_deg(q, r) for q, r in zip(before, after, strict=True)])


def largest(quantity_of_plane: dict[int, Array], first_elevation_index: int) -> tuple[float, int, int]:
    """The largest value over the grid, its plane and its elevation."""
    return max(
        (float(value), plane, ELEVATIONS[i + first_elevation_index])
        for plane, values in quantity_of_plane.items()
        for i, value in enumerate(values)
    )


every_joint = pytest.mark.parametrize("joint", JOINTS)
every_plane = pytest.mark.parametrize("plane", PLANES)


# --- The committed table -------------------------------------------------------------------------


def test_the_committed_table_is_regenerated_byte_for_byte(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("smooth-table", "--in", DATABASE, "--out", "smooth.csv")
    assert (tmp_path / "smooth.csv").read_bytes() == SMOOTHED.read_bytes()


@every_plane
@every_joint
def test_no_row_moves_far(joint: str, plane: int) -> None:
    assert moves_deg(joint, plane).max() < MOST_MOVED_DEG


@every_plane
@pytest.mark.parametrize("joint", ["sc", "ac"])
def test_the_clavicle_and_the_scapula_have_no_steps(joint: str, plane: int) -> None:
    assert bends_deg(rotations(read_rows(DATABASE), joint, plane)).max() > 1.0
    assert bends_deg(rotations(read_rows(SMOOTHED), joint, plane)).max() < MOST_BENT_DEG


@every_plane
def test_the_arm_has_no_steps_from_30_up(plane: int) -> None:
    """Beside the row 30 the fast axial turn near hanging ends, which is no step."""
    first = ELEVATIONS.index(40) - 1  # the first second difference stands at the second row
    series = rotations(read_rows(SMOOTHED), "gh", plane)
    assert bends_deg(series)[first:].max() < MOST_BENT_GH_DEG


def test_the_axial_rate_near_hanging_falls_steadily() -> None:
    """Measured: -6.9, -1.6, -3.1, -0.9 deg from row to row in the frontal plane."""
    axial = [float(row["gh_axial_deg"]) for row in read_rows(SMOOTHED)[:6]]
    rates = np.abs(np.diff(axial))
    assert list(rates) == sorted(rates, reverse=True)


@every_plane
@every_joint
def test_no_small_turn_of_a_row_makes_the_fit_better(joint: str, plane: int) -> None:
    measured = rotations(read_rows(DATABASE), joint, plane)
    fitted = rotations(read_rows(SMOOTHED), joint, plane)
    shares = np.ones(len(ELEVATIONS) - 3)
    if joint == "gh":
        shares[:FIRST_PINNED] = GH_LOW_SHARE

    def sum_of_squares(series: list[Array]) -> float:
        moved = [rotation_vector(q, r) for q, r in zip(measured, series, strict=True)]
        third = np.diff(ways(series), 2, axis=0)
        return float(np.sum(np.square(moved)) + PENALTY * shares @ np.square(third).sum(axis=1))

    least = sum_of_squares(fitted)
    # Far more than the file's rounding, far less than what bends the sum.
    turn_rad = np.radians(0.01)
    for row, q in enumerate(fitted):
        for axis in np.vstack([np.eye(3), -np.eye(3)]):
            turned = [*fitted]
            turned[row] = multiply(q, exp(axis * turn_rad / 2.0))
            assert sum_of_squares(turned) > least, f"row {row}"


def test_everything_but_the_joints_angles_is_the_source_s() -> None:
    before, after = read_rows(DATABASE), read_rows(SMOOTHED)
    assert list(after[0]) == list(before[0])
    kept = ["plane_deg", "elevation_deg", "origin", *(f"{name}_deg" for name in ST_COORDINATES)]
    for old, new in zip(before, after, strict=True):
        assert [new[column] for column in kept] == [old[column] for column in kept]


def test_the_table_says_where_it_comes_from() -> None:
    comments = [line for line in SMOOTHED.read_text().splitlines() if line.startswith("#")]
    text = "\n".join(comments)
    for word in ("ludewig2009.csv", "lambda = 10", "0.005", "girdle smooth-table", "Units: degrees"):
        assert word in text
    source = [line[1:] for line in DATABASE.read_text().splitlines() if line.startswith("#")]
    assert [line.removeprefix("#  ") for line in comments[-len(source) :]] == source


# --- The report ----------------------------------------------------------------------------------

QUANTITIES = (
    "move",
    "second difference before",
    "second difference after",
    "Euler second difference before",
    "Euler second difference after",
)


@pytest.fixture
def report(girdle_fine: Girdle) -> dict[tuple[str, str], tuple[float, float, float]]:
    """Value, plane and elevation by quantity and joint."""
    printed = json.loads(girdle_fine("smooth-table", "--in", DATABASE, "--out", "smooth.csv", "--json").text)
    assert (printed["table"], printed["penalty"]) == ("smooth.csv", PENALTY)
    return {
        (line["quantity"], line["joint"].lower()): (
            line["value_deg"],
            line["plane_deg"],
            line["elevation_deg"],
        )
        for line in printed["largest"]
    }


@every_joint
def test_the_report_tells_the_largest_of_each(
    report: dict[tuple[str, str], tuple[float, float, float]], joint: str
) -> None:
    before, after = read_rows(DATABASE), read_rows(SMOOTHED)
    expected = dict.fromkeys(QUANTITIES, (0.0, 0, 0))
    expected["move"] = largest({plane: moves_deg(joint, plane) for plane in PLANES}, 0)
    for when, rows in (("before", before), ("after", after)):
        series = {plane: rotations(rows, joint, plane) for plane in PLANES}
        expected[f"second difference {when}"] = largest(
            {plane: bends_deg(series[plane]) for plane in PLANES}, 1
        )
        expected[f"Euler second difference {when}"] = largest(
            {plane: euler_bends_deg(series[plane], joint) for plane in PLANES}, 1
        )
    for quantity, (value, plane, elevation) in expected.items():
        reported, reported_plane, reported_elevation = report[(quantity, joint)]
        # A second difference has four roundings of each of three angles.
        assert reported == pytest.approx(value, abs=12 * ROUNDED_DEG), quantity
        if not quantity.startswith("Euler"):  # of equal decimals any may be named
            assert reported_plane == pytest.approx(plane), quantity
            assert reported_elevation == pytest.approx(elevation), quantity


def test_the_text_gives_the_numbers_of_the_json(
    girdle_fine: Girdle, report: dict[tuple[str, str], tuple[float, float, float]]
) -> None:
    text = girdle_fine("smooth-table", "--in", DATABASE, "--out", "smooth.csv").text
    lines = [" ".join(line.split()) for line in text.splitlines()]
    for (quantity, joint), (value, plane, elevation) in report.items():
        expected = f"{quantity} {joint.upper()} {round(value, 3):g}"
        assert f"{expected} plane {plane:g}, elevation {elevation:g}" in lines


def test_a_table_on_standard_output_is_alone_there(girdle_fine: Girdle) -> None:
    printed = girdle_fine("smooth-table", "--in", DATABASE, "--out", "-").output
    assert printed == SMOOTHED.read_bytes()


def test_without_a_penalty_the_angles_stay(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("smooth-table", "--in", DATABASE, "--out", "same.csv", "--penalty", "0")
    assert read_rows(tmp_path / "same.csv") == read_rows(DATABASE)


def test_a_larger_penalty_bends_less(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("smooth-table", "--in", DATABASE, "--out", "stiff.csv", "--penalty", "1000")
    stiff = rotations(read_rows(tmp_path / "stiff.csv"), "sc", 40)
    assert bends_deg(stiff).max() < bends_deg(rotations(read_rows(SMOOTHED), "sc", 40)).max()


def test_the_result_is_a_table_for_every_verb(girdle_fine: Girdle) -> None:
    girdle_fine("smooth-table", "--in", DATABASE, "--out", "smooth.csv")
    girdle_fine("solve", "--elevation", "23", "--plane", "50", "--table", "smooth.csv")


# --- Bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "patterns"),
    [
        (("--out", "smooth.csv"), ("--in", "--help")),
        (("--in", DATABASE), ("--out", "--help")),
        (("--in", "absent.csv", "--out", "smooth.csv"), ("absent.csv", "Check")),
        (("--in", ".", "--out", "smooth.csv"), ("folder",)),
        (
            ("--in", DATABASE, "--out", "smooth.csv", "--penalty", "1O"),
            ("--penalty '1O'", "finite number"),
        ),
        (
            ("--in", DATABASE, "--out", "smooth.csv", "--penalty", "-1"),
            ("--penalty -1", "0 to 1000000"),
        ),
        (
            ("--in", DATABASE, "--out", "smooth.csv", "--penalty", "2e6"),
            ("--penalty 2e6", "0 to 1000000"),
        ),
        (("--in", DATABASE, "--out", "-", "--json"), ("--json and --out -", "to a file")),
    ],
)
def test_a_wrong_command_is_refused(
    refuses: Refuses, options: tuple[str | Path, ...], patterns: tuple[str, ...]
) -> None:
    refuses("smooth-table", *options, because=patterns)


def data_lines() -> list[str]:
    return [line for line in DATABASE.read_text().splitlines() if not line.startswith("#")]


def test_a_table_of_three_elevations_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    kept = ("elevation_deg", "60", "65", "70")
    few = [line for line in data_lines() if line.split(",")[1] in kept]
    (tmp_path / "mine.csv").write_text("\n".join(few) + "\n")
    refuses(
        *("smooth-table", "--in", "mine.csv", "--out", "smooth.csv"),
        because=("mine.csv: elevations: 3 given", "at least 4"),
    )


def test_a_mistake_in_the_table_is_refused_with_its_place(refuses: Refuses, tmp_path: Path) -> None:
    lines = data_lines()
    lines[9] = lines[9].replace("measured", "guessed")
    (tmp_path / "mine.csv").write_text("\n".join(lines) + "\n")
    refuses(
        *("smooth-table", "--in", "mine.csv", "--out", "smooth.csv"),
        because=("mine.csv:10: origin is 'guessed'",),
    )


def test_a_refused_table_leaves_the_earlier_one(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "smooth.csv").write_text("earlier\n")
    refuses("smooth-table", "--in", "absent.csv", "--out", "smooth.csv", because=("absent.csv",))
