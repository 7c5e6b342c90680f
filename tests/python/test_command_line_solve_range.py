# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle solve` beyond the published method: defaults, range, offsets, rates, postures, sweeps."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import TWELVE_DIGITS, Girdle, Refuses
from reference_rhythm import (
    COORDINATES,
    DATABASE,
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    ST_COORDINATES,
    Array,
    Interpolation,
    Position,
    ReferenceRhythm,
    elevation_and_plane_deg,
    multiply,
    quaternion_from_euler,
    read_database,
)
from reference_smooth import SmoothRhythm

SMOOTHED = DATABASE.with_name("ludewig2009_smoothed.csv")
POSTURES = DATABASE.with_name("postures.csv")

# Two implementations in double precision, one of which takes differences.
AGREEMENT_DEG = 1e-6
RATE = 1e-6
# An angle that went through a quaternion and back.
ROUNDING_DEG = 1e-9
# Text for people is rounded to six decimals.
TEXT = 0.5e-6 + ROUNDING_DEG
# Central differences of first derivatives, in steps of this many degrees, per degree.
STEP_DEG = 0.01
SECOND_RATE = 1e-5

Answer = dict[str, Any]

# Measured, between planes, derived, low, high, behind, across.
POSES_DEG = [(71.5, 12.0), (90.0, 40.0), (23.0, 50.0), (5.0, 70.0), (150.0, 20.0), (50.0, -40.0)]
POSES_DEG += [(100.0, 120.0), (0.0, 0.0), (180.0, 30.0)]


def words(elevation: float, plane: float, **options: float | str) -> list[str]:
    """Options as typed; a negative number needs the equals sign."""
    pose = {"elevation": elevation, "plane": plane} | options
    return [f"--{name}={value}" for name, value in pose.items()]


def solve(girdle_fine: Girdle, elevation: float, plane: float, *options: str) -> Answer:
    answer: Answer = json.loads(girdle_fine("solve", *words(elevation, plane), *options, "--json").text)
    return answer


def joint_angles(answer: Answer) -> dict[str, float]:
    """Those of SC, AC and GH, without the scapula in the thorax that follows from them."""
    return {c: answer["angles_deg"][c] for c in COORDINATES}


def read_rows(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(text.splitlines()))


def rotations(angles_deg: dict[str, float]) -> dict[str, Array]:
    return {
        joint: quaternion_from_euler(sequence, [angles_deg[c] for c in JOINT_COORDINATES[joint]])
        for joint, sequence in JOINT_SEQUENCES.items()
    }


def humerus(angles_deg: dict[str, float]) -> Array:
    q = rotations(angles_deg)
    return multiply(multiply(q["sc"], q["ac"]), q["gh"])


@pytest.fixture(scope="module")
def smoothed() -> SmoothRhythm:
    return SmoothRhythm(read_database(SMOOTHED))


@pytest.fixture(scope="module")
def measured(database: list[Position]) -> SmoothRhythm:
    return SmoothRhythm(database)


def reference_angles_deg(
    rhythm: SmoothRhythm, elevation_deg: float, plane_deg: float, *added_deg: float
) -> dict[str, float]:
    """Further numbers are what is added: axial, shrug, protraction."""
    axial_deg, shrug_deg, protraction_deg = (*added_deg, 0.0, 0.0, 0.0)[:3]
    angles = (elevation_deg, plane_deg, axial_deg, shrug_deg, protraction_deg)
    elevation, plane, axial, shrug, protraction = (np.array([angle]) for angle in angles)
    poses = rhythm.solve(elevation, plane, axial, shrug, protraction)
    return {coordinate: float(values[0]) for coordinate, values in poses.angles_deg.items()}


# --- What it does unless told otherwise ----------------------------------------------------------


@pytest.mark.parametrize(("elevation", "plane"), POSES_DEG)
def test_unless_told_otherwise_it_is_smooth_and_exact_over_the_whole_range(
    girdle_fine: Girdle, smoothed: SmoothRhythm, elevation: float, plane: float
) -> None:
    answer = solve(girdle_fine, elevation, plane)
    assert (answer["interpolation"], answer["closure"]) == ("smooth", "exact")
    assert answer["range"] == "whole"
    assert answer["clamped"] is False
    expected_deg = reference_angles_deg(smoothed, elevation, plane)
    assert joint_angles(answer) == pytest.approx(expected_deg, abs=AGREEMENT_DEG)


@pytest.mark.parametrize(("elevation", "plane"), POSES_DEG[:-2])
def test_unless_told_otherwise_the_arm_points_where_it_was_asked_to(
    girdle_fine: Girdle, elevation: float, plane: float
) -> None:
    q_TH = humerus(solve(girdle_fine, elevation, plane)["angles_deg"])
    reached_deg = elevation_and_plane_deg(q_TH)
    assert reached_deg == pytest.approx((elevation, plane), abs=1e-7)


def functional_positions() -> list[tuple[str, float, float]]:
    text = DATABASE.with_name("functional_positions.csv").read_text(encoding="utf-8")
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return [(r["position"], float(r["elevation_deg"]), float(r["plane_deg"])) for r in rows]


