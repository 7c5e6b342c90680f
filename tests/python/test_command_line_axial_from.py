# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Axial turns counted from ISB's zero or the swing's, as a person types them."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import numpy as np
import pytest
from conftest import Girdle, Refuses
from documents import Document
from reference_rhythm import Array, Position, multiply
from reference_smooth import isb_humerus, turned

MEASURED = ("--table", "measured")

# Angles through a few quaternions.
ROUNDING_DEG = 1e-9
# Splines pass through a table's position to rounding; the arc tangent of its arm costs a little.
TABLE_DEG = 1e-6


def third_angle_and_plane_deg(p: Position) -> float:
    """The sum of a and c of the table's own arm, R = Y(a) X(b) Y(c), from its matrix.

    The second column of R is (sin a sin b, cos b, cos a sin b), its second row (sin b sin c, cos b,
    -sin b cos c), and sin b is negative.
    """
    q_TH = multiply(multiply(p.rotation("sc"), p.rotation("ac")), p.rotation("gh"))[:, np.newaxis]
    columns = [turned(q_TH, np.eye(3)[:, [n]])[:, 0] for n in range(3)]
    first = np.arctan2(-columns[1][0], -columns[1][2])
    third = np.arctan2(-columns[0][1], columns[2][1])
    return float(np.degrees(first + third))


@pytest.mark.parametrize("plane_deg", [0.0, 40.0, 90.0])
def test_isbs_axial_rotation_follows_from_the_published_table(
    girdle_fine: Girdle, database: list[Position], plane_deg: float
) -> None:
    """At elevation 60; exact closure points to the plane itself, so that the sum is the same."""
    (position,) = (p for p in database if (p.elevation_deg, p.plane_deg) == (60.0, plane_deg))
    expected_deg = third_angle_and_plane_deg(position) - plane_deg
    pose = ("--elevation", "60", "--plane", str(plane_deg), *MEASURED, "--json")
    used = json.loads(girdle_fine("solve", *pose).text)["used"]
    difference_deg = (used["axial_isb_deg"] - expected_deg + 180.0) % 360.0 - 180.0
    assert abs(difference_deg) < TABLE_DEG
    assert used["axial_deg"] == 0.0


def test_a_pose_with_isbs_angle_has_it(girdle_fine: Girdle) -> None:
    pose = ("--elevation", "60", "--plane", "40", "--axial", "-30", "--axial-from", "isb")
    answer = json.loads(girdle_fine("solve", *pose, "--json").text)
    assert answer["axial_deg"] == -30.0
    assert answer["axial_from"] == "isb"
    assert answer["clamped"] is False
    assert answer["used"]["axial_isb_deg"] == pytest.approx(-30.0, abs=ROUNDING_DEG)
    # From the rhythm's own turn, the same pose.
    turn = repr(answer["used"]["axial_deg"])
    other = json.loads(
        girdle_fine("solve", "--elevation", "60", "--plane", "40", "--axial", turn, "--json").text
    )
    assert other["axial_from"] == "rhythm"
    assert other["angles_deg"] == pytest.approx(answer["angles_deg"], abs=ROUNDING_DEG)
    text = girdle_fine("solve", *pose).text
    assert "clamped" not in text
    found = re.search(r"^axial +(\S+) deg from the rhythm's own turn, ISB (\S+) deg$", text, re.MULTILINE)
    assert found
    assert float(found[1]) == pytest.approx(answer["used"]["axial_deg"], abs=1e-6)
    assert float(found[2]) == -30.0


def test_the_rhythms_own_turn_is_what_no_axial_turn_says(girdle_fine: Girdle) -> None:
    answer = json.loads(girdle_fine("solve", "--elevation", "60", "--plane", "40", "--json").text)
    assert answer["used"]["axial_deg"] == 0.0
    own = repr(answer["used"]["axial_isb_deg"])
    pose = ("--elevation", "60", "--plane", "40", "--axial", own, "--axial-from", "isb", "--json")
    again = json.loads(girdle_fine("solve", *pose).text)
    assert again["used"]["axial_deg"] == pytest.approx(0.0, abs=ROUNDING_DEG)
    assert again["angles_deg"] == pytest.approx(answer["angles_deg"], abs=ROUNDING_DEG)


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def test_a_file_has_its_column_counted_from_isb(girdle_fine: Girdle) -> None:
    poses = b"elevation_deg,plane_deg,axial_deg\n60,40,-30\n100,90,-80\n0,-120,60\n"
    rows = rows_of(girdle_fine("solve", "--in", "-", "--axial-from", "isb", stdin=poses).text)
    for row in rows:
        assert row["clamped"] == "0"
    assert [float(row["used_axial_isb_deg"]) for row in rows[:2]] == pytest.approx(
        [-30.0, -80.0], abs=ROUNDING_DEG
    )
    # An option for all rows says the same as a column.
    same = rows_of(
        girdle_fine(
            "solve",
            "--in",
            "-",
            "--axial-from",
            "isb",
            "--axial",
            "-30",
            stdin=b"elevation_deg,plane_deg\n60,40\n",
        ).text
    )
    assert same[0]["gh_axial_deg"] == rows[0]["gh_axial_deg"]
    swept = rows_of(
        girdle_fine(
            "solve", "--elevation", "60:70:10", "--plane", "40", "--axial", "-30", "--axial-from", "isb"
        ).text
    )
    assert swept[0]["gh_axial_deg"] == rows[0]["gh_axial_deg"]


