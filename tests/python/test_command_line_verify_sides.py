# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle verify` on left shoulders, both, loops and servos: sound ones pass, flaws fail."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import (
    ABOVE_TOLERANCE,
    Edit,
    Girdle,
    Refuses,
    RunProgram,
    find_element,
    remove_element,
)
from shared_results import SharedResults
from test_command_line_verify import (
    LANDMARKS,
    SMOOTHED,
    Caught,
    Report,
    in_joints,
    joined,
    move,
    numbers,
    scale_config,
    set_attribute,
    shift_keyframe,
    shift_reference,
    turn_axis,
    turn_body,
    verify,
)

SIDES = ("right", "left", "both")
LOOP = ("--assembly", "loop")
SCAPULA_LEADS = (*LOOP, "--lead", "scapula")
POSITION = ("--actuation", "position")
ASSEMBLIES: dict[str, tuple[str, ...]] = {
    "tree": (),
    "loop": LOOP,
    "scapula leads": SCAPULA_LEADS,
}
ACTUATIONS: dict[str, tuple[str, ...]] = {"plugin": (), "position": POSITION}


@pytest.fixture(scope="module")
def models(shared: SharedResults) -> Callable[..., Path]:
    """The model by the options that it was made with."""
    return lambda *options: shared.generate(*options).model


@pytest.fixture
def edited(models: Callable[..., Path], tmp_path: Path) -> Callable[..., Path]:
    """A model by its options with one edit."""

    def write(options: tuple[str, ...], edit: Edit) -> Path:
        tree = ElementTree.parse(models(*options))
        before = ElementTree.tostring(tree.getroot())
        edit(tree.getroot())
        assert ElementTree.tostring(tree.getroot()) != before, "the edit changes nothing"
        path = tmp_path / "edited.xml"
        tree.write(path)
        return path

    return write


# --- Sound models --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("side", "assembly", "actuation"), list(itertools.product(SIDES, ASSEMBLIES, ACTUATIONS))
)
def test_every_kind_of_model_passes(
    girdle: Girdle, models: Callable[..., Path], side: str, assembly: str, actuation: str
) -> None:
    words = ("--side", side, *ASSEMBLIES[assembly], *ACTUATIONS[actuation])
    code, report = verify(girdle, models(*words))
    assert (code, report.failed) == (0, set())
    kind = report.answer["kind"]
    assert kind.startswith("right and left" if side == "both" else side)
    assert ("assembly tree" in kind) == (assembly == "tree")
    assert ("the scapula leads" in kind) == (assembly == "scapula leads")
    assert kind.endswith("plugin" if actuation == "plugin" else "position servos")


def lines_of(report: Report) -> dict[Caught, float]:
    return {(r["group"], r["item"]): r["value"] for r in report.answer["residuals"]}


# What differs only by rounding: how a constraint's solver ends decides these digits.
SAME = 1e-6


@pytest.mark.parametrize("assembly", ASSEMBLIES)
def test_a_left_shoulder_has_the_lines_of_the_right_one(
    girdle: Girdle, models: Callable[..., Path], assembly: str
) -> None:
    _, right = verify(girdle, models(*ASSEMBLIES[assembly]))
    _, left = verify(girdle, models("--side", "left", *ASSEMBLIES[assembly]))
    assert lines_of(left) == pytest.approx(lines_of(right), abs=SAME)


@pytest.mark.parametrize("assembly", ASSEMBLIES)
def test_both_have_the_lines_of_each(girdle: Girdle, models: Callable[..., Path], assembly: str) -> None:
    _, right = verify(girdle, models(*ASSEMBLIES[assembly]))
    _, both = verify(girdle, models("--side", "both", *ASSEMBLIES[assembly]))
    lines = lines_of(right)
    of_the_model = {line: lines.pop(line) for line in list(lines) if line[0] == "time step"}
    assert len(of_the_model) == 1
    expected = of_the_model | {
        (group, f"{item}, {side}"): value
        for side in ("right", "left")
        for (group, item), value in lines.items()
    }
    assert lines_of(both) == pytest.approx(expected, abs=SAME)


