# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle generate` as a person types it."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import MODEL_FILE, SCENE_FILE, Girdle, Refuses, contents, find_element
from reference_rhythm import DATABASE

# An angle that went through a quaternion and back.
ROUNDING_DEG = 1e-9

# A position that is no keyframe, an angle that no other joint depends on.
CHANGED_PLANE, CHANGED_ELEVATION = "40", "60"
CHANGED_COLUMN = "gh_flexion_deg"
CHANGE_DEG = 2.5

PUBLISHED = ("--interpolation", "squad", "--closure", "table")
OFFSET_ACTUATORS = ("shrug_r", "protraction_r")
RATE_ACTUATORS = ("elevation_rate_r", "plane_rate_r", "axial_rate_r")


@pytest.fixture
def changed_angle_deg(tmp_path: Path) -> float:
    """The one angle that differs from the measured table in `mine.csv`."""
    lines = DATABASE.read_text().splitlines()
    columns = next(line for line in lines if not line.startswith("#")).split(",")
    (number,) = (
        i for i, line in enumerate(lines) if line.startswith(f"{CHANGED_PLANE},{CHANGED_ELEVATION},")
    )
    fields = lines[number].split(",")
    angle_deg = float(fields[columns.index(CHANGED_COLUMN)]) + CHANGE_DEG
    fields[columns.index(CHANGED_COLUMN)] = repr(angle_deg)
    lines[number] = ",".join(fields)
    (tmp_path / "mine.csv").write_text("\n".join(lines) + "\n")
    return angle_deg


def test_a_model_is_two_files(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "model")
    assert contents(tmp_path / "model").keys() == {MODEL_FILE, SCENE_FILE}


def test_the_scene_includes_the_model(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "model")
    scene = ElementTree.parse(tmp_path / "model" / SCENE_FILE)
    assert [include.get("file") for include in scene.findall("include")] == [MODEL_FILE]


def test_it_says_what_it_wrote(girdle_fine: Girdle) -> None:
    text = girdle_fine("generate", "--out", "model").text
    assert f"model/{MODEL_FILE}\n" in text
    assert f"model/{SCENE_FILE}\n" in text


def test_it_says_what_it_wrote_as_json(girdle_fine: Girdle) -> None:
    answer = json.loads(girdle_fine("generate", "--out", "model", "--json").text)
    assert (answer["model"], answer["scene"]) == (f"model/{MODEL_FILE}", f"model/{SCENE_FILE}")


@pytest.mark.numbers
def test_a_second_run_gives_the_same_bytes(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "first")
    girdle_fine("generate", "--out", "second")
    assert contents(tmp_path / "first") == contents(tmp_path / "second")


@pytest.mark.parametrize("place", [".", "deep/down/here", "absent/../beside", "with space/\u00fc"])
def test_the_place_does_not_change_the_model(
    girdle_fine: Girdle, generated: Path, tmp_path: Path, place: str
) -> None:
    girdle_fine("generate", "--out", place)
    for file in (MODEL_FILE, SCENE_FILE):
        assert (tmp_path / place / file).read_bytes() == (generated / file).read_bytes()


def test_an_absolute_place_gives_the_same_bytes_as_a_relative_one(
    girdle_fine: Girdle, tmp_path: Path
) -> None:
    girdle_fine("generate", "--out", "relative")
    girdle_fine("generate", "--out", tmp_path / "absolute")
    assert contents(tmp_path / "relative") == contents(tmp_path / "absolute")


def test_what_else_is_in_the_folder_stays(girdle_fine: Girdle, generated: Path, tmp_path: Path) -> None:
    (tmp_path / "model").mkdir()
    (tmp_path / "model" / "notes.txt").write_text("mine\n")
    (tmp_path / "model" / SCENE_FILE).write_text("earlier\n")
    girdle_fine("generate", "--out", "model")
    found = contents(tmp_path / "model")
    assert (tmp_path / "model" / "notes.txt").read_text() == "mine\n"
    del found["notes.txt"]
    assert found == contents(generated)


def plugin_config(model: Path) -> dict[str | None, str | None]:
    configs = ElementTree.parse(model).findall("extension/plugin/instance/config")
    return {config.get("key"): config.get("value") for config in configs}


# Options, and what the plugin is told: interpolation, closure, range and table.
CONFIGURED = [
    ((), ("smooth", "exact", "whole", "smoothed")),
    (("--table", "measured"), ("smooth", "exact", "whole", "measured")),
    (("--range", "clamp"), ("smooth", "exact", "clamp", "smoothed")),
    (("--closure", "table"), ("smooth", "table", "clamp", "smoothed")),
    (("--interpolation", "squad"), ("squad", "exact", "clamp", "measured")),
    (PUBLISHED, ("squad", "table", "clamp", "measured")),
    (
        ("--interpolation", "slerp", "--table", "smoothed"),
        ("slerp", "exact", "clamp", "smoothed"),
    ),
]


