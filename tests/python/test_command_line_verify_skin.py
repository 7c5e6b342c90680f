# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle verify` on models with a skin: the measured girdle passes, a frozen one fails, and what is
wrong with a skin is found in its own line."""

from __future__ import annotations

import csv
import json
import math
import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from conftest import ABOVE_TOLERANCE, MODEL_FILE, SCENE_FILE, Girdle, Refuses
from reference_rhythm import DATABASE, JOINT_COORDINATES, Array
from shared_results import SharedResults

MAPPING = Path(__file__).resolve().parents[2] / "data/mappings/girdle_right.csv"
SKIN_FILE = "shoulder_right.skn"
PLANES_DEG = (0, 40, 90)
LANDMARKS = ("skin_ac", "skin_acromion", "skin_mid_clavicle", "skin_scapular_spine", "skin_deltoid")

RISES = {f"acromion's skin rises, plane {plane}" for plane in PLANES_DEG}
# Stated, of the bones under that skin.
BONE_RISES = ("acromion's bone rises", "AC joint rises")
SQUEEZED = "area below half, plane 0"
BLEND = {f"MuJoCo - linear blend, {state}" for state in ("at rest", "moving")}
POSE = "MuJoCo - commanded pose"
BOUND = "bones - where they were bound"
DEPTH = "depth of landmarks, bind pose"
KNOTS = ("elevation", "plane")
# Of which vertices, and what of a jump passes [mm/deg].
VERTICES = {"MuJoCo": 0.01, "linear blend": 1e-6}
JUMPS = {f"jump of AC skin over {knots} knots, {of}" for knots in KNOTS for of in VERTICES}
# Stated.
OTHER_JUMPS = {f"jump of other landmarks over {knots} knots, linear blend" for knots in KNOTS}

# All lines that can fail.
CHECKED = RISES | JUMPS | BLEND | {SQUEEZED, POSE, BOUND, DEPTH}
# What an arm that turns in GH alone does to skin.
FROZEN_FAILS = RISES | {SQUEEZED}

# MuJoCo's vertices are single precision, a metre and a half above the floor [mm].
SINGLE_PRECISION_MM = 1e-3

# While which the model is simulated.
MOTIONS = {"abduction", "scapular plane", "flexion", "protraction at 90"}


@pytest.fixture(scope="session")
def skinned(shared: SharedResults) -> Path:
    """The folder of a model with a skin, which no test writes to."""
    return shared.generate("--skin", "implicit").folder


@dataclass(frozen=True)
class Report:
    """What `verify --json` prints."""

    code: int
    answer: dict[str, Any]

    @property
    def skin(self) -> dict[str, dict[str, Any]]:
        return {r["item"]: r for r in self.answer["residuals"] if r["group"] == "skin"}

    @property
    def others(self) -> list[dict[str, Any]]:
        return [r for r in self.answer["residuals"] if r["group"] != "skin"]

    @property
    def failed(self) -> set[str]:
        """Failed lines of the skin; nothing else may fail."""
        assert all(r["passed"] for r in self.others)
        failed = {item for item, r in self.skin.items() if not r["passed"]}
        assert self.code == (ABOVE_TOLERANCE if failed else 0)
        assert self.answer["passed"] == (not failed)
        return failed


@pytest.fixture(scope="session")
def measured(shared: SharedResults, skinned: Path) -> Report:
    verified = shared.verify(skinned / SCENE_FILE)
    assert (verified.code, verified.message) == (0, "")
    return Report(0, verified.answer)


def verify(girdle: Girdle, scene: Path, *options: str) -> Report:
    finished = girdle("verify", scene, "--json", *options)
    assert finished.message == "", finished.command
    return Report(finished.code, json.loads(finished.text))


# --- Measured and frozen -------------------------------------------------------------------------


def test_a_measured_girdle_passes_all_that_can_fail(measured: Report) -> None:
    assert measured.failed == set()
    assert {i for i, r in measured.skin.items() if r["tolerance"] is not None} == CHECKED


def test_the_blend_is_compared_at_rest_and_while_the_model_moves(measured: Report) -> None:
    """Without a comparison a line is no number and fails; with the other's it tells nothing."""
    at_rest, moving = (measured.skin[f"MuJoCo - linear blend, {state}"] for state in ("at rest", "moving"))
    assert at_rest["where"].startswith("pose, ")
    assert moving["where"].split(",")[0] in MOTIONS
    for line in (at_rest, moving):
        # Single precision leaves something, where anything was compared.
        assert 0 < line["value"] < line["tolerance"] == SINGLE_PRECISION_MM


