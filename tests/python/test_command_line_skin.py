# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models with the skin that is made of solids, as a person types it and as MuJoCo loads them."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
from conftest import MODEL_FILE, SCENE_FILE, Girdle, Refuses, contents
from shared_results import SharedResults

pytestmark = pytest.mark.usefixtures("no_warning")

SKIN = ("--skin", "implicit")
SIDES = {"right": ("_r",), "left": ("_l",), "both": ("_r", "_l")}
ASSEMBLIES = ("tree", "loop")
ACTUATIONS = ("plugin", "position")
VARIANTS = list(itertools.product(SIDES, ASSEMBLIES, ACTUATIONS))

# Of every side.
LANDMARKS = {
    "skin_ac": 1,
    "skin_acromion": 3,
    "skin_mid_clavicle": 1,
    "skin_scapular_spine": 1,
    "skin_deltoid": 1,
}

Models = Callable[[str, str, str], Path]


def words(side: str, assembly: str, actuation: str) -> tuple[str, ...]:
    return ("--side", side, "--assembly", assembly, "--actuation", actuation)


@pytest.fixture(scope="module")
def models(shared: SharedResults) -> Models:
    """The scene of a model with a skin by what it is; each in a folder of its own, made once."""
    return lambda *variant: shared.generate(*SKIN, *words(*variant)).scene


def skin_of(scene: Path) -> Path:
    (skin,) = scene.parent.glob("*.skn")
    return skin


def load(scene: Path) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(scene))


def body_names(model: mujoco.MjModel, bodies: np.ndarray) -> list[str]:
    return [model.body(int(body)).name for body in bodies]


# --- What is written -----------------------------------------------------------------------------


@pytest.mark.parametrize(("side", "assembly", "actuation"), VARIANTS)
def test_the_skin_stands_beside_the_model_and_its_scene(
    models: Models, side: str, assembly: str, actuation: str
) -> None:
    scene = models(side, assembly, actuation)
    servos = "_position" if actuation == "position" else ""
    model = f"shoulder_{side}{servos}.xml"
    assert contents(scene.parent).keys() == {scene.name, model, f"shoulder_{side}{servos}.skn"}


@pytest.mark.parametrize("side", SIDES)
def test_all_models_of_a_side_have_the_same_skin(models: Models, side: str) -> None:
    skins = {
        skin_of(models(side, assembly, actuation)).read_bytes()
        for assembly, actuation in itertools.product(ASSEMBLIES, ACTUATIONS)
    }
    assert len(skins) == 1


def test_a_model_leaves_the_skin_of_another_one_in_the_folder_alone(
    models: Models, girdle_fine: Girdle, tmp_path: Path
) -> None:
    girdle_fine("generate", "--out", "model", *SKIN)
    small = ("--stature", "1.2", "--actuation", "position")
    girdle_fine("generate", "--out", "model", *SKIN, *small)
    adult = skin_of(models("right", "tree", "plugin")).read_bytes()
    assert (tmp_path / "model" / "shoulder_right.skn").read_bytes() == adult
    assert (tmp_path / "model" / "shoulder_right_position.skn").read_bytes() != adult


# The shortest and longest that the option takes.
@pytest.mark.parametrize(
    "size",
    [
        *("clavicle-length 0.05", "clavicle-length 0.25", "scapula-length 0.04", "scapula-length 0.25"),
        *("humerus-length 0.1", "humerus-length 0.5", "stature 0.5", "stature 2.8"),
    ],
)
def test_a_body_of_any_size_that_is_taken_has_a_skin(girdle_fine: Girdle, tmp_path: Path, size: str) -> None:
    option, length = size.split()
    girdle_fine("generate", "--out", "model", *SKIN, f"--{option}", length)
    model = load(tmp_path / "model" / "scene.xml")
    assert model.nskinvert > 1000
    assert np.isfinite(model.skin_vert).all()


def test_the_same_words_give_the_same_bytes(models: Models, girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "again", *SKIN, *words("both", "tree", "plugin"))
    assert contents(tmp_path / "again") == contents(models("both", "tree", "plugin").parent)


@pytest.mark.parametrize(
    "options",
    [("--stature", "1.9"), ("--clavicle-length", "0.17")],
    ids=" ".join,
)
def test_a_body_of_another_size_has_another_skin(
    models: Models, girdle_fine: Girdle, tmp_path: Path, options: tuple[str, ...]
) -> None:
    girdle_fine("generate", "--out", "model", *SKIN, *options)
    adult = models("right", "tree", "plugin").parent / "shoulder_right.skn"
    assert (tmp_path / "model" / "shoulder_right.skn").read_bytes() != adult.read_bytes()


