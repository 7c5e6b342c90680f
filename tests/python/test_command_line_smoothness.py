# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle smoothness` as a person types it: how smooth interpolations are, what a rhythm keeps."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ABOVE_TOLERANCE, Girdle, Refuses, RunProgram
from reference_rhythm import (
    DATABASE,
    Array,
    ReferenceRhythm,
    inverse,
    log,
    multiply,
    read_database,
)
from reference_smooth import SmoothRhythm as ReferenceSmooth

PUBLISHED = ("--interpolation", "squad", "--closure", "table")
JOINTS = ("SC", "AC", "GH")

# One-sided differences of the reference are good to this (deg/deg).
DIFFERENCE = 1e-3

Answer = dict[str, Any]
Measure = Callable[..., Answer]


@pytest.fixture(scope="module")
def measure(run_program: RunProgram) -> Measure:
    """The answer to some options, measured once."""
    answers: dict[tuple[str, ...], Answer] = {}

    def run(*options: str) -> Answer:
        if options not in answers:
            answers[options] = json.loads(run_program("smoothness", *options, "--json"))
        return answers[options]

    return run


def jumps(answer: Answer, joint: str, order: str) -> dict[tuple[str, str], float]:
    return {(row["interpolation"], row["over"]): row[joint][order] for row in answer["jumps"]}


# --- Interpolations ------------------------------------------------------------------------------


def test_every_interpolation_is_measured_over_both(measure: Measure) -> None:
    rows = [(row["interpolation"], row["over"]) for row in measure()["jumps"]]
    assert rows == [
        (interpolation, over)
        for interpolation in ("slerp", "squad", "smooth")
        for over in ("elevation", "plane")
    ]


@pytest.mark.parametrize("joint", JOINTS)
def test_smooth_jumps_by_rounding_alone(measure: Measure, joint: str) -> None:
    for order, rounding in (("velocity_deg_per_deg", 1e-9), ("acceleration_deg_per_deg2", 1e-7)):
        found = jumps(measure(), joint, order)
        assert max(found["smooth", over] for over in ("elevation", "plane")) < rounding


@pytest.mark.parametrize("joint", JOINTS)
def test_squad_has_a_kink_over_planes_and_slerp_over_both(measure: Measure, joint: str) -> None:
    """Over evenly spaced knots, which elevations are, squad's velocity is continuous."""
    found = jumps(measure(), joint, "velocity_deg_per_deg")
    assert found["squad", "elevation"] < 1e-9
    assert found["squad", "plane"] > 0.01
    assert found["slerp", "elevation"] > 0.1
    assert found["slerp", "plane"] > 0.1
    assert jumps(measure(), joint, "acceleration_deg_per_deg2")["squad", "elevation"] > 0.01


def jump_of_the_reference(
    reference: ReferenceRhythm, joint: str, interpolation: Any, plane_deg: float
) -> float:
    """The largest jump of velocity over inner elevations in a plane, by differences."""
    h = 1e-4

    def velocity(elevation_deg: float, step_deg: float) -> Array:
        q = [
            reference.solve(elevation_deg + n * step_deg, plane_deg, interpolation).rotations[joint]
            for n in range(3)
        ]
        once, twice = (2.0 * log(multiply(other, inverse(q[0]))) for other in q[1:])
        return np.degrees(4.0 * once - twice) / (2.0 * step_deg)

    inner = reference.elevations_deg[1:-1]
    return max(float(np.linalg.norm(velocity(e, h) - velocity(e, -h))) for e in inner)


@pytest.mark.parametrize("interpolation", ["slerp", "squad"])
@pytest.mark.parametrize("joint", ["sc", "ac", "gh"])
def test_no_plane_of_the_reference_jumps_by_more(
    measure: Measure, reference: ReferenceRhythm, joint: str, interpolation: str
) -> None:
    """And one of a few planes by nearly as much; the largest may be between them."""
    found = jumps(measure(), joint.upper(), "velocity_deg_per_deg")[interpolation, "elevation"]
    planes_deg = (0.5, 20.5, 40.5, 89.5)
    expected = max(jump_of_the_reference(reference, joint, interpolation, p) for p in planes_deg)
    assert expected < found + DIFFERENCE
    assert found < 2 * expected + DIFFERENCE


