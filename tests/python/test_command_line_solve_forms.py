# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The forms in which `girdle solve` writes rotations: of what, as what, since when, how exactly."""

from __future__ import annotations

import csv
import io
import json
import re

import numpy as np
import pytest
from conftest import Girdle, Refuses
from reference_rhythm import (
    COORDINATES,
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    ST_COORDINATES,
    ST_SEQUENCE,
    Array,
    elevation_and_plane_deg,
    euler_from_quaternion,
    inverse,
    multiply,
    quaternion_from_euler,
)

SEED = 20090815

# The sequence and the angles of each rotation that is written as angles.
SEQUENCES = {**JOINT_SEQUENCES, "st": ST_SEQUENCE}
ANGLES = {**JOINT_COORDINATES, "st": ST_COORDINATES}
ROTATIONS = ("sc", "ac", "gh", "st", "ht")

# What goes through sines and arc tangents and back.
ROUNDING_DEG = 1e-9
ROUNDING = 1e-11

ALL_DIGITS = ("--digits", "15")

FORMS = ("json", "csv", "text")
every_form = pytest.mark.parametrize("form", FORMS)

POSES = {
    "hanging": ("0", "0"),
    "the paper's example": ("23", "50"),
    "abducted": ("90", "40"),
    "behind the body": ("60", "-80"),
    "across the chest": ("100", "130"),
    "overhead": ("172.5", "15"),
    "turned about its length": ("71.5", "12", "--axial", "-35"),
    "shrugged and protracted": ("45", "60", "--shrug", "20", "--protraction", "-10"),
    "published": ("71.5", "12", "--interpolation", "squad", "--closure", "table"),
}
every_pose = pytest.mark.parametrize("pose", POSES.values(), ids=POSES.keys())


def typed(form: str, pose: tuple[str, ...], *options: str) -> tuple[str, ...]:
    """The command whose answer to a pose has this form, with all digits."""
    elevation, plane, *further = pose
    if form == "csv":
        elevation = f"{elevation}:{elevation}:1"
    words = ("solve", "--elevation", elevation, "--plane", plane, *further, *options)
    return (*words, "--json") if form == "json" else (*words, *ALL_DIGITS)


SINCE = "_since_hanging"


def row_of(text: str) -> dict[str, str]:
    """The row by the names of columns, which say of relative rotations that they are."""
    (row,) = csv.DictReader(io.StringIO(text, newline=""))
    return {name.replace(SINCE, ""): field for name, field in row.items()}


def lines_of_numbers(text: str) -> dict[str, list[float]]:
    """The numbers of each line that is a name and numbers, with or without their unit."""
    lines = re.findall(r"^(\w+) +(-?[\d.e+-]+(?: +-?[\d.e+-]+)*)(?: deg)?$", text, re.MULTILINE)
    return {name: [float(number) for number in numbers.split()] for name, numbers in lines}


def angles_in(form: str, text: str) -> dict[str, float]:
    """All angles of an answer by their names."""
    if form == "json":
        angles_deg: dict[str, float] = json.loads(text)["angles_deg"]
        return angles_deg
    names = [name for names in ANGLES.values() for name in names]
    if form == "csv":
        row = row_of(text)
        return {name: float(row[f"{name}_deg"]) for name in names}
    return {name: numbers[0] for name, numbers in lines_of_numbers(text).items() if name in names}


def quaternions_in(form: str, text: str) -> dict[str, Array]:
    """All quaternions of an answer by their names."""
    if form == "json":
        answer = json.loads(text)["quaternions"]
        return {name: np.array(answer[name]) for name in answer}
    if form == "csv":
        row = row_of(text)
        return {name: np.array([float(row[f"{name}_q{part}"]) for part in "wxyz"]) for name in ROTATIONS}
    lines = lines_of_numbers(text)
    return {name: np.array(lines[name]) for name in ROTATIONS}


def rotation_from(angles_deg: dict[str, float], name: str) -> Array:
    return quaternion_from_euler(SEQUENCES[name], [angles_deg[angle] for angle in ANGLES[name]])


def with_positive_w(q: Array) -> Array:
    return -q if q[0] < 0 else q


