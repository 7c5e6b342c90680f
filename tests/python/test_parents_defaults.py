# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""A model that includes a shoulder has defaults of its own, which leave the shoulder as it is."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

pytestmark = pytest.mark.usefixtures("engine_with_plugin")

MODELS = Path(__file__).resolve().parents[2] / "model"
SHOULDERS = sorted(MODELS.glob("*/shoulder_*.xml"))
DEFAULTS = (
    '<mesh scale="0.001 0.001 0.001"/>'
    '<joint type="slide" pos="0 0 0.1" range="-0.1 0.1" limited="true" stiffness="10" springdamper="1 1"'
    ' damping="3" frictionloss="2" margin="0.1" armature="1" solreflimit="0.3 1" solimplimit="0.1 0.2 0.1"'
    ' actuatorfrcrange="-1 1" actuatorfrclimited="true"/>'
    '<geom pos="0 0 0.1" quat="0.7 0.7 0 0" contype="1" conaffinity="1" mass="1" group="3"/>'
    '<site pos="0 0 0.1" quat="0.7 0.7 0 0" size="0.1" group="1"/>'
    '<tendon damping="5" frictionloss="2" stiffness="7" springlength="0.1" range="0 0.1"'
    ' limited="true" solreflimit="0.3 1" solimplimit="0.1 0.2 0.1"/>'
    '<equality active="false" solref="0.1 1" solimp="0.1 0.2 0.1"/>'
    '<pair margin="0.1" gap="0.1" solref="0.1 1"/>'
    '<position kp="20" kv="3" inheritrange="1" forcerange="-1 1" forcelimited="true"/>'
)
ACTUATORS = (
    "",
    '<general gear="2 3 4 5 6 7" forcerange="-1 1" ctrlrange="-0.1 0.1" ctrllimited="true"'
    ' forcelimited="true" dyntype="filter" dynprm="0.1"/>',
    '<velocity kv="4" gear="3"/>',
    '<intvelocity kp="4" inheritrange="1"/>',
)


def included(shoulder: Path, defaults: str, tmp_path: Path) -> mujoco.MjModel:
    parent = tmp_path / "parent.xml"
    parent.write_text(f'<mujoco><default>{defaults}</default><include file="{shoulder}"/></mujoco>')
    return mujoco.MjModel.from_xml_path(str(parent))


def arrays_of(model: mujoco.MjModel) -> dict[str, np.ndarray]:
    """What the model is made of, without the text of its files and the words for its controls."""
    members = {name: getattr(model, name) for name in dir(model) if not name.startswith("_")}
    return {
        name: value
        for name, value in members.items()
        if isinstance(value, np.ndarray) and name not in ("paths", "text_data", "actuator_ctrlspec")
    }


@pytest.mark.parametrize("actuators", ACTUATORS, ids=["position", "general", "velocity", "intvelocity"])
@pytest.mark.parametrize("shoulder", SHOULDERS, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_no_default_of_a_parent_reaches_a_shoulder(shoulder: Path, actuators: str, tmp_path: Path) -> None:
    alone = arrays_of(included(shoulder, "", tmp_path))
    beside = arrays_of(included(shoulder, DEFAULTS + actuators, tmp_path))
    assert alone.keys() == beside.keys()
    assert len(alone) > 300
    changed = [name for name, value in alone.items() if not np.array_equal(value, beside[name])]
    assert changed == []
