# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""How far `girdle simulate` finds the joint of a loop open, at several time steps."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from conftest import Girdle, Refuses

if TYPE_CHECKING:
    from collections.abc import Callable

# Up and down, or back and forth, once a second.
PERIOD_S = 1.0
MOTION_S = 2.0
SAMPLE_S = 0.01
# Gaps are allowed to be so large at steps of so many milliseconds [mm].
LARGEST_GAP_MM = {1: 0.1, 2: 0.1, 5: 1.0}
# Positions of order one in the trace, to whole doubles.
ROUNDING_MM = 1e-9


def raised(phase: float) -> tuple[float, float]:
    """To the front, from hanging to 150 degrees."""
    return 75 - 75 * math.cos(phase), 90


def swung(phase: float) -> tuple[float, float]:
    """Past hanging, where the plane turns round."""
    forward_deg = 5 - 35 * math.cos(phase)
    return abs(forward_deg), 90 if forward_deg > 0 else -90


def written(path: Path, command: Callable[[float], tuple[float, float]]) -> Path:
    rows = ["time_s,elevation_deg,plane_deg"]
    for i in range(round(MOTION_S / SAMPLE_S) + 1):
        time_s = i * SAMPLE_S
        elevation_deg, plane_deg = command(2 * math.pi * time_s / PERIOD_S)
        rows.append(f"{time_s:.2f},{elevation_deg:.6f},{plane_deg}")
    path.write_text("\n".join(rows) + "\n")
    return path


@pytest.fixture
def motion(tmp_path: Path) -> Path:
    return written(tmp_path / "motion.csv", raised)


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
@pytest.mark.parametrize("moved", [raised, swung])
def test_a_loop_holds_and_its_gap_is_reported(
    girdle_fine: Girdle,
    tmp_path: Path,
    moved: Callable[[float], tuple[float, float]],
    lead: str,
    step_ms: int,
    actuation: str,
) -> None:
    motion = written(tmp_path / "motion.csv", moved)
    loop = ("--assembly", "loop", "--lead", lead, "--actuation", actuation)
    model = stepped(girdle_fine, tmp_path / "model", step_ms, *loop)
    words = ("simulate", str(model), "--in", str(motion))
    gaps_mm = {}
    for side in ("right", "left"):
        trace = tmp_path / f"{side}.csv"
        said = girdle_fine(*words, "--side", side, "--out", str(trace), "--json").text
        # Of every loop, whichever shoulder the trace is of.
        gaps_mm = json.loads(said)["loop_gaps_mm"]
        assert list(gaps_mm) == ["AC_r", "AC_l"]
        own = gaps_mm["AC_" + side[0]]
        assert own == pytest.approx(gap_of_trace_mm(trace), abs=ROUNDING_MM)
        assert 1e-3 < own < LARGEST_GAP_MM[step_ms]
    text = girdle_fine(*words).text
    stated = re.findall(r"^loop (\w+) open by at most ([\d.]+) mm$", text, re.MULTILINE)
    assert dict(stated) == {name: f"{round(gap_mm, 3):g}" for name, gap_mm in gaps_mm.items()}


@pytest.mark.parametrize(("step_ms", "tolerance_mm"), [(2, 0.1), (5, 0.988)])
def test_a_moving_loop_is_verified_by_what_its_step_can_hold(
    girdle_fine: Girdle, tmp_path: Path, step_ms: int, tolerance_mm: float
) -> None:
    model = stepped(girdle_fine, tmp_path / "model", step_ms, "--assembly", "loop")
    report = json.loads(girdle_fine("verify", model, "--json").text)
    lines = {line["item"]: line for line in report["residuals"] if line["group"] == "joint constraint"}
    for side in ("right", "left"):
        for moving in ("AC moving", "AC at 1 Hz"):
            line = lines[f"{moving}, {side}"]
            assert line["tolerance"] == pytest.approx(tolerance_mm, abs=5e-4)
            # It would not hold what a shorter step holds.
            assert line["passed"]
            assert (line["value"] > 0.1) == (step_ms > 2 and moving == "AC at 1 Hz")


def test_a_tree_has_no_loop(girdle_fine: Girdle, tmp_path: Path, motion: Path) -> None:
    model = stepped(girdle_fine, tmp_path / "model", 2)
    assert "loop" not in girdle_fine("simulate", str(model), "--in", str(motion)).text
    said = girdle_fine("simulate", str(model), "--in", str(motion), "--json").text
    assert json.loads(said)["loop_gaps_mm"] == {}


