# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models whose command for the axial turn is counted from ISB's zero or from the swing's."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from conftest import Refuses, RunProgram
from reference_rhythm import COORDINATES, DATABASE, Array, inverse, multiply, read_database
from reference_smooth import (
    AxialFrom,
    SmoothRhythm,
    angles_between_deg,
    isb_humerus,
    read_joint_ranges,
)
from shared_results import Made, SharedResults

SEED = 20050515
COMMANDS = 200

# Two implementations in double precision, one of which takes differences.
TARGET_RAD = 1e-8
# Angles that only went through a few quaternions.
ROUNDING_DEG = 1e-9

# A command's rate is that over a step, the rhythm's own share of it that at the step's beginning.
FED_FORWARD_DEG = 0.02

AXIAL, ISB_COMMANDED, ISB_REACHED = 2, 25, 26
TARGETS = slice(6, 15)


@pytest.fixture(scope="module")
def smooth() -> SmoothRhythm:
    positions = read_database(DATABASE.with_name("ludewig2009_smoothed.csv"))
    return SmoothRhythm(positions, read_joint_ranges())


@pytest.fixture(autouse=True)
def warnings(engine_with_plugin: None) -> Iterator[list[str]]:
    messages: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(messages.append)
    yield messages
    mujoco.set_mju_user_warning(before)
    assert messages == []


@pytest.fixture(scope="module", params=["isb", "swing"])
def zero(request: pytest.FixtureRequest) -> AxialFrom:
    chosen: AxialFrom = request.param
    return chosen


@pytest.fixture(scope="module")
def made(shared: SharedResults, zero: AxialFrom) -> Made:
    return shared.generate("--axial-from", zero, "--offsets", "--rates")


@pytest.fixture
def model(made: Made) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(made.scene))


def forward(model: mujoco.MjModel, data: mujoco.MjData, command_rad: Array) -> Array:
    for stem, value in zip(("elevation", "plane", "axial"), command_rad, strict=True):
        data.actuator(f"{stem}_r").ctrl[0] = value
    mujoco.mj_forward(model, data)
    return data.sensor("rhythm_r").data.copy()


def random_commands_deg() -> Array:
    """Elevation, plane and axial, some out of the controls' ranges."""
    random = np.random.default_rng(SEED)
    return random.uniform((-10.0, -200.0, -180.0), (190.0, 200.0, 90.0), (COMMANDS, 3)).T


def read_deg(commands_deg: Array) -> tuple[Array, Array, Array]:
    elevation_deg, plane_deg, axial_deg = commands_deg
    return np.clip(elevation_deg, 0.0, 180.0), (plane_deg + 180.0) % 360.0 - 180.0, axial_deg


def expected_targets_rad(smooth: SmoothRhythm, zero: AxialFrom, commands_deg: Array) -> Array:
    elevation_deg, plane_deg, axial_deg = read_deg(commands_deg)
    turn_deg = smooth.axial_on_rhythm_deg(elevation_deg, plane_deg, axial_deg, zero)
    angles_deg = smooth.solve(elevation_deg, plane_deg, turn_deg).angles_deg
    return np.radians(np.stack([angles_deg[c] for c in COORDINATES], axis=1))


def test_the_targets_are_the_references_angles(
    model: mujoco.MjModel, smooth: SmoothRhythm, zero: AxialFrom
) -> None:
    commands_deg = random_commands_deg()
    data = mujoco.MjData(model)
    expected_rad = expected_targets_rad(smooth, zero, commands_deg)
    for command_deg, targets_rad in zip(commands_deg.T, expected_rad, strict=True):
        found_rad = forward(model, data, np.radians(command_deg))[TARGETS]
        assert found_rad == pytest.approx(targets_rad, abs=TARGET_RAD), command_deg