def test_servos_are_held_against_the_rhythm_that_is_said(girdle: Girdle, models: Callable[..., Path]) -> None:
    published = ("--interpolation", "squad", "--closure", "table")
    code, report = verify(girdle, models(*POSITION, *published), *published)
    assert (code, report.failed) == (0, set())
    assert "squad" in report.answer["rhythm"]
    # They follow any; their keyframes are those of one.
    _, other = verify(girdle, models(*POSITION, *published))
    assert ("kinematic consistency", "keyframes") in other.failed


def test_what_ac_comes_out_as_in_a_loop_is_the_tables_own_contradiction(
    girdle: Girdle, models: Callable[..., Path]
) -> None:
    """2.03 deg rms: what the published tables disagree by is all that the simulator finds."""
    _, tree = verify(girdle, models())
    _, loop = verify(girdle, models(*LOOP))
    emergent = lines_of(loop)["emergent AC", "measured AC, rms"]
    own = lines_of(tree)["scapulothoracic", "published ST, rms"]
    assert emergent == pytest.approx(own, abs=0.01)
    assert 1.9 < emergent < 2.1


# --- Loops in which one thing has been changed ---------------------------------------------------

PLACE: Caught = ("kinematic consistency", "scapula's place")
KEYFRAMES: Caught = ("kinematic consistency", "keyframes")
KEYFRAME_PLACES: Caught = ("kinematic consistency", "keyframes, scapula's place")
CLAVICLE_SITES: Caught = ("kinematic consistency", "clavicle landmarks")
SCAPULA_SITES: Caught = ("kinematic consistency", "scapula landmarks")
AC_MOVING: set[Caught] = {("joint constraint", "AC moving"), ("joint constraint", "AC at 1 Hz")}
AC_AT_REST: Caught = ("joint constraint", "AC at rest")
AC_POSED: Caught = ("joint constraint", "AC at the worst pose")
NOT_STILL: Caught = ("tracking settled", "fastest joint")

# Each of these says by itself what is wrong. The others (closure, scapulothoracic, emergent AC and,
# where something is held by force, tracking) follow or not.
DIRECT_GROUPS = {"joint constraint", "bones", "kinematic consistency"}


def shift_place(name: str, root: ElementTree.Element) -> None:
    """A keyframe's last slide, by a tenth of a millimeter."""
    key = find_element(root, f".//key[@name='{name}']")
    qpos = numbers(key, "qpos")
    qpos[5] += 1e-4
    key.set("qpos", joined(qpos))


def shift_last_control(name: str, root: ElementTree.Element) -> None:
    key = find_element(root, f".//key[@name='{name}']")
    controls = numbers(key, "ctrl")
    controls[-1] += 1e-4
    key.set("ctrl", joined(controls))


def tilt_slide(root: ElementTree.Element) -> None:
    slide = find_element(root, ".//joint[@name='st_lateral_r']")
    axis = numbers(slide, "axis")
    axis[1] += 0.001
    slide.set("axis", joined(axis / np.linalg.norm(axis)))


def shift_slide(root: ElementTree.Element) -> None:
    slide = find_element(root, ".//joint[@name='st_anterior_r']")
    slide.set("ref", joined(numbers(slide, "ref") + 0.001))


@dataclass(frozen=True)
class Flaw:
    """One change to a sound loop, and all that says so directly."""

    edit: Edit
    caught: set[Caught]


