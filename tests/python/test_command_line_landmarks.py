# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle solve --landmarks` as a person types it: where the bones' landmarks are."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from conftest import TWELVE_DIGITS, Girdle, Refuses

DATA = Path(__file__).resolve().parents[2] / "data"

# In the order of the output.
POINTS = ["elbow", "sc", "pac", "ts", "ai", "aa", "pc", "acj", "gc", "gh", "em", "el"]
COLUMNS = [f"{point}_{axis}_mm" for point in POINTS for axis in "xyz"]

# Two implementations in double precision, of bones of some hundred millimeters.
AGREEMENT_MM = 1e-9
# Text for people is rounded to six decimals.
TEXT_MM = 0.5e-6 + AGREEMENT_MM

POSES = [(60.0, 0.0, 0.0), (23.0, 50.0, 0.0), (150.0, 110.0, 20.0), (0.0, -40.0, -15.0)]

Vector = npt.NDArray[np.float64]


def turn(axis: int, angle_deg: float) -> npt.NDArray[np.float64]:
    """The matrix of a turn about a coordinate axis."""
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    matrix = np.eye(3)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    matrix[j, j] = matrix[k, k] = c
    matrix[j, k], matrix[k, j] = -s, s
    return matrix


def turned(angles_deg: dict[str, float], joint: str, sequence: str) -> npt.NDArray[np.float64]:
    first, second, third = (
        turn("xyz".index(axis), angle_deg)
        for axis, (name, angle_deg) in zip(
            sequence,
            ((n, a) for n, a in angles_deg.items() if n.startswith(f"{joint}_")),
            strict=True,
        )
    )
    return first @ second @ third


