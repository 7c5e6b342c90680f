# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The committed models in the MuJoCo that runs these tests, held against the program's own.

The lines of `girdle verify` that need an engine, recomputed here: gaps of the joints, bones against
the rhythm, tracking; and every joint at every step against what the program simulates.
"""

from __future__ import annotations

import csv
import json
import math
import subprocess
from pathlib import Path

import mujoco
import numpy as np
import pytest
from conftest import PROGRAM_TIMEOUT_S
from reference_rhythm import (
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    Array,
    inverse,
    multiply,
    quaternion_from_euler,
    rotation_angle_deg,
)

pytestmark = pytest.mark.usefixtures("no_warning")

MODELS = Path(__file__).resolve().parents[2] / "model"
VERSION = tuple(int(part) for part in mujoco.__version__.split("."))
FAMILIES = ("shoulder_tree", "shoulder_loop", "shoulder_skin")

# Commands far apart, with turns about the arm's own axis and an end behind the frontal plane.
MOTION = """\
time_s,elevation_deg,plane_deg,axial_deg
0,0,0,0
1.2,150,0,0
2.4,90,90,20
3.6,30,-30,-20
4.8,120,70,0
6,0,0,0
"""
STEPS = 3000

# The engines do the same sums in an order of their own: rounding, of angles up to 3 rad.
SAME_RAD = 1e-9
# From 3.7 on MuJoCo counts the acceleration that a closed loop's motion brings along; before, a loop
# that moves gapes a little more.
COUNTS_MOTION = VERSION >= (3, 7)
SAME_IN_A_LOOP_RAD = SAME_RAD if COUNTS_MOTION else 1e-3

# The tolerances of `girdle verify`.
TREE_GAP_MM = 1e-6
LOOP_GAP_AT_REST_MM = 0.05
LOOP_GAP_MOVING_MM = 0.1
BONES_DEG = 1e-6
SETTLED_DEG = 0.01

SETTLING_S = 3.0
POSTURES_DEG = [(0.0, 0.0, 0.0), (90.0, 40.0, 0.0), (120.0, 90.0, 10.0), (150.0, 0.0, 0.0)]
# Pairs of sites that are one point: on the parent bone, on the child.
JOINT_SITES = {"SC": "SC_clavicle", "PAC": "PAC_scapula", "GH": "GH_humerus"}


def sides_of(model: mujoco.MjModel) -> list[str]:
    body = mujoco.mjtObj.mjOBJ_BODY
    found = [side for side in ("_r", "_l") if mujoco.mj_name2id(model, body, "humerus" + side) >= 0]
    assert found
    return found


def is_loop(family: str) -> bool:
    return family == "shoulder_loop"


def load(scene: Path) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_path(str(scene))
    return model, mujoco.MjData(model)


def command(data: mujoco.MjData, sides: list[str], posture_deg: tuple[float, ...]) -> None:
    for side in sides:
        for name, value_deg in zip(("elevation", "plane", "axial"), posture_deg, strict=True):
            data.actuator(name + side).ctrl[0] = math.radians(value_deg)


def largest_gap_mm(data: mujoco.MjData, sides: list[str]) -> float:
    apart = [
        data.site(parent + side).xpos - data.site(child + side).xpos
        for parent, child in JOINT_SITES.items()
        for side in sides
    ]
    return 1e3 * max(float(np.linalg.norm(each)) for each in apart)


def rotation_in(data: mujoco.MjData, parent: str, child: str) -> Array:
    return multiply(inverse(data.body(parent).xquat), data.body(child).xquat)


# --- Every joint at every step -------------------------------------------------------------------


@pytest.fixture(scope="module")
def motion(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("motion") / "motion.csv"
    path.write_text(MOTION)
    return path


def simulated(program: Path, scene: Path, motion: Path, folder: Path) -> tuple[list[dict[str, str]], Array]:
    """The program's trace, and what it tells position servos, a row a step."""
    trace, controls = folder / "trace.csv", folder / "controls.csv"
    results = ("--out", trace, "--out-controls", controls)
    words: list[str | Path] = ["simulate", scene, "--in", motion, *results]
    subprocess.run([program, *words], check=True, capture_output=True, timeout=PROGRAM_TIMEOUT_S)
    with trace.open() as file:
        rows = list(csv.DictReader(file))
    return rows, np.loadtxt(controls, delimiter=",", skiprows=1)[:, 1:]