IN_ANY_LOOP: dict[str, Flaw] = {
    "soft connect": Flaw(partial(set_attribute, "equality/connect", "solref", "0.05 1"), AC_MOVING),
    "PAC_r moved": Flaw(partial(move, "site", "PAC_r"), {LANDMARKS, CLAVICLE_SITES, PLACE}),
    "TS_r moved": Flaw(partial(move, "site", "TS_r"), {LANDMARKS, SCAPULA_SITES}),
    "clavicle turned": Flaw(
        partial(turn_body, "clavicle_r"),
        {*in_joints("kinematic consistency", ["SC", "AC"]), CLAVICLE_SITES},
    ),
    "scapula turned": Flaw(
        partial(turn_body, "scapula_r"),
        {*in_joints("kinematic consistency", ["AC"]), SCAPULA_SITES, PLACE},
    ),
    "a scapula's axis": Flaw(
        partial(turn_axis, "st_tilt_r"),
        {*in_joints("kinematic consistency", ["AC"]), SCAPULA_SITES},
    ),
    "a scapula's reference": Flaw(
        partial(shift_reference, "st_tilt_r"),
        {*in_joints("kinematic consistency", ["AC"]), SCAPULA_SITES},
    ),
    "a slide's axis": Flaw(tilt_slide, {PLACE}),
    "a slide's reference": Flaw(shift_slide, {PLACE}),
    "scapula moved": Flaw(partial(move, "body", "scapula_r"), {PLACE}),
    "a keyframe's place": Flaw(partial(shift_place, "abduction_60"), {KEYFRAME_PLACES}),
    "a keyframe's scapula": Flaw(partial(shift_keyframe, "flexion_90", 7), {KEYFRAMES}),
}

# The gap of the AC joint follows from these or not, by how much.
GAPS = {*AC_MOVING, AC_AT_REST, AC_POSED}


@pytest.mark.parametrize(
    ("name", "options"),
    [
        (name, (*assembly, *actuation))
        for name in IN_ANY_LOOP
        for assembly, actuation in [(LOOP, ()), (LOOP, POSITION), (SCAPULA_LEADS, ())]
    ],
)
def test_one_change_to_a_loop_is_caught_where_it_is_and_nowhere_else(
    girdle: Girdle, edited: Callable[..., Path], name: str, options: tuple[str, ...]
) -> None:
    flaw = IN_ANY_LOOP[name]
    code, report = verify(girdle, edited(options, flaw.edit))
    assert code == ABOVE_TOLERANCE
    direct = {line for line in report.failed if line[0] in DIRECT_GROUPS}
    follows = set() if flaw.caught & GAPS else GAPS
    humerus = {("kinematic consistency", "humerus landmarks")}
    assert direct - follows - humerus == flaw.caught - follows


@pytest.mark.parametrize("actuation", ACTUATIONS)
def test_the_place_that_a_keyframe_holds_the_scapula_at_is_caught(
    girdle: Girdle, edited: Callable[..., Path], actuation: str
) -> None:
    options = (*SCAPULA_LEADS, *ACTUATIONS[actuation])
    _, report = verify(girdle, edited(options, partial(shift_last_control, "abduction_60")))
    assert report.failed == {KEYFRAME_PLACES}


def loosen(root: ElementTree.Element) -> None:
    """The AC joint is not held at all."""
    find_element(root, "equality/connect").set("active", "false")


@pytest.mark.parametrize("options", [LOOP, SCAPULA_LEADS, (*LOOP, *POSITION)])
def test_an_ac_joint_that_nothing_holds_is_caught_at_rest_and_moving(
    girdle: Girdle, edited: Callable[..., Path], options: tuple[str, ...]
) -> None:
    code, report = verify(girdle, edited(options, loosen))
    assert code == ABOVE_TOLERANCE
    assert {AC_AT_REST, *AC_MOVING} <= report.failed


def narrow(joint: str, low: float, high: float, root: ElementTree.Element) -> None:
    find_element(root, f".//joint[@name='{joint}']").set("range", f"{low} {high}")


OTHER_FLAWS: Mapping[str, tuple[tuple[str, ...], Edit, set[Caught]]] = {
    "the scapula may not turn far enough": (
        LOOP,
        partial(narrow, "st_upward_rotation_r", -0.6, 0.5),
        {("tracking settled", "ST"), ("tracking moving", "ST")},
    ),
    "the scapula may not slide far enough": (
        LOOP,
        partial(narrow, "st_lateral_r", 0.155, 0.2),
        {AC_POSED, *AC_MOVING, ("tracking settled", "SC")},
    ),
    "sticky slides": (
        LOOP,
        partial(set_attribute, ".//joint[@name='st_lateral_r']", "damping", "40000"),
        {("tracking moving", "SC")},
    ),
    "the weight of the arm": (
        LOOP,
        partial(set_attribute, ".//body[@name='humerus_r']", "gravcomp", "0"),
        in_joints("tracking settled", ["SC", "ST", "GH"]),
    ),
    "the scapula softly placed": (
        SCAPULA_LEADS,
        partial(scale_config, "kp_translation", [0.02]),
        in_joints("tracking moving", ["SC"]),
    ),
    "the scapula softly turned": (
        LOOP,
        partial(scale_config, "kp", [1.0] * 3 + [0.01] * 3 + [1.0] * 3),
        in_joints("tracking settled", ["ST"]) | in_joints("tracking moving", ["ST"]),
    ),
}