def humerus(row: dict[str, str]) -> Array:
    """q_TH, from the direction asked for and ISB's angle answered."""
    names = ("elevation_deg", "plane_deg", "used_axial_isb_deg")
    return isb_humerus(*(np.array([float(row[name])]) for name in names))[:, 0]


def test_the_swings_turn_is_one_humerus_straight_up(girdle_fine: Girdle) -> None:
    sweep = ("--elevation", "180", "--plane", "0:90:10", "--axial")
    own = rows_of(girdle_fine("solve", *sweep, "0").text)
    swung = rows_of(girdle_fine("solve", *sweep, "-50", "--axial-from", "swing").text)
    for rows, spins in ((own, True), (swung, False)):
        apart_deg = np.degrees(2 * np.arccos(min(1.0, abs(humerus(rows[0]) @ humerus(rows[-1])))))
        assert (apart_deg > 120.0) == spins
        assert spins or apart_deg < 1e-5


# --- What is refused -----------------------------------------------------------------------------

POSE = ("--elevation", "60", "--plane", "40")


@pytest.mark.parametrize(
    ("words", "because"),
    [
        ((*POSE, "--axial", "0", "--axial-from", "ulna"), ("--axial-from ulna", "rhythm, isb, swing")),
        ((*POSE, "--axial-from", "isb"), ("--axial-from isb", "Add --axial")),
        (("--elevation", "0:90:5", "--plane", "0", "--axial-from", "isb"), ("no axial turn", "Add --axial")),
        (("--posture", "relaxed", "--axial-from", "isb"), ("--posture gives the whole arm", "Omit")),
    ],
)
def test_a_zero_without_a_turn_or_of_an_unknown_name_is_refused(
    refuses: Refuses, words: tuple[str, ...], because: tuple[str, ...]
) -> None:
    refuses("solve", *words, because=because)


def test_a_file_without_the_column_is_refused(refuses: Refuses) -> None:
    refuses(
        "solve", "--in", "-", "--axial-from", "isb",
        because=("standard input:1: --axial-from isb", "Add the column axial_deg"),
        stdin=b"elevation_deg,plane_deg\n60,40\n",
    )  # fmt: skip


@pytest.mark.parametrize(
    "column", ["axial_rotation_deg", "axial_isb_deg", "external_rotation_deg", "Humeral rotation"]
)
def test_a_column_that_plainly_is_the_axial_turn_is_refused_by_every_verb(
    refuses: Refuses, model_path: Path, tmp_path: Path, column: str
) -> None:
    (tmp_path / "arm.csv").write_text(f"time_s,elevation_deg,plane_deg,{column}\n0,20,40,1\n1,60,40,1\n")
    because = (f"arm.csv:1: column '{column}' is not known. Did you mean 'axial_deg'", "--axial-from isb")
    refuses("solve", "--in", "arm.csv", "--out", "angles.csv", because=because)
    words = ("simulate", model_path, "--in", "arm.csv", "--out", "trace.csv")
    refuses(*words, because=because)


def test_a_motion_without_the_column_is_refused(refuses: Refuses, model_path: Path, tmp_path: Path) -> None:
    (tmp_path / "arm.csv").write_text("time_s,elevation_deg,plane_deg\n0,20,40\n1,60,40\n")
    words = ("simulate", model_path, "--in", "arm.csv", "--axial-from", "isb", "--out", "t.csv")
    refuses(*words, because=("arm.csv:1: --axial-from isb: no axial turn", "Add the column axial_deg"))


