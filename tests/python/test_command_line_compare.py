# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle compare` as a person types it: published rhythms beside the measured one."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from typing import Any

import pytest
from conftest import Girdle, Refuses
from reference_rhythm import COORDINATES

RHYTHMS = ["Inman", "Braman", "de Groot and Brand", "MoBL-ARMS", "frozen girdle"]
UPWARD_ROTATION_ALONE = ("Inman", "Braman")
# Fields of the map are rounded to six decimals; a difference of two is twice as far off.
ROUNDED_DEG = 1.1e-6
EXACT = 1e-9
# What of a rhythm is compared: rotations of joints, and angles of clavicle and scapula.
COMPARED = {
    *("sc", "ac", "gh", "sc_protraction", "sc_elevation"),
    *("st_internal_rotation", "st_upward_rotation", "st_tilt"),
}
WIDEST_LINE = 110

# A small map, all of it within the table.
MAP = ("--elevation", "30:120:30", "--plane", "0:90:45")
ELEVATIONS = (30, 60, 90, 120)
PLANES = (0, 45, 90)

# Relaxed standing posture of the published table.
RELAXED_UPWARD_DEG = -5.4

Rows = dict[tuple[str, float, float], dict[str, str]]


def summary(girdle_fine: Girdle, *options: str) -> Any:
    return json.loads(girdle_fine("compare", *options, "--json").text)


def read_map(path: Path) -> Rows:
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    by_place = {(row["rhythm"], float(row["elevation_deg"]), float(row["plane_deg"])): row for row in rows}
    assert len(by_place) == len(rows), "a position is there twice"
    return by_place


@pytest.fixture
def small_map(girdle_fine: Girdle, tmp_path: Path) -> Rows:
    girdle_fine("compare", *MAP, "--out", "map.csv")
    return read_map(tmp_path / "map.csv")


def rows_of(rhythm: str, rows: Rows) -> dict[tuple[float, float], dict[str, str]]:
    """The rows of one rhythm of a map of MAP by elevation and plane; none is missing."""
    found = {(elevation, plane): row for (name, elevation, plane), row in rows.items() if name == rhythm}
    assert list(found) == [(elevation, plane) for elevation in ELEVATIONS for plane in PLANES]
    return found


def differences(report: Any, rhythm: str) -> dict[str, Any]:
    (found,) = [entry for entry in report["rhythms"] if entry["name"] == rhythm]
    by_angle = {entry["of"]: entry for entry in found["differences"]}
    assert by_angle.keys() == COMPARED
    return by_angle


# --- The map -------------------------------------------------------------------------------------


def test_the_map_has_a_row_a_rhythm_and_position(small_map: Rows) -> None:
    expected = [
        (rhythm, elevation, plane)
        for rhythm in ["Girdle", *RHYTHMS]
        for elevation in ELEVATIONS
        for plane in PLANES
    ]
    assert list(small_map) == expected


@pytest.mark.parametrize(
    "options",
    [(), ("--interpolation", "squad", "--closure", "table"), ("--table", "measured")],
    ids=" ".join,
)
def test_girdles_rows_are_what_solve_gives(
    girdle_fine: Girdle, tmp_path: Path, options: tuple[str, ...]
) -> None:
    girdle_fine("compare", *MAP, *options, "--out", "map.csv")
    rows = rows_of("Girdle", read_map(tmp_path / "map.csv"))
    for (elevation, plane), row in rows.items():
        place = ("--elevation", str(elevation), "--plane", str(plane))
        pose = ("solve", *place, *options, "--json")
        expected_deg = json.loads(girdle_fine(*pose).text)["angles_deg"]
        found_deg = {name: float(row[f"{name}_deg"]) for name in expected_deg}
        assert found_deg == pytest.approx(expected_deg, abs=ROUNDED_DEG)


def test_girdle_does_not_differ_from_itself(small_map: Rows) -> None:
    for row in rows_of("Girdle", small_map).values():
        found = {row[name] for name in row if name.endswith("_difference_deg")}
        assert found == {"0"}


def test_a_frozen_girdle_differs_by_what_was_measured(small_map: Rows) -> None:
    for (elevation, plane), row in rows_of("frozen girdle", small_map).items():
        measured_deg = float(small_map["Girdle", elevation, plane]["st_upward_rotation_deg"])
        assert float(row["st_upward_rotation_deg"]) == RELAXED_UPWARD_DEG
        assert float(row["st_upward_rotation_difference_deg"]) == pytest.approx(
            RELAXED_UPWARD_DEG - measured_deg, abs=ROUNDED_DEG
        )


