# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle simulate` as a person types it."""

from __future__ import annotations

import csv
import json
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import (
    MODEL_FILE,
    SCENE_FILE,
    TWELVE_DIGITS,
    Girdle,
    Refuses,
    WriteModel,
    contents,
    find_element,
)
from reference_rhythm import COORDINATES, DATABASE

COMMANDS = ("elevation_deg", "plane_deg", "axial_deg")
OFFSETS = ("shrug_deg", "protraction_deg")

# Bones, then sites: the landmarks in the order of data/landmarks.csv and, where two bones meet, the
# second bone's own.
BONES = ("clavicle", "scapula", "humerus")
SITES = (
    *("IJ", "PX", "C7", "T8", "SC", "PAC", "TS", "AI", "AA", "PC", "ACJ", "GC", "GH", "EM", "EL"),
    *("SC_clavicle", "PAC_scapula", "GH_humerus"),
)
TRACE_COLUMNS = [
    "time_s",
    *COMMANDS,
    *OFFSETS,
    "used_elevation_deg",
    "used_plane_deg",
    "distance_deg",
    "used_axial_deg",
    "used_axial_isb_deg",
    *(f"used_{offset}" for offset in OFFSETS),
    *(f"target_{coordinate}_deg" for coordinate in COORDINATES),
    *(f"{coordinate}_deg" for coordinate in COORDINATES),
    *(f"{bone}_q{component}" for bone in BONES for component in "wxyz"),
    *(f"{site}_{component}_m" for site in SITES for component in "xyz"),
]

# Commands go to radians and back, times are sums of steps.
ROUNDING = 1e-9
# The same for lengths and quaternions, of order one.
UNIT = 1e-12


def read_trace(text: str) -> list[dict[str, float]]:
    rows = csv.DictReader(text.splitlines())
    return [{column: float(value) for column, value in row.items()} for row in rows]


def timestep_s(model: Path) -> float:
    option = find_element(ElementTree.parse(model).getroot(), "option")
    return float(option.attrib["timestep"])


@pytest.fixture
def scene(generated: Path) -> Path:
    return generated / SCENE_FILE


RAISE = ("--elevation", "15:120", "--plane", "40", "--seconds", "0.5")


# --- The trace -----------------------------------------------------------------------------------


def test_the_trace_has_its_columns_in_order(girdle_fine: Girdle, scene: Path) -> None:
    text = girdle_fine("simulate", scene, *RAISE, "--out", "-").text
    assert text.splitlines()[0].split(",") == TRACE_COLUMNS


@pytest.mark.parametrize("seconds", ["0.1", "0.5", "2"])
def test_the_trace_has_a_row_for_every_step_and_one_for_the_start(
    girdle_fine: Girdle, scene: Path, seconds: str
) -> None:
    step_s = timestep_s(scene.parent / MODEL_FILE)
    text = girdle_fine("simulate", scene, "--elevation", "15:120", "--seconds", seconds, "--out", "-").text
    times_s = [row["time_s"] for row in read_trace(text)]
    expected_s = [i * step_s for i in range(round(float(seconds) / step_s) + 1)]
    assert times_s == pytest.approx(expected_s, abs=ROUNDING)


def test_the_rows_follow_the_models_own_time_step(girdle_fine: Girdle, write_model: WriteModel) -> None:
    scene = write_model(lambda root: find_element(root, "option").set("timestep", "0.005"))
    rows = read_trace(girdle_fine("simulate", scene, *RAISE, "--out", "-").text)
    assert len(rows) == 101
    assert rows[1]["time_s"] == pytest.approx(0.005, abs=ROUNDING)


def test_the_arm_starts_on_its_targets(girdle_fine: Girdle, scene: Path) -> None:
    first = read_trace(girdle_fine("simulate", scene, *RAISE, "--out", "-").text)[0]
    targets_deg = {coordinate: first[f"target_{coordinate}_deg"] for coordinate in COORDINATES}
    angles_deg = {coordinate: first[f"{coordinate}_deg"] for coordinate in COORDINATES}
    assert angles_deg == pytest.approx(targets_deg, abs=ROUNDING)


