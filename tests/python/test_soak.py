# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`scripts/soak`: random controls of all models, and what it says of one that diverges."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import REFUSED

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "soak"
RUN = 2000
FAILED = 1


def soak(*words: str, script: Path = SCRIPT) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-B", str(script), *words], capture_output=True, text=True, check=False, timeout=120
    )


def test_no_model_warns_under_random_controls() -> None:
    finished = soak("1")
    assert (finished.returncode, finished.stderr) == (0, "")
    _, *lines, total = (line.split() for line in finished.stdout.splitlines())
    scenes = sorted(path.relative_to(ROOT / "model").as_posix() for path in ROOT.glob("model/*/scene*.xml"))
    assert [line[0] for line in lines] == scenes
    # A part of one step is a whole run; steps, warnings and what is not finite.
    assert all((int(line[1]), line[4], line[5]) == (RUN, "0", "0") for line in lines)
    assert (total[0], int(total[1]), *total[-2:]) == ("all", RUN * len(scenes), "0", "0")


def test_a_model_that_diverges_is_found(tmp_path: Path) -> None:
    made = tmp_path / "model" / "diverges"
    made.mkdir(parents=True)
    own = (ROOT / "model" / "shoulder_tree" / "shoulder_right_position.xml").read_text()
    changed = own.replace('timestep="0.002" integrator="implicitfast"', 'timestep="0.01" integrator="RK4"')
    assert changed != own
    (made / "scene.xml").write_text(changed)
    (tmp_path / "build").symlink_to(ROOT / "build")
    (tmp_path / "scripts").mkdir()
    shutil.copy(SCRIPT, tmp_path / "scripts")
    finished = soak("20000", script=tmp_path / "scripts" / "soak")
    assert finished.returncode == FAILED
    name, steps, *_, warnings, _ = finished.stdout.splitlines()[1].split()
    assert (name, steps) == ("diverges/scene.xml", "20000")
    assert int(warnings) > 0
    assert finished.stderr.startswith("soak: diverges/scene.xml: ")


@pytest.mark.parametrize("words", [("0",), ("many",), ("1e13",), ("1", "2")])
def test_what_is_no_number_of_steps_is_refused(words: tuple[str, ...]) -> None:
    finished = soak(*words)
    assert (finished.returncode, finished.stdout) == (REFUSED, "")
    assert "Usage: scripts/soak [STEPS]" in finished.stderr


def test_help_is_printed() -> None:
    finished = soak("--help")
    assert (finished.returncode, finished.stderr) == (0, "")
    assert "Usage: scripts/soak [STEPS]" in finished.stdout