def test_inman_turns_the_scapula_by_a_third_and_says_no_more(small_map: Rows) -> None:
    for (elevation, _), row in rows_of("Inman", small_map).items():
        assert float(row["st_upward_rotation_deg"]) == pytest.approx(
            RELAXED_UPWARD_DEG - elevation / 3, abs=ROUNDED_DEG
        )
        said = {name for name, field in row.items() if field != ""}
        assert said == {
            *("rhythm", "elevation_deg", "plane_deg", "in_table"),
            *("st_upward_rotation_deg", "st_upward_rotation_difference_deg"),
        }


def test_de_groot_and_brand_say_nothing_of_the_clavicles_axial_rotation(small_map: Rows) -> None:
    row = small_map["de Groot and Brand", 60, 45]
    unsaid = {name for name, field in row.items() if field == ""}
    assert unsaid == {
        *("sc_rotation_deg", "sc_difference_deg", "ac_difference_deg"),
        *("ac_internal_rotation_deg", "ac_upward_rotation_deg", "ac_tilt_deg"),
    }
    # The regression at H = 60, P = 45.
    clavicle = -4.983 + 0.120 * 45 - 0.242 * 60 + 0.851 * -28.6
    upward = 3.095 - 0.079 * 45 + 0.396 * 60 + 0.414 * 10.7
    assert float(row["sc_protraction_deg"]) == pytest.approx(clavicle, abs=ROUNDED_DEG)
    assert float(row["st_upward_rotation_deg"]) == pytest.approx(-upward, abs=ROUNDED_DEG)


def test_differences_of_angles_are_rhythm_minus_measured(small_map: Rows) -> None:
    angles = ("sc_protraction", "sc_elevation", "st_internal_rotation", "st_tilt")
    compared = dict.fromkeys(["Girdle", *RHYTHMS], 0)
    for (rhythm, elevation, plane), row in small_map.items():
        measured = small_map["Girdle", elevation, plane]
        for angle in angles:
            if row[f"{angle}_difference_deg"] != "":
                compared[rhythm] += 1
                expected = float(row[f"{angle}_deg"]) - float(measured[f"{angle}_deg"])
                error = math.remainder(float(row[f"{angle}_difference_deg"]) - expected, 360)
                assert error == pytest.approx(0, abs=2 * ROUNDED_DEG), rhythm
    everywhere = len(angles) * len(ELEVATIONS) * len(PLANES)
    assert compared == {rhythm: 0 if rhythm in UPWARD_ROTATION_ALONE else everywhere for rhythm in compared}


def test_positions_beyond_the_table_are_marked_or_left_out(girdle_fine: Girdle, tmp_path: Path) -> None:
    options = ("--elevation", "0:180:30", "--plane", "-90:135:45", "--out", "map.csv")
    report = summary(girdle_fine, *options)
    rows = read_map(tmp_path / "map.csv")
    measured = [row for (rhythm, _, _), row in rows.items() if rhythm == "Girdle"]
    in_table = [row for row in measured if row["in_table"] == "1"]
    assert {(row["elevation_deg"], row["plane_deg"]) for row in in_table} == {
        (str(elevation), str(plane)) for elevation in ELEVATIONS for plane in PLANES
    }
    assert report["table"]["compared"] == len(in_table)
    assert report["map"]["compared"] == len(measured)
    assert report["map"]["compared"] + report["map"]["clamped"] == 7 * 6
    for row in measured:
        pose = ("--elevation", row["elevation_deg"], f"--plane={row['plane_deg']}")
        assert not json.loads(girdle_fine("solve", *pose, "--json").text)["clamped"]


def test_the_default_map_is_the_whole_range_in_steps_of_five(girdle_fine: Girdle) -> None:
    typed = ("--elevation", "0:180:5", "--plane", "-95:135:5")
    assert girdle_fine("compare", *typed).output == girdle_fine("compare").output