@pytest.mark.numbers
def test_a_girdle_is_measured_unless_told_otherwise(girdle: Girdle, skinned: Path, measured: Report) -> None:
    assert verify(girdle, skinned / SCENE_FILE, "--girdle", "measured") == measured


def test_a_frozen_girdle_fails_in_what_it_does_to_skin(
    girdle: Girdle, skinned: Path, measured: Report
) -> None:
    frozen = verify(girdle, skinned / SCENE_FILE, "--girdle", "frozen")
    assert frozen.failed == FROZEN_FAILS
    assert frozen.skin.keys() == measured.skin.keys()
    assert frozen.others == measured.others
    assert frozen.answer["kind"] == measured.answer["kind"] + ", skin of a frozen girdle"
    # A bound between two values that nearly meet would tell nothing apart.
    for plane in PLANES_DEG:
        assert measured.skin[f"acromion's skin rises, plane {plane}"]["value"] > 8
        assert frozen.skin[f"acromion's skin rises, plane {plane}"]["value"] < 4
        for bone in BONE_RISES:
            assert measured.skin[f"{bone}, plane {plane}"]["value"] > 10
            assert frozen.skin[f"{bone}, plane {plane}"]["value"] == 0
    assert measured.skin[SQUEEZED]["value"] < 5
    assert frozen.skin[SQUEEZED]["value"] > 10


@pytest.mark.numbers
@pytest.mark.parametrize(
    "options",
    [
        ("--side", "left", "--assembly", "loop"),
        ("--side", "both", "--actuation", "position"),
        ("--interpolation", "squad", "--closure", "table"),
    ],
    ids="-".join,
)
def test_every_kind_of_model_tells_them_apart(
    girdle: Girdle, shared: SharedResults, options: tuple[str, ...]
) -> None:
    scene = shared.generate("--skin", "implicit", *options).scene
    sides = [", right", ", left"] if "both" in options else [""]
    assert verify(girdle, scene).failed == set()
    assert verify(girdle, scene, "--girdle", "frozen").failed == {
        line + side for line in FROZEN_FAILS for side in sides
    }


@pytest.mark.numbers
def test_a_small_person_is_measured_by_a_small_ruler(
    girdle: Girdle, girdle_fine: Girdle, tmp_path: Path
) -> None:
    girdle_fine("generate", "--skin", "implicit", "--stature", "1.2", "--out", "model")
    scene = tmp_path / "model" / SCENE_FILE
    report = verify(girdle, scene, "--stature", "1.2")
    assert report.failed == set()
    for line in RISES:
        assert report.skin[line]["tolerance"] == pytest.approx(8 * 1.2 / 1.71)
    # Held against an adult's bones the skin is not where they take it.
    assert not verify(girdle, scene, "--stature", "1.71").skin[POSE]["passed"]


# --- Continuity of the model's own rhythm --------------------------------------------------------

SLERP = ("--interpolation", "slerp", "--closure", "table")
SQUAD = ("--interpolation", "squad", "--closure", "table")

MakeSkinned = Callable[..., Path]


@pytest.fixture
def make_skinned(girdle_fine: Girdle, tmp_path: Path) -> MakeSkinned:
    """Makes a model with a skin in the test's folder; returns its scene."""

    def make(*options: str) -> Path:
        girdle_fine("generate", "--skin", "implicit", *options, "--out", "model")
        return tmp_path / "model" / SCENE_FILE

    return make