def joints_apart_rad(model: mujoco.MjModel, data: mujoco.MjData, side: str, row: dict[str, str]) -> float:
    names = [name[len("target_") : -len("_deg")] for name in row if name.startswith("target_")]
    assert len(names) == 9
    there = np.radians([float(row[name + "_deg"]) for name in names])
    here = np.array([data.joint(name + side).qpos[0] for name in names])
    return float(np.abs(here - there).max())


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("scene", ["scene.xml", "scene_both.xml", "scene_position.xml"])
def test_every_joint_is_at_every_step_where_the_program_has_it(
    family: str, scene: str, program: Path, motion: Path, tmp_path: Path
) -> None:
    rows, controls = simulated(program, MODELS / family / scene.replace("_position", ""), motion, tmp_path)
    assert len(rows) == len(controls) == STEPS + 1
    model, data = load(MODELS / family / scene)
    same_rad = SAME_IN_A_LOOP_RAD if is_loop(family) else SAME_RAD
    side = sides_of(model)[0]
    moved = 0.0
    for step, row in enumerate(rows):
        apart_rad = joints_apart_rad(model, data, side, row)
        assert apart_rad < same_rad, (step, apart_rad)
        moved = max(moved, abs(float(row["gh_elevation_deg"]) - float(rows[0]["gh_elevation_deg"])))
        if model.nplugin:
            posture_deg = tuple(float(row[name]) for name in ("elevation_deg", "plane_deg", "axial_deg"))
            command(data, sides_of(model), posture_deg)
        else:
            data.ctrl[:] = controls[step]
        mujoco.mj_step(model, data)
    assert moved > 30, "nothing moves"


# From 3.11 on an actuator may have several controls and forces: this one four and three.
ORIENTATION = """
<mujoco>
  <option timestep="0.002" integrator="implicitfast"/>
  <worldbody>
    <body pos="0 0 3"><joint name="head" type="ball" damping="1"/><geom size="0.1"/></body>
  </worldbody>
  <actuator><orientation joint="head" kp="1" input="quat"/></actuator>
</mujoco>
"""


@pytest.mark.skipif(VERSION < (3, 11), reason="an actuator has one control and one force")
def test_actuators_of_several_controls_before_ours_change_nothing() -> None:
    shoulder = mujoco.MjSpec.from_file(str(MODELS / "shoulder_tree" / "shoulder_right.xml"))
    parent = mujoco.MjSpec.from_string(ORIENTATION)
    parent.worldbody.add_frame().attach_body(shoulder.body("thorax"), "her_", "")
    both = parent.compile()
    assert both.nu == both.nactuator + 3
    alone, alone_data = load(MODELS / "shoulder_tree" / "shoulder_right.xml")
    data = mujoco.MjData(both)
    for step in range(200):
        for each, prefix in ((data, "her_"), (alone_data, "")):
            # By address: before 3.17 the bindings take an actuator's number for that of its control.
            for name, value in (("elevation_r", 1 - math.cos(0.02 * step)), ("ac_tilt_r", 0.1)):
                actuator = each.model.actuator(prefix + name).id
                each.ctrl[each.model.actuator_ctrladr[actuator]] = value
        mujoco.mj_step(both, data)
        mujoco.mj_step(alone, alone_data)
    for k in range(9):
        name = alone.joint(k).name
        expected = alone_data.joint(name).qpos[0]
        assert data.joint("her_" + name).qpos[0] == pytest.approx(expected, abs=SAME_RAD), name
    assert abs(alone_data.joint("gh_elevation_r").qpos[0] - alone.qpos0[6]) > 0.3, "nothing moves"


