# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Left shoulders, both and loops in stock Python, as a user of the wheel meets them."""

from __future__ import annotations

import copy
import csv
import io
import itertools
import math
import pickle
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
from conftest import RunProgram
from reference_rhythm import COORDINATES, Array
from shared_results import SharedResults

pytestmark = pytest.mark.usefixtures("no_warning")

SIDES = {"right": ("_r",), "left": ("_l",), "both": ("_r", "_l")}
ASSEMBLIES: dict[str, tuple[str, ...]] = {
    "tree": (),
    "loop": ("--assembly", "loop"),
    "scapula leads": ("--assembly", "loop", "--lead", "scapula"),
}
POSITION = ("--actuation", "position")
KINDS = list(itertools.product(SIDES, ASSEMBLIES))

# The same motion by two ways of turning targets into forces: kp (target - q) and kp target - kp q
# round differently, and a constraint's solver ends by its tolerance.
SAME_RAD = 1e-9
VERSION = tuple(int(part) for part in mujoco.__version__.split("."))

# Through all planes, up to where it is not measured, and back.
MOTION = """time_s,elevation_deg,plane_deg,axial_deg
0,0,0,0
0.1,30,20,5
0.2,80,70,-10
0.3,130,40,0
0.4,90,-10,10
0.5,40,90,0
"""


@pytest.fixture(scope="module")
def made(shared: SharedResults) -> Callable[..., Path]:
    """The scene of a model by the options that it was made with."""
    return lambda *options: shared.generate(*options).scene


def load(scene: Path) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(scene))


# --- The same motion with the plugin and without it ----------------------------------------------


def table_of(text: str) -> tuple[list[str], Array]:
    rows = list(csv.reader(io.StringIO(text)))
    return rows[0], np.array([[float(field) for field in row] for row in rows[1:]])


@pytest.fixture(scope="module")
def motion(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("motion") / "motion.csv"
    path.write_text(MOTION)
    return path


def joints_in_trace(header: list[str], table: Array, assembly: str) -> Array:
    """The nine driven angles of a trace, row by row [rad]."""
    names = [
        name if assembly == "tree" or not name.startswith("ac_") else "st_" + name[3:] for name in COORDINATES
    ]
    columns = [header.index(name + "_deg") for name in names]
    return np.radians(table[:, columns])


def joints_of(model: mujoco.MjModel, data: mujoco.MjData, suffix: str) -> Array:
    """The nine driven angles of a shoulder [rad]."""
    stems = [name if data_has(model, name + suffix) else "st_" + name[3:] for name in COORDINATES]
    return np.array([data.joint(stem + suffix).qpos[0] for stem in stems])


def data_has(model: mujoco.MjModel, joint: str) -> bool:
    return mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, joint) >= 0


@pytest.mark.parametrize(("side", "assembly"), KINDS)
def test_controls_written_by_the_plugin_move_the_servos_alike(
    made: Callable[..., Path],
    motion: Path,
    run_program: RunProgram,
    tmp_path: Path,
    side: str,
    assembly: str,
) -> None:
    words = ("--side", side, *ASSEMBLIES[assembly])
    traces = {}
    for suffix in SIDES[side]:
        name = {"_r": "right", "_l": "left"}[suffix]
        run_program(
            *("simulate", made(*words), "--in", motion, "--side", name),
            *("--out", tmp_path / "trace.csv", "--out-controls", tmp_path / "controls.csv"),
        )
        trace = table_of((tmp_path / "trace.csv").read_text())
        traces[suffix] = joints_in_trace(*trace, assembly)
    header, controls = table_of((tmp_path / "controls.csv").read_text())
    servos = load(made(*words, *POSITION))
    data = mujoco.MjData(servos)
    columns = [name.rsplit("_", 1)[0] for name in header[1:]]
    assert columns == [servos.actuator(i).name for i in range(servos.nu)]
    # Before 3.7 what closes a loop leaves out the acceleration that its motion brings along.
    same_rad = SAME_RAD if assembly == "tree" or VERSION >= (3, 7) else 1e-3
    largest_rad = 0.0
    for row, targets in enumerate(controls[:, 1:]):
        for suffix, trace_rad in traces.items():
            apart_rad = np.abs(joints_of(servos, data, suffix) - trace_rad[row]).max()
            assert apart_rad < same_rad, (suffix, row)
            largest_rad = max(largest_rad, float(np.abs(trace_rad[row] - trace_rad[0]).max()))
        data.ctrl[:] = targets
        mujoco.mj_step(servos, data)
    assert len(controls) == 251
    assert largest_rad > 1, "nothing moves"