@pytest.mark.parametrize(
    ("options", "expected"), CONFIGURED, ids=[" ".join(options) for options, _ in CONFIGURED]
)
def test_the_model_says_what_it_moves_by(
    girdle_fine: Girdle, tmp_path: Path, options: tuple[str, ...], expected: tuple[str, ...]
) -> None:
    girdle_fine("generate", "--out", "model", *options)
    config = plugin_config(tmp_path / "model" / MODEL_FILE)
    keys = ("interpolation", "closure", "range", "table")
    assert tuple(config[key] for key in keys) == expected


def test_the_model_carries_the_table(girdle_fine: Girdle, tmp_path: Path, changed_angle_deg: float) -> None:
    girdle_fine("generate", "--out", "model", "--table", "mine.csv")
    table = plugin_config(tmp_path / "model" / MODEL_FILE)["table"]
    assert table is not None
    carried = list(csv.DictReader(table.split(";")))
    written = [line for line in (tmp_path / "mine.csv").open() if not line.startswith("#")]
    assert carried == list(csv.DictReader(written))


@pytest.mark.parametrize("interpolation", ["smooth", "squad", "slerp"])
def test_a_model_with_a_table_of_its_own_verifies(
    girdle_fine: Girdle, changed_angle_deg: float, interpolation: str
) -> None:
    options = ("--table", "mine.csv", "--interpolation", interpolation)
    girdle_fine("generate", "--out", "model", *options)
    assert json.loads(girdle_fine("verify", f"model/{SCENE_FILE}", "--json").text)["passed"]


def test_a_model_with_a_table_of_its_own_moves_by_it(
    girdle_fine: Girdle, tmp_path: Path, changed_angle_deg: float
) -> None:
    """What the plugin aims at in the simulation, at the position that was changed."""
    girdle_fine("generate", "--out", "model", "--table", "mine.csv", *PUBLISHED)
    (tmp_path / "stay.csv").write_text(
        f"time_s,elevation_deg,plane_deg\n0,{CHANGED_ELEVATION},{CHANGED_PLANE}\n"
    )
    trace = girdle_fine("simulate", f"model/{SCENE_FILE}", "--in", "stay.csv", "--out", "-").text
    (row,) = csv.DictReader(trace.splitlines())
    assert float(row[f"target_{CHANGED_COLUMN}"]) == pytest.approx(changed_angle_deg, abs=ROUNDING_DEG)


# --- Further commands ----------------------------------------------------------------------------


def actuator_names(model: Path) -> list[str]:
    root = ElementTree.parse(model).getroot()
    return [actuator.get("name", "") for actuator in root.findall("actuator/plugin")]


@pytest.mark.parametrize(
    ("options", "further"),
    [
        (("--offsets",), OFFSET_ACTUATORS),
        (("--rates",), RATE_ACTUATORS),
        (("--offsets", "--rates"), OFFSET_ACTUATORS + RATE_ACTUATORS),
    ],
    ids=["offsets", "rates", "both"],
)
def test_further_commands_stand_between_the_three_and_the_servos(
    girdle_fine: Girdle,
    generated: Path,
    tmp_path: Path,
    options: tuple[str, ...],
    further: tuple[str, ...],
) -> None:
    plain = actuator_names(generated / MODEL_FILE)
    girdle_fine("generate", "--out", "model", *options)
    assert actuator_names(tmp_path / "model" / MODEL_FILE) == [*plain[:3], *further, *plain[3:]]


def test_offsets_reach_as_far_as_a_clavicle_does(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "model", "--offsets")
    root = ElementTree.parse(tmp_path / "model" / MODEL_FILE).getroot()
    for name, expected_deg in (("shrug_r", (-15, 35)), ("protraction_r", (-25, 30))):
        actuator = find_element(root, f"actuator/plugin[@name='{name}']")
        found_deg = [math.degrees(float(x)) for x in actuator.get("ctrlrange", "").split()]
        assert found_deg == pytest.approx(expected_deg, abs=ROUNDING_DEG)


@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
def test_rates_need_an_interpolation_that_has_them(refuses: Refuses, interpolation: str) -> None:
    because = ("--rates", f"{interpolation} has no derivatives", "--interpolation smooth")
    options = ("--interpolation", interpolation, "--rates")
    refuses("generate", "--out", "model", *options, because=because)


@pytest.mark.parametrize("options", [("--closure", "table"), ("--range", "clamp")], ids=" ".join)
def test_rates_go_with_everything_smooth(girdle_fine: Girdle, options: tuple[str, ...]) -> None:
    girdle_fine("generate", "--out", "model", "--rates", *options)


def test_with_rates_the_joints_lag_less(girdle_fine: Girdle, generated: Path) -> None:
    """Fed forward, the rates leave next to nothing but what the servos do not know: inertia."""
    girdle_fine("generate", "--out", "model", "--rates")
    motion = ("--elevation", "0:150", "--plane", "40", "--seconds", "1.5", "--json")
    plain, fed = (
        json.loads(girdle_fine("simulate", scene, *motion).text)["worst_tracking_error_deg"]
        for scene in (generated / SCENE_FILE, f"model/{SCENE_FILE}")
    )
    assert fed < plain / 2