@pytest.mark.parametrize(("options", "edit", "caught"), OTHER_FLAWS.values(), ids=OTHER_FLAWS.keys())
def test_a_loop_that_does_not_do_what_it_is_told_is_caught(
    girdle: Girdle,
    edited: Callable[..., Path],
    options: tuple[str, ...],
    edit: Edit,
    caught: set[Caught],
) -> None:
    code, report = verify(girdle, edited(options, edit))
    assert code == ABOVE_TOLERANCE
    assert caught <= report.failed
    # Nothing that is not a consequence of where the joints are.
    assert not any(group in ("bones", "kinematic consistency") for group, _ in report.failed)


def test_an_emergent_ac_that_is_not_the_measured_one_is_caught(
    girdle: Girdle, run_program: RunProgram, tmp_path: Path
) -> None:
    """AC drives nothing in a loop: a table with a wrong one moves as it should, and is found."""
    lines = SMOOTHED.read_text().splitlines()
    header = next(line for line in lines if not line.startswith("#")).split(",")
    column = header.index("ac_internal_rotation_deg")
    for number, line in enumerate(lines):
        fields = line.split(",")
        if line[:1].isdigit():
            fields[column] = repr(float(fields[column]) + 8.0)
        lines[number] = ",".join(fields)
    table = tmp_path / "mine.csv"
    table.write_text("\n".join(lines) + "\n")
    run_program("generate", "--out", tmp_path, *LOOP, "--table", table, "--range", "clamp")
    code, report = verify(girdle, tmp_path / "scene.xml")
    assert code == ABOVE_TOLERANCE
    assert report.failed == {
        ("emergent AC", "measured AC, rms"),
        ("emergent AC", "measured AC, worst"),
    }


# --- Left shoulders and both ---------------------------------------------------------------------


def turn_mesh_free(root: ElementTree.Element) -> None:
    """The left humerus where a right one would be: not mirrored."""
    body = find_element(root, ".//body[@name='humerus_l']")
    position = numbers(body, "pos")
    position[2] = -position[2]
    body.set("pos", joined(position))


LEFT_FLAWS: dict[str, Flaw] = {
    "TS_l moved": Flaw(partial(move, "site", "TS_l"), {LANDMARKS}),
    "an axis not mirrored": Flaw(
        lambda root: find_element(root, ".//joint[@name='gh_axial_l']").set("axis", "0 1 0"),
        in_joints("kinematic consistency", ["GH"]),
    ),
    "a place not mirrored": Flaw(turn_mesh_free, in_joints("joint constraint", ["GH"])),
    "scapula_l turned": Flaw(partial(turn_body, "scapula_l"), in_joints("kinematic consistency", ["AC"])),
    "a keyframe": Flaw(partial(shift_keyframe, "abduction_60", 4), {KEYFRAMES}),
    "a centre of mass not mirrored": Flaw(
        lambda root: find_element(root, ".//body[@name='scapula_l']/inertial").set(
            "pos", "0.0052 -0.0351 -0.0627"
        ),
        {("bones", "centres of mass")},
    ),
}
FROM_LANDMARKS = {"clavicle landmarks", "scapula landmarks", "humerus landmarks"}


@pytest.mark.parametrize("flaw", LEFT_FLAWS.values(), ids=LEFT_FLAWS.keys())
def test_one_change_to_a_left_shoulder_is_caught_where_it_is(
    girdle: Girdle, edited: Callable[..., Path], flaw: Flaw
) -> None:
    code, report = verify(girdle, edited(("--side", "left"), flaw.edit))
    assert code == ABOVE_TOLERANCE
    direct = {line for line in report.failed if line[0] in DIRECT_GROUPS}
    assert {line for line in direct if line[1] not in FROM_LANDMARKS} == flaw.caught