def test_the_quaternions_of_the_trace_are_rotations(girdle_fine: Girdle, scene: Path) -> None:
    for row in read_trace(girdle_fine("simulate", scene, *RAISE, "--out", "-").text):
        for bone in BONES:
            norm = math.hypot(*(row[f"{bone}_q{component}"] for component in "wxyz"))
            assert norm == pytest.approx(1.0, abs=UNIT), (bone, row["time_s"])


@pytest.mark.parametrize(
    ("parent", "child"), [("SC", "SC_clavicle"), ("PAC", "PAC_scapula"), ("GH", "GH_humerus")]
)
def test_the_bones_of_the_trace_meet_at_their_joints(
    girdle_fine: Girdle, scene: Path, parent: str, child: str
) -> None:
    for row in read_trace(girdle_fine("simulate", scene, *RAISE, "--out", "-").text):
        at_parent, at_child = ([row[f"{s}_{c}_m"] for c in "xyz"] for s in (parent, child))
        assert math.dist(at_parent, at_child) < UNIT, row["time_s"]


# --- The motion ----------------------------------------------------------------------------------


def commands_deg(rows: list[dict[str, float]], column: str) -> list[float]:
    return [row[column] for row in rows]


@pytest.mark.parametrize(("low", "high"), [("15", "120"), ("10.5", "60"), ("90", "30")])
def test_a_raise_runs_from_one_elevation_to_the_other(
    girdle_fine: Girdle, scene: Path, low: str, high: str
) -> None:
    motion = ("--elevation", f"{low}:{high}", "--plane", "40", "--seconds", "0.5")
    rows = read_trace(girdle_fine("simulate", scene, *motion, "--out", "-").text)
    elevations_deg = commands_deg(rows, "elevation_deg")
    assert elevations_deg[0] == pytest.approx(float(low), abs=ROUNDING)
    assert elevations_deg[-1] == pytest.approx(float(high), abs=ROUNDING)
    assert elevations_deg == sorted(elevations_deg, reverse=float(low) > float(high))
    others = commands_deg(rows, "plane_deg") + commands_deg(rows, "axial_deg")
    assert others == pytest.approx([40.0] * len(rows) + [0.0] * len(rows), abs=ROUNDING)


def test_a_raise_is_in_the_frontal_plane_for_two_seconds_unless_told_otherwise(
    girdle_fine: Girdle, scene: Path
) -> None:
    short = girdle_fine("simulate", scene, "--elevation", "15:120", "--out", "-").output
    long = ("--elevation", "15:120", "--plane", "0", "--seconds", "2")
    assert girdle_fine("simulate", scene, *long, "--out", "-").output == short


MOTION = "time_s,elevation_deg,plane_deg,axial_deg\n0,20,5,0\n0.1,40,5,10\n0.3,100,85,-10\n0.4,90,80,0\n"


def direction(elevation_deg: float, plane_deg: float) -> np.ndarray:
    """The humerus's unit vector in the thorax: x forward, y up, z to the right."""
    theta, psi = math.radians(elevation_deg), math.radians(plane_deg)
    return np.array([math.sin(theta) * math.sin(psi), -math.cos(theta), math.sin(theta) * math.cos(psi)])


def slerp_deg(start: tuple[float, float], end: tuple[float, float], share: float) -> tuple[float, float]:
    """Elevation and plane a share of the way along the great circle."""
    a, b = direction(*start), direction(*end)
    whole = math.acos(a @ b)
    x, y, z = (math.sin((1 - share) * whole) * a + math.sin(share * whole) * b) / math.sin(whole)
    return math.degrees(math.acos(-y)), math.degrees(math.atan2(x, z))


def test_a_motion_file_is_followed_straight_from_row_to_row(
    girdle_fine: Girdle, scene: Path, tmp_path: Path
) -> None:
    (tmp_path / "motion.csv").write_text(MOTION)
    text = girdle_fine("simulate", scene, "--in", "motion.csv", "--out", "-").text
    rows = {round(row["time_s"], 6): row for row in read_trace(text)}
    expected_deg = {
        0.0: (20, 5, 0),
        0.05: (30, 5, 5),
        0.1: (40, 5, 10),
        0.15: (*slerp_deg((40, 5), (100, 85), 0.25), 5),
        0.2: (*slerp_deg((40, 5), (100, 85), 0.5), 0),
        0.3: (100, 85, -10),
        0.35: (*slerp_deg((100, 85), (90, 80), 0.5), -5),
        0.4: (90, 80, 0),
    }
    for time_s, command_deg in expected_deg.items():
        found_deg = tuple(rows[time_s][column] for column in COMMANDS)
        assert found_deg == pytest.approx(command_deg, abs=ROUNDING), time_s
    assert max(rows) == 0.4