@pytest.mark.parametrize(("position", "elevation", "plane"), functional_positions())
def test_positions_of_daily_tasks_are_reached(
    girdle_fine: Girdle, position: str, elevation: float, plane: float
) -> None:
    answer = solve(girdle_fine, elevation, plane)
    assert not answer["clamped"], position
    reached_deg = elevation_and_plane_deg(humerus(answer["angles_deg"]))
    assert reached_deg == pytest.approx((elevation, plane), abs=1e-6)


# Arm swing, extension, the hand up the back.
@pytest.mark.parametrize("plane", [-60, -70, -80, -90])
@pytest.mark.parametrize("elevation", [5, 20, 40, 60])
def test_arms_swing_back_as_far_as_they_are_told_to(
    girdle_fine: Girdle, elevation: float, plane: float
) -> None:
    answer = solve(girdle_fine, elevation, plane)
    assert not answer["clamped"]
    assert answer["origin"] == "modelled"
    reached_deg = elevation_and_plane_deg(humerus(answer["angles_deg"]))
    assert reached_deg == pytest.approx((elevation, plane), abs=1e-6)


SAID = {
    "smooth": ("--interpolation=smooth", "--closure=exact", "--range=whole", "--table=smoothed"),
    "smooth without a range": ("--interpolation=smooth", "--closure=exact"),
    "range alone": ("--range=whole",),
    "table alone": ("--table=smoothed",),
}


@pytest.mark.parametrize("options", SAID.values(), ids=SAID.keys())
def test_the_default_may_be_said(girdle_fine: Girdle, options: tuple[str, ...]) -> None:
    for elevation, plane in POSES_DEG:
        expected = girdle_fine("solve", *words(elevation, plane), "--json").output
        assert girdle_fine("solve", *words(elevation, plane), "--json", *options).output == expected


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ((), ("smooth", "exact", "whole")),
        (("--closure", "table"), ("smooth", "table", "clamp")),
        (("--range", "clamp"), ("smooth", "exact", "clamp")),
        (("--interpolation", "squad"), ("squad", "exact", "clamp")),
        (("--interpolation", "slerp", "--closure", "table"), ("slerp", "table", "clamp")),
    ],
)
def test_what_is_not_said_follows_from_what_is(
    girdle_fine: Girdle, options: tuple[str, ...], expected: tuple[str, ...]
) -> None:
    answer = solve(girdle_fine, 60, 30, *options)
    assert (answer["interpolation"], answer["closure"], answer["range"]) == expected


@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
def test_squad_and_slerp_use_the_measured_table(
    girdle_fine: Girdle, reference: ReferenceRhythm, interpolation: Interpolation
) -> None:
    options = ("--interpolation", interpolation, "--closure", "table")
    answer = solve(girdle_fine, 112, 33, *options)
    expected_deg = reference.solve(112, 33, interpolation).angles_deg
    assert joint_angles(answer) == pytest.approx(expected_deg, abs=AGREEMENT_DEG)
    assert solve(girdle_fine, 112, 33, *options, "--table", "measured") == answer
    assert solve(girdle_fine, 112, 33, *options, "--table", "smoothed") != answer


@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
def test_the_exact_closure_keeps_the_girdle_and_turns_the_arm_to_the_command(
    girdle_fine: Girdle, interpolation: str
) -> None:
    """With the turn about the humerus's own axis that the table's arm has."""
    options = ("--interpolation", interpolation)
    exact = solve(girdle_fine, 112, 33, *options)["angles_deg"]
    table = solve(girdle_fine, 112, 33, *options, "--closure", "table")["angles_deg"]
    for coordinate in COORDINATES[:6]:
        assert exact[coordinate] == pytest.approx(table[coordinate], abs=ROUNDING_DEG)
    assert elevation_and_plane_deg(humerus(exact)) == pytest.approx((112, 33), abs=ROUNDING_DEG)
    turns = [2.0 * np.arctan2(q[2], q[0]) for q in (humerus(exact), humerus(table))]
    assert np.cos(turns[0] - turns[1]) == pytest.approx(1.0, abs=1e-12)


def test_the_measured_table_may_be_named_with_smooth(girdle_fine: Girdle, measured: SmoothRhythm) -> None:
    answer = solve(girdle_fine, 112, 33, "--table", "measured")
    expected_deg = reference_angles_deg(measured, 112, 33)
    assert joint_angles(answer) == pytest.approx(expected_deg, abs=AGREEMENT_DEG)
    assert solve(girdle_fine, 112, 33, "--table", str(DATABASE)) == answer


def test_a_file_that_is_named_like_a_table_needs_a_path(girdle_fine: Girdle, tmp_path: Path) -> None:
    (tmp_path / "measured").write_bytes(SMOOTHED.read_bytes())
    named, in_file, shipped = (
        solve(girdle_fine, 112, 33, "--table", table)["angles_deg"]
        for table in ("measured", "./measured", str(SMOOTHED))
    )
    assert in_file == shipped
    assert named != shipped