def test_what_solve_answered_is_a_motion(girdle_fine: Girdle, model_path: Path, tmp_path: Path) -> None:
    """Its columns about axial turns are those of the answer, and of bones."""
    poses = b"time_s,elevation_deg,plane_deg\n0,20,40\n0.01,21,40\n"
    girdle_fine("solve", "--in", "-", "--out", "solved.csv", stdin=poses)
    girdle_fine("simulate", model_path, "--in", "solved.csv")


def test_the_tally_says_what_axial_turns_count_from(girdle: Girdle, model_path: Path, tmp_path: Path) -> None:
    rows = "time_s,elevation_deg,plane_deg,axial_deg\n0,60,40,-40\n0.01,60,40,-40\n"
    (tmp_path / "arm.csv").write_text(rows)
    (tmp_path / "isb.csv").write_text(rows.replace(",60,", ",-60,"))
    simulate = ("simulate", model_path, "--in")
    for words, zero in (
        (("solve", "--in", "arm.csv"), "rhythm"),
        (("solve", "--in", "arm.csv", "--axial-from", "swing"), "swing"),
        (("solve", "--in", "isb.csv", "--convention", "isb"), "isb"),
        (("solve", "--elevation=60:70:10", "--plane=40", "--axial=3"), "rhythm"),
        ((*simulate, "arm.csv"), "rhythm"),
        ((*simulate, "isb.csv", "--convention", "isb"), "isb"),
    ):
        assert girdle(*words).message.endswith(f" modelled, axial from {zero}\n"), words
    none = girdle("solve", "--elevation=60:70:10", "--plane=40")
    assert none.message.endswith(" modelled\n")


def test_a_raise_has_no_turn_to_count(refuses: Refuses, model_path: Path) -> None:
    refuses(
        "simulate", str(model_path), "--elevation", "0:90", "--axial-from", "isb",
        because=("--axial-from says how the column axial_deg of a motion is read", "Give --in FILE"),
    )  # fmt: skip


def test_the_documents_numbers_are_those_of_solve(girdle_fine: Girdle) -> None:
    found = re.search(
        r"axial rotation of (-?\d+) at \(elevation (\d+), plane (\d+)\) and (-?\d+) at \((\d+), (\d+)\)",
        Document("generator/kinematics/README.md").prose,
    )
    assert found
    for axial, elevation, plane in (found.groups()[:3], found.groups()[3:]):
        pose = ("--elevation", elevation, "--plane", plane, "--json")
        used = json.loads(girdle_fine("solve", *pose).text)["used"]
        assert round(used["axial_isb_deg"]) == int(axial)


@pytest.mark.parametrize("said", [(), ("--axial-from", "isb")])
def test_isbs_convention_means_isbs_axial_rotation(girdle_fine: Girdle, said: tuple[str]) -> None:
    pose = ("--plane", "40", "--axial", "-30", "--json")
    written = girdle_fine("solve", "--convention", "isb", "--elevation", "-60", *pose, *said)
    answer = json.loads(written.text)
    assert answer["axial_from"] == "isb"
    assert answer["used"]["axial_isb_deg"] == pytest.approx(-30.0, abs=ROUNDING_DEG)


def test_isbs_convention_with_an_axial_rotation_from_the_rhythm(girdle_fine: Girdle) -> None:
    words = ("--convention", "isb", "--elevation", "-60", "--plane", "40", "--axial", "-30")
    answer = json.loads(girdle_fine("solve", *words, "--axial-from", "rhythm", "--json").text)
    assert answer["axial_from"] == "rhythm"
    assert answer["used"]["axial_deg"] == pytest.approx(-30.0, abs=ROUNDING_DEG)


def test_a_file_of_isbs_angles_comes_out_as_it_went_in(girdle_fine: Girdle) -> None:
    poses = b"elevation_deg,plane_deg,axial_deg\n-60,40,-30\n-100,10,-60\n"
    text = girdle_fine("solve", "--convention", "isb", "--in", "-", stdin=poses).text
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [row["clamped"] for row in rows] == ["0", "0"]
    for row in rows:
        assert float(row["used_axial_isb_deg"]) == pytest.approx(float(row["axial_deg"]), abs=1e-9)
        assert float(row["used_elevation_deg"]) == pytest.approx(-float(row["elevation_deg"]))


def test_isbs_convention_without_an_axial_rotation_has_the_rhythms_own_turn(
    girdle_fine: Girdle,
) -> None:
    pose = ("--plane", "40", "--json")
    isb = json.loads(girdle_fine("solve", "--convention", "isb", "--elevation", "-60", *pose).text)
    assert isb == json.loads(girdle_fine("solve", "--elevation", "60", *pose).text)