def expected_mm(angles_deg: dict[str, float]) -> dict[str, Vector]:
    """Bones hung from each other by ISB's sequences, from the file of landmarks."""
    lines = [line for line in (DATA / "landmarks.csv").read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    own_mm = {row["landmark"]: 1e3 * np.array([float(row[f"{axis}_m"]) for axis in "xyz"]) for row in rows}
    R_TC = turned(angles_deg, "sc", "yxz")
    R_TS = R_TC @ turned(angles_deg, "ac", "yxz")
    R_TH = R_TS @ turned(angles_deg, "gh", "xzy")
    p_TC = own_mm["SC"]
    p_TS = p_TC + R_TC @ own_mm["PAC"]
    p_TH = p_TS + R_TS @ own_mm["GH"]
    place = {
        "thorax": (np.eye(3), np.zeros(3)),
        "clavicle": (R_TC, p_TC),
        "scapula": (R_TS, p_TS),
        "humerus": (R_TH, p_TH),
    }
    points_mm = {
        row["landmark"].lower(): place[row["segment"]][1] + place[row["segment"]][0] @ own_mm[row["landmark"]]
        for row in rows
    }
    points_mm["elbow"] = (points_mm["em"] + points_mm["el"]) / 2
    return {point: points_mm[point] for point in POINTS}


@pytest.mark.parametrize(("elevation", "plane", "shrug"), POSES)
def test_landmarks_are_where_bones_hung_from_each_other_have_them(
    girdle_fine: Girdle, elevation: float, plane: float, shrug: float
) -> None:
    pose = ("--elevation", str(elevation), "--plane", str(plane), "--shrug", str(shrug))
    answer = json.loads(girdle_fine("solve", *pose, "--landmarks", "--json").text)
    expected = expected_mm(answer["angles_deg"])
    assert list(answer["landmarks_mm"]) == POINTS
    for point in POINTS:
        assert answer["landmarks_mm"][point] == pytest.approx(expected[point], abs=AGREEMENT_MM)


def test_the_relaxed_shoulder_has_its_landmarks_too(girdle_fine: Girdle) -> None:
    answer = json.loads(girdle_fine("solve", "--posture", "relaxed", "--landmarks", "--json").text)
    expected = expected_mm(answer["angles_deg"])
    for point in POINTS:
        assert answer["landmarks_mm"][point] == pytest.approx(expected[point], abs=AGREEMENT_MM)


def test_a_table_has_the_columns_of_one_pose_behind_its_others(girdle_fine: Girdle) -> None:
    command = ("solve", "--elevation", "15:45:15", "--plane", "10", *TWELVE_DIGITS)
    text = girdle_fine(*command, "--landmarks").text
    without = girdle_fine(*command).text
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == without.splitlines()[0].split(",") + COLUMNS
    for row in rows:
        pose = ("--elevation", row["elevation_deg"], "--plane", "10", "--landmarks", "--json")
        one = json.loads(girdle_fine("solve", *pose).text)["landmarks_mm"]
        expected = [coordinate for point in POINTS for coordinate in one[point]]
        assert [float(row[column]) for column in COLUMNS] == pytest.approx(expected, abs=AGREEMENT_MM)


@pytest.mark.parametrize("pose", [("--elevation", "80", "--plane", "5"), ("--posture", "relaxed")])
def test_the_text_for_people_has_every_landmark(girdle_fine: Girdle, pose: tuple[str, ...]) -> None:
    text = girdle_fine("solve", *pose, "--landmarks").text
    found = re.findall(r"^(\w+) +(-?[\d.]+) +(-?[\d.]+) +(-?[\d.]+)$", text, re.MULTILINE)
    expected = json.loads(girdle_fine("solve", *pose, "--landmarks", "--json").text)["landmarks_mm"]
    assert [point for point, *_ in found] == POINTS
    for point, *numbers in found:
        assert [float(number) for number in numbers] == pytest.approx(expected[point], abs=TEXT_MM)


def test_a_longer_humerus_takes_the_elbow_along_and_no_other_bone(girdle_fine: Girdle) -> None:
    pose = ("solve", "--elevation", "70", "--plane", "30", "--landmarks", "--json")
    adult, longer = (
        {point: np.array(p) for point, p in json.loads(girdle_fine(*words).text)[key].items()}
        for key, words in (
            ("landmarks_mm", pose),
            ("landmarks_mm", (*pose, "--humerus-length", "0.33")),
        )
    )
    assert np.linalg.norm(longer["elbow"] - longer["gh"]) == pytest.approx(330, abs=AGREEMENT_MM)
    assert longer["gh"] == pytest.approx(adult["gh"], abs=AGREEMENT_MM)
    assert longer["ai"] == pytest.approx(adult["ai"], abs=AGREEMENT_MM)


@pytest.mark.parametrize(
    "whose",
    [("--stature", "1.8"), ("--anatomy", "mine.csv"), ("--ellipsoids", "mine.csv")],
    ids=lambda whose: whose[0],
)
@pytest.mark.parametrize(
    "pose",
    [
        ("--elevation", "60", "--plane", "0"),
        ("--elevation", "0:90:30", "--plane", "0"),
        ("--posture", "relaxed"),
    ],
)
def test_a_person_without_landmarks_to_print_is_refused(
    refuses: Refuses, pose: tuple[str, ...], whose: tuple[str, ...]
) -> None:
    refuses("solve", *pose, *whose, because=("change no angle", "Add --landmarks"))


def test_a_stature_that_nobody_has_is_refused(refuses: Refuses) -> None:
    pose = ("--elevation", "60", "--plane", "0", "--landmarks")
    refuses("solve", *pose, "--stature", "17.1", because=("--stature", "17.1"))


@pytest.mark.parametrize("column", COLUMNS)
def test_an_input_with_a_column_of_the_output_is_refused(refuses: Refuses, column: str) -> None:
    poses = f"elevation_deg,plane_deg,{column}\n60,0,1\n".encode()
    because = (f"standard input:1: column '{column}' would be there twice",)
    refuses("solve", "--in", "-", "--landmarks", because=because, stdin=poses)