def jump(report: Report, knots: str, vertices: str) -> dict[str, Any]:
    return report.skin[f"jump of AC skin over {knots} knots, {vertices}"]


def test_the_default_model_is_smooth_to_the_last_digit_of_each_way(measured: Report) -> None:
    for knots in KNOTS:
        for vertices, tolerance in VERTICES.items():
            line = jump(measured, knots, vertices)
            assert line["tolerance"] == tolerance
            # Rounding leaves something, where anything was compared.
            assert 0 < line["value"] < tolerance / 2, line
    for other in OTHER_JUMPS:
        assert measured.skin[other]["tolerance"] is None
        assert 0 < measured.skin[other]["value"] < VERTICES["linear blend"]


@pytest.mark.numbers
def test_a_model_that_moves_by_slerp_jumps_in_the_ac_skin_and_fails_in_nothing_else(
    girdle: Girdle, make_skinned: MakeSkinned
) -> None:
    report = verify(girdle, make_skinned(*SLERP))
    assert report.code == ABOVE_TOLERANCE
    assert report.failed == JUMPS
    for knots in KNOTS:
        drawn, blended = (jump(report, knots, vertices) for vertices in VERTICES)
        assert blended["value"] > 0.1
        # MuJoCo's are looked at in fewer places, where the largest need not be.
        assert 0.5 * blended["value"] < drawn["value"] < blended["value"] + 0.01
        assert drawn["where"].startswith(("skin_ac,", "skin_acromion,"))


@pytest.mark.numbers
def test_a_model_that_moves_by_squad_is_smooth_over_elevation_and_bounded_over_plane(
    girdle: Girdle, make_skinned: MakeSkinned
) -> None:
    report = verify(girdle, make_skinned(*SQUAD))
    assert report.failed == set()
    for vertices, tolerance in VERTICES.items():
        assert jump(report, "elevation", vertices)["tolerance"] == tolerance
        over_plane = jump(report, "plane", vertices)
        # Without a bound of its own it would fail.
        assert over_plane["tolerance"] == 0.2
        assert tolerance < over_plane["value"] < 0.2
        assert over_plane["where"].endswith(
            "; squad is not C1 here: (9) spaces knots 40 and 50 deg apart, (5) assumes even ones"
        )


@pytest.mark.numbers
def test_what_is_said_over_the_model_is_what_is_measured(girdle: Girdle, skinned: Path) -> None:
    report = verify(girdle, skinned / SCENE_FILE, *SLERP)
    failed = {item for item, r in report.skin.items() if not r["passed"]}
    assert failed >= JUMPS


