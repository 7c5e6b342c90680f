# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What model/README.md says of time steps and of soft ranges is what is measured."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import mujoco
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "model" / "README.md").read_text()
SCRIPT = ROOT / "scripts" / "longest_steps"
LONGEST = ROOT / "generator" / "names" / "longest_timestep.h"


def test_the_table_is_what_the_script_measures_and_the_plugin_knows() -> None:
    measured = subprocess.run([SCRIPT], capture_output=True, text=True, timeout=280, check=True).stdout
    assert len(measured.splitlines()) == 5
    assert measured in README
    # As the function has them: implicit of a tree and a loop, RK4 of both, the rest.
    tree, *loops = (list(map(int, re.findall(r"\| (\d+) ms", line))) for line in measured.splitlines()[2:])
    assert loops[0] == loops[1]
    assert tree[2] == loops[0][2]
    code = LONGEST.read_text().split("LongestTimestep_s(", 1)[1]
    known_ms = [round(1e3 * float(step_s)) for step_s in re.findall(r"0\.\d+", code)]
    assert known_ms == [tree[0], loops[0][0], tree[1], loops[0][1], tree[2]]


SEEDS = range(5)
JUMPS = 80
JUMP_S = 0.25
# A command of the plugin that jumps swings past a range by less than that [deg].
PLUGIN_DEG = 1.0


def farthest_outside_deg(family: str, kind: str) -> float:
    """Of any joint past its range, over random controls; of the plugin, random commands."""
    farthest_rad = 0.0
    for seed in SEEDS:
        model = mujoco.MjModel.from_xml_path(str(ROOT / "model" / family / f"shoulder_right{kind}.xml"))
        data = mujoco.MjData(model)
        random = np.random.default_rng(seed)
        lower, upper = model.actuator_ctrlrange.T.copy()
        if not kind:
            lower[3:] = upper[3:] = 0
        limited = model.jnt_limited.astype(bool)
        ranges = model.jnt_range[limited]
        for _ in range(JUMPS):
            data.ctrl[:] = random.uniform(lower, upper)
            for _ in range(round(JUMP_S / model.opt.timestep)):
                mujoco.mj_step(model, data)
                q = data.qpos[model.jnt_qposadr[limited]]
                farthest_rad = max(farthest_rad, (ranges[:, 0] - q).max(), (q - ranges[:, 1]).max())
    return float(np.degrees(farthest_rad))


@pytest.mark.usefixtures("no_warning")
def test_how_far_controls_that_jump_throw_a_joint_past_its_range() -> None:
    families = ("shoulder_tree", "shoulder_loop")
    stated = re.search(r"past its range by up to (\d+) degrees", README)
    assert stated
    farthest_deg = max(farthest_outside_deg(family, "_position") for family in families)
    assert float(stated[1]) - 1 < farthest_deg <= float(stated[1])
    assert "by less than a degree" in README
    assert max(farthest_outside_deg(family, "") for family in families) < PLUGIN_DEG