def test_the_sensor_says_the_turn_from_the_rhythm_and_isbs(
    model: mujoco.MjModel, smooth: SmoothRhythm, zero: AxialFrom
) -> None:
    commands_deg = random_commands_deg()
    elevation_deg, plane_deg, axial_deg = read_deg(commands_deg)
    turn_deg = smooth.axial_on_rhythm_deg(elevation_deg, plane_deg, axial_deg, zero)
    expected = smooth.solve(elevation_deg, plane_deg, turn_deg)
    q_TH = multiply(multiply(expected.rotations["sc"], expected.rotations["ac"]), expected.rotations["gh"])
    data = mujoco.MjData(model)
    for n, command_deg in enumerate(commands_deg.T):
        values = forward(model, data, np.radians(command_deg))
        assert values[AXIAL] == pytest.approx(math.radians(expected.axial_deg[n]), abs=TARGET_RAD)
        used_deg = (expected.elevation_deg[[n]], expected.plane_deg[[n]])
        again = isb_humerus(*used_deg, np.degrees(values[[ISB_COMMANDED]]))
        assert angles_between_deg(again, q_TH[:, [n]])[0] < math.degrees(TARGET_RAD)


def test_the_humerus_reaches_isbs_angle_and_the_sensor_measures_it(
    model: mujoco.MjModel, zero: AxialFrom
) -> None:
    command_deg = np.array([70.0, 55.0, -40.0])
    data = mujoco.MjData(model)
    targets_rad = forward(model, data, np.radians(command_deg))[TARGETS]
    for stem, target_rad in zip(COORDINATES, targets_rad, strict=True):
        data.joint(f"{stem}_r").qpos[0] = target_rad
    mujoco.mj_forward(model, data)
    values = data.sensor("rhythm_r").data
    assert values[ISB_REACHED] == pytest.approx(values[ISB_COMMANDED], abs=1e-12)
    q_TH = multiply(inverse(data.body("thorax").xquat), data.body("humerus_r").xquat)
    reached_deg = np.degrees(values[[3, 4, ISB_REACHED]])[:, np.newaxis]
    assert angles_between_deg(isb_humerus(*reached_deg), q_TH[:, np.newaxis])[0] < ROUNDING_DEG
    if zero == "isb":
        assert reached_deg[:, 0] == pytest.approx(command_deg, abs=ROUNDING_DEG)


def test_what_rates_add_is_the_damping_of_joints_that_keep_up(
    model: mujoco.MjModel, smooth: SmoothRhythm, zero: AxialFrom
) -> None:
    data = mujoco.MjData(model)
    command_deg, rates = np.array([80.0, 30.0, -45.0]), np.array([1.5, -0.7, 0.4])
    forward(model, data, np.radians(command_deg))
    names = [f"{stem}_r" for stem in COORDINATES]
    plain_N_m = np.array([data.actuator(name).force[0] for name in names])
    for stem, rate in zip(("elevation_rate", "plane_rate", "axial_rate"), rates, strict=True):
        data.actuator(f"{stem}_r").ctrl[0] = rate
    mujoco.mj_forward(model, data)
    added_N_m = np.array([data.actuator(name).force[0] for name in names]) - plain_N_m
    h = 1e-5
    moments_deg = np.stack([command_deg + sign * np.degrees(h * rates) for sign in (1.0, -1.0)]).T
    after, before = expected_targets_rad(smooth, zero, moments_deg)
    damping = np.array([model.joint(name).damping[0] for name in names])
    assert added_N_m == pytest.approx(damping * (after - before) / (2 * h), abs=1e-4)