# --- Where it comes from -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("elevation", "plane", "origin"),
    [
        (60, 30, "measured"),
        (30, 0, "measured"),
        (30.1, 20, "measured"),
        (29.9, 20, "derived"),
        (15, 90, "derived"),
        (14.9, 20, "modelled"),
        (120.1, 20, "modelled"),
        (60, -1, "modelled"),
        (60, 91, "modelled"),
    ],
)
def test_the_origin_says_how_much_of_a_pose_was_measured(
    girdle_fine: Girdle, elevation: float, plane: float, origin: str
) -> None:
    """SC and AC at 15, 20 and 25 are derived; outside there is a rule."""
    answer = solve(girdle_fine, elevation, plane)
    assert answer["origin"] == origin
    assert (answer["distance_deg"] > 0) == (origin == "modelled")
    text = girdle_fine("solve", *words(elevation, plane)).text
    assert re.search(rf"^origin +{origin}\b", text, re.MULTILINE)
    assert ("deg from measured positions" in text) == (origin == "modelled")


def test_a_clamped_pose_is_as_measured_as_the_one_that_is_used(girdle_fine: Girdle) -> None:
    answer = solve(girdle_fine, 130, 50, "--range", "clamp")
    assert (answer["clamped"], answer["origin"]) == (True, "measured")
    assert answer["distance_deg"] == pytest.approx(10, abs=ROUNDING_DEG)
    assert solve(girdle_fine, 5, 50, "--range", "clamp")["origin"] == "derived"


# --- What is used instead ------------------------------------------------------------------------


def foot_deg(elevation_deg: float, beyond_deg: float) -> float:
    """The elevation of the direction of a plane that is nearest to one so far beyond it."""
    theta, beyond = math.radians(elevation_deg), math.radians(beyond_deg)
    return math.degrees(math.atan2(math.sin(theta) * math.cos(beyond), math.cos(theta)))


@pytest.mark.parametrize(
    ("elevation", "plane", "used"),
    [
        # Beside a plane the foot of the perpendicular: tan(foot) = tan(elevation) cos(beyond).
        (60, 150, {"elevation": foot_deg(60, 15), "plane": 135}),
        (60, -210, {"elevation": foot_deg(60, 15), "plane": 135}),
        (60, -100, {"elevation": foot_deg(60, 5), "plane": -95}),
        (150, -45, {"elevation": foot_deg(150, 15), "plane": -30}),
        # Behind the body elevations end at 62.5.
        (70, -90, {"elevation": 62.5}),
        # Far from all that is reached: in the middle of its planes.
        (90, 200, {"elevation": 90 * math.cos(math.radians(65)), "plane": 20}),
    ],
)
def test_beyond_what_an_arm_can_reach_the_nearest_is_used(
    girdle_fine: Girdle, elevation: float, plane: float, used: dict[str, float]
) -> None:
    answer = solve(girdle_fine, elevation, plane)
    asked = {"elevation": elevation, "plane": plane, "axial": 0, "shrug": 0, "protraction": 0}
    assert answer["clamped"] is True
    expected_deg = {f"{name}_deg": value for name, value in (asked | used).items()}
    used_deg = {name: answer["used"][name] for name in expected_deg}
    assert used_deg == pytest.approx(expected_deg, abs=ROUNDING_DEG)
    nearest = solve(girdle_fine, **{"elevation": elevation, "plane": plane} | used)
    assert answer["angles_deg"] == pytest.approx(nearest["angles_deg"], abs=ROUNDING_DEG)
    text = girdle_fine("solve", *words(elevation, plane)).text
    (line,) = re.findall(r"^clamped .*: (.*)", text, re.MULTILINE)
    assert line.count(", ") == len(used) - 1
    found = {name: float(value) for name, value in re.findall(r"(\w+) (\S+) deg", line)}
    assert found == pytest.approx(used, abs=TEXT)


@pytest.mark.parametrize(("elevation", "plane", "same"), [(60, 350, -10), (30, -300, 60), (0, 180, 0)])
def test_a_plane_is_an_angle(girdle_fine: Girdle, elevation: float, plane: float, same: float) -> None:
    """Whole turns do not matter, and hanging all planes are one."""
    answer, expected = (solve(girdle_fine, elevation, p) for p in (plane, same))
    assert answer["clamped"] is False
    assert answer["angles_deg"] == pytest.approx(expected["angles_deg"], abs=ROUNDING_DEG)
    assert answer["origin"] == expected["origin"]
    assert answer["distance_deg"] == pytest.approx(expected["distance_deg"], abs=ROUNDING_DEG)
    assert "clamped" not in girdle_fine("solve", *words(elevation, plane)).text


def test_what_is_clamped_beside_a_whole_turn_is_named_alone(girdle_fine: Girdle) -> None:
    text = girdle_fine("solve", *words(60, 390), "--axial=170").text
    (line,) = re.findall(r"^clamped .*: (.*)", text, re.MULTILINE)
    assert re.fullmatch(r"axial \S+ deg", line)


# --- Offsets -------------------------------------------------------------------------------------


