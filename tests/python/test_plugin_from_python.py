# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The engine plugin in stock Python: as a user of the wheel meets it, without any code of ours."""

from __future__ import annotations

import copy
import csv
import math
import pickle
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np
import pytest
from conftest import RunProgram
from reference_rhythm import (
    COORDINATES,
    DATABASE,
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    Array,
    elevation_and_plane_deg,
    inverse,
    multiply,
    quaternion_from_euler,
    read_database,
    rotation_angle_deg,
)
from reference_smooth import SmoothRhythm, read_joint_ranges
from shared_results import SharedResults

SEED = 20090201
RANDOM_COMMANDS = 300

COMMANDS = ("elevation", "plane", "axial")
OFFSETS = ("shrug", "protraction")
RATES = ("elevation_rate", "plane_rate", "axial_rate")
MOVING_BODIES = ("clavicle", "scapula", "humerus")
RHYTHM_SENSOR_SIZE = 27

# The same two factors as the program's, so that the same bits come out.
RAD_PER_DEG = math.pi / 180.0
DEG_PER_RAD = 180.0 / math.pi

# Two implementations in double precision differ by 1e-11 or so: the reference takes differences
# where the rule has a derivative in it.
TARGET_RAD = 1e-8
# Angles that only went through a few sines and cosines.
ROUNDING_RAD = 1e-12
# The same through quaternions, as an angle in degrees.
ROTATION_DEG = 1e-9
# The motion file is interpolated twice, here and in the program, over commands up to 135 deg.
MOTION_DEG = 1e-9

# The program runs MuJoCo 4. Earlier ones do their sums in another order.
OTHER_ENGINE_ROUNDING = 0.0 if mujoco.__version__.startswith("4.") else 1e-9


def same(value: object) -> object:
    """What equals `value` to the last bit, or to rounding in an engine of another series."""
    return pytest.approx(value, rel=0, abs=OTHER_ENGINE_ROUNDING)


# Up and down, across all planes, with a stretch outside the table, 15..120 and 0..90.
MOTION = (
    # time_s, elevation_deg, plane_deg
    (0.0, 20.0, 5.0),
    (0.2, 62.0, 20.0),
    (0.4, 110.0, 47.0),
    (0.6, 135.0, 100.0),
    (0.8, 88.0, 71.0),
    (1.0, 40.0, 30.0),
)


# --- The engine ----------------------------------------------------------------------------------


class Watch:
    """Collects the warnings of the engine: those on the data it is shown, those it prints."""

    def __init__(self) -> None:
        self.watched: list[mujoco.MjData] = []
        self.messages: list[str] = []

    def __call__(self, data: mujoco.MjData) -> mujoco.MjData:
        self.watched.append(data)
        return data

    def raised_on_data(self) -> list[str]:
        kinds = [k for k in mujoco.mjtWarning.__members__.values() if k.name.startswith("mjWARN_")]
        return [k.name for d in self.watched for k in kinds if d.warning[k].number > 0]


@pytest.fixture(autouse=True)
def watch(engine_with_plugin: None) -> Iterator[Watch]:
    """Any warning of the engine fails the test that it was raised in."""
    watching = Watch()
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(watching.messages.append)
    yield watching
    mujoco.set_mju_user_warning(before)
    assert not watching.raised_on_data()
    assert not watching.messages


@pytest.fixture
def model(watch: Watch, model_path: Path) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(model_path))


# --- A shoulder in a model -----------------------------------------------------------------------


@dataclass(frozen=True)
class Shoulder:
    """One right shoulder by the names of its elements, whatever it is a part of."""

    model: mujoco.MjModel
    prefix: str = ""

    def name(self, stem: str) -> str:
        return f"{self.prefix}{stem}_r"

    def command(self, data: mujoco.MjData, command_rad: Array) -> None:
        for stem, value in zip(COMMANDS, command_rad, strict=True):
            data.actuator(self.name(stem)).ctrl[0] = value

    def joints_rad(self, data: mujoco.MjData) -> Array:
        return np.array([data.joint(self.name(stem)).qpos[0] for stem in COORDINATES])

    def move_joints(self, data: mujoco.MjData, joints_rad: Array) -> None:
        for stem, value in zip(COORDINATES, joints_rad, strict=True):
            data.joint(self.name(stem)).qpos[0] = value

    def rotation_in_thorax(self, data: mujoco.MjData, body: str) -> Array:
        q_WT = data.body(f"{self.prefix}thorax").xquat
        return multiply(inverse(q_WT), data.body(self.name(body)).xquat)

    def rhythm(self, data: mujoco.MjData) -> Rhythm:
        return Rhythm(data.sensor(self.name("rhythm")).data.copy())