def test_a_motion_file_without_axial_turns_nothing(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "motion.csv").write_text("plane_deg,time_s,elevation_deg\n5,0,20\n15,0.1,40\n")
    text = girdle_fine("simulate", scene, "--in", "motion.csv", "--out", "-").text
    rows = read_trace(text)
    assert {row["axial_deg"] for row in rows} == {0.0}
    assert rows[-1]["plane_deg"] == pytest.approx(15.0, abs=ROUNDING)


def test_the_commands_of_a_trace_are_a_motion_that_gives_the_same_angles(
    girdle_fine: Girdle, scene: Path, tmp_path: Path
) -> None:
    trace = girdle_fine("simulate", scene, *RAISE, "--out", "-").text
    motion = "\n".join(",".join(line.split(",")[:6]) for line in trace.splitlines())
    (tmp_path / "motion.csv").write_text(motion)
    replayed = girdle_fine("simulate", scene, "--in", "motion.csv", "--out", "-").text
    for found, expected in zip(read_trace(replayed), read_trace(trace), strict=True):
        assert found == pytest.approx(expected, abs=ROUNDING)


# --- What is printed -----------------------------------------------------------------------------


def test_two_runs_give_the_same_bytes(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    first = girdle_fine("simulate", scene, *RAISE, "--out", "trace.csv")
    first_trace = (tmp_path / "trace.csv").read_bytes()
    second = girdle_fine("simulate", scene, *RAISE, "--out", "trace.csv")
    assert second.output == first.output
    assert (tmp_path / "trace.csv").read_bytes() == first_trace


def test_a_trace_on_standard_output_is_alone_there(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    girdle_fine("simulate", scene, *RAISE, "--out", "trace.csv")
    printed = girdle_fine("simulate", scene, *RAISE, "--out", "-").output
    assert printed == (tmp_path / "trace.csv").read_bytes()


def test_the_summary_tells_what_the_trace_holds(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    options = (*RAISE, "--out", "trace.csv", "--json")
    summary = json.loads(girdle_fine("simulate", scene, *options).text)
    rows = read_trace((tmp_path / "trace.csv").read_text())
    errors_deg = [max(abs(row[f"target_{c}_deg"] - row[f"{c}_deg"]) for c in COORDINATES) for row in rows]
    assert summary["rows"] == len(rows)
    assert summary["out"] == "trace.csv"
    assert summary["duration_s"] == rows[-1]["time_s"]
    assert summary["worst_tracking_error_deg"] == pytest.approx(max(errors_deg), abs=ROUNDING)
    assert summary["last_tracking_error_deg"] == pytest.approx(errors_deg[-1], abs=ROUNDING)
    distances_deg = [row["distance_deg"] for row in rows]
    assert summary["worst_distance_deg"] == pytest.approx(max(distances_deg), abs=ROUNDING)


def test_the_text_gives_the_numbers_of_the_json(girdle_fine: Girdle, scene: Path) -> None:
    summary = json.loads(girdle_fine("simulate", scene, *RAISE, "--json").text)
    text = girdle_fine("simulate", scene, *RAISE).text
    expected = (
        rf"simulated 0\.5 s in {summary['rows']} states; joints at most "
        rf"{round(summary['worst_tracking_error_deg'], 3)} deg off"
    )
    assert re.match(expected, text), text


def test_without_a_trace_no_file_is_written(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    summary = json.loads(girdle_fine("simulate", scene, *RAISE, "--json").text)
    assert summary["out"] is None
    assert contents(tmp_path) == {}


# --- Runs that fail ------------------------------------------------------------------------------


NO_MOTIONS: list[tuple[tuple[str, ...], tuple[str, ...]]] = [
    ((), ("--elevation FROM:TO", "--in FILE")),
    (("--elevation", "15:120", "--in", "motion.csv"), ("--elevation FROM:TO", "--in FILE")),
    (("--elevation", "15"), ("--elevation 15: a motion goes from one elevation", "0:90")),
    (("--elevation", ""), ("--elevation", "empty|15:120")),
    (("--elevation", "15-120"), ("--elevation 15-120: a motion goes from one elevation", "0:90")),
    # The fix is a whole FROM:TO: one number would be refused in its turn.
    (("--elevation", "15:12O"), ("--elevation", "12O", "15:120")),
    (("--elevation", "l5:120"), ("--elevation", "l5", "15:120")),
    (("--elevation", "15:nan"), ("--elevation", "nan", "15:120")),
    (("--elevation", "-15:120"), ("--elevation", "-15: elevation counts from 0", "--convention isb")),
    (("--elevation", "15:181"), ("--elevation", "181: expected 0 to 180")),
    (("--elevation", ":"), ("--elevation", "15:120")),
    (("--elevation", "15:60:120"), ("--elevation", "60:120", "15:120")),
    # As a motion file may not hold.
    (("--elevation", "1e300:120"), ("--elevation", "1e300", "180")),
    (("--elevation", "15:120", "--plane", "1e300"), ("--plane 1e300", "-3600 to 3600")),
    (("--elevation", "15:120", "--seconds", "3601"), ("--seconds 3601", "3600", "--longest")),
    (("--elevation", "15:120", "--angles", "rad"), ("--angles rad", "of a file")),
    (("--in", "motion.csv", "--longest", "0.3"), ("motion.csv:5: ", "at most 0.3", "--longest")),
    (("--in", "motion.csv", "--longest", "0"), ("--longest 0", "more than 0")),
    (("--in", "motion.csv", "--longest", "1e9"), ("--longest 1e9", "a year")),
    (("--elevation", "15:120", "--plane", "4O"), ("--plane '4O'", "such as --plane")),
    (("--elevation", "15:120", "--plane", "inf"), ("--plane 'inf'", "such as --plane")),
    (("--elevation", "15:120", "--plane", ""), ("--plane", "empty|such as --plane")),
    (("--elevation", "15:120", "--seconds", "two"), ("--seconds 'two'", "such as --seconds")),
    (("--elevation", "15:120", "--seconds", "nan"), ("--seconds 'nan'", "such as --seconds")),
    (("--elevation", "15:120", "--seconds", "0"), ("--seconds 0", "more than 0")),
    (("--elevation", "15:120", "--seconds", "-2"), ("--seconds -2", "more than 0")),
    (("--elevation", "15:120", "--seconds", "1e9"), ("--seconds 1e9", "at most")),
    # Neither means anything to a motion file, which has its own.
    (("--in", "motion.csv", "--seconds", "3"), ("--seconds", "--in")),
    (("--in", "motion.csv", "--plane", "40"), ("--plane", "--in")),
    (("--in", "absent.csv"), ("absent.csv: ", "Check")),
    (("--in", "there"), ("there", "folder|directory")),
    (("--in", ""), ("--in",)),
]


@pytest.mark.parametrize("name", ["arm.MP4", "arm.png"])
def test_a_table_is_not_written_as_a_picture_or_video(
    refuses: Refuses, scene: Path, tmp_path: Path, name: str
) -> None:
    because = (f"--out {name}: the output is a CSV", "--out-picture", "--out-video")
    refuses("simulate", scene, "--elevation", "15:120", "--out", name, because=because)
    assert not (tmp_path / name).exists()


@pytest.mark.parametrize(("words", "patterns"), NO_MOTIONS, ids=[" ".join(words) for words, _ in NO_MOTIONS])
def test_a_motion_that_is_not_one_is_refused(
    refuses: Refuses,
    scene: Path,
    tmp_path: Path,
    words: tuple[str, ...],
    patterns: tuple[str, ...],
) -> None:
    (tmp_path / "motion.csv").write_text(MOTION)
    (tmp_path / "there").mkdir()
    refuses("simulate", scene, *words, "--out", "trace.csv", because=patterns)


@dataclass(frozen=True)
class WrongMotion:
    """A change to MOTION, the line that it is in, and what is said of it."""

    change: Callable[[str], str]
    line: int
    patterns: tuple[str, ...]


def replaced(line: int, old: str, new: str, *patterns: str) -> WrongMotion:
    """One text, which stands once in MOTION, by another."""
    assert MOTION.count(old) == 1
    return WrongMotion(lambda motion: motion.replace(old, new), line, patterns)


@pytest.mark.parametrize(
    "wrong",
    [
        replaced(3, "\n0.1,", "\n0,", "time_s is 0", "does not increase", "previous 0"),
        replaced(4, "\n0.3,", "\n0.05,", "time_s is 0.05", "does not increase", "previous 0.1"),
        replaced(5, "\n0.4,", "\n1e9,", "time_s is 1e\\+09", "at most 3600", "--longest"),
        replaced(3, ",40,", ",4O,", "elevation_deg is '4O'", "such as"),
        replaced(3, ",40,", ",400,", "elevation_deg is 400", "expected 0 to 180"),
        replaced(3, ",40,", ",181,", "elevation_deg is 181", "expected 0 to 180"),
        replaced(3, ",5,10", ",1e300,10", "plane_deg is 1e\\+300", "-3600 to 3600"),
        replaced(3, ",40,", ",nan,", "elevation_deg is 'nan', a gap", "--bridge-gaps 1"),
        replaced(3, "0.1,40,5,10", "0.1,40,5", "3 fields, expected 4"),
        replaced(1, "axial_deg", "axial", "'axial' is not known", "mean 'axial_deg'"),
        replaced(1, "time_s", "axial_deg", "'axial_deg' is given twice", "Rename"),
        replaced(1, ",plane_deg", "", "'plane_deg' is missing"),
        WrongMotion(lambda motion: motion.splitlines()[0] + "\n", 1, ("no rows",)),
        WrongMotion(lambda _: "", 1, ("no header",)),
    ],
    ids=lambda wrong: " ".join(wrong.patterns),
)
def test_a_mistake_in_a_motion_file_is_refused_with_file_and_line(
    refuses: Refuses, scene: Path, tmp_path: Path, wrong: WrongMotion
) -> None:
    (tmp_path / "motion.csv").write_text(wrong.change(MOTION))
    refuses(
        *("simulate", scene, "--in", "motion.csv", "--out", "trace.csv"),
        because=(f"motion.csv:{wrong.line}: ", *wrong.patterns),
    )


# --- Outside what was measured -------------------------------------------------------------------


def test_the_trace_says_how_far_each_command_is_from_measured_ones(girdle_fine: Girdle, scene: Path) -> None:
    motion = ("--elevation", "0:150", "--plane", "0", "--seconds", "0.2")
    rows = read_trace(girdle_fine("simulate", scene, *motion, "--out", "-").text)
    for row in rows:
        elevation_deg = row["elevation_deg"]
        expected_deg = max(15 - elevation_deg, elevation_deg - 120, 0)
        assert row["distance_deg"] == pytest.approx(expected_deg, abs=ROUNDING), row["time_s"]


def test_the_summary_says_that_a_motion_leaves_what_was_measured(girdle_fine: Girdle, scene: Path) -> None:
    high = ("simulate", scene, "--elevation", "90:150", "--plane", "0", "--seconds", "0.2")
    summary = json.loads(girdle_fine(*high, "--json").text)
    assert summary["worst_distance_deg"] == pytest.approx(30, abs=ROUNDING)
    assert summary["clamped_rows"] == 0
    assert "up to 30 deg from measured positions" in girdle_fine(*high).text
    inside = ("simulate", scene, "--elevation", "30:90", "--plane", "40", "--seconds", "0.2")
    assert json.loads(girdle_fine(*inside, "--json").text)["worst_distance_deg"] == 0
    assert "measured" not in girdle_fine(*inside).text


def test_commands_out_of_reach_are_counted(girdle_fine: Girdle, scene: Path) -> None:
    """In plane -30 an arm goes all the way up, in plane -31 it does not."""
    motion = ("simulate", scene, "--elevation", "60:175", "--plane", "-31", "--seconds", "0.2")
    rows = read_trace(girdle_fine(*motion, "--out", "-").text)
    beyond = sum(row["used_plane_deg"] > -31 + ROUNDING for row in rows)
    assert 0 < beyond < len(rows)
    assert json.loads(girdle_fine(*motion, "--json").text)["clamped_rows"] == beyond
    assert f"{beyond} commands lay outside" in girdle_fine(*motion).text


# --- Offsets -------------------------------------------------------------------------------------

SHRUG = "time_s,elevation_deg,plane_deg,shrug_deg,protraction_deg\n0,30,20,0,0\n0.2,60,40,10,-4\n"


@pytest.fixture
def scene_with_offsets(girdle_fine: Girdle, tmp_path: Path) -> Path:
    girdle_fine("generate", "--out", "offsets", "--offsets")
    return tmp_path / "offsets" / SCENE_FILE


def test_a_motion_file_may_shrug_and_protract(
    girdle_fine: Girdle, scene_with_offsets: Path, tmp_path: Path
) -> None:
    """The targets are what solve says of the same commands."""
    (tmp_path / "motion.csv").write_text(SHRUG)
    motion = ("--in", "motion.csv", "--out", "-")
    rows = read_trace(girdle_fine("simulate", scene_with_offsets, *motion).text)
    for share, row in ((0, rows[0]), (0.5, rows[50]), (1, rows[-1])):
        assert row["shrug_deg"] == pytest.approx(10 * share, abs=ROUNDING)
        assert row["protraction_deg"] == pytest.approx(-4 * share, abs=ROUNDING)
        pose = [f"--{name.removesuffix('_deg')}={row[name]!r}" for name in (*COMMANDS, *OFFSETS)]
        solved_deg = json.loads(girdle_fine("solve", *pose, "--json").text)["angles_deg"]
        expected_deg = {c: solved_deg[c] for c in COORDINATES}
        targets_deg = {c: row[f"target_{c}_deg"] for c in COORDINATES}
        assert targets_deg == pytest.approx(expected_deg, abs=ROUNDING)


def test_offsets_that_end_at_a_joints_range_are_counted(
    girdle_fine: Girdle, scene_with_offsets: Path, tmp_path: Path
) -> None:
    """With the arm high a clavicle has no room for the largest shrug, with the arm low it has."""
    header = "time_s,elevation_deg,plane_deg,shrug_deg\n"
    for elevation_deg, plane_deg, clamped_rows in ((150, 0, 11), (10, 90, 0)):
        place = f"{elevation_deg},{plane_deg},35\n"
        (tmp_path / "motion.csv").write_text(f"{header}0,{place}0.02,{place}")
        words = ("simulate", scene_with_offsets, "--in", "motion.csv", "--json")
        assert json.loads(girdle_fine(*words).text)["clamped_rows"] == clamped_rows
        pose = (f"--elevation={elevation_deg}", f"--plane={plane_deg}", "--shrug=35", "--json")
        clamped = json.loads(girdle_fine("solve", *pose).text)["clamped"]
        assert clamped == (clamped_rows > 0)


def test_the_offsets_that_were_left_are_those_of_solve(
    girdle_fine: Girdle, scene_with_offsets: Path, tmp_path: Path
) -> None:
    """High up the largest shrug is clamped; what is left of it stands in trace and table."""
    (tmp_path / "motion.csv").write_text(
        "time_s,elevation_deg,plane_deg,shrug_deg,protraction_deg\n0,150,0,35,4\n0.02,150,0,35,4\n"
    )
    pose = ("--elevation=150", "--plane=0", "--shrug=35", "--protraction=4", "--json")
    left_deg = json.loads(girdle_fine("solve", *pose).text)["used"]
    assert left_deg["shrug_deg"] < 30
    words = ("simulate", scene_with_offsets, "--in", "motion.csv", "--out", "-")
    solve = ("solve", "--in", "motion.csv", *TWELVE_DIGITS)
    for text in (girdle_fine(*words).text, girdle_fine(*solve).text):
        for row in csv.DictReader(text.splitlines()):
            used_deg = {offset: float(row[f"used_{offset}"]) for offset in OFFSETS}
            assert used_deg == pytest.approx({o: left_deg[o] for o in OFFSETS}, abs=ROUNDING)


def test_a_column_of_zeros_needs_no_command(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    zeros = SHRUG.replace(",10,-4", ",0,0")
    (tmp_path / "motion.csv").write_text(zeros)
    girdle_fine("simulate", scene, "--in", "motion.csv")


def test_without_offsets_their_columns_are_zero(girdle_fine: Girdle, scene: Path) -> None:
    rows = read_trace(girdle_fine("simulate", scene, *RAISE, "--out", "-").text)
    assert {row[name] for row in rows for name in OFFSETS} == {0.0}


@pytest.mark.parametrize("name", ["shrug", "protraction"])
def test_an_offset_needs_a_model_with_a_command_for_it(
    refuses: Refuses, scene: Path, tmp_path: Path, name: str
) -> None:
    (tmp_path / "motion.csv").write_text(
        f"time_s,elevation_deg,plane_deg,{name}_deg\n0,30,20,0\n0.2,60,40,5\n"
    )
    because = (re.escape(str(scene)), f'no actuator "{name}_r"', "girdle generate --offsets")
    words = ("--in", "motion.csv", "--out", "trace.csv")
    refuses("simulate", scene, *words, because=because)


@pytest.mark.parametrize(
    ("name", "value", "bounds"),
    [
        ("shrug", "36", "-15 to 35"),
        ("shrug", "-16", "-15 to 35"),
        ("protraction", "31", "-25 to 30"),
        ("protraction", "-26", "-25 to 30"),
    ],
)
def test_an_offset_that_no_clavicle_makes_is_refused_with_its_line(
    refuses: Refuses, scene_with_offsets: Path, tmp_path: Path, name: str, value: str, bounds: str
) -> None:
    (tmp_path / "motion.csv").write_text(
        f"time_s,elevation_deg,plane_deg,{name}_deg\n0,30,20,0\n0.2,60,40,{value}\n"
    )
    because = ("motion.csv:3: ", f"{name}_deg is {value}", bounds)
    words = ("--in", "motion.csv", "--out", "trace.csv")
    refuses("simulate", scene_with_offsets, *words, because=because)


# --- Held to a rhythm ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "what"),
    [
        (("--interpolation", "squad"), "interpolation than squad"),
        (("--closure", "table"), "closure than table"),
        (("--range", "clamp"), "range than clamp"),
        (("--table", "measured"), "table than measured"),
        (("--table", str(DATABASE)), f"table than {re.escape(str(DATABASE))}"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_a_model_that_moves_by_another_rhythm_is_refused(
    refuses: Refuses, scene: Path, options: tuple[str, ...], what: str
) -> None:
    because = (re.escape(str(scene)), f"another {what}", "girdle generate")
    refuses("simulate", scene, *RAISE, "--out", "trace.csv", *options, because=because)


def test_a_model_that_moves_by_the_rhythm_named_is_simulated(girdle_fine: Girdle, scene: Path) -> None:
    options = ("--interpolation", "smooth", "--closure", "exact", "--range", "whole")
    table = ("--table", "smoothed")
    plain = girdle_fine("simulate", scene, *RAISE, "--out", "-").output
    assert girdle_fine("simulate", scene, *RAISE, "--out", "-", *options, *table).output == plain


# --- Simulations that break off ------------------------------------------------------------------


def unstable(root: ElementTree.Element) -> None:
    """A wind so strong that the simulation cannot follow it."""
    option = find_element(root, "option")
    option.set("density", "1e6")
    option.set("wind", "1e9 0 0")


@pytest.mark.parametrize("before", [None, b"earlier\n"])
def test_a_simulation_that_breaks_off_leaves_no_half_written_trace(
    refuses: Refuses, write_model: WriteModel, tmp_path: Path, before: bytes | None
) -> None:
    scene = write_model(unstable)
    if before is not None:
        (tmp_path / "trace.csv").write_bytes(before)
    words = ("--elevation", "15:120", "--out", "trace.csv")
    refuses("simulate", scene, *words, because=(re.escape(str(scene)), "at 0", "unstable"))