@pytest.mark.parametrize(("elevation", "plane"), POSES_DEG)
def test_offsets_turn_the_clavicle_and_leave_the_arm_where_it_is(
    girdle_fine: Girdle, elevation: float, plane: float
) -> None:
    plain = solve(girdle_fine, elevation, plane)["angles_deg"]
    answer = solve(girdle_fine, elevation, plane, "--shrug=7.5", "--protraction=-4")
    assert answer["clamped"] is False
    expected_deg = {c: plain[c] for c in COORDINATES[:6]}
    expected_deg["sc_elevation"] -= 7.5  # up is negative
    expected_deg["sc_protraction"] -= 4
    found_deg = {c: answer["angles_deg"][c] for c in COORDINATES[:6]}
    assert found_deg == pytest.approx(expected_deg, abs=ROUNDING_DEG)
    assert abs(humerus(plain) @ humerus(answer["angles_deg"])) == pytest.approx(1, abs=1e-12)


def test_with_the_tables_closure_offsets_take_the_arm_along(girdle_fine: Girdle) -> None:
    options = ("--interpolation", "squad", "--closure", "table")
    plain = joint_angles(solve(girdle_fine, 60, 30, *options))
    moved = joint_angles(solve(girdle_fine, 60, 30, *options, "--shrug=10", "--protraction=5"))
    expected_deg = plain | {
        "sc_elevation": plain["sc_elevation"] - 10,
        "sc_protraction": plain["sc_protraction"] + 5,
    }
    assert moved == pytest.approx(expected_deg, abs=ROUNDING_DEG)


@pytest.mark.parametrize(
    ("options", "coordinate", "end_deg"),
    [
        (("--shrug=35",), "sc_elevation", -45),
        (("--protraction=-25",), "sc_protraction", -60),
        (("--axial=-170",), "gh_axial", -180),
        (("--axial=170",), "gh_axial", 60),
    ],
)
def test_what_is_added_ends_at_the_joints_range(
    girdle_fine: Girdle, options: tuple[str, ...], coordinate: str, end_deg: float
) -> None:
    plain, answer = solve(girdle_fine, 150, 0), solve(girdle_fine, 150, 0, *options)
    assert answer["clamped"] is True
    assert answer["angles_deg"][coordinate] == pytest.approx(end_deg, abs=ROUNDING_DEG)
    name = options[0].removeprefix("--").partition("=")[0]
    added_deg = abs(end_deg - plain["angles_deg"][coordinate])
    assert abs(answer["used"][f"{name}_deg"]) == pytest.approx(added_deg, abs=ROUNDING_DEG)


@pytest.mark.parametrize("axial", [-150, -90, -60, -20, 60, 150])
@pytest.mark.parametrize(("elevation", "plane"), [(90, -30), (60, -60), (60, -95), (85, -45), (150, -30)])
def test_behind_the_body_too_axial_ends_at_the_joints_range(
    girdle_fine: Girdle, elevation: float, plane: float, axial: float
) -> None:
    """There the joint is near the end of its range without any turn."""
    plain = solve(girdle_fine, elevation, plane)["angles_deg"]["gh_axial"]
    answer = solve(girdle_fine, elevation, plane, f"--axial={axial}")
    expected_deg = min(max(plain + axial, -180.0), 60.0)
    assert answer["angles_deg"]["gh_axial"] == pytest.approx(expected_deg, abs=ROUNDING_DEG)
    assert answer["used"]["axial_deg"] == pytest.approx(expected_deg - plain, abs=ROUNDING_DEG)


def test_columns_and_options_give_rows_their_offsets(girdle_fine: Girdle) -> None:
    plain = b"elevation_deg,plane_deg\n60,30\n150,100\n"
    columns = b"shrug_deg,elevation_deg,plane_deg,protraction_deg\n5,60,30,-3\n5,150,100,-3\n"
    command = ("solve", "--in", "-", *TWELVE_DIGITS)
    by_column = read_rows(girdle_fine(*command, stdin=columns).text)
    offsets = ("--shrug=5", "--protraction=-3")
    by_option = read_rows(girdle_fine(*command, *offsets, stdin=plain).text)
    for in_column, in_option in zip(by_column, by_option, strict=True):
        assert {name: in_column[name] for name in in_option} == in_option
        pose = (float(in_option["elevation_deg"]), float(in_option["plane_deg"]))
        one = solve(girdle_fine, *pose, *offsets)["angles_deg"]
        found = {angle: float(in_option[f"{angle}_deg"]) for angle in one}
        assert found == pytest.approx(one, abs=ROUNDING_DEG)


@pytest.mark.parametrize(
    ("option", "value", "bounds"),
    [
        ("--shrug", "36", "-15 to 35"),
        ("--shrug", "-15.1", "-15 to 35"),
        ("--protraction", "30.5", "-25 to 30"),
        ("--protraction", "-26", "-25 to 30"),
        ("--protraction", "1e300", "-25 to 30"),
    ],
)
@pytest.mark.parametrize("poses", [("--elevation=60", "--plane=30"), ("--in", "-")])
def test_an_offset_that_no_clavicle_makes_is_refused_with_its_bounds(
    refuses: Refuses, poses: tuple[str, ...], option: str, value: str, bounds: str
) -> None:
    because = (f"{option} {re.escape(value)}: ", f"from {bounds} deg", "Give an offset within")
    stdin = b"elevation_deg,plane_deg\n60,30\n"
    refuses("solve", *poses, f"{option}={value}", because=because, stdin=stdin)