@pytest.mark.parametrize(("side", "assembly"), KINDS)
def test_the_program_moves_plugin_and_servos_alike(
    made: Callable[..., Path], motion: Path, run_program: RunProgram, side: str, assembly: str
) -> None:
    words = ("--side", side, *ASSEMBLIES[assembly])
    plugin, servos = (
        table_of(run_program("simulate", scene, "--in", motion, "--out", "-"))
        for scene in (made(*words), made(*words, *POSITION))
    )
    assert plugin[0] == servos[0]
    for column, name in enumerate(plugin[0]):
        unit = math.radians(1) if name.endswith("_deg") else 1.0
        apart = np.abs(plugin[1][:, column] - servos[1][:, column]).max() * unit
        assert apart < SAME_RAD, name


# --- Handled as users do -------------------------------------------------------------------------


def drive(model: mujoco.MjModel, data: mujoco.MjData, steps: int) -> Array:
    """The positions at the end of some steps, each side with its own commands."""
    for step in range(steps):
        for suffix, later in (("_r", 0.0), ("_l", 0.7)):
            data.actuator("elevation" + suffix).ctrl[0] = 1.2 - math.cos(0.02 * step + later)
            data.actuator("plane" + suffix).ctrl[0] = 0.5 + math.sin(0.03 * step + later)
        mujoco.mj_step(model, data)
    return data.qpos.copy()


@pytest.fixture(params=ASSEMBLIES)
def both(made: Callable[..., Path], request: pytest.FixtureRequest) -> mujoco.MjModel:
    return load(made("--side", "both", *ASSEMBLIES[request.param]))


def test_copies_of_both_go_on_as_their_original(both: mujoco.MjModel) -> None:
    data = mujoco.MjData(both)
    drive(both, data, 30)
    twin = copy.copy(data)
    assert (drive(both, twin, 30) == drive(both, data, 30)).all()


def test_reset_data_of_both_go_on_as_new_ones(both: mujoco.MjModel) -> None:
    data, fresh = mujoco.MjData(both), mujoco.MjData(both)
    drive(both, data, 30)
    mujoco.mj_resetData(both, data)
    assert (drive(both, data, 30) == drive(both, fresh, 30)).all()


def test_both_saved_as_mjb_go_on_as_their_original(both: mujoco.MjModel, tmp_path: Path) -> None:
    path = str(tmp_path / "both.mjb")
    mujoco.mj_saveModel(both, path)
    again = mujoco.MjModel.from_binary_path(path)
    assert (drive(again, mujoco.MjData(again), 30) == drive(both, mujoco.MjData(both), 30)).all()


def test_both_pickled_go_on_as_their_original(both: mujoco.MjModel) -> None:
    again = pickle.loads(pickle.dumps(both))
    assert (drive(again, mujoco.MjData(again), 30) == drive(both, mujoco.MjData(both), 30)).all()


# --- Attached to somebody else's torso -----------------------------------------------------------

TORSO = """
<mujoco model="somebody's">
  <compiler angle="radian"/>
  <option timestep="0.002" integrator="implicitfast"/>
  <worldbody>
    <body name="neck" pos="0 0 3">
      <joint name="nod" axis="0 1 0" damping="1" armature="0.1"/>
      <geom size="0.1" mass="1"/>
    </body>
    <body name="torso" pos="0.3 -0.2 0.1" quat="0.8 0 0 0.6">
      <geom type="capsule" size="0.05 0.1" contype="0" conaffinity="0"/>
      <site name="here"/>
    </body>
  </worldbody>
  <actuator><motor name="nod" joint="nod"/></actuator>
</mujoco>
"""


def attached(*shoulders: tuple[str, Path]) -> mujoco.MjModel:
    """The thorax of each model on the torso, by its prefix."""
    parent = mujoco.MjSpec.from_string(TORSO)
    for prefix, scene in shoulders:
        frame = parent.body("torso").add_frame()
        frame.attach_body(mujoco.MjSpec.from_file(str(scene)).body("thorax"), prefix, "")
    return parent.compile()