def table_of(sc_protraction_deg: Callable[[int, int], float]) -> str:
    """A table between whose rows slerp turns about one axis of each joint, at one speed: the other
    angles are those measured at elevation 60 in plane 40."""
    with DATABASE.open(encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        (row,) = (r for r in rows if (r["plane_deg"], r["elevation_deg"]) == ("40", "60"))
    names = [f"{name}_deg" for joint in JOINT_COORDINATES.values() for name in joint]
    angles = {name: float(row[name]) for name in names}
    table = [",".join(["plane_deg", "elevation_deg", *names])]
    for plane in (0, 30, 60, 90):
        for elevation in range(20, 121, 10):
            angles["sc_protraction_deg"] = sc_protraction_deg(elevation, plane)
            angles["gh_elevation_deg"] = -5 - elevation / 2
            table.append(",".join(str(value) for value in (plane, elevation, *angles.values())))
    return "\n".join(table) + "\n"


@pytest.mark.numbers
def test_a_table_of_the_users_own_is_what_is_measured(
    girdle: Girdle, make_skinned: MakeSkinned, tmp_path: Path
) -> None:
    """Slerp has no corner where nothing bends; one bent row has one, of 3 degrees in 10."""

    def even(elevation: int, plane: int) -> float:
        return -30 + elevation / 10 + plane / 15

    def bent(elevation: int, plane: int) -> float:
        return even(elevation, plane) + (3 if (elevation, plane) == (70, 60) else 0)

    reports = {}
    for name, sc_protraction_deg in (("even", even), ("bent", bent)):
        (tmp_path / "mine.csv").write_text(table_of(sc_protraction_deg))
        reports[name] = verify(girdle, make_skinned(*SLERP, "--table", "mine.csv")).skin
    assert all(reports["even"][line]["passed"] for line in JUMPS)
    assert not any(reports["bent"][line]["passed"] for line in JUMPS)
    for line in JUMPS:
        where = re.search(r"elevation (\S+), plane (\S+)", reports["bent"][line]["where"])
        # Places on the lines are a degree apart.
        assert where
        assert math.dist((float(where[1]), float(where[2])), (70, 60)) <= 0.5, line
    # Of a clavicle that turns by 3 deg more in 10 deg and then by as much less.
    lever_mm = reports["bent"]["jump of AC skin over elevation knots, linear blend"]["value"] / (
        math.radians(2 * 0.3)
    )
    assert 100 < lever_mm < 220


# --- The numbers, from MuJoCo in another program -------------------------------------------------


@pytest.fixture(scope="session")
def raised(shared: SharedResults, skinned: Path) -> mujoco.MjModel:
    """The same skin on bones that need no plugin, with keyframes at 30 and 120."""
    made = shared.generate("--skin", "implicit", "--actuation", "position")
    (skin,) = made.folder.glob("*.skn")
    assert skin.read_bytes() == (skinned / SKIN_FILE).read_bytes()
    return mujoco.MjModel.from_xml_path(str(made.scene))


def drawn_vertices(model: mujoco.MjModel, keyframe: str) -> Array:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key(keyframe).id)
    mujoco.mj_forward(model, data)
    scene = mujoco.MjvScene(model, 1000)
    mujoco.mjv_updateScene(
        model,
        data,
        mujoco.MjvOption(),
        None,
        mujoco.MjvCamera(),
        mujoco.mjtCatBit.mjCAT_ALL.value,
        scene,
    )
    return np.array(scene.skinvert, dtype=float).reshape(-1, 3)


def test_the_skin_rises_as_mujoco_draws_it(raised: mujoco.MjModel, measured: Report) -> None:
    acromion = raised.numeric("skin_acromion_r").data.astype(int)
    assert len(acromion) == 3
    low, high = (
        drawn_vertices(raised, f"abduction_{elevation}")[acromion, 2].mean() for elevation in (30, 120)
    )
    line = measured.skin["acromion's skin rises, plane 0"]
    assert line["value"] == pytest.approx(1000 * (high - low), abs=2 * SINGLE_PRECISION_MM)


def test_the_ac_joint_rises_as_mujoco_has_it(raised: mujoco.MjModel, measured: Report) -> None:
    heights = []
    for elevation in (30, 120):
        data = mujoco.MjData(raised)
        mujoco.mj_resetDataKeyframe(raised, data, raised.key(f"abduction_{elevation}").id)
        mujoco.mj_kinematics(raised, data)
        heights.append(data.site("ACJ_r").xpos[2])
    line = measured.skin["AC joint rises, plane 0"]
    assert line["value"] == pytest.approx(1000 * (heights[1] - heights[0]), abs=1e-6)


def test_skin_is_squeezed_as_mujoco_draws_it(raised: mujoco.MjModel, skinned: Path, measured: Report) -> None:
    skin = read_skin(skinned / SKIN_FILE)
    corners = skin.vertices[skin.triangles]
    near = np.linalg.norm(corners.mean(axis=1) - ac_joint(skin), axis=1) <= 0.06
    assert 100 < near.sum() < len(near) / 2

    def areas(vertices: Array) -> Array:
        a, b, c = np.moveaxis(vertices[skin.triangles[near]], 1, 0)
        return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2

    first, now = areas(skin.vertices), areas(drawn_vertices(raised, "abduction_120"))
    lines = measured.skin
    # A triangle that is very nearly half as large may count or not; they have 1/4 % of the area.
    assert lines[SQUEEZED]["value"] == pytest.approx(
        100 * first[now < first / 2].sum() / first.sum(), abs=0.5
    )
    assert lines["area kept, plane 0"]["value"] == pytest.approx(100 * now.sum() / first.sum(), abs=0.01)