@pytest.mark.parametrize(
    "options", [("--shrug=35", "--protraction=30"), ("--shrug=-15", "--protraction=-25")]
)
def test_the_bounds_themselves_are_accepted(girdle_fine: Girdle, options: tuple[str, ...]) -> None:
    answer = solve(girdle_fine, 60, 30, *options)
    assert [f"--shrug={answer['shrug_deg']:g}", f"--protraction={answer['protraction_deg']:g}"] == [*options]
    shrug, protraction = (option.partition("=")[2] for option in options)
    poses = f"elevation_deg,plane_deg,shrug_deg,protraction_deg\n60,30,{shrug},{protraction}\n"
    girdle_fine("solve", "--in", "-", stdin=poses.encode())


@pytest.mark.parametrize("option", ["--shrug", "--protraction"])
@pytest.mark.parametrize("word", ["4O", "nan", "inf", "", " "])
def test_an_offset_that_is_no_number_is_refused(refuses: Refuses, option: str, word: str) -> None:
    refuses("solve", *words(60, 30), f"{option}={word}", because=(option, "empty|such as"))


@pytest.mark.parametrize(
    ("header", "row", "patterns"),
    [
        ("shrug_deg", "36", ("shrug_deg is 36", "-15 to 35")),
        ("shrug_deg", "-15.5", ("shrug_deg is -15.5", "-15 to 35")),
        ("protraction_deg", "31", ("protraction_deg is 31", "-25 to 30")),
        ("protraction_deg", "-25.01", ("protraction_deg is -25.01", "-25 to 30")),
        ("shrug_deg", "up", ("shrug_deg is 'up'", "such as")),
        ("protraction_deg", "-", ("protraction_deg is '-'", "such as")),
    ],
)
def test_a_wrong_offset_in_a_file_is_refused_with_its_line(
    refuses: Refuses, tmp_path: Path, header: str, row: str, patterns: tuple[str, ...]
) -> None:
    poses = f"elevation_deg,plane_deg,{header}\n60,30,0\n60,30,{row}\n"
    (tmp_path / "poses.csv").write_text(poses)
    words = ("solve", "--in", "poses.csv", "--out", "angles.csv")
    refuses(*words, because=("poses.csv:3: ", *patterns))


@pytest.mark.parametrize("name", ["axial", "shrug", "protraction"])
def test_a_column_and_its_option_exclude_each_other(refuses: Refuses, tmp_path: Path, name: str) -> None:
    (tmp_path / "poses.csv").write_text(f"elevation_deg,plane_deg,{name}_deg\n60,30,0\n")
    because = ("poses.csv:1: ", f"{name}_deg", f"--{name}", "exclude", "Remove one")
    refuses("solve", "--in", "poses.csv", f"--{name}=0", because=because)


# --- Rates ---------------------------------------------------------------------------------------

RATE_COLUMNS = [
    f"{joint}_w_{by}_{axis}"
    for joint in ("sc", "ac", "gh")
    for by in ("elevation", "plane")
    for axis in "xyz"
]
# Not on a border of the rule, where second derivatives jump.
SMOOTH_POSES_DEG = [(71.5, 12.0), (23.0, 50.0), (5.0, 70.0), (140.0, 20.0), (50.0, -40.0)]
SMOOTH_POSES_DEG += [(100.0, 120.0), (165.0, 30.0)]


def test_derivatives_stand_behind_all_other_columns(girdle_fine: Girdle) -> None:
    poses = b"elevation_deg,plane_deg\n60,30\n"
    plain = girdle_fine("solve", "--in", "-", stdin=poses).text.splitlines()
    rates = girdle_fine("solve", "--in", "-", "--derivatives", stdin=poses).text.splitlines()
    assert rates[0] == ",".join([plain[0], *RATE_COLUMNS])
    assert rates[1].startswith(plain[1] + ",")
    assert len(rates[1].split(",")) == len(rates[0].split(","))


@pytest.mark.parametrize("column", RATE_COLUMNS)
def test_an_input_column_that_a_rate_is_called_is_refused(refuses: Refuses, column: str) -> None:
    poses = f"elevation_deg,plane_deg,{column}\n60,30,0\n".encode()
    because = ("standard input:1: ", f"'{column}' would be there twice", "Rename")
    refuses("solve", "--in", "-", "--derivatives", because=because, stdin=poses)


OFFSETS = ("--axial=-7", "--shrug=6", "--protraction=4")
# Options, and whether the range is whole with them.
HOW: dict[str, tuple[tuple[str, ...], bool]] = {
    "default": ((), True),
    "offsets": (OFFSETS, True),
    "clamp": (("--range", "clamp"), False),
    "table": (("--closure", "table", *OFFSETS), False),
}