@dataclass(frozen=True)
class Rhythm:
    """The sensor, in radians: what was commanded, reached, aimed at and missed."""

    values: Array

    @property
    def commanded(self) -> Array:
        return self.values[0:3]

    @property
    def reached(self) -> Array:
        return self.values[3:6]

    @property
    def targets(self) -> Array:
        return self.values[6:15]

    @property
    def errors(self) -> Array:
        return self.values[15:24]

    @property
    def distance(self) -> float:
        return float(self.values[24])

    @property
    def axial_isb(self) -> Array:
        """Commanded and reached."""
        return self.values[25:27]


@pytest.fixture(scope="module")
def smooth() -> SmoothRhythm:
    """What the committed model moves by."""
    positions = read_database(DATABASE.with_name("ludewig2009_smoothed.csv"))
    return SmoothRhythm(positions, read_joint_ranges())


def expected_targets_rad(smooth: SmoothRhythm, commands_rad: list[Array]) -> Array:
    """The nine targets of each command, which is elevation, plane, axial, shrug, protraction.

    MuJoCo takes controls into their ranges before the plugin sees them.
    """
    elevation_deg, plane_deg, *further_deg = np.degrees(commands_rad).T
    control_deg = np.clip(elevation_deg, 0.0, 180.0)
    angles_deg = smooth.solve(control_deg, plane_deg, *further_deg).angles_deg
    return np.radians(np.stack([angles_deg[coordinate] for coordinate in COORDINATES], axis=1))


def random_commands_deg(low: tuple[float, float], high: tuple[float, float]) -> list[Array]:
    random = np.random.default_rng(SEED)
    return [np.array([*random.uniform(low, high), 0.0]) for _ in range(RANDOM_COMMANDS)]


MEASURED_COMMANDS_DEG = random_commands_deg((15.1, 0.1), (119.9, 89.9))
# Over all that an arm can reach; the measured domain is less than a quarter of this.
COMMANDS_DEG = random_commands_deg((-10.0, -115.0), (190.0, 155.0))


def is_measured(command_deg: Array) -> bool:
    elevation_deg, plane_deg, _ = command_deg
    return bool(15.0 <= elevation_deg <= 120.0 and 0.0 <= plane_deg <= 90.0)


def wandering_command_rad(step: int, phase: float = 0.0) -> Array:
    """A smooth command that runs over most of the measured domain within a second."""
    elevation_deg = 65.0 + 40.0 * math.sin(0.02 * step + phase)
    plane_deg = 45.0 + 40.0 * math.sin(0.031 * step + 2.0 * phase)
    return np.radians([elevation_deg, plane_deg, 5.0 * math.sin(0.01 * step)])


Snapshot = dict[str, Array]


def step_along(
    data: mujoco.MjData, shoulder: Shoulder, first: int, steps: int, phase: float = 0.0
) -> list[Snapshot]:
    """Steps with the wandering command and returns all that a user can read after each step."""
    snapshots = []
    for step in range(first, first + steps):
        shoulder.command(data, wandering_command_rad(step, phase))
        mujoco.mj_step(shoulder.model, data)
        fields = ("qpos", "qvel", "qacc", "actuator_force", "sensordata", "xquat", "site_xpos")
        snapshots.append({field: np.array(getattr(data, field)) for field in fields})
        snapshots[-1]["time"] = np.array(data.time)
    return snapshots


def assert_same_to_the_last_bit(snapshots: list[Snapshot], expected: list[Snapshot]) -> None:
    for step, (found, wanted) in enumerate(zip(snapshots, expected, strict=True)):
        for field in wanted:
            assert np.array_equal(found[field], wanted[field]), f"{field} after step {step}"


# --- The program and Python run the same motion -------------------------------------------------


@dataclass(frozen=True)
class Trace:
    header: list[str]
    rows: list[dict[str, float]]

    def landmarks(self, model: mujoco.MjModel) -> dict[str, tuple[str, str, str]]:
        """Site and its columns, of everything that follows the orientation of the humerus."""
        site_names = {model.site(i).name for i in range(model.nsite)}
        columns: dict[str, dict[str, str]] = {}
        for column in self.header[self.header.index("humerus_qz") + 1 :]:
            match = re.fullmatch(r"(?P<landmark>.+)_(?P<axis>[xyz])(_m)?", column)
            assert match, f"column {column} is not a coordinate of a landmark"
            landmark = match["landmark"]
            site = landmark if landmark in site_names else f"{landmark}_r"
            assert site in site_names, f"column {column}: the model has no site {site}"
            columns.setdefault(site, {})[match["axis"]] = column
        assert columns, f"the trace has no landmarks: {self.header}"
        return {site: (axes["x"], axes["y"], axes["z"]) for site, axes in columns.items()}


