# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models with position servos move in a browser's MuJoCo as they do in the C library.

The engine here is not ours in any part: the npm package @mujoco/mujoco, run by Node, against the
Python bindings of the same version, both as scripts/setup fetches them.
"""

from __future__ import annotations

import csv
import json
import math
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
MODELS = ROOT / "model"
NODE = Path(sys.executable).parent / "node"
STEP_IN_NODE = ROOT / "tests" / "node" / "step_model.mjs"
WEBASSEMBLY = ROOT / "build" / "node" / "node_modules" / "@mujoco" / "mujoco"

# Both run IEEE double arithmetic; what differs is the order of sums that the compilers choose.
SAME_RAD = 1e-9

TIMEOUT_S = 120

# One second: up and to the side, then down and across, with turns about the arm's own axis.
MOTION = """\
time_s,elevation_deg,plane_deg,axial_deg
0,0,0,0
0.5,120,30,10
1,40,90,-20
"""

STEP_IN_PYTHON = """
import json, mujoco, sys
model = mujoco.MjModel.from_xml_path(sys.argv[1])
data = mujoco.MjData(model)
positions = [data.qpos.tolist()]
for control in json.load(open(sys.argv[2])):
    data.ctrl[:] = control
    mujoco.mj_step(model, data)
    positions.append(data.qpos.tolist())
warnings = [warning.number for warning in data.warning]
print(json.dumps(dict(version=mujoco.mj_versionString(), positions=positions, warnings=warnings)))
"""


@dataclass(frozen=True)
class Run:
    version: str
    positions_rad: np.ndarray  # a row a step
    warnings: list[int]


def finished_run(*command: str | Path, **environment: str) -> Run:
    finished = subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
        env={**os.environ, **environment},
    )
    assert finished.returncode == 0, finished.stderr
    answer = json.loads(finished.stdout)
    return Run(answer["version"], np.array(answer["positions"]), answer["warnings"])


@pytest.fixture(scope="session")
def version() -> str:
    """Of the npm package."""
    return str(json.loads((WEBASSEMBLY / "package.json").read_text())["version"])


@pytest.fixture(scope="module")
def native(version: str) -> Callable[[Path, Path], Run]:
    """Steps a model with the C library of this version."""
    packages = ROOT / "build" / "engine" / f"mujoco-{version}"
    if not packages.is_dir():
        pytest.fail(f"{packages} is missing: run scripts/setup --python", pytrace=False)

    def run(model: Path, controls: Path) -> Run:
        command = (sys.executable, "-c", STEP_IN_PYTHON, model, controls)
        return finished_run(*command, PYTHONPATH=str(packages))

    return run


def step_in_node(model: Path, controls: Path) -> Run:
    return finished_run(NODE, STEP_IN_NODE, WEBASSEMBLY / "mujoco.js", model, controls)


@pytest.mark.parametrize("assembly", ["tree", "loop"])
@pytest.mark.parametrize(("side", "scene"), [("right", ""), ("left", "_left"), ("both", "_both")])
def test_webassembly_and_the_c_library_move_a_position_model_the_same_way(
    program: Path,
    native: Callable[[Path, Path], Run],
    version: str,
    tmp_path: Path,
    assembly: str,
    side: str,
    scene: str,
) -> None:
    folder = MODELS / f"shoulder_{assembly}"
    motion, table, controls = (tmp_path / name for name in ("motion.csv", "table.csv", "list.json"))
    motion.write_text(MOTION)
    driven = folder / f"scene{scene}.xml"
    subprocess.run(
        [program, "simulate", driven, "--in", motion, "--out-controls", table],
        check=True,
        capture_output=True,
        timeout=TIMEOUT_S,
    )
    with table.open() as file:
        rows = [[float(value) for value in row[1:]] for row in list(csv.reader(file))[1:]]
    controls.write_text(json.dumps(rows))

    model = folder / f"shoulder_{side}_position.xml"
    in_node = step_in_node(model, controls)
    expected = native(model, controls)
    assert in_node.version == expected.version == version
    assert in_node.positions_rad.shape == expected.positions_rad.shape
    assert in_node.positions_rad.shape[0] == len(rows) + 1
    assert np.abs(in_node.positions_rad - expected.positions_rad).max() < SAME_RAD
    assert sum(in_node.warnings) == sum(expected.warnings) == 0
    # Two arms that hang would agree as well.
    travel_rad = np.ptp(expected.positions_rad, axis=0)
    assert (travel_rad > math.radians(3)).sum() >= 9
