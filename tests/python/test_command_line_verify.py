# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle verify` as a person types it: sound models pass, and one thing changed is found."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import (
    ABOVE_TOLERANCE,
    MODEL_FILE,
    SCENE_FILE,
    Edit,
    Girdle,
    WriteModel,
    find_element,
    remove_element,
)
from reference_rhythm import DATABASE, JOINT_COORDINATES, Array, multiply
from shared_results import SharedResults

GROUPS = {
    "time step",
    "joint constraint",
    "bones",
    "kinematic consistency",
    "tracking settled",
    "tracking moving",
    "closure",
    "range",
    "scapulothoracic",
    "ligaments",
}
JOINTS = ("SC", "AC", "GH")

# What the default model moves by.
SMOOTHED = DATABASE.with_name("ludewig2009_smoothed.csv")
PUBLISHED = ("--interpolation", "squad", "--closure", "table")

# The sizes of what is changed: small enough to be missed by the eye.
SHIFT_M = 0.001
TURN_RAD = math.radians(0.1)

Caught = tuple[str, str]
KEYFRAMES: Caught = ("kinematic consistency", "keyframes")
LANDMARKS: Caught = ("bones", "landmarks")


def in_joints(group: str, joints: Iterable[str] = JOINTS) -> set[Caught]:
    return {(group, joint) for joint in joints}


# Each of these says by itself what is wrong. The others (landmarks, closure, scapulothoracic) are
# consequences, which follow or not.
DIRECT: set[Caught] = {KEYFRAMES, LANDMARKS}.union(
    *map(
        in_joints,
        ("joint constraint", "kinematic consistency", "tracking settled", "tracking moving"),
    )
)


@dataclass(frozen=True)
class Report:
    """What `verify --json` prints."""

    answer: dict[str, Any]

    @property
    def failed(self) -> set[Caught]:
        return {(r["group"], r["item"]) for r in self.answer["residuals"] if not r["passed"]}

    @property
    def caught(self) -> set[Caught]:
        return self.failed & DIRECT


def verify(girdle: Girdle, scene: Path, *options: str | Path) -> tuple[int, Report]:
    finished = girdle("verify", scene, "--json", *options)
    assert finished.message == "", finished.command
    return finished.code, Report(json.loads(finished.text))


# --- The report ----------------------------------------------------------------------------------


def test_the_report_has_every_group(girdle: Girdle, generated: Path) -> None:
    _, report = verify(girdle, generated / SCENE_FILE)
    assert {residual["group"] for residual in report.answer["residuals"]} == GROUPS


def test_every_direct_residual_is_in_the_report(girdle: Girdle, generated: Path) -> None:
    _, report = verify(girdle, generated / SCENE_FILE)
    assert DIRECT - {(r["group"], r["item"]) for r in report.answer["residuals"]} == set()


def test_a_residual_passes_exactly_when_it_is_within_its_tolerance(
    girdle: Girdle, write_model: WriteModel
) -> None:
    _, report = verify(girdle, write_model(partial(move, "site", "TS_r")))
    residuals = report.answer["residuals"]
    assert {r["passed"] for r in residuals} == {True, False}
    for r in residuals:
        assert r["passed"] == (r["tolerance"] is None or r["value"] <= r["tolerance"]), r


def test_the_text_has_the_lines_of_the_json(girdle_fine: Girdle, generated: Path) -> None:
    scene = generated / SCENE_FILE
    answer = json.loads(girdle_fine("verify", scene, "--json").text)
    text = girdle_fine("verify", scene, "--full").text
    for r in answer["residuals"]:
        line = rf"^{re.escape(r['group'])} +{re.escape(r['item'])} .* {re.escape(r['unit'])} "
        assert len(re.findall(line, text, re.MULTILINE)) == 1, line
    checked = [r for r in answer["residuals"] if r["tolerance"] is not None]
    verdict = f"PASS: {len(checked)} residuals checked, all within their tolerances"
    assert text.endswith(f"\n{verdict}\n")