def expect_angles(found_deg: dict[str, float], expected: dict[str, Array]) -> None:
    """The angles are those of the rotations, each in the sequence of its joint."""
    for name, sequence in SEQUENCES.items():
        angles_deg = euler_from_quaternion(sequence, expected[name])
        assert [found_deg[angle] for angle in ANGLES[name]] == pytest.approx(
            angles_deg, rel=0, abs=ROUNDING_DEG
        )


# --- The scapula in the thorax -------------------------------------------------------------------


@every_form
@every_pose
def test_the_scapula_in_the_thorax_is_the_clavicle_followed_by_the_ac_joint(
    girdle_fine: Girdle, form: str, pose: tuple[str, ...]
) -> None:
    found_deg = angles_in(form, girdle_fine(*typed(form, pose)).text)
    assert list(found_deg) == [*COORDINATES, *ST_COORDINATES]
    q_TS = multiply(rotation_from(found_deg, "sc"), rotation_from(found_deg, "ac"))
    expected_deg = euler_from_quaternion(ST_SEQUENCE, q_TS)
    scapula_deg = [found_deg[angle] for angle in ST_COORDINATES]
    assert scapula_deg == pytest.approx(expected_deg, rel=0, abs=ROUNDING_DEG)


def test_the_scapula_turns_upward_and_tilts_backward_as_the_arm_is_raised(
    girdle_fine: Girdle,
) -> None:
    """With the signs of the AC joint: upward rotation is negative, posterior tilt positive."""
    low_deg, high_deg = (
        angles_in("json", girdle_fine(*typed("json", (elevation, "40"))).text) for elevation in ("20", "120")
    )
    assert high_deg["st_upward_rotation"] < low_deg["st_upward_rotation"] - 20
    assert high_deg["st_tilt"] > low_deg["st_tilt"]


# --- Quaternions ---------------------------------------------------------------------------------


@every_form
@every_pose
def test_quaternions_are_the_rotations_of_the_angles(
    girdle_fine: Girdle, form: str, pose: tuple[str, ...]
) -> None:
    angles_deg = angles_in("json", girdle_fine(*typed("json", pose)).text)
    found = quaternions_in(form, girdle_fine(*typed(form, pose, "--as", "quaternions")).text)
    assert list(found) == list(ROTATIONS)
    for name in SEQUENCES:
        expected = with_positive_w(rotation_from(angles_deg, name))
        assert found[name] == pytest.approx(expected, rel=0, abs=ROUNDING), name


@every_form
@every_pose
def test_quaternions_have_length_one_and_no_negative_w(
    girdle_fine: Girdle, form: str, pose: tuple[str, ...]
) -> None:
    found = quaternions_in(form, girdle_fine(*typed(form, pose, "--as", "quaternions")).text)
    for name, q in found.items():
        assert np.linalg.norm(q) == pytest.approx(1, rel=0, abs=ROUNDING), name
        assert q[0] >= 0, name


@every_form
@every_pose
def test_the_humerus_in_the_thorax_is_all_three_joints_in_turn(
    girdle_fine: Girdle, form: str, pose: tuple[str, ...]
) -> None:
    found = quaternions_in(form, girdle_fine(*typed(form, pose, "--as", "quaternions")).text)
    q_TH = multiply(multiply(found["sc"], found["ac"]), found["gh"])
    assert found["ht"] == pytest.approx(with_positive_w(q_TH), rel=0, abs=ROUNDING)


@every_form
def test_the_humerus_in_the_thorax_points_where_the_arm_is_told_to(girdle_fine: Girdle, form: str) -> None:
    command = typed(form, ("71.5", "12"), "--as", "quaternions")
    q_TH = quaternions_in(form, girdle_fine(*command).text)["ht"]
    assert elevation_and_plane_deg(q_TH) == pytest.approx((71.5, 12), rel=0, abs=1e-6)