def test_steps_that_are_no_binary_fractions_meet_their_end(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("compare", "--elevation", "119:120:0.1", "--plane", "0:0:1", "--out", "map.csv")
    elevations = [place[1] for place in read_map(tmp_path / "map.csv") if place[0] == "Inman"]
    assert elevations == [119, 119.1, 119.2, 119.3, 119.4, 119.5, 119.6, 119.7, 119.8, 119.9, 120]


# --- The summary ---------------------------------------------------------------------------------


def test_the_summary_is_made_of_the_map(girdle_fine: Girdle, small_map: Rows) -> None:
    report = summary(girdle_fine, *MAP)
    assert [rhythm["name"] for rhythm in report["rhythms"]] == RHYTHMS
    for rhythm in RHYTHMS:
        rows = rows_of(rhythm, small_map).values()
        for of, found in differences(report, rhythm).items():
            fields = [row[f"{of}_difference_deg"] for row in rows]
            if "" in fields:
                assert set(fields) == {""}
                assert found["in_table"] is found["on_map"] is None
                continue
            values = [float(field) for field in fields]
            rms = math.sqrt(sum(value * value for value in values) / len(values))
            largest = max(values, key=abs)
            assert found["on_map"]["rms_deg"] == pytest.approx(rms, abs=ROUNDED_DEG)
            assert abs(found["on_map"]["largest_deg"]) == pytest.approx(abs(largest), abs=ROUNDED_DEG)
            there = small_map[rhythm, found["on_map"]["elevation_deg"], found["on_map"]["plane_deg"]]
            assert float(there[f"{of}_difference_deg"]) == pytest.approx(
                found["on_map"]["largest_deg"], abs=ROUNDED_DEG
            )
            assert found["in_table"] == found["on_map"]  # all of this map lies in the table


def test_the_glenohumeral_joint_takes_what_the_scapula_does_not(girdle_fine: Girdle) -> None:
    """A frozen girdle is off by the measured change, and the joint with the arm as much."""
    found = differences(summary(girdle_fine, *MAP), "frozen girdle")
    upward = found["st_upward_rotation"]["on_map"]
    assert upward["largest_deg"] > 0  # less upward than measured
    assert upward["elevation_deg"] == 120
    assert found["gh"]["on_map"]["largest_deg"] > upward["largest_deg"]


def ratios(report: Any, rhythm: str) -> list[float | None]:
    return [row[rhythm] for row in report["scapulohumeral_ratio"]["rows"]]


def test_ratios_of_the_published_rhythms_are_their_closed_forms(girdle_fine: Girdle) -> None:
    report = summary(girdle_fine)
    rows = report["scapulohumeral_ratio"]["rows"]
    places = [(row["plane_deg"], row["elevation_deg"]) for row in rows]
    assert places == [(plane, to) for plane in (0, 40, 90) for to in (60, 90, 120, 150, 180)]
    assert ratios(report, "Inman") == pytest.approx([2.0] * 15, abs=EXACT)
    assert ratios(report, "Braman") == pytest.approx([(1 - 0.301) / 0.301] * 15, abs=EXACT)
    expected = [(1 - 0.396) / 0.396] * 15
    assert ratios(report, "de Groot and Brand") == pytest.approx(expected, abs=EXACT)
    assert ratios(report, "frozen girdle") == [None] * 15


def test_girdles_ratio_is_that_of_its_map(girdle_fine: Girdle, tmp_path: Path) -> None:
    options = ("--elevation", "30:120:30", "--plane", "0:90:10", "--out", "map.csv")
    report = summary(girdle_fine, *options)
    rows = read_map(tmp_path / "map.csv")
    in_table = [row for row in report["scapulohumeral_ratio"]["rows"] if row["elevation_deg"] <= 120]
    assert [(row["plane_deg"], row["elevation_deg"]) for row in in_table] == [
        (plane, to) for plane in (0, 40, 90) for to in (60, 90, 120)
    ]
    for row in in_table:
        to, plane = row["elevation_deg"], row["plane_deg"]
        # Upward rotation is negative.
        change = float(rows["Girdle", 30, plane]["st_upward_rotation_deg"]) - float(
            rows["Girdle", to, plane]["st_upward_rotation_deg"]
        )
        assert row["Girdle"] == pytest.approx((to - 30 - change) / change, abs=1e-6)


def test_a_json_file_holds_what_json_prints(girdle_fine: Girdle, tmp_path: Path) -> None:
    printed = girdle_fine("compare", *MAP, "--out", "summary.json", "--json").output
    assert (tmp_path / "summary.json").read_bytes() == printed


@pytest.mark.numbers
def test_the_same_options_give_the_same_bytes(girdle_fine: Girdle, tmp_path: Path) -> None:
    for name in ("a.csv", "b.csv"):
        girdle_fine("compare", *MAP, "--out", name)
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()


def test_a_table_of_ones_own_is_what_is_compared_with(girdle_fine: Girdle, tmp_path: Path) -> None:
    """The relaxed posture everywhere: a frozen girdle differs by rounding alone."""
    header = "plane_deg,elevation_deg," + ",".join(f"{name}_deg" for name in COORDINATES)
    places = [(plane, elevation) for plane in (0, 40, 90) for elevation in (30, 60, 90, 120)]
    rows = [f"{p},{e},-19.2,-5.9,0,60.0,-2.5,-8.4,{-e},0,0" for p, e in places]
    (tmp_path / "table.csv").write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    found = differences(summary(girdle_fine, *MAP, "--table", "table.csv"), "frozen girdle")
    for of in found:
        # Relaxed SC, AC and ST are each printed to a tenth.
        assert abs(found[of]["in_table"]["largest_deg"]) < 0.15


# --- The terminal --------------------------------------------------------------------------------


def test_the_text_fits_a_terminal(girdle_fine: Girdle) -> None:
    lines = girdle_fine("compare").text.splitlines()
    assert max(map(len, lines)) <= WIDEST_LINE
    assert [line for line in lines if line != line.rstrip()] == []


def test_the_text_gives_the_figures_of_the_json(girdle_fine: Girdle) -> None:
    report = summary(girdle_fine, *MAP)
    text = girdle_fine("compare", *MAP).text
    found = differences(report, "Inman")["st_upward_rotation"]["on_map"]
    figures = (
        rf"{found['rms_deg']:.1f} +{found['largest_deg']:.1f} +"
        rf"{found['elevation_deg']:g}/{found['plane_deg']:g}"
    )
    assert re.search(rf"^scapula upward rotation +Inman +{figures} +{figures}$", text, re.MULTILINE)
    assert re.search(r"^SC +Inman( +-){6}$", text, re.MULTILINE)


def test_the_text_says_what_a_ratio_is(girdle_fine: Girdle) -> None:
    text = girdle_fine("compare").text
    change = "change of upward rotation"
    assert f"(change of humeral elevation - {change}) / {change}" in text
    assert "from elevation 30" in text


def test_the_text_says_how_many_positions_are_left_out(girdle_fine: Girdle) -> None:
    options = ("--elevation", "90:90:1", "--plane", "0:180:90")
    report = summary(girdle_fine, *options)
    assert report["map"]["clamped"] > 0  # nobody reaches plane 180
    assert f"{report['map']['clamped']} left out" in girdle_fine("compare", *options).text
    assert "left out" not in girdle_fine("compare", *MAP).text


def test_a_map_without_a_position_has_no_figures(girdle_fine: Girdle) -> None:
    options = ("--elevation", "90:90:1", "--plane", "180:180:1")
    report = summary(girdle_fine, *options)
    assert report["map"]["compared"] == 0
    for rhythm in RHYTHMS:
        for found in differences(report, rhythm).values():
            assert found["in_table"] is found["on_map"] is None
    assert "scapulohumeral ratio" in girdle_fine("compare", *options).text


# --- What is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize("option", ["--elevation", "--plane"])
@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("30", "FROM:TO:STEP"),
        ("30:60", "FROM:TO:STEP"),
        ("30:60:5:5", "FROM:TO:STEP"),
        ("30:6O:5", "'6O' is not a finite number"),
        ("30:60:", "'' is not a finite number"),
        ("nan:60:5", "'nan' is not a finite number"),
        ("30:inf:5", "'inf' is not a finite number"),
        ("30:60:5deg", "'5deg' is not a finite number"),
        ("30:181:1", "181 is outside"),
        ("-181:30:1", "-181 is outside"),
        ("60:30:5", "smaller end first"),
        ("30:60:0", "the step is 0"),
        ("30:60:-5", "the step is -5"),
        ("30:60:7", "do not meet 60. End at 58 or change the step"),
        ("30:60:1e-300", "Give a larger step"),
    ],
)
def test_a_wrong_axis_is_refused_with_the_fix(refuses: Refuses, option: str, value: str, reason: str) -> None:
    refuses("compare", f"{option}={value}", because=(option, re.escape(f"'{value}'"), reason))