# --- Skins with a change -------------------------------------------------------------------------


@dataclass
class SkinBone:
    name: bytes
    place: Array
    turn: Array
    vertices: Array
    weights: Array


@dataclass
class Skin:
    """An .skn file: four counts, vertices, triangles, bones; 32 bits a number."""

    vertices: Array
    triangles: Array
    bones: list[SkinBone]

    def bone(self, name: str) -> SkinBone:
        (bone,) = (b for b in self.bones if b.name.rstrip(b"\0") == name.encode())
        return bone


def read_skin(path: Path) -> Skin:
    content = path.read_bytes()
    at = 0

    def take(kind: str, count: int) -> Array:
        nonlocal at
        values = np.frombuffer(content, kind, count, at)
        at += values.nbytes
        return values.copy()

    vertices, coordinates, triangles, bones = take("<i4", 4)
    assert coordinates == 0
    skin = Skin(
        take("<f4", 3 * vertices).astype(float).reshape(-1, 3),
        take("<i4", 3 * triangles).reshape(-1, 3),
        [],
    )
    for _ in range(bones):
        name = take("S40", 1).tobytes()
        place, turn = take("<f4", 3).astype(float), take("<f4", 4).astype(float)
        (count,) = take("<i4", 1)
        skin.bones.append(SkinBone(name, place, turn, take("<i4", count), take("<f4", count).astype(float)))
    assert at == len(content)
    return skin


def skin_bytes(skin: Skin) -> bytes:
    parts = [
        struct.pack("<4i", len(skin.vertices), 0, len(skin.triangles), len(skin.bones)),
        skin.vertices.astype("<f4").tobytes(),
        skin.triangles.astype("<i4").tobytes(),
    ]
    for bone in skin.bones:
        parts += [
            bone.name.ljust(40, b"\0"),
            bone.place.astype("<f4").tobytes(),
            bone.turn.astype("<f4").tobytes(),
            struct.pack("<i", len(bone.vertices)),
            bone.vertices.astype("<i4").tobytes(),
            bone.weights.astype("<f4").tobytes(),
        ]
    return b"".join(parts)


def rotated(turn: Array, vector: Array) -> Array:
    """A vector turned by a unit quaternion w, x, y, z."""
    w, axis = turn[0], turn[1:]
    across = np.cross(axis, vector)
    return vector + 2 * (w * across + np.cross(axis, across))