@pytest.mark.parametrize(("options", "reaches_everywhere"), HOW.values(), ids=HOW.keys())
def test_the_derivatives_are_the_limits_of_differences(
    girdle_fine: Girdle, options: tuple[str, ...], reaches_everywhere: bool
) -> None:
    """First derivatives of the angles against angles nearby, second against first nearby."""
    poses = SMOOTH_POSES_DEG if reaches_everywhere else SMOOTH_POSES_DEG[:2]

    def derivatives(elevation: float, plane: float) -> tuple[Array, Array, Array]:
        """Angles (9), their first (9, 2) and second derivatives (9, 3)."""
        answer = solve(girdle_fine, elevation, plane, *options, "--derivatives")
        rows = answer["derivatives"]["angles"]
        assert list(rows) == list(COORDINATES)
        second = ("by_elevation_twice", "by_elevation_and_plane", "by_plane_twice")
        return (
            np.array([answer["angles_deg"][c] for c in COORDINATES]),
            np.array([[row["by_elevation"], row["by_plane"]] for row in rows.values()]),
            np.array([[row[f"{name}_per_deg"] for name in second] for row in rows.values()]),
        )

    h = STEP_DEG
    for elevation, plane in poses:
        _, first, second = derivatives(elevation, plane)
        up, down = derivatives(elevation + h, plane), derivatives(elevation - h, plane)
        front, back = derivatives(elevation, plane + h), derivatives(elevation, plane - h)
        by_elevation, by_plane = ((a[0] - b[0]) / (2 * h) for a, b in ((up, down), (front, back)))
        assert np.abs(first - np.stack([by_elevation, by_plane], axis=1)).max() < SECOND_RATE
        twice, mixed = ((up[1] - down[1]) / (2 * h)).T
        of_plane = (front[1] - back[1])[:, 1] / (2 * h)
        found = np.abs(second - np.stack([twice, mixed, of_plane], axis=1)).max()
        assert found < SECOND_RATE, (elevation, plane)


def test_one_pose_has_the_velocities_of_the_rows_and_of_the_reference(
    girdle_fine: Girdle, smoothed: SmoothRhythm
) -> None:
    for elevation, plane in SMOOTH_POSES_DEG:
        pose = f"elevation_deg,plane_deg\n{elevation},{plane}\n".encode()
        command = ("solve", "--in", "-", "--derivatives", *TWELVE_DIGITS)
        (row,) = read_rows(girdle_fine(*command, stdin=pose).text)
        one = solve(girdle_fine, elevation, plane, "--derivatives")["derivatives"]["angular_velocity"]
        expected = smoothed.rates(np.array([elevation]), np.array([plane]))
        for joint in JOINT_SEQUENCES:
            for by in ("elevation", "plane"):
                in_row = [float(row[f"{joint}_w_{by}_{axis}"]) for axis in "xyz"]
                assert one[joint.upper()][f"by_{by}"] == pytest.approx(in_row, abs=ROUNDING_DEG)
                assert in_row == pytest.approx(expected[joint][by][:, 0], abs=RATE)


def test_second_derivatives_of_the_rotations_are_the_limits_of_differences(
    girdle_fine: Girdle,
) -> None:
    def velocities(elevation: float, plane: float) -> dict[str, dict[str, list[float]]]:
        found = solve(girdle_fine, elevation, plane, *OFFSETS, "--derivatives")
        velocity: dict[str, dict[str, list[float]]] = found["derivatives"]["angular_velocity"]
        return velocity

    h = STEP_DEG
    for elevation, plane in ((71.5, 12.0), (140.0, 20.0)):
        here = velocities(elevation, plane)
        up, down = velocities(elevation + h, plane), velocities(elevation - h, plane)
        front, back = velocities(elevation, plane + h), velocities(elevation, plane - h)
        for joint, found in here.items():
            for name, after, before, of in (
                ("by_elevation_twice", up, down, "by_elevation"),
                ("by_elevation_and_plane", front, back, "by_elevation"),
                ("by_plane_twice", front, back, "by_plane"),
            ):
                difference = np.subtract(after[joint][of], before[joint][of]) / (2 * h)
                assert found[f"{name}_per_deg"] == pytest.approx(difference, abs=SECOND_RATE), name


@pytest.mark.parametrize(
    ("elevation", "plane", "by", "range_"),
    [
        (60, 100, "plane", "clamp"),
        (60, -50, "plane", "clamp"),
        (130, 30, "elevation", "clamp"),
    ],
)
def test_where_a_command_is_clamped_nothing_changes_with_it(
    girdle_fine: Girdle, elevation: float, plane: float, by: str, range_: str
) -> None:
    found = solve(girdle_fine, elevation, plane, "--derivatives", f"--range={range_}")["derivatives"]
    assert {angle[f"by_{by}"] for angle in found["angles"].values()} == {0.0}
    assert [w[f"by_{by}"] for w in found["angular_velocity"].values()] == [[0.0] * 3] * 3


