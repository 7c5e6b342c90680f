# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The committed models as a collection of models wants them: layout, and steps that stay sane.

The checks are those that MuJoCo Menagerie runs on its own models, and harder ones.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import mujoco
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
MODELS = ROOT / "model"
FAMILIES = sorted(path for path in MODELS.iterdir() if path.is_dir())
SCENES = sorted(MODELS.glob("*/scene*.xml"))

SEED = 20090201
RANDOM_CONTROLS = 10_000
# How many steps a control is held: none gets away by being gone before the bones have moved, and
# none is always left in peace.
HOLDS = (1, 2, 5, 10, 20)

# A joint may go past its range by what its servo can be told to pull it there: the trim of the
# plugin's, 30 deg, against a limit that is soft.
TRIM_RAD = np.radians(30)
# Position servos are told nothing outside the range; what the bones swing over, whose neighbours
# are thrown from one end of their ranges to the other every few steps, is this.
SWING_RAD = np.radians(15)

# Settled, from wherever the random controls have left the bones.
SETTLING_S = 3.0
SETTLED_RAD = 1e-6
AT_REST_RAD_PER_S = 1e-6
# The constraint that closes the AC joint of a loop, settled [m].
CLOSED_M = 1e-6


def name_of(path: Path) -> str:
    return f"{path.parent.name}/{path.name}"


@pytest.fixture(autouse=True)
def messages(engine_with_plugin: None, capfd: pytest.CaptureFixture[str]) -> Iterator[list[str]]:
    """Whatever the engine says fails the test that it was said in."""
    said: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    yield said
    mujoco.set_mju_user_warning(before)
    assert not said
    assert capfd.readouterr() == ("", "")


@pytest.fixture(params=SCENES, ids=name_of)
def model(request: pytest.FixtureRequest, messages: list[str]) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(request.param))


# --- Layout --------------------------------------------------------------------------------------


def test_there_are_all_families_with_all_their_variants() -> None:
    variants = ["", "_both", "_both_position", "_left", "_left_position", "_position"]
    assert [path.name for path in FAMILIES] == ["shoulder_loop", "shoulder_skin", "shoulder_tree"]
    for family in FAMILIES:
        found = sorted(path.stem.removeprefix("scene") for path in family.glob("scene*.xml"))
        assert found == variants, family.name