@pytest.mark.parametrize("form", FORMS)
def test_quaternions_take_the_place_of_the_angles_and_of_nothing_else(girdle_fine: Girdle, form: str) -> None:
    angles, degrees, quaternions = (
        girdle_fine(*typed(form, ("60", "50"), *options)).text
        for options in ((), ("--as", "degrees"), ("--as", "quaternions"))
    )
    assert degrees == angles
    if form == "csv":
        rows = [row_of(angles), row_of(quaternions)]
        written = [
            [f"{name}_deg" for name in (*COORDINATES, *ST_COORDINATES)],
            [f"{name}_q{part}" for name in ROTATIONS for part in "wxyz"],
        ]
        assert [list(row)[2 : 2 + len(names)] for row, names in zip(rows, written, strict=True)] == (written)
        rest = [
            {name: row[name] for name in row if name not in names}
            for row, names in zip(rows, written, strict=True)
        ]
    elif form == "json":
        answers = [json.loads(angles), json.loads(quaternions)]
        assert "quaternions" not in answers[0]
        assert "angles_deg" not in answers[1]
        rest = [
            {key: answer[key] for key in answer if key not in ("angles_deg", "quaternions")}
            for answer in answers
        ]
    else:
        rest = [{"above": text.partition("\n\n")[0]} for text in (angles, quaternions)]
        assert "deg" not in quaternions.partition("\n\n")[2]
    assert rest[0] == rest[1]
    assert rest[0]


# --- Since the arm was hanging -------------------------------------------------------------------

SINCE_HANGING = ("--relative-to", "hanging")
AS_QUATERNIONS = ("--as", "quaternions")

WHOLE_POSES = {name: pose for name, pose in POSES.items() if name != "published"}
every_whole_pose = pytest.mark.parametrize("pose", WHOLE_POSES.values(), ids=WHOLE_POSES.keys())


@every_form
@every_whole_pose
def test_a_turn_since_hanging_leads_from_the_hanging_rotation_to_the_pose(
    girdle_fine: Girdle, form: str, pose: tuple[str, ...]
) -> None:
    now, hanging = (
        quaternions_in("json", girdle_fine(*typed("json", of, *AS_QUATERNIONS)).text)
        for of in (pose, ("0", "0"))
    )
    turned = {name: with_positive_w(multiply(inverse(hanging[name]), now[name])) for name in ROTATIONS}
    command = typed(form, pose, *AS_QUATERNIONS, *SINCE_HANGING)
    found = quaternions_in(form, girdle_fine(*command).text)
    for name in ROTATIONS:
        assert found[name] == pytest.approx(turned[name], rel=0, abs=ROUNDING), name
    expect_angles(angles_in(form, girdle_fine(*typed(form, pose, *SINCE_HANGING)).text), turned)


@every_form
def test_the_hanging_arm_has_not_turned_since_it_was_hanging(girdle_fine: Girdle, form: str) -> None:
    command = typed(form, ("0", "0"), *SINCE_HANGING)
    found = quaternions_in(form, girdle_fine(*command, *AS_QUATERNIONS).text)
    for name in ROTATIONS:
        assert found[name] == pytest.approx([1, 0, 0, 0], rel=0, abs=ROUNDING), name
    angles_deg = angles_in(form, girdle_fine(*command).text)
    assert list(angles_deg.values()) == pytest.approx([0] * 12, rel=0, abs=ROUNDING_DEG)


def test_columns_say_that_they_are_relative(girdle_fine: Girdle) -> None:
    for form, last in (((), "_deg"), (AS_QUATERNIONS, "_qw")):
        command = typed("csv", POSES["abducted"], *form)
        absolute = girdle_fine(*command).text.splitlines()[0].split(",")
        relative = girdle_fine(*command, *SINCE_HANGING).text.splitlines()[0].split(",")
        assert [name.replace(SINCE, "") for name in relative] == absolute
        assert f"st_upward_rotation{SINCE}{last}" in relative or f"st{SINCE}{last}" in relative
        joints = [name for name in absolute if name[:3] in ("sc_", "ac_", "gh_", "st_", "ht_")]
        assert len([name for name in relative if SINCE in name]) == len(joints) > 10
        assert not any(SINCE in name for name in absolute)


def test_derivatives_are_not_those_of_relative_angles(refuses: Refuses) -> None:
    because = ("--derivatives", "--relative-to", "Omit one of them")
    refuses("solve", "--elevation", "60", "--plane", "40", *SINCE_HANGING, "--derivatives", because=because)


