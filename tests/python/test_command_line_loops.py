# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""How far `girdle simulate` finds the joint of a loop open, at several time steps."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path

import pytest
from conftest import Girdle, Refuses

# Raised and lowered once a second, through the table.
PERIOD_S = 1.0
MOTION_S = 2.0
SAMPLE_S = 0.01
# Gaps are allowed to be so large at steps of so many milliseconds [mm].
LARGEST_GAP_MM = {1: 0.1, 2: 0.1, 5: 1.0}
LONGEST_S = {"clavicle": "0.005", "scapula": "0.007"}
# Positions of order one in the trace, to whole doubles.
ROUNDING_MM = 1e-9


@pytest.fixture
def motion(tmp_path: Path) -> Path:
    rows = ["time_s,elevation_deg,plane_deg"]
    for i in range(round(MOTION_S / SAMPLE_S) + 1):
        time_s = i * SAMPLE_S
        elevation_deg = 67.5 - 52.5 * math.cos(2 * math.pi * time_s / PERIOD_S)
        rows.append(f"{time_s:.2f},{elevation_deg:.6f},90")
    path = tmp_path / "motion.csv"
    path.write_text("\n".join(rows) + "\n")
    return path


def stepped(girdle_fine: Girdle, folder: Path, step_ms: int, *options: str) -> Path:
    """A model of both shoulders with a time step of its own."""
    girdle_fine("generate", "--side", "both", *options, "--out", str(folder))
    (model,) = folder.glob("shoulder_both*.xml")
    text = model.read_text()
    changed = text.replace('timestep="0.002"', f'timestep="{step_ms / 1e3}"')
    assert (changed == text) == (step_ms == 2)
    model.write_text(changed)
    return model


def gap_of_trace_mm(trace: Path) -> float:
    with trace.open() as file:
        rows = list(csv.DictReader(file))
    ends = ("PAC", "PAC_scapula")
    return 1e3 * max(
        math.dist(*([float(row[f"{end}_{axis}_m"]) for axis in "xyz"] for end in ends)) for row in rows
    )


@pytest.mark.parametrize("actuation", ["plugin", "position"])
@pytest.mark.parametrize("lead", ["clavicle", "scapula"])
@pytest.mark.parametrize("step_ms", [1, 2, 5])
def test_a_loop_holds_and_its_gap_is_reported(
    girdle_fine: Girdle, tmp_path: Path, motion: Path, lead: str, step_ms: int, actuation: str
) -> None:
    loop = ("--assembly", "loop", "--lead", lead, "--actuation", actuation)
    model = stepped(girdle_fine, tmp_path / "model", step_ms, *loop)
    words = ("simulate", str(model), "--motion", str(motion))
    gaps_mm = {}
    for side in ("right", "left"):
        trace = tmp_path / f"{side}.csv"
        said = girdle_fine(*words, "--side", side, "--trace", str(trace), "--json").text
        # Of every loop, whichever shoulder the trace is of.
        gaps_mm = json.loads(said)["loop_gaps_mm"]
        assert list(gaps_mm) == ["AC_r", "AC_l"]
        own = gaps_mm["AC_" + side[0]]
        assert own == pytest.approx(gap_of_trace_mm(trace), abs=ROUNDING_MM)
        assert 1e-3 < own < LARGEST_GAP_MM[step_ms]
    text = girdle_fine(*words).text
    stated = re.findall(r"^loop (\w+) open by at most ([\d.]+) mm$", text, re.MULTILINE)
    assert dict(stated) == {name: f"{round(gap_mm, 3):g}" for name, gap_mm in gaps_mm.items()}


def test_a_tree_has_no_loop(girdle_fine: Girdle, tmp_path: Path, motion: Path) -> None:
    model = stepped(girdle_fine, tmp_path / "model", 2)
    assert "loop" not in girdle_fine("simulate", str(model), "--motion", str(motion)).text
    said = girdle_fine("simulate", str(model), "--motion", str(motion), "--json").text
    assert json.loads(said)["loop_gaps_mm"] == {}


@pytest.mark.parametrize("lead", ["clavicle", "scapula"])
@pytest.mark.parametrize("step_ms", [8, 10])
def test_longer_steps_are_refused_with_the_longest_one(
    girdle_fine: Girdle, refuses: Refuses, tmp_path: Path, motion: Path, lead: str, step_ms: int
) -> None:
    model = stepped(girdle_fine, tmp_path / "model", step_ms, "--assembly", "loop", "--lead", lead)
    refuses(
        *("simulate", str(model), "--motion", str(motion)),
        because=(
            f"the time step is {step_ms / 1e3:g} s",
            f"the longest for a loop that the {lead} leads is {LONGEST_S[lead]} s",
            'write <option timestep="0.002" integrator="implicitfast"/>',
        ),
    )


@pytest.mark.parametrize("assembly", ["tree", "loop"])
def test_20_ms_are_refused(
    girdle_fine: Girdle, refuses: Refuses, tmp_path: Path, motion: Path, assembly: str
) -> None:
    model = stepped(girdle_fine, tmp_path / "model", 20, "--assembly", assembly)
    because = ("the time step is 0.02 s, expected .* to 0.01", 'Set <option timestep="0.002"/>')
    refuses("simulate", str(model), "--motion", str(motion), because=because)