def test_a_heavier_body_keeps_its_skin(models: Models, girdle_fine: Girdle, tmp_path: Path) -> None:
    """Bones and skin are lengths; of a body's mass nobody can tell where it is."""
    girdle_fine("generate", "--out", "model", *SKIN, "--body-mass", "90")
    adult = models("right", "tree", "plugin").parent / "shoulder_right.skn"
    assert (tmp_path / "model" / "shoulder_right.skn").read_bytes() == adult.read_bytes()


@pytest.mark.parametrize("word", ["explicit", "Implicit", "implicit "])
def test_a_word_that_is_no_skin_is_refused_and_nothing_is_written(refuses: Refuses, word: str) -> None:
    refuses("generate", "--out", "model", "--skin", word, because=("--skin", word, "implicit"))


def test_there_is_no_skin_unless_it_is_asked_for(generated: Path) -> None:
    assert contents(generated).keys() == {MODEL_FILE, SCENE_FILE}
    assert load(generated / SCENE_FILE).nskin == 0


# --- What MuJoCo loads ---------------------------------------------------------------------------


@pytest.mark.parametrize(("side", "assembly", "actuation"), VARIANTS)
def test_a_loaded_skin_hangs_on_the_bones_of_its_sides(
    models: Models, side: str, assembly: str, actuation: str
) -> None:
    model = load(models(side, assembly, actuation))
    assert model.nskin == 1
    assert model.skin(0).name == "skin"
    assert body_names(model, model.skin_bonebodyid) == ["thorax"] + [
        bone + suffix for suffix in SIDES[side] for bone in ("clavicle", "scapula", "humerus")
    ]


@pytest.mark.parametrize(("side", "assembly", "actuation"), VARIANTS)
def test_landmarks_name_vertices_of_the_skin(
    models: Models, side: str, assembly: str, actuation: str
) -> None:
    model = load(models(side, assembly, actuation))
    numerics = {model.numeric(i).name: model.numeric(i).data for i in range(model.nnumeric)}
    assert {name: len(data) for name, data in numerics.items()} == {
        stem + suffix: count for stem, count in LANDMARKS.items() for suffix in SIDES[side]
    }
    for name, data in numerics.items():
        assert np.array_equal(data, np.round(data)), name
        assert data.min() >= 0, name
        assert data.max() < model.nskinvert, name
    firsts = [data[0] for data in numerics.values()]
    assert len(set(firsts)) == len(firsts), "no landmark is another one"


@pytest.mark.parametrize("side", SIDES)
def test_every_vertex_hangs_on_bones_with_weights_of_one_in_sum(models: Models, side: str) -> None:
    model = load(models(side, "tree", "position"))
    sums = np.zeros(model.nskinvert)
    np.add.at(sums, model.skin_bonevertid, model.skin_bonevertweight)
    # MuJoCo keeps weights as floats, seven at most a vertex.
    assert sums == pytest.approx(np.ones(model.nskinvert), abs=1e-6)
    assert model.skin_bonevertweight.min() > 0


@pytest.mark.parametrize("actuation", ACTUATIONS)
def test_an_attached_model_keeps_its_skin_on_its_own_bones(models: Models, actuation: str) -> None:
    scene = models("both", "tree", actuation)
    model_file = scene.parent / scene.name.replace("scene", "shoulder")
    alone = load(model_file)
    parent = mujoco.MjSpec()
    # The shoulders are to be stepped as they were made for; a parent that says otherwise gets a
    # warning.
    parent.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    parent.option.timestep = alone.opt.timestep
    for prefix, x_m in (("him_", 0.0), ("her_", 2.0)):
        child = mujoco.MjSpec.from_file(str(model_file))
        frame = parent.worldbody.add_frame(pos=[x_m, 0.0, 0.0])
        frame.attach_body(child.body("thorax"), prefix, "")
    both = parent.compile()
    assert [both.skin(i).name for i in range(both.nskin)] == ["him_skin", "her_skin"]
    bones = body_names(alone, alone.skin_bonebodyid)
    assert body_names(both, both.skin_bonebodyid) == [
        prefix + bone for prefix in ("him_", "her_") for bone in bones
    ]
    assert np.array_equal(both.skin_vert, np.concatenate([alone.skin_vert, alone.skin_vert]))