def test_the_text_of_a_model_that_fails_says_where(girdle: Girdle, write_model: WriteModel) -> None:
    scene = write_model(partial(move, "body", "scapula_r"))
    _, report = verify(girdle, scene)
    finished = girdle("verify", scene, "--full")
    assert (finished.code, finished.message) == (ABOVE_TOLERANCE, "")
    found = re.findall(r"^(\S.*?)  +(\S.*?)  .* FAIL ", finished.text, re.MULTILINE)
    assert set(found) == report.failed
    assert len(found) > 1
    checked = [r for r in report.answer["residuals"] if r["tolerance"] is not None]
    verdict = f"FAIL: {len(found)} of {len(checked)} residuals outside their tolerances"
    assert finished.text.endswith(f"\n{verdict}\n")


@pytest.mark.numbers
def test_two_runs_give_the_same_bytes(girdle_fine: Girdle, generated: Path) -> None:
    first, second = (girdle_fine("verify", generated / SCENE_FILE).output for _ in range(2))
    assert first == second


# --- Sound models --------------------------------------------------------------------------------


def test_the_committed_model_passes(girdle: Girdle, model_path: Path) -> None:
    code, report = verify(girdle, model_path)
    assert (code, report.failed) == (0, set())
    assert report.answer["passed"]


@pytest.mark.numbers
def test_the_model_passes_without_its_scene(girdle: Girdle, generated: Path) -> None:
    code, report = verify(girdle, generated / MODEL_FILE)
    assert (code, report.failed) == (0, set())


@pytest.mark.numbers
def test_a_model_written_anew_by_another_program_passes(girdle: Girdle, write_model: WriteModel) -> None:
    """The control of all that follows: the same way through the XML with no change at all."""
    code, report = verify(girdle, write_model())
    assert (code, report.failed) == (0, set())


def set_attribute(path: str, name: str, value: str, root: ElementTree.Element) -> None:
    find_element(root, path).set(name, value)


def scale_config(key: str, factors: Iterable[float], root: ElementTree.Element) -> None:
    config = find_element(root, f".//config[@key='{key}']")
    config.set("value", joined(np.array(numbers(config, "value")) * np.array(list(factors))))


def numbers(element: ElementTree.Element, name: str, default: str = "") -> Array:
    return np.array([float(word) for word in element.get(name, default).split()])


def joined(values: Iterable[float]) -> str:
    return " ".join(repr(float(value)) for value in values)


def remove_keyframes(root: ElementTree.Element) -> None:
    root.remove(find_element(root, "keyframe"))


def turn_thorax(root: ElementTree.Element) -> None:
    """By much, about an axis that is no axis of anything."""
    thorax = find_element(root, ".//body[@name='thorax']")
    thorax.set("quat", joined(multiply(np.array([0.8, 0.0, 0.36, 0.48]), numbers(thorax, "quat"))))


SOUND_MODELS: dict[str, Edit] = {
    "no keyframes": remove_keyframes,
    "standing elsewhere": partial(set_attribute, ".//body[@name='thorax']", "pos", "3 -2 0.5"),
    "turned": turn_thorax,
    "finer time step": partial(set_attribute, "option", "timestep", "0.001"),
}


@pytest.mark.parametrize(
    "edit",
    [
        pytest.param(edit, id=name, marks=() if name == "no keyframes" else pytest.mark.numbers)
        for name, edit in SOUND_MODELS.items()
    ],
)
def test_a_change_that_leaves_the_shoulder_what_it_is_passes(
    girdle: Girdle, write_model: WriteModel, edit: Edit
) -> None:
    code, report = verify(girdle, write_model(edit))
    assert (code, report.failed) == (0, set())


RHYTHMS: dict[str, tuple[str, ...]] = {
    "published": PUBLISHED,
    "smooth, closure table": ("--closure", "table"),
    "squad, closure exact": ("--interpolation", "squad"),
    "slerp, closure table": ("--interpolation", "slerp", "--closure", "table"),
    "range clamp": ("--range", "clamp"),
    "measured table": ("--table", "measured"),
    "offsets and rates": ("--offsets", "--rates"),
}


@pytest.fixture(scope="module")
def models(shared: SharedResults) -> Callable[..., Path]:
    """The folder of a model by the options that it was made with."""
    return lambda *options: shared.generate(*options).folder