@pytest.mark.parametrize(
    ("options", "coordinate"),
    [("--shrug=35", "sc_elevation"), ("--protraction=-25", "sc_protraction")],
)
def test_an_angle_at_the_end_of_its_range_stays_there(
    girdle_fine: Girdle, options: str, coordinate: str
) -> None:
    answer = solve(girdle_fine, 150, 0, options, "--derivatives")
    assert answer["clamped"] is True
    found = answer["derivatives"]["angles"][coordinate]
    assert (found["by_elevation"], found["by_plane"]) == pytest.approx((0, 0), abs=ROUNDING_DEG)


def test_the_text_has_a_table_of_derivatives(girdle_fine: Girdle) -> None:
    plain = girdle_fine("solve", *words(60, 30)).text
    text = girdle_fine("solve", *words(60, 30), "--derivatives").text
    assert text.startswith(plain)
    rows = re.findall(r"^(\w+) +(\S+) +([-\d.]+)$", text.removeprefix(plain), re.MULTILINE)
    expected = solve(girdle_fine, 60, 30, "--derivatives")["derivatives"]["angles"]
    assert [name for name, _, _ in rows] == list(COORDINATES)
    for name, by_elevation, by_plane in rows:
        found = (float(by_elevation), float(by_plane))
        assert found == pytest.approx((expected[name]["by_elevation"], expected[name]["by_plane"]), abs=TEXT)


def test_derivatives_are_there_only_if_they_are_asked_for(girdle_fine: Girdle) -> None:
    assert "derivatives" not in solve(girdle_fine, 60, 30)


@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
@pytest.mark.parametrize(
    "poses", [("--elevation=60", "--plane=30"), ("--in", "-"), ("--elevation=30:60:5", "--plane=0")]
)
def test_derivatives_need_an_interpolation_that_has_them(
    refuses: Refuses, poses: tuple[str, ...], interpolation: str
) -> None:
    because = ("--derivatives", f"{interpolation} has no derivatives", "--interpolation smooth")
    options = ("--interpolation", interpolation, "--derivatives")
    stdin = b"elevation_deg,plane_deg\n60,30\n"
    refuses("solve", *poses, *options, because=because, stdin=stdin)


# --- Postures ------------------------------------------------------------------------------------


def relaxed_deg() -> dict[str, float]:
    """SC and AC as in the file."""
    lines = [line for line in POSTURES.read_text().splitlines() if not line.startswith("#")]
    (row,) = [row for row in csv.DictReader(lines) if row["posture"] == "relaxed"]
    return {c: float(row[f"{c}_deg"]) for c in COORDINATES[:6]}


@pytest.mark.parametrize("options", [(), ("--table", "measured")], ids=["default", "measured"])
def test_relaxed_is_the_measured_posture_with_the_arm_hanging(
    girdle_fine: Girdle, options: tuple[str, ...]
) -> None:
    answer = json.loads(girdle_fine("solve", "--posture", "relaxed", "--json", *options).text)
    found_deg = {c: answer["angles_deg"][c] for c in COORDINATES[:6]}
    assert answer["posture"] == "relaxed"
    assert found_deg == pytest.approx(relaxed_deg(), abs=ROUNDING_DEG)
    # The humerus is where the rhythm's own arm hangs.
    hanging = solve(girdle_fine, 0, 0, *options)["angles_deg"]
    assert abs(humerus(answer["angles_deg"]) @ humerus(hanging)) == pytest.approx(1, abs=1e-12)


def test_a_posture_as_text_gives_every_angle_of_the_json(girdle_fine: Girdle) -> None:
    found = re.findall(r"^(\w+) +(\S+) deg$", girdle_fine("solve", "--posture", "relaxed").text, re.MULTILINE)
    answer = json.loads(girdle_fine("solve", "--posture", "relaxed", "--json").text)
    expected_deg = answer["angles_deg"]
    assert [name for name, _ in found] == [*COORDINATES, *ST_COORDINATES]
    assert {name: float(text) for name, text in found} == pytest.approx(expected_deg, abs=TEXT)


@pytest.mark.parametrize("word", ["Relaxed", "rest", "abduction_90"])
def test_an_unknown_posture_is_refused_with_the_known_one(refuses: Refuses, word: str) -> None:
    refuses("solve", "--posture", word, because=(f"--posture {word}", "Choose one of: relaxed"))


@pytest.mark.parametrize(
    "further",
    [
        *(("--elevation", "60"), ("--plane", "30"), ("--axial", "5"), ("--shrug", "5")),
        *(("--protraction", "5"), ("--derivatives",), ("--in", "-"), ("--threads", "2")),
        *(("--convention", "isb"), ("--angles", "rad")),
    ],
    ids=" ".join,
)
def test_a_posture_gives_the_whole_arm(refuses: Refuses, further: tuple[str, ...]) -> None:
    because = ("--posture", "Omit the other options")
    refuses("solve", "--posture", "relaxed", *further, because=because)


# --- Sweeps --------------------------------------------------------------------------------------