def test_an_answer_says_that_it_is_relative(girdle_fine: Girdle) -> None:
    pose = ("60", "50")
    assert json.loads(girdle_fine(*typed("json", pose, *SINCE_HANGING)).text)["relative_to"] == ("hanging")
    assert "relative_to" not in json.loads(girdle_fine(*typed("json", pose)).text)
    line = "\nturned since the arm was hanging (modelled)\n"
    assert line in girdle_fine(*typed("text", pose, *SINCE_HANGING)).text
    assert line not in girdle_fine(*typed("text", pose)).text


@every_form
@pytest.mark.parametrize(
    "rhythm",
    [("--range", "clamp"), ("--interpolation", "squad"), ("--closure", "table")],
    ids=" ".join,
)
def test_a_rhythm_that_does_not_reach_the_hanging_arm_has_no_turn_since_then(
    refuses: Refuses, form: str, rhythm: tuple[str, ...]
) -> None:
    because = ("--relative-to hanging", "does not reach the hanging arm", "Omit --range clamp")
    refuses(*typed(form, ("60", "50"), *rhythm, *SINCE_HANGING), because=because)


# --- A posture -----------------------------------------------------------------------------------


def test_a_posture_has_the_scapula_in_the_thorax_as_well(girdle_fine: Girdle) -> None:
    """Clavicle and scapula of standing people: none of the rhythm's hanging arm."""
    posture = ("solve", "--posture", "relaxed")
    found_deg = angles_in("json", girdle_fine(*posture, "--json").text)
    q_TS = multiply(rotation_from(found_deg, "sc"), rotation_from(found_deg, "ac"))
    expected_deg = euler_from_quaternion(ST_SEQUENCE, q_TS)
    assert [found_deg[angle] for angle in ST_COORDINATES] == pytest.approx(
        expected_deg, rel=0, abs=ROUNDING_DEG
    )
    text_deg = angles_in("text", girdle_fine(*posture, *ALL_DIGITS).text)
    assert text_deg == pytest.approx(found_deg, rel=0, abs=ROUNDING_DEG)


@pytest.mark.parametrize("form", ["json", "text"])
def test_a_posture_may_be_a_turn_since_the_arm_was_hanging(girdle_fine: Girdle, form: str) -> None:
    posture = ("solve", "--posture", "relaxed", *AS_QUATERNIONS)
    options = ("--json",) if form == "json" else ALL_DIGITS
    relaxed = quaternions_in("json", girdle_fine(*posture, "--json").text)
    hanging = quaternions_in("json", girdle_fine(*typed("json", ("0", "0"), *AS_QUATERNIONS)).text)
    found = quaternions_in(form, girdle_fine(*posture, *SINCE_HANGING, *options).text)
    for name in ROTATIONS:
        expected = with_positive_w(multiply(inverse(hanging[name]), relaxed[name]))
        assert found[name] == pytest.approx(expected, rel=0, abs=ROUNDING), name


# --- Decimals ------------------------------------------------------------------------------------

DIGITS = (0, 3, 6, 12, 15)
DEFAULT_DIGITS = 6
RANDOM_POSES = 200
# Fifteen decimals of an angle are more than a double has: the spacing of doubles near 180.
SPACING_DEG = 3e-14


def random_poses() -> str:
    """Some of them are outside the table."""
    random = np.random.default_rng(SEED)
    lines = [f"{random.uniform(0.0, 140.0)!r},{random.uniform(-30.0, 110.0)!r}" for _ in range(RANDOM_POSES)]
    return "\n".join(["elevation_deg,plane_deg", *lines])


def solved_texts(girdle_fine: Girdle, digits: int, *options: str) -> list[list[str]]:
    """The texts of all rotations and landmarks of random poses, by rows."""
    command = ("solve", "--in", "-", "--landmarks", "--digits", str(digits), *options)
    text = girdle_fine(*command, stdin=random_poses().encode()).text
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    assert len(rows) == RANDOM_POSES
    words = ("elevation_deg", "plane_deg", "clamped", "origin")
    return [[row[name] for name in row if name not in words] for row in rows]


@pytest.mark.parametrize("options", [(), AS_QUATERNIONS], ids=["degrees", "quaternions"])
@pytest.mark.parametrize("digits", DIGITS)
def test_numbers_have_that_many_decimals_at_most_and_none_to_spare(
    girdle_fine: Girdle, digits: int, options: tuple[str, ...]
) -> None:
    texts = [text for row in solved_texts(girdle_fine, digits, *options) for text in row]
    decimals = rf"(\.\d{{0,{digits - 1}}}[1-9])?" if digits else ""
    form = re.compile(r"-?\d{1,4}" + decimals)
    assert [text for text in texts if not form.fullmatch(text)][:10] == []
    assert "-0" not in texts