@pytest.mark.parametrize("options", RHYTHMS.values(), ids=RHYTHMS.keys())
def test_a_model_of_every_rhythm_passes(
    girdle: Girdle, models: Callable[..., Path], options: tuple[str, ...]
) -> None:
    code, report = verify(girdle, models(*options) / SCENE_FILE)
    assert (code, report.failed) == (0, set())


def test_the_report_names_the_rhythm(girdle: Girdle, models: Callable[..., Path]) -> None:
    _, report = verify(girdle, models(*PUBLISHED) / SCENE_FILE)
    expected = "interpolation squad, closure table, range clamp, table measured"
    assert report.answer["rhythm"] == expected


def say_no_table(root: ElementTree.Element) -> None:
    remove_element(root, ".//config[@key='table']")


def test_a_model_that_says_no_table_is_held_against_the_one_that_is_named(
    girdle: Girdle, write_model: WriteModel
) -> None:
    """What it means is the default of its interpolation, with which it was made."""
    code, report = verify(girdle, write_model(say_no_table))
    assert (code, report.failed) == (0, set())
    assert report.answer["rhythm"].endswith(", range whole, table smoothed")


@pytest.mark.parametrize("interpolation", ["squad", pytest.param("slerp", marks=pytest.mark.numbers)])
def test_without_a_table_the_one_that_the_other_interpolation_uses_is_named(
    girdle: Girdle, write_model: WriteModel, interpolation: str
) -> None:
    """The figures are those of the table that the report names, and no other's."""
    scene = write_model(say_no_table)
    said = ("--interpolation", interpolation)
    _, unsaid = verify(girdle, scene, *said)
    _, measured = verify(girdle, scene, *said, "--table", "measured")
    _, smoothed = verify(girdle, scene, *said, "--table", "smoothed")
    expected = f"interpolation {interpolation}, closure exact, range clamp, table measured"
    assert unsaid.answer["rhythm"] == expected
    assert unsaid.answer == measured.answer
    assert unsaid.answer["residuals"] != smoothed.answer["residuals"]


def test_a_table_that_the_model_says_stays_under_another_interpolation(
    girdle: Girdle, generated: Path
) -> None:
    scene = generated / SCENE_FILE
    _, own = verify(girdle, scene, "--interpolation", "squad")
    _, smoothed = verify(girdle, scene, "--interpolation", "squad", "--table", "smoothed")
    assert own.answer["rhythm"].endswith("table smoothed")
    assert own.answer == smoothed.answer


def lines_of(report: Report, group: str) -> dict[str, dict[str, Any]]:
    return {r["item"]: r for r in report.answer["residuals"] if r["group"] == group}


REACHED = ("elevation reached - commanded", "plane reached - commanded")
OWN = ("elevation against the table's own", "plane against the table's own")


def test_an_exact_arm_goes_where_it_is_told_to(girdle: Girdle, generated: Path) -> None:
    _, report = verify(girdle, generated / SCENE_FILE)
    lines = lines_of(report, "closure")
    assert set(lines) == {*OWN, *REACHED}
    for item in REACHED:
        assert 0 <= lines[item]["value"] <= lines[item]["tolerance"] <= 1e-6


def test_how_far_the_tables_arm_misses_the_command_is_stated(
    girdle: Girdle, models: Callable[..., Path]
) -> None:
    """By 22.9 deg of plane, and more below 30: so generator/kinematics/README.md says."""
    _, report = verify(girdle, models(*PUBLISHED) / SCENE_FILE)
    lines = lines_of(report, "closure")
    high, low = lines["plane, from elevation 30"], lines["plane, below elevation 30"]
    assert high["tolerance"] is low["tolerance"] is None
    assert 20 < high["value"] < 25 < low["value"]
    assert all(lines[item]["value"] <= lines[item]["tolerance"] <= 1e-6 for item in OWN)


def test_what_was_not_measured_is_stated_and_not_judged(
    girdle: Girdle, generated: Path, models: Callable[..., Path]
) -> None:
    beside = "TS, AI to ellipsoid, outside measured data"
    _, whole = verify(girdle, generated / SCENE_FILE)
    distance = lines_of(whole, "range")["farthest from measured data"]
    # Straight up is 60 deg above the table, and a level arm behind the body farther beside it.
    assert distance["value"] > 45
    assert distance["tolerance"] is lines_of(whole, "scapulothoracic")[beside]["tolerance"] is None
    _, clamp = verify(girdle, models("--range", "clamp") / SCENE_FILE)
    assert lines_of(clamp, "range") == {}
    assert beside not in lines_of(clamp, "scapulothoracic")