@pytest.fixture(scope="module")
def trace(run_program: RunProgram, model_path: Path, tmp_path_factory: pytest.TempPathFactory) -> Trace:
    directory = tmp_path_factory.mktemp("trace")
    motion_path, trace_path = directory / "motion.csv", directory / "trace.csv"
    lines = ["time_s,elevation_deg,plane_deg", *(",".join(map(repr, row)) for row in MOTION)]
    motion_path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    run_program("simulate", model_path, "--in", motion_path, "--out", trace_path)
    with trace_path.open(newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        rows = [{column: float(text) for column, text in row.items()} for row in reader]
    return Trace(list(reader.fieldnames or []), rows)


@dataclass(frozen=True)
class Moment:
    """What one row of a trace holds: the start of a step and what that step derived from it."""

    time: float
    joints_rad: Array
    targets_rad: Array
    quaternions: dict[str, Array]
    site_positions: Array


@pytest.fixture
def replay(watch: Watch, model: mujoco.MjModel, trace: Trace) -> list[Moment]:
    """The traced commands, given to the engine in Python; at rest where the motion begins."""
    shoulder = Shoulder(model)
    data = watch(mujoco.MjData(model))
    mujoco.mj_resetData(model, data)

    def command(row: dict[str, float]) -> None:
        shoulder.command(data, np.array([row[f"{name}_deg"] * RAD_PER_DEG for name in COMMANDS]))

    command(trace.rows[0])
    mujoco.mj_forward(model, data)
    shoulder.move_joints(data, shoulder.rhythm(data).targets)
    moments = []
    for i, row in enumerate(trace.rows):
        time, joints_rad = data.time, shoulder.joints_rad(data)
        command(row)
        is_last = i == len(trace.rows) - 1
        (mujoco.mj_forward if is_last else mujoco.mj_step)(model, data)
        moments.append(
            Moment(
                time=time,
                joints_rad=joints_rad,
                targets_rad=shoulder.rhythm(data).targets,
                quaternions={b: data.body(shoulder.name(b)).xquat.copy() for b in MOVING_BODIES},
                site_positions=data.site_xpos.copy(),
            )
        )
    return moments


def test_the_trace_has_its_columns_in_order(trace: Trace) -> None:
    expected = [
        "time_s",
        *(f"{command}_deg" for command in (*COMMANDS, *OFFSETS)),
        *("used_elevation_deg", "used_plane_deg"),
        "distance_deg",
        "used_axial_deg",
        "used_axial_isb_deg",
        *(f"used_{offset}_deg" for offset in OFFSETS),
        *(f"target_{coordinate}_deg" for coordinate in COORDINATES),
        *(f"{coordinate}_deg" for coordinate in COORDINATES),
        *(f"{body}_q{axis}" for body in MOVING_BODIES for axis in "wxyz"),
    ]
    assert trace.header[: len(expected)] == expected


def test_the_trace_has_a_row_for_every_step_and_one_for_the_end(model: mujoco.MjModel, trace: Trace) -> None:
    steps = round(MOTION[-1][0] / model.opt.timestep)
    assert len(trace.rows) == steps + 1
    assert trace.rows[0]["time_s"] == 0.0


def test_the_commands_in_the_trace_follow_the_motion_file(trace: Trace) -> None:
    """The direction goes from row to row along the great circle, at constant speed."""
    time_s, elevations_deg, planes_deg = np.array(MOTION).T
    theta, psi = np.radians(elevations_deg), np.radians(planes_deg)
    rows = np.stack([np.sin(theta) * np.sin(psi), -np.cos(theta), np.sin(theta) * np.cos(psi)]).T
    for row in trace.rows:
        i = min(int(np.searchsorted(time_s, row["time_s"], "right")) - 1, len(MOTION) - 2)
        share = (row["time_s"] - time_s[i]) / (time_s[i + 1] - time_s[i])
        whole = np.arccos(rows[i] @ rows[i + 1])
        x, y, z = (np.sin((1 - share) * whole) * rows[i] + np.sin(share * whole) * rows[i + 1]) / np.sin(
            whole
        )
        expected_deg = (np.degrees(np.arccos(-y)), np.degrees(np.arctan2(x, z)), 0.0)
        commands_deg = tuple(row[f"{command}_deg"] for command in COMMANDS)
        assert commands_deg == pytest.approx(expected_deg, abs=MOTION_DEG), row["time_s"]


def test_python_steps_at_the_same_times(replay: list[Moment], trace: Trace) -> None:
    for row, moment in zip(trace.rows, replay, strict=True):
        assert row["time_s"] == moment.time


@pytest.mark.parametrize("body", MOVING_BODIES)
def test_python_turns_the_bodies_to_the_same_bits(replay: list[Moment], trace: Trace, body: str) -> None:
    for row, moment in zip(trace.rows, replay, strict=True):
        traced = [row[f"{body}_q{axis}"] for axis in "wxyz"]
        assert traced == same(list(moment.quaternions[body])), f"at {moment.time!r} s"


def test_python_moves_the_landmarks_to_the_same_bits(
    replay: list[Moment], trace: Trace, model: mujoco.MjModel
) -> None:
    landmarks = trace.landmarks(model)
    for row, moment in zip(trace.rows, replay, strict=True):
        for site, columns in landmarks.items():
            traced = [row[column] for column in columns]
            position = list(moment.site_positions[model.site(site).id])
            assert traced == same(position), f"{site} at {moment.time!r} s"


@pytest.mark.parametrize("coordinate", COORDINATES)
def test_python_moves_the_joints_to_the_same_bits(
    replay: list[Moment], trace: Trace, coordinate: str
) -> None:
    i = COORDINATES.index(coordinate)
    for row, moment in zip(trace.rows, replay, strict=True):
        position_deg = moment.joints_rad[i] * DEG_PER_RAD
        assert row[f"{coordinate}_deg"] == same(position_deg), f"at {moment.time!r} s"


@pytest.mark.parametrize("coordinate", COORDINATES)
def test_python_aims_at_the_same_bits(replay: list[Moment], trace: Trace, coordinate: str) -> None:
    i = COORDINATES.index(coordinate)
    for row, moment in zip(trace.rows, replay, strict=True):
        target_deg = moment.targets_rad[i] * DEG_PER_RAD
        assert row[f"target_{coordinate}_deg"] == same(target_deg), f"at {moment.time!r} s"


@pytest.mark.parametrize("coordinate", COORDINATES)
def test_every_joint_moves_in_the_motion(replay: list[Moment], coordinate: str) -> None:
    """Bits that agree because nothing moved would prove nothing."""
    positions_rad = np.array([m.joints_rad[COORDINATES.index(coordinate)] for m in replay])
    assert np.ptp(positions_rad) > math.radians(1.0)


# --- Targets and the sensor ---------------------------------------------------------------------


@pytest.fixture
def data(watch: Watch, model: mujoco.MjModel) -> mujoco.MjData:
    return watch(mujoco.MjData(model))


@pytest.fixture
def shoulder(model: mujoco.MjModel) -> Shoulder:
    return Shoulder(model)


def forward(data: mujoco.MjData, shoulder: Shoulder, command_rad: Array) -> Rhythm:
    shoulder.command(data, command_rad)
    mujoco.mj_forward(shoulder.model, data)
    return shoulder.rhythm(data)


def test_the_sensor_has_its_27_numbers(data: mujoco.MjData, shoulder: Shoulder) -> None:
    assert shoulder.rhythm(data).values.shape == (RHYTHM_SENSOR_SIZE,)


def test_the_targets_are_the_references_angles(
    data: mujoco.MjData, shoulder: Shoulder, smooth: SmoothRhythm
) -> None:
    expected_rad = expected_targets_rad(smooth, [np.radians(c) for c in COMMANDS_DEG])
    for command_deg, targets_rad in zip(COMMANDS_DEG, expected_rad, strict=True):
        error_rad = forward(data, shoulder, np.radians(command_deg)).targets - targets_rad
        worst = int(np.argmax(np.abs(error_rad)))
        assert abs(error_rad[worst]) < TARGET_RAD, (COORDINATES[worst], command_deg, error_rad)


def test_the_distance_is_above_0_only_outside_the_measured_domain(
    data: mujoco.MjData, shoulder: Shoulder
) -> None:
    for command_deg in COMMANDS_DEG:
        distance_rad = forward(data, shoulder, np.radians(command_deg)).distance
        if is_measured(command_deg):
            assert distance_rad == 0.0, command_deg
        else:
            assert distance_rad > 0.0, command_deg


def test_an_axial_command_adds_to_the_last_gh_angle_alone(
    data: mujoco.MjData, shoulder: Shoulder, smooth: SmoothRhythm
) -> None:
    expected_rad = expected_targets_rad(smooth, [np.radians(c) for c in MEASURED_COMMANDS_DEG])
    for i, command_deg in enumerate(MEASURED_COMMANDS_DEG):
        axial_rad = math.radians((-20.0, 15.0)[i % 2])
        targets_rad = forward(data, shoulder, np.array([*np.radians(command_deg[:2]), axial_rad])).targets
        expected_rad[i, -1] += axial_rad
        assert targets_rad == pytest.approx(expected_rad[i], abs=TARGET_RAD), command_deg


def test_the_sensor_repeats_a_measured_command(data: mujoco.MjData, shoulder: Shoulder) -> None:
    for command_deg in MEASURED_COMMANDS_DEG:
        command_rad = np.radians(command_deg)
        commanded_rad = forward(data, shoulder, command_rad).commanded
        assert commanded_rad == pytest.approx(command_rad, abs=ROUNDING_RAD), command_deg


def test_the_tracking_error_is_target_minus_position(data: mujoco.MjData, shoulder: Shoulder) -> None:
    random = np.random.default_rng(SEED)
    for command_deg in MEASURED_COMMANDS_DEG:
        joints_rad = random.uniform(-0.5, 0.5, size=len(COORDINATES))
        shoulder.move_joints(data, joints_rad)
        rhythm = forward(data, shoulder, np.radians(command_deg))
        assert rhythm.errors == pytest.approx(rhythm.targets - joints_rad, abs=ROUNDING_RAD)


@pytest.fixture
def data_at_targets(
    data: mujoco.MjData, shoulder: Shoulder
) -> Callable[[Array], tuple[mujoco.MjData, Rhythm]]:
    """The data and its sensor with the joints where this command wants them."""

    def move(command_rad: Array) -> tuple[mujoco.MjData, Rhythm]:
        shoulder.move_joints(data, forward(data, shoulder, command_rad).targets)
        return data, forward(data, shoulder, command_rad)

    return move


def test_the_bodies_turn_as_the_joints_say_in_euler_angles(
    data_at_targets: Callable[[Array], tuple[mujoco.MjData, Rhythm]], shoulder: Shoulder
) -> None:
    for command_deg in MEASURED_COMMANDS_DEG:
        data, rhythm = data_at_targets(np.radians(command_deg))
        angles_deg = np.degrees(rhythm.targets).reshape(3, 3)
        expected = np.array([1.0, 0.0, 0.0, 0.0])
        for joint, body, joint_deg in zip(JOINT_COORDINATES, MOVING_BODIES, angles_deg, strict=True):
            expected = multiply(expected, quaternion_from_euler(JOINT_SEQUENCES[joint], joint_deg))
            found = shoulder.rotation_in_thorax(data, body)
            assert rotation_angle_deg(found, expected) < ROTATION_DEG, (body, command_deg)


def test_the_reached_elevation_and_plane_are_the_humerus_in_the_thorax(
    data_at_targets: Callable[[Array], tuple[mujoco.MjData, Rhythm]], shoulder: Shoulder
) -> None:
    for command_deg in MEASURED_COMMANDS_DEG:
        data, rhythm = data_at_targets(np.radians(command_deg))
        q_TH = shoulder.rotation_in_thorax(data, "humerus")
        expected_rad = np.radians(elevation_and_plane_deg(q_TH))
        assert rhythm.reached[:2] == pytest.approx(expected_rad, abs=TARGET_RAD), command_deg


def test_the_joints_settle_on_their_targets(data: mujoco.MjData, shoulder: Shoulder) -> None:
    """Design section 7: below 0.1 deg once settled."""
    command_rad = np.radians([75.0, 30.0, 0.0])
    for _ in range(round(5.0 / shoulder.model.opt.timestep)):
        shoulder.command(data, command_rad)
        mujoco.mj_step(shoulder.model, data)
    errors_deg = np.degrees(forward(data, shoulder, command_rad).errors)
    assert np.abs(errors_deg).max() < 0.1, dict(zip(COORDINATES, errors_deg, strict=True))


# --- Copies, resets and round trips ------------------------------------------------------------

STEPS = 200


def copied_by_engine(watch: Watch, data: mujoco.MjData) -> mujoco.MjData:
    copied = mujoco.MjData(data.model)
    mujoco.mj_copyData(copied, data.model, data)
    return watch(copied)


def copied_by_python(watch: Watch, data: mujoco.MjData) -> mujoco.MjData:
    return watch(copy.copy(data))


def copied_by_state(watch: Watch, data: mujoco.MjData) -> mujoco.MjData:
    """New data with the engine's own state: what the plugin kept elsewhere would be missing."""
    everything = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.empty(mujoco.mj_stateSize(data.model, everything))
    mujoco.mj_getState(data.model, data, state, everything)
    copied = mujoco.MjData(data.model)
    mujoco.mj_setState(data.model, copied, state, everything)
    return watch(copied)


# Not pickled data: MuJoCo 4.0.1 pickles the address in plugin_data as a number, and the copy frees
# it a second time. That is so with its own plugins too; models are pickled below.
# Before 3.5 the bindings do not have mj_copyData; copy.copy is made of it in all of them.
COPIES = [copied_by_python, copied_by_state]
if hasattr(mujoco, "mj_copyData"):
    COPIES.append(copied_by_engine)


@pytest.mark.parametrize("make_copy", COPIES)
def test_a_copy_steps_like_its_original(
    watch: Watch,
    data: mujoco.MjData,
    shoulder: Shoulder,
    make_copy: Callable[[Watch, mujoco.MjData], mujoco.MjData],
) -> None:
    step_along(data, shoulder, 0, STEPS)
    copied = make_copy(watch, data)
    of_copy = step_along(copied, Shoulder(copied.model), STEPS, STEPS)
    of_original = step_along(data, shoulder, STEPS, STEPS)
    assert_same_to_the_last_bit(of_copy, of_original)


def test_reset_data_step_like_new_data(watch: Watch, data: mujoco.MjData, shoulder: Shoulder) -> None:
    expected = step_along(watch(mujoco.MjData(shoulder.model)), shoulder, 0, STEPS)
    step_along(data, shoulder, 0, STEPS, phase=1.0)
    mujoco.mj_resetData(shoulder.model, data)
    assert_same_to_the_last_bit(step_along(data, shoulder, 0, STEPS), expected)


def test_a_model_saved_as_mjb_steps_like_its_original(
    watch: Watch, data: mujoco.MjData, shoulder: Shoulder, tmp_path: Path
) -> None:
    binary_path = tmp_path / "shoulder.mjb"
    mujoco.mj_saveModel(shoulder.model, str(binary_path))
    loaded = mujoco.MjModel.from_binary_path(str(binary_path))
    of_loaded = step_along(watch(mujoco.MjData(loaded)), Shoulder(loaded), 0, STEPS)
    assert_same_to_the_last_bit(of_loaded, step_along(data, shoulder, 0, STEPS))


def test_a_pickled_model_steps_like_its_original(
    watch: Watch, data: mujoco.MjData, shoulder: Shoulder
) -> None:
    loaded = pickle.loads(pickle.dumps(shoulder.model))
    of_loaded = step_along(watch(mujoco.MjData(loaded)), Shoulder(loaded), 0, STEPS)
    assert_same_to_the_last_bit(of_loaded, step_along(data, shoulder, 0, STEPS))


# --- Several at once -----------------------------------------------------------------------------

PHASES = (0.0, 1.3)


def test_two_data_of_one_model_do_not_disturb_each_other(
    watch: Watch, model: mujoco.MjModel, shoulder: Shoulder
) -> None:
    alone = [step_along(watch(mujoco.MjData(model)), shoulder, 0, STEPS, phase) for phase in PHASES]
    pair = [watch(mujoco.MjData(model)) for _ in PHASES]
    interleaved: list[list[Snapshot]] = [[] for _ in PHASES]
    for step in range(STEPS):
        for data, phase, snapshots in zip(pair, PHASES, interleaved, strict=True):
            snapshots.extend(step_along(data, shoulder, step, 1, phase))
    for found, expected in zip(interleaved, alone, strict=True):
        assert_same_to_the_last_bit(found, expected)
    assert not np.array_equal(alone[0][-1]["qpos"], alone[1][-1]["qpos"])


ATTACHED_PREFIXES = ("him_", "her_")


@pytest.fixture
def attached_model(watch: Watch, model_path: Path) -> mujoco.MjModel:
    """Two of the shoulder in a fresh model, one of them turned and moved away."""
    parent = mujoco.MjSpec()
    parent.compiler.degree = False  # MuJoCo 3.3.0 reads what it attaches in its own unit
    # The shoulder is to be stepped as it was made for; a parent that says otherwise gets a warning.
    parent.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    frames = (
        parent.worldbody.add_frame(),
        parent.worldbody.add_frame(pos=[1.0, -2.0, 0.5], quat=[0.8, 0.0, 0.36, 0.48]),
    )
    for prefix, frame in zip(ATTACHED_PREFIXES, frames, strict=True):
        child = mujoco.MjSpec.from_file(str(model_path))
        parent.attach(child, prefix=prefix, frame=frame)
    compiled = parent.compile()
    assert compiled.opt.timestep == child.option.timestep
    assert compiled.opt.integrator == child.option.integrator
    return compiled


def test_two_attached_shoulders_follow_their_own_commands(
    watch: Watch, attached_model: mujoco.MjModel, smooth: SmoothRhythm
) -> None:
    expected_rad = expected_targets_rad(smooth, [np.radians(c) for c in COMMANDS_DEG])
    data = watch(mujoco.MjData(attached_model))
    shoulders = [Shoulder(attached_model, prefix) for prefix in ATTACHED_PREFIXES]
    for pair in zip(range(0, RANDOM_COMMANDS, 2), range(1, RANDOM_COMMANDS, 2), strict=True):
        for shoulder, n in zip(shoulders, pair, strict=True):
            shoulder.command(data, np.radians(COMMANDS_DEG[n]))
        mujoco.mj_forward(attached_model, data)
        for shoulder, n in zip(shoulders, pair, strict=True):
            targets_rad = shoulder.rhythm(data).targets
            assert targets_rad == pytest.approx(expected_rad[n], abs=TARGET_RAD), (
                shoulder.prefix,
                COMMANDS_DEG[n],
            )


def test_an_attached_shoulder_reaches_the_same_place_in_its_own_thorax(
    watch: Watch, attached_model: mujoco.MjModel
) -> None:
    data = watch(mujoco.MjData(attached_model))
    command_rad = np.radians([70.0, 35.0, 0.0])
    shoulders = [Shoulder(attached_model, prefix) for prefix in ATTACHED_PREFIXES]
    for shoulder in shoulders:
        shoulder.move_joints(data, forward(data, shoulder, command_rad).targets)
    mujoco.mj_forward(attached_model, data)
    first, second = (shoulder.rhythm(data) for shoulder in shoulders)
    assert first.reached == pytest.approx(second.reached, abs=ROUNDING_RAD)
    assert first.errors == pytest.approx(np.zeros(9), abs=ROUNDING_RAD)
    assert second.errors == pytest.approx(np.zeros(9), abs=ROUNDING_RAD)


def test_the_joints_of_an_attached_shoulder_settle_on_their_own_targets(
    watch: Watch, attached_model: mujoco.MjModel
) -> None:
    """A force on the other shoulder's joint would leave both of them away from their targets."""
    data = watch(mujoco.MjData(attached_model))
    commands_deg = ([75.0, 30.0, 0.0], [40.0, 70.0, 0.0])
    shoulders = [Shoulder(attached_model, prefix) for prefix in ATTACHED_PREFIXES]
    for _ in range(round(5.0 / attached_model.opt.timestep)):
        for shoulder, command_deg in zip(shoulders, commands_deg, strict=True):
            shoulder.command(data, np.radians(command_deg))
        mujoco.mj_step(attached_model, data)
    mujoco.mj_forward(attached_model, data)
    for shoulder in shoulders:
        errors_deg = np.degrees(shoulder.rhythm(data).errors)
        assert np.abs(errors_deg).max() < 0.1, (shoulder.prefix, errors_deg)


# --- Further commands, and controls that are no numbers ------------------------------------------


@pytest.fixture(scope="module")
def further_path(shared: SharedResults) -> Path:
    return shared.generate("--offsets", "--rates").scene


@pytest.fixture
def further(watch: Watch, further_path: Path) -> Shoulder:
    """A shoulder with commands for offsets and rates."""
    return Shoulder(mujoco.MjModel.from_xml_path(str(further_path)))


def test_offsets_lead_where_the_reference_says(watch: Watch, further: Shoulder, smooth: SmoothRhythm) -> None:
    random = np.random.default_rng(SEED)
    low_deg, high_deg = (0.0, -95.0, -60.0, -15.0, -25.0), (180.0, 135.0, 60.0, 35.0, 30.0)
    commands_rad = [np.radians(random.uniform(low_deg, high_deg)) for _ in range(RANDOM_COMMANDS)]
    data = watch(mujoco.MjData(further.model))
    expected_rad = expected_targets_rad(smooth, commands_rad)
    for command_rad, targets_rad in zip(commands_rad, expected_rad, strict=True):
        for stem, value in zip((*COMMANDS, *OFFSETS), command_rad, strict=True):
            data.actuator(further.name(stem)).ctrl[0] = value
        mujoco.mj_forward(further.model, data)
        error_rad = np.abs(further.rhythm(data).targets - targets_rad)
        assert error_rad.max() < TARGET_RAD, (np.degrees(command_rad), error_rad)


def test_a_shrug_lifts_the_shoulder_and_leaves_the_arm_where_it_points(
    watch: Watch, further: Shoulder
) -> None:
    """Settled, in the world: the thorax's y is the world's z."""
    data = watch(mujoco.MjData(further.model))
    heights, arms = [], []
    for shrug_deg in (0.0, 12.0):
        mujoco.mj_resetData(further.model, data)
        further.command(data, np.radians([60.0, 40.0, 0.0]))
        data.actuator(further.name("shrug")).ctrl[0] = math.radians(shrug_deg)
        for _ in range(round(3.0 / further.model.opt.timestep)):
            mujoco.mj_step(further.model, data)
        heights.append(data.site("PAC_r").xpos[2] - data.site("SC_r").xpos[2])
        arms.append(elevation_and_plane_deg(further.rotation_in_thorax(data, "humerus")))
    length = np.linalg.norm(data.site("PAC_r").xpos - data.site("SC_r").xpos)
    rises_deg = np.degrees(np.arcsin(np.array(heights) / length))
    assert rises_deg[1] - rises_deg[0] == pytest.approx(12.0, abs=0.1)
    assert arms[1] == pytest.approx(arms[0], abs=0.1)
    assert arms[1] == pytest.approx((60.0, 40.0), abs=0.1)


def test_what_rates_add_is_the_damping_of_joints_that_keep_up(
    watch: Watch, further: Shoulder, smooth: SmoothRhythm
) -> None:
    data = watch(mujoco.MjData(further.model))
    command_deg, rates = [80.0, 30.0, 0.0], [1.5, -0.7, 0.4]
    forward(data, further, np.radians(command_deg))
    names = [further.name(stem) for stem in COORDINATES]
    plain_N_m = np.array([data.actuator(name).force[0] for name in names])
    for stem, rate in zip(RATES, rates, strict=True):
        data.actuator(further.name(stem)).ctrl[0] = rate
    mujoco.mj_forward(further.model, data)
    added_N_m = np.array([data.actuator(name).force[0] for name in names]) - plain_N_m
    # The targets a moment before and after.
    h = 1e-5
    moments = [np.radians(command_deg) + sign * h * np.array(rates) for sign in (1.0, -1.0)]
    after, before = expected_targets_rad(smooth, moments)
    damping = np.array([further.model.joint(name).damping[0] for name in names])
    assert added_N_m == pytest.approx(damping * (after - before) / (2 * h), abs=1e-4)


def assert_finite(data: mujoco.MjData) -> None:
    for field in ("qpos", "qvel", "qacc", "qfrc_actuator", "actuator_force", "sensordata"):
        assert np.isfinite(getattr(data, field)).all(), field


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e300])
def test_a_control_that_is_no_angle_makes_no_force_that_is_no_number(
    watch: Watch, further: Shoulder, value: float
) -> None:
    model = further.model
    expects_warning = math.isnan(value)
    for stem in (*COMMANDS, *OFFSETS, *RATES, *COORDINATES):
        # Not shown to the watch: MuJoCo itself warns of a NaN, once a step.
        data = mujoco.MjData(model)
        further.command(data, np.radians([60.0, 30.0, 0.0]))
        for step in range(20):
            data.actuator(further.name(stem)).ctrl[0] = value
            mujoco.mj_step(model, data)
            assert_finite(data)
            bad = data.warning[mujoco.mjtWarning.mjWARN_BADCTRL].number
            assert bad == (step + 1 if expects_warning else 0), stem
        others = [k for k in range(len(data.warning)) if k != mujoco.mjtWarning.mjWARN_BADCTRL]
        assert [data.warning[k].number for k in others] == [0] * len(others), stem
        data.actuator(further.name(stem)).ctrl[0] = 0.0
        mujoco.mj_step(model, data)
        assert_finite(data)
    if expects_warning:
        assert all("CTRL" in message for message in watch.messages)
        watch.messages.clear()


def test_without_mujocos_own_check_no_force_is_not_a_number_either(watch: Watch, further: Shoulder) -> None:
    """With clamping off a control goes to the plugin as it is."""
    model = further.model
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CLAMPCTRL
    for stem in (*COMMANDS, *OFFSETS, *RATES, *COORDINATES):
        for value in (math.inf, -math.inf, 1e300):
            data = mujoco.MjData(model)
            further.command(data, np.radians([60.0, 30.0, 0.0]))
            data.actuator(further.name(stem)).ctrl[0] = value
            mujoco.mj_forward(model, data)
            assert np.isfinite(data.actuator_force).all(), (stem, value)
            assert np.isfinite(data.qfrc_actuator).all(), (stem, value)
    watch.messages.clear()