def test_the_range_of_the_command_holds_all_that_the_joint_allows(
    model: mujoco.MjModel, smooth: SmoothRhythm, zero: AxialFrom
) -> None:
    """At a direction the ends of the joint's range are numbers that the control can have."""
    low_rad, high_rad = model.actuator("axial_r").ctrlrange
    assert low_rad <= -math.pi
    assert high_rad >= math.pi
    elevations_deg, planes_deg = (
        grid.ravel() for grid in np.meshgrid(np.arange(0.0, 181.0, 10.0), np.arange(-30.0, 136.0, 15.0))
    )
    none_deg = np.zeros_like(elevations_deg)
    own_deg = smooth.solve(elevations_deg, planes_deg).angles_deg["gh_axial"]
    # Axial 0 of the zero, counted from the rhythm, and where the joint is then.
    turn_deg = smooth.axial_on_rhythm_deg(elevations_deg, planes_deg, none_deg, zero)
    at_zero_deg = own_deg + turn_deg
    for end_deg in read_joint_ranges()["gh_axial"]:
        numbers_deg = end_deg - at_zero_deg
        # Of whole turns, one is in the range.
        turns = np.ceil((math.degrees(low_rad) - 1e-6 - numbers_deg) / 360.0)
        assert (numbers_deg + 360.0 * turns <= math.degrees(high_rad) + 1e-6).all()


def test_the_list_of_names_has_the_ranges(model: mujoco.MjModel, zero: AxialFrom) -> None:
    readme = (DATABASE.parents[1] / "model" / "README.md").read_text(encoding="utf-8")
    found = re.search(
        r"With `--axial-from isb` or `swing` the range of `axial_\*` is (\S+) to (\S+) or (\S+) to (\S+): ",
        readme,
    )
    assert found
    stated = found.groups()[:2] if zero == "isb" else found.groups()[2:]
    ends_deg = np.degrees(model.actuator("axial_r").ctrlrange)
    assert [int(text) for text in stated] == [round(end) for end in ends_deg]