def test_unless_told_otherwise_the_measured_tables_jumps_are_shown(girdle: Girdle, measure: Measure) -> None:
    """Of its checks one fails: how fast the bones turn where it is steep and the arm behind."""
    by_name, by_file = (
        json.loads(girdle("smoothness", "--table", table, "--json").text) for table in ("measured", DATABASE)
    )
    assert by_name.pop("rhythm").endswith(", table measured")
    assert by_file.pop("rhythm").endswith(f", table {DATABASE}")
    assert by_name == by_file
    assert by_name["jumps"] == measure()["jumps"]
    assert measure("--table", "smoothed")["jumps"] != measure()["jumps"]


# --- On a skin -----------------------------------------------------------------------------------

SKIN = ("--skin", "implicit")
# Differences of places in double precision are good to this (mm/deg).
ROUNDING_MM = 1e-6


def skin_jumps(answer: Answer, figure: str) -> dict[tuple[str, str], float]:
    return {(row["interpolation"], row["over"]): row[figure] for row in answer["skin"]["jumps"]}


def test_every_interpolation_is_measured_on_the_same_skin(measure: Measure) -> None:
    skin = measure(*SKIN)["skin"]
    interpolations = ["slerp", "squad", "smooth"]
    assert [(row["interpolation"], row["over"]) for row in skin["jumps"]] == [
        (interpolation, over) for interpolation in interpolations for over in ("elevation", "plane")
    ]
    assert [row["interpolation"] for row in skin["steps"]] == interpolations
    for row in (*skin["jumps"], *skin["steps"]):
        assert row["where"].startswith(("skin_ac, elevation ", "skin_acromion, elevation "))
        assert row["ac_skin_mm_per_deg"] > 0


def test_squads_jump_of_the_skin_over_elevation_is_no_hundredth_of_slerps(
    measure: Measure,
) -> None:
    """Squad is as smooth over elevation as published; what is left is rounding."""
    found = skin_jumps(measure(*SKIN), "ac_skin_mm_per_deg")
    assert found["slerp", "elevation"] > 0.5
    assert found["squad", "elevation"] < 0.01 * found["slerp", "elevation"]
    assert found["squad", "elevation"] < ROUNDING_MM


def test_squad_and_slerp_jump_in_the_skin_over_plane_and_smooth_nowhere(measure: Measure) -> None:
    for figure in ("ac_skin_mm_per_deg", "all_mm_per_deg"):
        found = skin_jumps(measure(*SKIN), figure)
        assert 0.05 < found["squad", "plane"] < found["slerp", "plane"]
        assert found["smooth", "plane"] < ROUNDING_MM
        assert found["smooth", "elevation"] < ROUNDING_MM


def test_no_interpolation_is_half_as_large_a_step_as_another(measure: Measure) -> None:
    """They meet at the table's rows, between which the skin goes as far."""
    steps = [row["ac_skin_mm_per_deg"] for row in measure(*SKIN)["skin"]["steps"]]
    assert 0.2 < min(steps) < max(steps) < 2 * min(steps)


def test_all_landmarks_jump_by_no_less_than_those_over_the_joint(measure: Measure) -> None:
    answer = measure(*SKIN)
    over_joint, everywhere = (
        skin_jumps(answer, figure) for figure in ("ac_skin_mm_per_deg", "all_mm_per_deg")
    )
    assert all(over_joint[key] <= everywhere[key] for key in over_joint)
    assert everywhere["slerp", "elevation"] > over_joint["slerp", "elevation"]


@pytest.mark.numbers
def test_the_skins_jump_is_that_of_a_model_that_moves_so(
    measure: Measure, girdle: Girdle, girdle_fine: Girdle
) -> None:
    """What verify finds on a model made with the same table, interpolation and skin."""
    slerp = ("--interpolation", "slerp", "--closure", "table")
    girdle_fine("generate", *SKIN, *slerp, "--out", "model")
    report = json.loads(girdle("verify", "model/scene.xml", "--json").text)
    found = skin_jumps(measure(*SKIN), "ac_skin_mm_per_deg")
    for over in ("elevation", "plane"):
        item = f"jump of AC skin over {over} knots, linear blend"
        (line,) = (r for r in report["residuals"] if r["item"] == item)
        # The skin of a model is stored in single precision.
        assert found["slerp", over] == pytest.approx(line["value"], rel=1e-5)