# --- Models in which one thing has been changed --------------------------------------------------


def move(tag: str, name: str, root: ElementTree.Element) -> None:
    """In a direction that is no axis."""
    element = find_element(root, f".//{tag}[@name='{name}']")
    direction = np.array([2.0, -1.0, 2.0]) / 3.0
    element.set("pos", joined(numbers(element, "pos", "0 0 0") + SHIFT_M * direction))


def turn_body(name: str, root: ElementTree.Element) -> None:
    body = find_element(root, f".//body[@name='{name}']")
    turn = np.array([math.cos(TURN_RAD / 2), *(math.sin(TURN_RAD / 2) * np.ones(3) / 3**0.5)])
    body.set("quat", joined(multiply(numbers(body, "quat"), turn)))


def turn_axis(hinge: str, root: ElementTree.Element) -> None:
    """About a line across it."""
    joint = find_element(root, f".//joint[@name='{hinge}']")
    axis = numbers(joint, "axis")
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across /= np.linalg.norm(across)
    joint.set("axis", joined(math.cos(TURN_RAD) * axis + math.sin(TURN_RAD) * across))


def shift_reference(hinge: str, root: ElementTree.Element) -> None:
    joint = find_element(root, f".//joint[@name='{hinge}']")
    joint.set("ref", joined(numbers(joint, "ref") + TURN_RAD))


def swap_hinges(first: str, second: str, root: ElementTree.Element) -> None:
    body = find_element(root, f".//joint[@name='{first}']/..")
    children = list(body)
    i, j = (children.index(find_element(body, f"joint[@name='{n}']")) for n in (first, second))
    children[i], children[j] = children[j], children[i]
    body[:] = children


def shift_keyframe(name: str, coordinate: int, root: ElementTree.Element) -> None:
    key = find_element(root, f".//key[@name='{name}']")
    angles_rad = numbers(key, "qpos")
    angles_rad[coordinate] += TURN_RAD
    key.set("qpos", joined(angles_rad))


def scale_damping(factor: float, root: ElementTree.Element) -> None:
    for hinge in root.iterfind(".//body/joint"):
        hinge.set("damping", joined(factor * numbers(hinge, "damping")))


def swap_servos(first: str, second: str, root: ElementTree.Element) -> None:
    a, b = (find_element(root, f"actuator/plugin[@name='{name}']") for name in (first, second))
    a.attrib["joint"], b.attrib["joint"] = b.attrib["joint"], a.attrib["joint"]


def narrow_range(path: str, name: str, share: float, root: ElementTree.Element) -> None:
    """Takes so much off the upper end."""
    element = find_element(root, path)
    low, high = numbers(element, name)
    element.set(name, joined([low, high - share * (high - low)]))


def softened(joint: str) -> list[float]:
    return [0.01 if j == joint else 1.0 for j in JOINTS for _ in range(3)]


@dataclass(frozen=True)
class Tampering:
    """One change to a sound model and everything that says so directly."""

    edit: Edit
    caught: set[Caught]


# Bone, its joint to the one before it, and the sites that meet there.
BONES = {
    "clavicle_r": ("SC", "SC_r", "SC_clavicle_r"),
    "scapula_r": ("AC", "PAC_r", "PAC_scapula_r"),
    "humerus_r": ("GH", "GH_r", "GH_humerus_r"),
}
HINGES = {
    f"{coordinate}_r": joint.upper()
    for joint, coordinates in JOINT_COORDINATES.items()
    for coordinate in coordinates
}
LONE_LANDMARKS = (
    *("IJ", "PX", "C7", "T8"),
    *(f"{name}_r" for name in ("TS", "AI", "AA", "PC", "ACJ", "GC", "EM", "EL")),
)
KEYFRAME_NAMES = (
    *("hanging", "relaxed", "abduction_30", "abduction_60", "abduction_90", "abduction_120"),
    *("abduction_150", "flexion_90", "across_90"),
)