def test_a_sweep_is_a_file_of_all_its_positions(girdle_fine: Girdle) -> None:
    swept = girdle_fine("solve", "--elevation=0:180:45", "--plane=-60:135:65").output
    poses = [(e, p) for p in (-60, 5, 70, 135) for e in (0, 45, 90, 135, 180)]
    file = "elevation_deg,plane_deg\n" + "".join(f"{e},{p}\n" for e, p in poses)
    assert girdle_fine("solve", "--in", "-", stdin=file.encode()).output == swept


@pytest.mark.parametrize(
    ("sweep", "expected"),
    [
        (("--elevation=30:60:15", "--plane=40"), [(30, 40), (45, 40), (60, 40)]),
        (("--elevation=90", "--plane=-10:10:10"), [(90, -10), (90, 0), (90, 10)]),
        (("--elevation=30:30:1", "--plane=40"), [(30, 40)]),
    ],
)
def test_one_angle_may_be_swept_alone(
    girdle_fine: Girdle, sweep: tuple[str, ...], expected: list[tuple[float, float]]
) -> None:
    rows = read_rows(girdle_fine("solve", *sweep).text)
    assert [(float(r["elevation_deg"]), float(r["plane_deg"])) for r in rows] == expected


def test_positions_of_a_sweep_are_written_as_they_would_be_typed(girdle_fine: Girdle) -> None:
    rows = read_rows(girdle_fine("solve", "--elevation=0.1:0.7:0.1", "--plane=0").text)
    typed = [f"0.{tenth}" for tenth in range(1, 8)]
    assert [row["elevation_deg"] for row in rows] == typed


def test_a_sweep_takes_what_a_file_takes(girdle_fine: Girdle, tmp_path: Path) -> None:
    options = ("--derivatives", "--table", "measured")
    given = ("--shrug=5", "--protraction=-3", "--axial=4")
    girdle_fine("solve", "--elevation=30:60:15", "--plane=40", *given, *options, "--out", "map.csv")
    poses = (
        b"elevation_deg,plane_deg,axial_deg,shrug_deg,protraction_deg\n"
        b"30,40,4,5,-3\n45,40,4,5,-3\n60,40,4,5,-3\n"
    )
    expected = girdle_fine("solve", "--in", "-", *options, stdin=poses).output
    assert (tmp_path / "map.csv").read_bytes() == expected


def test_the_threads_of_a_sweep_change_nothing(girdle_fine: Girdle) -> None:
    sweep = ("solve", "--elevation=0:180:2", "--plane=-60:135:5", "--threads")
    outputs = {girdle_fine(*sweep, threads).output for threads in ("1", "2", "5")}
    assert len(outputs) == 1


@pytest.mark.parametrize("option", ["--elevation", "--plane"])
@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("30:60", "FROM:TO:STEP"),
        (":", "FROM:TO:STEP"),
        ("30:60:5:5", "FROM:TO:STEP"),
        ("30:6O:5", "'6O' is not a finite number"),
        ("30::5", "'' is not a finite number"),
        ("30:nan:5", "'nan' is not a finite number"),
        ("60:30:5", "goes downwards.* smaller end first"),
        ("30:60:0", "the step is 0.* positive"),
        ("30:60:-5", "the step is -5.* positive"),
        ("30:60:7", "do not meet 60. End at 58 or change the step"),
        ("30:60:1e-9", "more than 1000000 positions. Give a larger step"),
        ("30:4000:5", "4000 is outside -"),
    ],
)
def test_a_wrong_sweep_is_refused_with_the_fix(
    refuses: Refuses, option: str, value: str, reason: str
) -> None:
    pose = {"--elevation": "60", "--plane": "30"} | {option: value}
    words = [f"{name}={text}" for name, text in pose.items()]
    refuses("solve", *words, "--out", "map.csv", because=(option, re.escape(f"'{value}'"), reason))


def test_a_sweep_of_too_many_positions_is_refused(refuses: Refuses) -> None:
    sweep = ("--elevation=0:180:0.1", "--plane=0:90:0.1")
    because = ("--elevation and --plane make 1622701 positions", "at most 1000000", "larger steps")
    refuses("solve", *sweep, because=because)


@pytest.mark.parametrize(
    ("words", "patterns"),
    [
        (("--elevation=0:90:5",), ("--plane is missing",)),
        (("--plane=0:90:5",), ("--elevation is missing",)),
        (("--elevation=0:90:5", "--plane=4O"), ("--plane '4O'", "such as")),
        (("--elevation=0:90:5", "--plane=0", "--json"), ("--json", "CSV", "omit --json")),
        (("--elevation=0:90:5", "--plane=0", "--in", "-"), ("--in", "exclude")),
        (("--elevation=60", "--plane=0", "--axial=0:10:5"), ("--axial '0:10:5'", "such as")),
        (("--elevation=60", "--plane=0", "--shrug=0:10:5"), ("--shrug '0:10:5'", "such as")),
    ],
)
def test_a_sweep_that_contradicts_the_rest_is_refused(
    refuses: Refuses, words: tuple[str, ...], patterns: tuple[str, ...]
) -> None:
    refuses("solve", *words, because=patterns, stdin=b"elevation_deg,plane_deg\n60,30\n")