@pytest.mark.numbers
def test_the_skin_moves_by_the_table_that_is_said(measure: Measure) -> None:
    other = skin_jumps(measure(*SKIN, "--table", "smoothed"), "ac_skin_mm_per_deg")
    assert (
        other["slerp", "elevation"] < skin_jumps(measure(*SKIN), "ac_skin_mm_per_deg")["slerp", "elevation"]
    )


def test_without_a_skin_nothing_is_said_of_one_and_all_else_is_the_same(measure: Measure) -> None:
    with_skin = dict(measure(*SKIN))
    del with_skin["skin"]
    assert with_skin == measure()


def test_the_text_has_the_skins_lines_of_the_json(girdle_fine: Girdle, measure: Measure) -> None:
    text = girdle_fine("smoothness", *SKIN).text
    skin = measure(*SKIN)["skin"]
    for row in skin["jumps"]:
        (line,) = re.findall(rf"^{row['interpolation']} +{row['over']} .* skin_.*", text, re.MULTILINE)
        numbers = [float(word) for word in line.split()[2:4]]
        expected = [row["ac_skin_mm_per_deg"], row["all_mm_per_deg"]]
        assert numbers == pytest.approx(expected, rel=0.051), line
        assert line.endswith(f"  {row['where']}")
    for row in skin["steps"]:
        (line,) = re.findall(rf"^{row['interpolation']} +a degree .*", text, re.MULTILINE)
        assert float(line.split()[3]) == pytest.approx(row["ac_skin_mm_per_deg"], rel=0.051), line


@pytest.mark.parametrize(
    ("options", "because"),
    [
        (("--skin", "elsewhere"), ("--skin 'elsewhere'", "implicit")),
        (("--head", "cut"), ("--head cut", "add --skin")),
    ],
)
def test_a_skin_that_is_none_is_refused(
    refuses: Refuses, options: tuple[str, ...], because: tuple[str, ...]
) -> None:
    refuses("smoothness", *options, because=because)


# --- Checks of the rhythm ------------------------------------------------------------------------

RHYTHMS: dict[str, tuple[tuple[str, ...], str]] = {
    "default": ((), "interpolation smooth, closure exact, range whole, table smoothed"),
    "clamp": (("--range", "clamp"), "interpolation smooth, closure exact, range clamp, table smoothed"),
    "table": (("--closure", "table"), "interpolation smooth, closure table, range clamp, table smoothed"),
    "published": (PUBLISHED, "interpolation squad, closure table, range clamp, table measured"),
    "squad, exact": (
        ("--interpolation", "squad"),
        "interpolation squad, closure exact, range clamp, table measured",
    ),
}


@pytest.mark.parametrize(("options", "rhythm"), RHYTHMS.values(), ids=RHYTHMS.keys())
def test_the_checks_of_a_rhythm_pass(measure: Measure, options: tuple[str, ...], rhythm: str) -> None:
    answer = measure(*options)
    assert answer["rhythm"] == rhythm
    assert answer["passed"] is True
    for check in answer["checks"]:
        assert check["passed"] is True
        assert check["below"] is None or 0 <= check["value"] < check["below"], check


def test_what_the_humerus_spins_straight_up_is_stated(measure: Measure) -> None:
    """From plane 0 to 90, by the twist of the reference: straight up the humerus is tau - 2 psi."""
    positions = read_database(DATABASE.parent / "ludewig2009_smoothed.csv")
    upright, planes = np.radians([180.0, 180.0]), np.radians([0.0, 90.0])
    first, last = np.degrees(ReferenceSmooth(positions).whole_tau(upright, planes))
    spin_deg = abs((last - 180.0) - first)
    checks = {check["name"]: check for check in measure()["checks"]}
    stated = checks["humerus at 180, turned from plane 0"]
    assert stated["below"] is None
    assert stated["value"] == pytest.approx(spin_deg, abs=1e-6)
    assert stated["where"] == "elevation 180, plane 90"
    assert round(spin_deg) == 121
    assert checks["humerus at 180, axial from swing, plane to plane"]["value"] < 1e-9