@pytest.mark.parametrize(("suffix", "side"), [("_r", "right"), ("_l", "left")])
def test_a_change_to_one_of_both_is_caught_on_its_side(
    girdle: Girdle, edited: Callable[..., Path], suffix: str, side: str
) -> None:
    edit = partial(move, "body", "humerus" + suffix)
    code, report = verify(girdle, edited(("--side", "both", *LOOP), edit))
    assert code == ABOVE_TOLERANCE
    assert report.failed == {("joint constraint", f"GH, {side}")}


def test_the_left_of_both_may_not_use_another_rhythm(girdle: Girdle, edited: Callable[..., Path]) -> None:
    def closure_table(root: ElementTree.Element) -> None:
        for key, value in (("closure", "table"), ("range", "clamp")):
            path = f".//instance[@name='rhythm_l']/config[@key='{key}']"
            find_element(root, path).set("value", value)

    code, report = verify(girdle, edited(("--side", "both"), closure_table))
    assert code == ABOVE_TOLERANCE
    assert ("kinematic consistency", "GH, left") in report.failed
    assert not any(item.endswith(", right") for _, item in report.failed)


# --- Models that are none ------------------------------------------------------------------------


def unsided(root: ElementTree.Element) -> None:
    """An instance without its side is a right shoulder's."""
    remove_element(root, ".//instance[@name='rhythm_l']/config[@key='side']")


NO_MODELS: dict[str, tuple[tuple[str, ...], Edit, tuple[str, ...]]] = {
    "the AC joint without its connect": (
        LOOP,
        lambda root: remove_element(root, "equality/connect"),
        ('has no equality "AC_r"', "girdle generate"),
    ),
    "a scapula that leads without the connect": (
        SCAPULA_LEADS,
        lambda root: remove_element(root, "equality/connect"),
        (r'no <connect site1="\.\.\."', "says where the AC joint is", "Add one"),
    ),
    "servos without the connect": (
        (*LOOP, *POSITION),
        lambda root: remove_element(root, "equality/connect"),
        ('has no equality "AC_r"', "girdle generate"),
    ),
    "a left shoulder told to be a right one": (
        ("--side", "left"),
        partial(set_attribute, ".//config[@key='side']", "value", "right"),
        ('instance "rhythm_l" moves a right shoulder', 'key="side" value="left"'),
    ),
    "a left shoulder not told its side": (
        ("--side", "left"),
        unsided,
        ('instance "rhythm_l" moves a right shoulder', 'key="side" value="left"'),
    ),
    "a left shoulder without its sensor": (
        ("--side", "left"),
        lambda root: remove_element(root, "sensor/plugin"),
        ('has no sensor "rhythm_l"', "girdle generate"),
    ),
    "a clavicle whose roll nothing holds": (
        SCAPULA_LEADS,
        partial(scale_config, "kp", [1.0, 1.0, 0.0] + [1.0] * 6),
        ('kp is "0 0 0 1000', "0 is for sc_protraction and sc_elevation alone"),
    ),
    "a loop whose clavicle leads and is not held": (
        LOOP,
        partial(scale_config, "kp", [0.0] + [1.0] * 8),
        ('kp is "0 1500 1500', "positive number", "or nine"),
    ),
    "a slide without its name": (
        LOOP,
        partial(set_attribute, ".//joint[@name='st_lateral_r']", "name", "mine"),
        ('has no joint "st_lateral_r"', "girdle generate"),
    ),
}


@pytest.mark.parametrize(("options", "edit", "because"), NO_MODELS.values(), ids=NO_MODELS.keys())
@pytest.mark.parametrize("verb", ["verify", "simulate"])
def test_a_model_that_lacks_something_is_refused_with_its_name(
    refuses: Refuses,
    edited: Callable[..., Path],
    verb: str,
    options: tuple[str, ...],
    edit: Edit,
    because: tuple[str, ...],
) -> None:
    path = edited(options, edit)
    words = ("--elevation", "0:30", "--out", "trace.csv") if verb == "simulate" else ()
    refuses(verb, path, *words, because=because)