def test_an_elevation_below_hanging_is_refused(refuses: Refuses) -> None:
    refuses("compare", "--elevation=-5:90:5", because=("--elevation", "-5 is outside 0 to 180"))


def test_a_map_of_too_many_positions_is_refused(refuses: Refuses) -> None:
    options = ("--elevation", "0:180:0.1", "--plane", "0:90:0.1")
    refuses("compare", *options, because=("--elevation", "--plane", "Give larger steps"))


@pytest.mark.parametrize("name", ["rhythms", "rhythms.txt", "rhythms.CSV", "-", "csv"])
def test_another_ending_is_refused_with_the_known_ones(refuses: Refuses, name: str) -> None:
    refuses("compare", "--out", name, because=("--out", name, r"\.csv", r"\.json"))


@pytest.mark.parametrize("name", ["absent/map.csv", "absent/summary.json"])
def test_a_file_that_cannot_be_written_is_refused(refuses: Refuses, name: str) -> None:
    refuses("compare", "--out", name, because=(name, "cannot be written", "Choose"))


def test_a_refused_table_leaves_the_earlier_file(girdle: Girdle, refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "map.csv").write_text("kept\n")
    refuses("compare", "--table", "absent.csv", "--out", "map.csv", because=("absent.csv",))
    assert (tmp_path / "map.csv").read_text() == "kept\n"