def put_command(data: mujoco.MjData, step: int, suffix: str, prefix: str = "", later: float = 0.0) -> None:
    data.actuator(f"{prefix}elevation{suffix}").ctrl[0] = 1.2 - math.cos(0.02 * step + later)
    data.actuator(f"{prefix}plane{suffix}").ctrl[0] = 0.5 + math.sin(0.03 * step + later)


# Prefix, sides and assembly of what is attached.
ATTACHED = {
    "right tree and left loop": [("his_", "right", "tree"), ("hers_", "left", "loop")],
    "both of a loop": [("its_", "both", "loop")],
    "both, and where the scapula leads": [("a_", "both", "tree"), ("b_", "left", "scapula leads")],
}


@pytest.mark.parametrize("shoulders", ATTACHED.values(), ids=ATTACHED.keys())
def test_attached_shoulders_move_as_alone(
    made: Callable[..., Path], shoulders: list[tuple[str, str, str]]
) -> None:
    scenes = [made("--side", side, *ASSEMBLIES[assembly]) for _, side, assembly in shoulders]
    prefixes = [prefix for prefix, _, _ in shoulders]
    torso = attached(*zip(prefixes, scenes, strict=True))
    data = mujoco.MjData(torso)
    alone = [load(scene) for scene in scenes]
    alone_data = [mujoco.MjData(model) for model in alone]
    for step in range(200):
        for later, (prefix, side, _) in enumerate(shoulders):
            for suffix in SIDES[side]:
                put_command(data, step, suffix, prefix, float(later))
                put_command(alone_data[later], step, suffix, "", float(later))
            mujoco.mj_step(alone[later], alone_data[later])
        mujoco.mj_step(torso, data)
    for model, own, (prefix, side, _) in zip(alone, alone_data, shoulders, strict=True):
        for i in range(model.njnt):
            name = model.joint(i).name
            apart_rad = abs(data.joint(prefix + name).qpos[0] - own.joint(name).qpos[0])
            assert apart_rad < SAME_RAD, prefix + name
        for suffix in SIDES[side]:
            sensed = data.sensor(f"{prefix}rhythm{suffix}").data
            assert sensed == pytest.approx(own.sensor("rhythm" + suffix).data, abs=1e-8)


def test_attached_shoulders_keep_connects_and_keyframes(made: Callable[..., Path]) -> None:
    loop = made("--side", "both", *ASSEMBLIES["loop"])
    torso = attached(("his_", made()), ("hers_", loop))
    assert [torso.equality(i).name for i in range(torso.neq)] == ["hers_AC_r", "hers_AC_l"]
    model = load(loop)
    names = [model.key(i).name for i in range(model.nkey)]
    data, own = mujoco.MjData(torso), mujoco.MjData(model)
    for name in names:
        mujoco.mj_resetDataKeyframe(torso, data, torso.key("hers_" + name).id)
        mujoco.mj_resetDataKeyframe(model, own, model.key(name).id)
        for _ in range(100):
            mujoco.mj_step(torso, data)
        for i in range(model.njnt):
            joint = model.joint(i).name
            assert data.joint("hers_" + joint).qpos[0] == pytest.approx(own.joint(joint).qpos[0], abs=1e-9), (
                name,
                joint,
            )


def test_what_was_attached_is_written_and_read_again(made: Callable[..., Path], tmp_path: Path) -> None:
    """As XML, by MuJoCo."""
    parent = mujoco.MjSpec.from_string(TORSO)
    scene = made("--side", "left", *ASSEMBLIES["scapula leads"])
    frame = parent.body("torso").add_frame()
    frame.attach_body(mujoco.MjSpec.from_file(str(scene)).body("thorax"), "her_", "")
    model = parent.compile()
    again = mujoco.MjModel.from_xml_string(parent.to_xml())
    data, again_data = mujoco.MjData(model), mujoco.MjData(again)
    for step in range(100):
        for own in (data, again_data):
            put_command(own, step, "_l", "her_")
        mujoco.mj_step(model, data)
        mujoco.mj_step(again, again_data)
    # MuJoCo writes numbers to so many digits.
    assert again_data.qpos == pytest.approx(data.qpos, abs=1e-5)