@pytest.mark.parametrize("family", FAMILIES, ids=lambda path: path.name)
def test_a_family_has_the_files_that_menagerie_asks_for(family: Path) -> None:
    readme = (family / "README.md").read_text(encoding="utf-8")
    assert readme.startswith("# ")
    assert readme.splitlines()[0].endswith("Description (MJCF)")
    for wanted in ("Requires MuJoCo", "](CHANGELOG.md)", "## Overview", "## License", "](LICENSE)"):
        assert wanted in readme, wanted
    assert (family / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
    changelog = (family / "CHANGELOG.md").read_text(encoding="utf-8")
    assert changelog.startswith("# Changelog")
    files = {path.name for path in family.iterdir() if path.suffix in (".xml", ".skn")}
    assert files == {name for name in files if f"`{name}`" in readme}, "each file is described"


# --- Steps ---------------------------------------------------------------------------------------


def how_far_past_its_range(model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
    """By joint; 0 for one that has no range. Every joint has one coordinate."""
    low, high = model.jnt_range.T
    past = np.maximum(low - data.qpos, data.qpos - high)
    return np.where(model.jnt_limited, np.maximum(past, 0), 0)


def step_random_controls(model: mujoco.MjModel, data: mujoco.MjData, allowed_rad: float) -> None:
    """Spread over the keyframes; each control anywhere in its range."""
    random = np.random.default_rng(SEED)
    low, high = model.actuator_ctrlrange.T
    assert model.actuator_ctrllimited.all()
    controls = random.uniform(low, high, size=(RANDOM_CONTROLS, model.nu))
    holds = random.choice(HOLDS, size=RANDOM_CONTROLS)
    assert model.nkey == 9
    for key, turn in enumerate(np.array_split(np.arange(RANDOM_CONTROLS), model.nkey)):
        mujoco.mj_resetDataKeyframe(model, data, key)
        for i in turn:
            data.ctrl[:] = controls[i]
            mujoco.mj_step(model, data, nstep=int(holds[i]))
            assert np.isfinite(data.qpos).all(), i
            past_rad = how_far_past_its_range(model, data)
            worst = int(past_rad.argmax())
            assert past_rad[worst] < allowed_rad, (model.joint(worst).name, i, past_rad[worst])


def test_ten_thousand_random_controls_from_the_keyframes_do_no_harm(
    model: mujoco.MjModel,
) -> None:
    """No warning, no number that is none, no joint out of its range; afterwards it finds back."""
    data = mujoco.MjData(model)
    step_random_controls(model, data, TRIM_RAD if model.nplugin else SWING_RAD)
    assert data.warning.number.sum() == 0
    # Where the last control has left the bones.
    assert np.abs(data.qpos - model.key("abduction_90").qpos).max() > SWING_RAD
    data.ctrl[:] = model.key("abduction_90").ctrl
    mujoco.mj_step(model, data, nstep=round(SETTLING_S / model.opt.timestep))
    assert np.abs(data.qpos - model.key("abduction_90").qpos).max() < SETTLED_RAD
    assert np.abs(data.qvel).max() < AT_REST_RAD_PER_S
    assert np.abs(data.efc_pos).max(initial=0) < CLOSED_M
    assert data.ne == 3 * model.neq
    assert data.warning.number.sum() == 0


def test_a_keyframe_is_held_where_it_is(model: mujoco.MjModel) -> None:
    for key in range(model.nkey):
        data = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_step(model, data, nstep=50)
        moved_rad = np.abs(data.qpos - model.key_qpos[key]).max()
        assert moved_rad < SETTLED_RAD, model.key(key).name


# --- Cameras -------------------------------------------------------------------------------------

# Of half a picture; the rest is the margin without which a bone looks cut off.
EDGE = 0.95


def points_of_bones(model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
    """The corners of all that is drawn of the shoulder, in the world."""
    points = []
    for geom in np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_MESH):
        mesh = model.mesh(model.geom_dataid[geom])
        first = mesh.vertadr[0]
        corners = model.mesh_vert[first : first + mesh.vertnum[0]]
        points.append(data.geom_xpos[geom] + corners @ data.geom_xmat[geom].reshape(3, 3).T)
    return np.concatenate(points)


def test_every_camera_has_all_bones_in_its_picture_at_every_keyframe(
    model: mujoco.MjModel,
) -> None:
    """In a square picture, the narrowest that people make."""
    assert model.ncam == 4
    data = mujoco.MjData(model)
    half_width = np.tan(np.radians(model.cam_fovy) / 2)
    for key in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        points = points_of_bones(model, data)
        for camera in range(model.ncam):
            seen = (points - data.cam_xpos[camera]) @ data.cam_xmat[camera].reshape(3, 3)
            assert (seen[:, 2] < 0).all(), "a camera looks along its -z"
            edge = np.abs(seen[:, :2] / seen[:, 2:]).max() / half_width[camera]
            assert edge < EDGE, (model.camera(camera).name, model.key(key).name)


def test_a_viewer_starts_in_front_on_the_side_of_the_arm(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    azimuth_rad = np.radians(model.vis.global_.azimuth)
    # The azimuth is where the viewer looks to.
    front, left = -np.cos(azimuth_rad), -np.sin(azimuth_rad)
    assert front > 0.5
    middle_m = data.site_xpos[:, 1].mean()
    # Both arms are on both sides.
    assert abs(middle_m) < 1e-3 or np.sign(middle_m) == np.sign(left)