def names(answer: Answer) -> list[str]:
    return [check["name"] for check in answer["checks"]]


def test_what_a_rhythm_does_not_promise_is_not_checked(measure: Measure) -> None:
    whole, clamp, published = measure(), measure("--range", "clamp"), measure(*PUBLISHED)
    assert set(names(published)) < set(names(clamp)) < set(names(whole))
    assert {"elevation reached - commanded", "plane reached - commanded"} <= set(names(clamp))
    assert not [name for name in names(published) if "commanded" in name or "jump" in name]
    only_whole = set(names(whole)) - set(names(clamp))
    assert any("where the table ends" in name for name in only_whole)
    assert any("at 180" in name for name in only_whole)


def test_a_rhythm_that_leaves_the_joints_ranges_fails(girdle: Girdle, tmp_path: Path) -> None:
    header, *rows = (
        line.split(",") for line in DATABASE.read_text().splitlines() if not line.startswith("#")
    )
    row = next(row for row in rows if row[:2] == ["40", "60"])
    row[header.index("sc_rotation_deg")] = "60"
    lines = "".join(",".join(row) + "\n" for row in (header, *rows))
    (tmp_path / "mine.csv").write_text(lines)
    finished = girdle("smoothness", "--table", "mine.csv", "--json")
    assert (finished.code, finished.message) == (ABOVE_TOLERANCE, "")
    answer = json.loads(finished.text)
    assert answer["passed"] is False
    (outside,) = [c for c in answer["checks"] if c["name"] == "joint out of its range"]
    assert outside["passed"] is False
    # The range ends at 55; between the knots the spline goes a little further.
    assert 5 <= outside["value"] < 6
    found = re.fullmatch(r"elevation (\S+), plane (\S+)", outside["where"])
    assert found
    assert math.dist((float(found[1]), float(found[2])), (60, 40)) < 6
    text = girdle("smoothness", "--table", "mine.csv")
    assert text.code == ABOVE_TOLERANCE
    assert re.search(r"^joint out of its range .* FAIL +elevation", text.text, re.MULTILINE)
    assert text.text.endswith("\nsome checks fail\n")


# --- The text ------------------------------------------------------------------------------------


def test_the_text_has_the_lines_of_the_json(girdle_fine: Girdle, measure: Measure) -> None:
    answer = measure()
    text = girdle_fine("smoothness").text
    assert re.search(r"^interpolations compared on the table measured$", text, re.MULTILINE)
    assert f"\nrhythm  {answer['rhythm']}\n" in text
    for row in answer["jumps"]:
        start = f"{row['interpolation']} +{row['over']}"
        (line,) = re.findall(rf"^{start} .*", text, re.MULTILINE)
        numbers = [float(word) for word in line.split()[2:]]
        expected = [
            row[joint][order]
            for order in ("velocity_deg_per_deg", "acceleration_deg_per_deg2")
            for joint in JOINTS
        ]
        # Two significant digits.
        assert numbers == pytest.approx(expected, rel=0.051), line
    for check in answer["checks"]:
        pattern = rf"^{re.escape(check['name'])} +\S+ +\S+  {re.escape(check['unit'])} .*(pass|stated) .*"
        assert len(re.findall(pattern, text, re.MULTILINE)) == 1, check["name"]
    assert text.endswith("\nall checks pass\n")


@pytest.mark.numbers
def test_two_runs_give_the_same_bytes(girdle_fine: Girdle) -> None:
    first, second = (girdle_fine("smoothness", *PUBLISHED).output for _ in range(2))
    assert first == second


# --- What is refused -----------------------------------------------------------------------------


def test_an_absent_table_is_refused(refuses: Refuses) -> None:
    refuses("smoothness", "--table", "absent.csv", because=("absent.csv: ", "Check"))