@pytest.mark.parametrize("lead", ["clavicle", "scapula"])
@pytest.mark.parametrize("actuation", ["plugin", "position"])
def test_longer_steps_are_refused_with_the_longest_one(
    girdle_fine: Girdle, refuses: Refuses, tmp_path: Path, motion: Path, lead: str, actuation: str
) -> None:
    loop = ("--assembly", "loop", "--lead", lead, "--actuation", actuation)
    refuses(
        *("simulate", str(stepped(girdle_fine, tmp_path / "model", 8, *loop)), "--in", str(motion)),
        because=(
            "the time step is 0.008 s, and the longest for a loop is 0.005 s",
            'write <option timestep="0.005" integrator="implicitfast"/>',
        ),
    )


@pytest.mark.parametrize(
    ("own", "changed", "because"),
    [
        ("<flag ", '<flag damper="disable" ', ("damping, which the servos need, is disabled",)),
        ('<compiler angle="radian"/>', "", ("as if their radians had been read as degrees",)),
        (
            "<flag ",
            '<flag constraint="disable" ',
            ("constraints are disabled", '<flag constraint="enable"/>'),
        ),
        ("<flag ", '<flag equality="disable" ', ("equalities are disabled", '<flag equality="enable"/>')),
        ('name="AC_l" ', 'name="AC_l" active="false" ', ('active="true"', "starts inactive")),
    ],
)
@pytest.mark.parametrize("actuation", ["plugin", "position"])
def test_what_the_servos_cannot_do_with_is_refused(
    girdle_fine: Girdle,
    refuses: Refuses,
    tmp_path: Path,
    motion: Path,
    actuation: str,
    own: str,
    changed: str,
    because: tuple[str, ...],
) -> None:
    loop = ("--assembly", "loop", "--actuation", actuation)
    path = stepped(girdle_fine, tmp_path / "model", 2, *loop)
    model = path.read_text()
    model = re.sub(r"(<option [^>]*)/>", r"\1><flag /></option>", model, count=1)
    assert model.count(own) == 1
    path.write_text(model.replace(own, changed))
    refuses(
        *("simulate", str(path), "--in", str(motion)),
        because=because,
    )


@pytest.mark.parametrize(
    ("integrator", "flag", "longest_s"),
    [("RK4", "", 0.002), ("Euler", '<flag eulerdamp="disable"/>', 0.001)],
)
def test_position_servos_with_explicit_damping(
    girdle_fine: Girdle,
    refuses: Refuses,
    tmp_path: Path,
    motion: Path,
    integrator: str,
    flag: str,
    longest_s: float,
) -> None:
    """They have no plugin that says it."""
    path = stepped(girdle_fine, tmp_path / "model", 2, "--actuation", "position")
    words = ("simulate", str(path), "--in", str(motion))
    own = re.compile(r"<option timestep=\"0.002\" integrator=\"implicitfast\"(.*?)/>")
    model = path.read_text()
    assert own.search(model)

    def step(step_s: float) -> None:
        option = rf'<option timestep="{step_s}" integrator="{integrator}"\1>{flag}</option>'
        path.write_text(own.sub(option, model))

    step(longest_s)
    girdle_fine(*words)
    step(0.003)
    refuses(*words, because=("the time step is 0.003 s, and the longest for a tree with ", f"{longest_s} s"))


def test_a_place_servo_that_is_held_back(
    girdle_fine: Girdle, refuses: Refuses, tmp_path: Path, motion: Path
) -> None:
    path = stepped(girdle_fine, tmp_path / "model", 2, "--assembly", "loop", "--lead", "scapula")
    text = path.read_text()
    changed = text.replace('joint="st_lateral_r"', 'joint="st_lateral_r" forcerange="-50 60"')
    assert changed != text
    path.write_text(changed)
    because = (
        'joint "st_lateral_r" gets no more than -50 to 60 N of its servo, which needs 100 where it lags by '
        "10 mm",
        'write forcelimited="false"',
    )
    refuses("simulate", str(path), "--in", str(motion), because=because)


@pytest.mark.parametrize("assembly", ["tree", "loop"])
def test_20_ms_are_refused(
    girdle_fine: Girdle, refuses: Refuses, tmp_path: Path, motion: Path, assembly: str
) -> None:
    model = stepped(girdle_fine, tmp_path / "model", 20, "--assembly", assembly)
    because = ("the time step is 0.02 s, expected .* to 0.01", 'Set <option timestep="0.002"/>')
    refuses("simulate", str(model), "--in", str(motion), because=because)