@pytest.mark.parametrize("digits", [digits for digits in DIGITS if 0 < digits < 15])
def test_numbers_are_not_rounded_further(girdle_fine: Girdle, digits: int) -> None:
    """Nine of ten angles do not end in a zero. The first twelve columns are angles."""
    texts = [text for row in solved_texts(girdle_fine, digits) for text in row[:12]]
    short = [text for text in texts if len(text.partition(".")[2]) < digits]
    assert len(short) < len(texts) / 5, short[:10]


@pytest.mark.parametrize("digits", DIGITS)
def test_numbers_are_the_nearest_that_have_so_many_decimals(girdle_fine: Girdle, digits: int) -> None:
    pose = ("solve", "--elevation", "71.5", "--plane", "12")
    exact_deg = json.loads(girdle_fine(*pose, "--json").text)["angles_deg"]
    half = 0.5 * 10.0**-digits + SPACING_DEG
    text_deg = angles_in("text", girdle_fine(*pose, "--digits", str(digits)).text)
    assert text_deg == pytest.approx(exact_deg, rel=0, abs=half)
    sweep = ("solve", "--elevation", "71.5:71.5:1", "--plane", "12", "--digits", str(digits))
    assert angles_in("csv", girdle_fine(*sweep).text) == pytest.approx(exact_deg, rel=0, abs=half)


def test_six_decimals_are_written_unless_others_are_asked_for(girdle_fine: Girdle) -> None:
    for command in (
        ("solve", "--elevation", "71.5", "--plane", "12", "--landmarks"),
        ("solve", "--elevation", "10:90:8", "--plane", "12", "--derivatives"),
    ):
        default = girdle_fine(*command).text
        assert default == girdle_fine(*command, "--digits", str(DEFAULT_DIGITS)).text
        assert default != girdle_fine(*command, "--digits", str(DEFAULT_DIGITS + 1)).text


def test_json_has_all_digits_whatever_is_asked_for(girdle_fine: Girdle) -> None:
    pose = ("solve", "--elevation", "71.5", "--plane", "12", "--json")
    assert girdle_fine(*pose, "--digits", "2").text == girdle_fine(*pose).text


def test_the_typed_numbers_of_a_file_keep_their_digits(girdle_fine: Girdle) -> None:
    poses = b"note,elevation_deg,plane_deg\n1.23456789,71.123456789,12.987654321\n"
    text = girdle_fine("solve", "--in", "-", "--digits", "0", stdin=poses).text
    assert text.splitlines()[1].startswith("1.23456789,71.123456789,12.987654321,")


# --- Wrong words ---------------------------------------------------------------------------------

POSE = ("solve", "--elevation", "60", "--plane", "50")


@pytest.mark.parametrize("word", ["-1", "16", "1.5", "x", "nan", "inf", "1e9", " 2", "2x"])
def test_what_is_no_number_of_decimals_is_refused(refuses: Refuses, word: str) -> None:
    because = (f"--digits '{word}'", "from 0 to 15", "such as --digits 3")
    refuses(*POSE, f"--digits={word}", because=because)


@pytest.mark.parametrize("word", ["0", "15", "+3", "3.0"])
def test_a_number_of_decimals_is_accepted(girdle_fine: Girdle, word: str) -> None:
    assert girdle_fine(*POSE, "--digits", word).code == 0


@pytest.mark.parametrize("word", ["euler", "Quaternions", "rad"])
def test_another_form_of_rotations_is_refused_with_the_known_ones(refuses: Refuses, word: str) -> None:
    refuses(*POSE, "--as", word, because=(f"--as {word}", "degrees, quaternions"))


@pytest.mark.parametrize("word", ["relaxed", "rest", "0"])
def test_a_turn_since_another_pose_is_refused_with_the_known_one(refuses: Refuses, word: str) -> None:
    refuses(*POSE, "--relative-to", word, because=(f"--relative-to {word}", "Choose.* hanging"))