def ac_joint(skin: Skin) -> Array:
    """Centre of the AC joint where the skin was bound, from the measured landmarks."""
    with DATABASE.with_name("landmarks.csv").open(encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        (row,) = (row for row in rows if row["landmark"] == "ACJ")
    assert row["segment"] == "scapula"
    bone = skin.bone("scapula_r")
    return bone.place + rotated(bone.turn, np.array([float(row[f"{axis}_m"]) for axis in "xyz"]))


EditXml = Callable[[ElementTree.Element], None]
WriteSkinned = Callable[..., Path]


@pytest.fixture
def write_skinned(skinned: Path, tmp_path: Path) -> WriteSkinned:
    """Writes the model with its skin and its XML edited into the test's folder."""

    def write(
        edit_skin: Callable[[Skin], None] = lambda skin: None,
        edit_xml: EditXml = lambda root: None,
    ) -> Path:
        skin = read_skin(skinned / SKIN_FILE)
        edit_skin(skin)
        (tmp_path / SKIN_FILE).write_bytes(skin_bytes(skin))
        tree = ElementTree.parse(skinned / MODEL_FILE)
        edit_xml(tree.getroot())
        tree.write(tmp_path / MODEL_FILE)
        scene = tmp_path / SCENE_FILE
        scene.write_bytes((skinned / SCENE_FILE).read_bytes())
        return scene

    return write


@pytest.mark.numbers
def test_a_skin_written_anew_is_the_same(girdle: Girdle, skinned: Path, write_skinned: WriteSkinned) -> None:
    """The control of all that follows."""
    assert skin_bytes(read_skin(skinned / SKIN_FILE)) == (skinned / SKIN_FILE).read_bytes()
    assert verify(girdle, write_skinned()).failed == set()


@pytest.mark.numbers
def test_skin_of_the_scapula_that_is_given_to_the_thorax_is_found(
    girdle: Girdle, write_skinned: WriteSkinned
) -> None:
    def give_away(skin: Skin) -> None:
        scapula, thorax = skin.bone("scapula_r"), skin.bone("thorax")
        weights = np.zeros(len(skin.vertices))
        for bone in (scapula, thorax):
            weights[bone.vertices] += bone.weights
        thorax.vertices = np.flatnonzero(weights)
        thorax.weights = weights[thorax.vertices]
        # A bone without a vertex is none.
        scapula.vertices, scapula.weights = scapula.vertices[:1], scapula.weights[:1]

    assert verify(girdle, write_skinned(give_away)).failed >= RISES


@pytest.mark.numbers
def test_a_vertex_that_is_in_the_joint_is_found(girdle: Girdle, write_skinned: WriteSkinned) -> None:
    def push_in(skin: Skin) -> None:
        joint = ac_joint(skin)
        nearest = np.argmin(np.linalg.norm(skin.vertices - joint, axis=1))
        skin.vertices[nearest] = joint

    report = verify(girdle, write_skinned(push_in))
    assert report.failed == {DEPTH}
    assert report.skin[DEPTH]["where"] == "ACJ"


@pytest.mark.numbers
def test_a_bone_that_was_elsewhere_when_the_skin_was_bound_is_found(
    girdle: Girdle, write_skinned: WriteSkinned
) -> None:
    def shift(skin: Skin) -> None:
        skin.bone("scapula_r").place[1] += 1e-4

    report = verify(girdle, write_skinned(shift))
    assert report.failed == {BOUND}
    assert report.skin[BOUND]["value"] == pytest.approx(0.1, abs=0.001)


@pytest.mark.numbers
def test_a_skin_that_is_no_linear_blend_is_found(girdle: Girdle, write_skinned: WriteSkinned) -> None:
    def inflate(root: ElementTree.Element) -> None:
        (skin,) = root.findall(".//skin")
        skin.set("inflate", "1e-4")

    report = verify(girdle, write_skinned(edit_xml=inflate))
    assert report.failed == BLEND | {POSE}
    for line in BLEND:
        assert report.skin[line]["value"] == pytest.approx(0.1, abs=0.001)


def test_a_vertex_that_is_no_number_is_found(girdle: Girdle, write_skinned: WriteSkinned) -> None:
    """All vertices after it are where they belong: none of them may hide it."""

    def lose(skin: Skin) -> None:
        skin.vertices[100] = np.nan

    assert verify(girdle, write_skinned(lose)).failed >= BLEND | {POSE}


@pytest.mark.numbers
def test_skin_without_a_share_of_the_humerus_stands_still_on_a_frozen_girdle(
    girdle: Girdle, raised: mujoco.MjModel, write_skinned: WriteSkinned
) -> None:
    """With the girdle frozen the humerus alone moves, and skin by its share in it."""
    still = [name for name in LANDMARKS if name != "skin_deltoid"]

    def give_away(skin: Skin) -> None:
        humerus, scapula = skin.bone("humerus_r"), skin.bone("scapula_r")
        weights = np.zeros((2, len(skin.vertices)))
        for of_bone, bone in zip(weights, (humerus, scapula), strict=True):
            of_bone[bone.vertices] = bone.weights
        for name in still:
            vertices = raised.numeric(f"{name}_r").data.astype(int)
            weights[1, vertices] += weights[0, vertices]
            weights[0, vertices] = 0
        for of_bone, bone in zip(weights, (humerus, scapula), strict=True):
            bone.vertices = np.flatnonzero(of_bone)
            bone.weights = of_bone[bone.vertices]

    scene = write_skinned(give_away)
    measured, frozen = (verify(girdle, scene, "--girdle", motion).skin for motion in ("measured", "frozen"))
    standing = {f"step of {name}" for name in still} | JUMPS
    for line in standing:
        # The same sum of the same bones' places, to the last bit.
        assert frozen[line]["value"] == 0, line
        assert measured[line]["value"] > 0, line
    # Steps are millimetres a degree of the arm, not rounding.
    assert all(measured[line]["value"] > 0.01 for line in standing if line.startswith("step"))
    # The humerus goes on moving, and the deltoid's skin with it.
    assert frozen["step of skin_deltoid"]["value"] > 0.1


# --- What is refused -----------------------------------------------------------------------------


def set_numeric(name: str, data: str | None) -> EditXml:
    def edit(root: ElementTree.Element) -> None:
        (numeric,) = root.findall(f".//numeric[@name='{name}']")
        if data is None:
            numeric.set("name", "something_else")
        else:
            numeric.set("data", data)

    return edit


@pytest.mark.parametrize(
    ("edit", "because"),
    [
        (set_numeric("skin_ac_r", None), r'no <numeric name="skin_ac_r">'),
        (set_numeric("skin_acromion_r", "1 2 99999"), r'"skin_acromion_r"> holds 99999, exp'),
        (set_numeric("skin_deltoid_r", "-1"), r'"skin_deltoid_r"> holds -1, expected'),
        (set_numeric("skin_deltoid_r", "2.5"), r'"skin_deltoid_r"> holds 2.5, expected'),
    ],
    ids=["missing", "too large", "negative", "no whole number"],
)
def test_landmarks_that_are_no_vertices_are_refused(
    refuses: Refuses, write_skinned: WriteSkinned, edit: EditXml, because: str
) -> None:
    scene = write_skinned(edit_xml=edit)
    refuses("verify", scene, because=(because, "girdle generate --skin"))


@pytest.mark.parametrize(
    ("bone", "other", "because"),
    [
        ("scapula_r", "world", '"world", which is no bone'),
        ("scapula_r", "clavicle_r", 'does not hang on "scapula_r"'),
        ("thorax", "clavicle_r", 'does not hang on the body "thorax"'),
    ],
)
def test_a_skin_on_other_bones_is_refused(
    refuses: Refuses, write_skinned: WriteSkinned, bone: str, other: str, because: str
) -> None:
    def rename(skin: Skin) -> None:
        skin.bone(bone).name = other.encode()

    scene = write_skinned(rename)
    refuses("verify", scene, because=(because, "girdle generate --skin"))


def test_a_frozen_girdle_needs_a_skin(refuses: Refuses, generated: Path) -> None:
    refuses(
        "verify",
        generated / SCENE_FILE,
        "--girdle",
        "frozen",
        because=("has no skin", "girdle generate --skin"),
    )


def test_a_girdle_is_measured_or_frozen(refuses: Refuses, skinned: Path) -> None:
    refuses(
        "verify",
        skinned / SCENE_FILE,
        "--girdle",
        "stiff",
        because=("--girdle stiff: not known", "measured, frozen"),
    )


def test_a_mapped_model_has_no_girdle_to_choose(refuses: Refuses, skinned: Path) -> None:
    refuses(
        "verify",
        skinned / SCENE_FILE,
        "--mapping",
        MAPPING,
        "--girdle",
        "frozen",
        because=("--girdle is for the skin", "Omit it"),
    )


def test_a_model_without_a_skin_has_no_lines_of_it(girdle: Girdle, generated: Path) -> None:
    assert verify(girdle, generated / SCENE_FILE).skin == {}