def tamperings() -> dict[str, Tampering]:
    rows = {}
    for bone, (joint, parent_site, child_site) in BONES.items():
        apart = in_joints("joint constraint", [joint])
        turned = in_joints("kinematic consistency", [joint])
        rows[f"{bone} moved"] = Tampering(partial(move, "body", bone), apart)
        rows[f"{bone} turned"] = Tampering(partial(turn_body, bone), turned)
        for site in (parent_site, child_site):
            rows[f"{site} moved"] = Tampering(partial(move, "site", site), apart | {LANDMARKS})
    for site in LONE_LANDMARKS:
        rows[f"{site} moved"] = Tampering(partial(move, "site", site), {LANDMARKS})
    for hinge, joint in HINGES.items():
        turned = in_joints("kinematic consistency", [joint])
        rows[f"{hinge} axis"] = Tampering(partial(turn_axis, hinge), turned)
        rows[f"{hinge} reference"] = Tampering(partial(shift_reference, hinge), turned)
    for joint, coordinates in JOINT_COORDINATES.items():
        # A keyframe lists its angles in the order of the hinges.
        caught = in_joints("kinematic consistency", [joint.upper()]) | {KEYFRAMES}
        hinges = [f"{coordinate}_r" for coordinate in coordinates]
        for first, second in (hinges[0:2], hinges[1:3], hinges[0:3:2]):
            edit = partial(swap_hinges, first, second)
            rows[f"{first} and {second} swapped"] = Tampering(edit, caught)
    for number, name in enumerate(KEYFRAME_NAMES):
        rows[f"keyframe {name}"] = Tampering(partial(shift_keyframe, name, number), {KEYFRAMES})
    rows["last angle of a keyframe"] = Tampering(partial(shift_keyframe, "flexion_90", 8), {KEYFRAMES})
    for command in ("elevation_r", "plane_r"):
        path = f"actuator/plugin[@name='{command}']"
        rows[f"{command} does not reach as far"] = Tampering(
            partial(narrow_range, path, "ctrlrange", 0.25), in_joints("kinematic consistency")
        )
    return rows


TAMPERINGS = tamperings()


@pytest.mark.numbers
@pytest.mark.parametrize("tampering", TAMPERINGS.values(), ids=TAMPERINGS.keys())
def test_one_change_is_caught_where_it_is_and_nowhere_else(
    girdle: Girdle, write_model: WriteModel, tampering: Tampering
) -> None:
    code, report = verify(girdle, write_model(tampering.edit))
    assert code == ABOVE_TOLERANCE
    assert not report.answer["passed"]
    assert report.caught == tampering.caught


# The plane goes round to 180, and arms to 135.
@pytest.mark.parametrize(("command", "share"), [("elevation_r", 0.06), ("plane_r", 0.14)])
def test_an_end_that_is_not_reached_is_caught_by_where_the_arm_is(
    girdle: Girdle, write_model: WriteModel, command: str, share: float
) -> None:
    """Beyond the motions that everything is run through: a grid goes to the ends."""
    path = f"actuator/plugin[@name='{command}']"
    code, report = verify(girdle, write_model(partial(narrow_range, path, "ctrlrange", share)))
    assert code == ABOVE_TOLERANCE
    assert {group for group, _ in report.failed} >= {"closure"}


TRACKING = ("tracking settled", "tracking moving")


# What a servo does wrong disturbs its neighbours: theirs may fail too, but nothing but tracking and
# what follows from it, that the arm is elsewhere.
BAD_SERVOS: Mapping[str, tuple[Edit, set[Caught]]] = {
    f"soft {joint}": (
        partial(scale_config, "kp", softened(joint)),
        in_joints("tracking settled", [joint]) | in_joints("tracking moving", [joint]),
    )
    for joint in JOINTS
} | {
    "overdamped": (partial(scale_damping, 100.0), in_joints("tracking moving")),
    "undamped": (partial(scale_damping, 0.0), in_joints("tracking settled")),
    "servos of SC swapped": (
        partial(swap_servos, "sc_protraction_r", "sc_elevation_r"),
        in_joints("tracking settled", ["SC"]) | in_joints("tracking moving", ["SC"]),
    ),
    "weight of the arm": (
        partial(set_attribute, ".//body[@name='humerus_r']", "gravcomp", "0"),
        in_joints("tracking settled", ["GH"]),
    ),
    "stop in the way": (
        partial(set_attribute, ".//joint[@name='gh_elevation_r']", "range", "-1 0.7"),
        in_joints("tracking settled", ["GH"]) | in_joints("tracking moving", ["GH"]),
    ),
}