def test_keyframes_stand_where_their_controls_lead(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    for key in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        assert np.abs(data.actuator_force).max() < 1e-9, model.key(key).name
    assert (model.key("hanging").ctrl == 0).all()
    # Where the model stands with all controls at zero.
    assert model.key("hanging").qpos == pytest.approx(model.qpos0, abs=1e-12)


def test_the_arm_of_a_keyframe_has_the_rhythms_own_turn(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("abduction_90").id)
    mujoco.mj_forward(model, data)
    assert data.sensor("rhythm_r").data[AXIAL] == pytest.approx(0.0, abs=1e-12)


def test_derivatives_by_the_controls_go_through_the_zero(
    model: mujoco.MjModel, smooth: SmoothRhythm, zero: AxialFrom
) -> None:
    data = mujoco.MjData(model)
    command_deg = np.array([80.0, 30.0, -45.0])
    forward(model, data, np.radians(command_deg))
    D = np.zeros((model.nsensordata, model.nu))
    mujoco.mjd_transitionFD(model, data, 1e-6, 0, None, None, None, D)
    address = model.sensor("rhythm_r").adr[0]
    for i, stem in enumerate(("elevation", "plane", "axial")):
        step_deg = np.zeros(3)
        step_deg[i] = 1e-4
        moments_deg = np.stack([command_deg + step_deg, command_deg - step_deg]).T
        after, before = expected_targets_rad(smooth, zero, moments_deg)
        expected = (after - before) / math.radians(2e-4)
        found = D[address + 6 : address + 15, model.actuator(f"{stem}_r").id]
        assert found == pytest.approx(expected, abs=1e-4), stem


# --- Files ---------------------------------------------------------------------------------------


def test_the_model_says_what_it_counts_from(made: Made, zero: AxialFrom) -> None:
    configs = ElementTree.parse(made.model).findall("extension/plugin/instance/config")
    assert {c.get("key"): c.get("value") for c in configs}["axial_from"] == zero


def test_an_unknown_zero_is_refused_when_the_model_starts(made: Made, tmp_path: Path) -> None:
    text = made.model.read_text()
    for word in ("isb", "swing"):
        text = text.replace(f'key="axial_from" value="{word}"', 'key="axial_from" value="ulna"')
    (tmp_path / "model.xml").write_text(text)
    message = 'axial_from is "ulna", expected "rhythm" or "isb" or "swing"'
    with pytest.raises(ValueError, match=message):
        mujoco.MjModel.from_xml_path(str(tmp_path / "model.xml"))


def trace(run_program: RunProgram, scene: Path, folder: Path, *words: str) -> dict[str, Array]:
    run_program("simulate", scene, "--out", folder / "trace.csv", *words)
    with (folder / "trace.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def test_a_file_of_isbs_angles_moves_every_model_alike(
    run_program: RunProgram, shared: SharedResults, made: Made, tmp_path: Path, zero: AxialFrom
) -> None:
    (tmp_path / "motion.csv").write_text(
        "time_s,elevation_deg,plane_deg,axial_deg\n0,30,20,-40\n0.2,60,50,-70\n0.4,90,60,-55\n"
    )
    words = ("--in", str(tmp_path / "motion.csv"), "--axial-from", "isb")
    # Rates are fed forward in both.
    plain = trace(run_program, shared.generate("--offsets", "--rates").scene, tmp_path, *words)
    other = trace(run_program, made.scene, tmp_path, *words)
    # Of the humerus, whose direction goes along great circles, plane and axial together.
    turned_deg = np.interp(plain["time_s"], [0.0, 0.2, 0.4], [-20.0, -20.0, 5.0])
    asked_deg = turned_deg - plain["plane_deg"]
    assert asked_deg[[0, 100, -1]] == pytest.approx([-40.0, -70.0, -55.0], abs=1e-9)
    for found in (plain, other):
        assert found["used_axial_isb_deg"] == pytest.approx(asked_deg, abs=1e-9)
    # The model's own number is what it is given.
    if zero == "isb":
        assert other["axial_deg"] == pytest.approx(asked_deg, abs=1e-9)
    assert plain["axial_deg"] == pytest.approx(plain["used_axial_deg"], abs=1e-9)
    for stem in COORDINATES:
        for column, tolerance_deg in ((f"target_{stem}_deg", 1e-9), (f"{stem}_deg", FED_FORWARD_DEG)):
            assert other[column] == pytest.approx(plain[column], abs=tolerance_deg), column


def test_the_trace_of_position_servos_counts_as_a_motion_does(
    run_program: RunProgram, shared: SharedResults, tmp_path: Path
) -> None:
    (tmp_path / "motion.csv").write_text(
        "time_s,elevation_deg,plane_deg,axial_deg\n0,30,20,-40\n0.2,60,50,-70\n"
    )
    scene = shared.generate("--actuation", "position").scene
    first = trace(run_program, scene, tmp_path, "--in", str(tmp_path / "motion.csv"), "--axial-from", "isb")
    assert first["used_axial_isb_deg"][[0, -1]] == pytest.approx([-40.0, -70.0], abs=1e-9)
    again = tmp_path / "again"
    again.mkdir()
    second = trace(run_program, scene, again, "--in", str(tmp_path / "trace.csv"))
    for stem in COORDINATES:
        column = f"target_{stem}_deg"
        assert second[column] == pytest.approx(first[column], abs=1e-9), column


def test_a_raise_has_the_rhythms_own_turn_in_every_model(
    run_program: RunProgram, made: Made, tmp_path: Path
) -> None:
    motion = ("--elevation", "0:170", "--plane", "40", "--seconds", "0.5")
    found = trace(run_program, made.scene, tmp_path, *motion)
    assert np.abs(found["used_axial_deg"]).max() < 1e-9


def test_such_a_model_passes_its_verification(shared: SharedResults, made: Made, zero: AxialFrom) -> None:
    verified = shared.verify(made.scene)
    assert verified.code == 0, [line for line in verified.text.splitlines() if '"passed": false' in line]
    assert f"axial from {zero}" in verified.answer["kind"]


def test_zeros_and_position_servos_exclude_each_other(refuses: Refuses) -> None:
    refuses(
        "generate",
        "--out",
        "model",
        "--axial-from",
        "isb",
        "--actuation",
        "position",
        because=("--axial-from: position servos", "Omit it"),
    )