# --- The lines of the report ---------------------------------------------------------------------


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("scene", ["scene.xml", "scene_left.xml", "scene_both.xml"])
def test_a_settled_shoulder_is_on_its_targets_and_its_joints_hold(family: str, scene: str) -> None:
    model, data = load(MODELS / family / scene)
    sides = sides_of(model)
    for posture_deg in POSTURES_DEG:
        command(data, sides, posture_deg)
        mujoco.mj_step(model, data, round(SETTLING_S / model.opt.timestep))
        mujoco.mj_forward(model, data)
        for side in sides:
            values = data.sensor("rhythm" + side).data
            assert np.degrees(np.abs(values[15:24])).max() < SETTLED_DEG, posture_deg
            assert np.degrees(values[3]) == pytest.approx(posture_deg[0], abs=SETTLED_DEG)
        limit_mm = LOOP_GAP_AT_REST_MM if is_loop(family) else TREE_GAP_MM
        assert largest_gap_mm(data, sides) < limit_mm, posture_deg


@pytest.mark.parametrize("plane_deg", [0.0, 40.0, 90.0])
@pytest.mark.parametrize("family", FAMILIES)
def test_joints_hold_while_the_arm_goes_through_the_table_once_a_second(
    family: str, plane_deg: float
) -> None:
    model, data = load(MODELS / family / "scene_both.xml")
    sides = sides_of(model)
    gap_mm = 0.0
    for step in range(round(2.0 / model.opt.timestep)):
        elevation_deg = 67.5 - 52.5 * math.cos(2.0 * math.pi * step * model.opt.timestep)
        command(data, sides, (elevation_deg, plane_deg, 0.0))
        mujoco.mj_step(model, data)
        if step * model.opt.timestep > 1.0:  # from then on it is periodic
            gap_mm = max(gap_mm, largest_gap_mm(data, sides))
    if is_loop(family):
        assert 1e-4 < gap_mm < LOOP_GAP_MOVING_MM
    else:
        assert gap_mm < TREE_GAP_MM


@pytest.mark.parametrize("scene", ["scene.xml", "scene_left.xml"])
def test_bones_are_turned_as_the_programs_rhythm_says(scene: str, program: Path) -> None:
    """By the engine's forward kinematics of the plugin's targets; nothing is settled."""
    model, data = load(MODELS / "shoulder_tree" / scene)
    (side,) = sides_of(model)
    for posture_deg in POSTURES_DEG:
        command(data, [side], posture_deg)
        mujoco.mj_forward(model, data)
        targets = data.sensor("rhythm" + side).data[6:15].copy()
        names = [model.joint(k).name for k in range(9)]
        for name, target in zip(names, targets, strict=True):
            data.joint(name).qpos[0] = target
        mujoco.mj_forward(model, data)
        words = ["--elevation", posture_deg[0], "--plane", posture_deg[1], "--axial", posture_deg[2]]
        solved = subprocess.run(
            [program, "solve", *map(str, words), "--json"], check=True, capture_output=True, text=True
        ).stdout
        expected = json.loads(solved)["angles_deg"]
        bones = ("thorax", "clavicle" + side, "scapula" + side, "humerus" + side)
        for joint, parent, child in zip(JOINT_SEQUENCES, bones, bones[1:], strict=False):
            angles_deg = [expected[name] for name in JOINT_COORDINATES[joint]]
            q = quaternion_from_euler(JOINT_SEQUENCES[joint], angles_deg)
            if side == "_l":  # the mirror image in the plane of x and y
                q = q * np.array([1.0, -1.0, -1.0, 1.0])
            assert rotation_angle_deg(q, rotation_in(data, parent, child)) < BONES_DEG, joint