@pytest.mark.numbers
@pytest.mark.parametrize(("edit", "caught"), BAD_SERVOS.values(), ids=BAD_SERVOS.keys())
def test_a_servo_that_does_not_follow_is_caught_by_tracking(
    girdle: Girdle, write_model: WriteModel, edit: Edit, caught: set[Caught]
) -> None:
    code, report = verify(girdle, write_model(edit))
    assert code == ABOVE_TOLERANCE
    assert caught <= report.failed
    assert {group for group, _ in report.failed} <= {*TRACKING, "closure"}


# --- Held against something else -----------------------------------------------------------------

# What a model was made with, what its configuration says instead, and what it is held to.
OTHER_RHYTHMS = {
    "slerp instead of squad": (PUBLISHED, ("interpolation", "slerp"), PUBLISHED),
    "table instead of exact": (
        *(("--range", "clamp"), ("closure", "table")),
        ("--closure", "exact", "--range", "clamp"),
    ),
    "measured instead of smoothed": ((), ("table", "measured"), ("--table", "smoothed")),
}


@pytest.mark.numbers
@pytest.mark.parametrize(("made", "written", "held"), OTHER_RHYTHMS.values(), ids=OTHER_RHYTHMS.keys())
def test_a_model_is_caught_that_does_not_move_by_the_rhythm_named(
    girdle: Girdle,
    models: Callable[..., Path],
    tmp_path: Path,
    made: tuple[str, ...],
    written: tuple[str, str],
    held: tuple[str, ...],
) -> None:
    tree = ElementTree.parse(models(*made) / MODEL_FILE)
    key, value = written
    find_element(tree.getroot(), f".//config[@key='{key}']").set("value", value)
    tree.write(tmp_path / MODEL_FILE)
    code, report = verify(girdle, tmp_path / MODEL_FILE, *held)
    assert code == ABOVE_TOLERANCE
    moved = ["GH"] if key == "closure" else JOINTS
    assert report.caught == in_joints("kinematic consistency", moved)


def write_changed_table(path: Path, column: str, change_deg: float) -> None:
    """One angle at elevation 60 of plane 40, which is no keyframe."""
    lines = SMOOTHED.read_text().splitlines()
    header = next(line for line in lines if not line.startswith("#")).split(",")
    (number,) = (i for i, line in enumerate(lines) if line.startswith("40,60,"))
    fields = lines[number].split(",")
    fields[header.index(column)] = repr(float(fields[header.index(column)]) + change_deg)
    lines[number] = ",".join(fields)
    path.write_text("\n".join(lines) + "\n")


def test_a_model_is_caught_that_does_not_move_by_the_table_named(
    girdle: Girdle, generated: Path, tmp_path: Path
) -> None:
    write_changed_table(tmp_path / "mine.csv", "gh_flexion_deg", 0.1)
    code, report = verify(girdle, generated / SCENE_FILE, "--table", "mine.csv")
    assert code == ABOVE_TOLERANCE
    assert report.caught == in_joints("kinematic consistency", ["GH"])


def test_a_table_is_caught_whose_scapula_is_not_where_its_joints_put_it(
    girdle: Girdle, generated: Path, tmp_path: Path
) -> None:
    """The published scapulothoracic angles drive nothing: nothing else may fail."""
    write_changed_table(tmp_path / "mine.csv", "st_upward_rotation_deg", 10.0)
    code, report = verify(girdle, generated / SCENE_FILE, "--table", "mine.csv")
    assert code == ABOVE_TOLERANCE
    assert {group for group, _ in report.failed} == {"scapulothoracic"}


def test_a_model_passes_that_moves_by_the_table_named(girdle: Girdle, generated: Path) -> None:
    code, report = verify(girdle, generated / SCENE_FILE, "--table", SMOOTHED)
    assert (code, report.failed) == (0, set())
