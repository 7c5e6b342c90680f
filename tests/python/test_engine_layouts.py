# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The table of layouts is what the headers of each MuJoCo say."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "engine_layouts"
TABLE = ROOT / "generator" / "plugin" / "engine_layouts.inc"
PINS = ROOT / "scripts" / "requirements"
TESTED = (PINS / "tested_engines.txt").read_text().split()


def check(top: Path, *versions: str) -> subprocess.CompletedProcess[str]:
    command: list[str | Path] = [top / "scripts" / "engine_layouts", "--check", *versions]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.parametrize("version", TESTED)
def test_a_row_is_made_anew_as_it_is_committed(version: str) -> None:
    finished = check(ROOT, version)
    assert finished.returncode == 0, finished.stdout + finished.stderr
    assert finished.stdout == "engine_layouts: 1 of 1 rows are as their headers say\n"


def test_there_is_a_row_for_every_pinned_version() -> None:
    pinned = re.findall(r"^mujoco(?:-core)?==(\S+)", (PINS / "engines.txt").read_text(), re.MULTILINE)
    assert re.findall(r"^// MuJoCo (.*)$", TABLE.read_text(), re.MULTILINE) == pinned
    assert len(pinned) >= 26


@pytest.fixture
def other_checkout(tmp_path: Path) -> Path:
    """What the script reads, with two versions' headers, to be changed."""
    for path in (SCRIPT, TABLE, TABLE.parent / "engine_members.inc", PINS / "engines.txt"):
        copied = tmp_path / path.relative_to(ROOT)
        copied.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, copied)
    for version in ("3.4.0", "3.17.0"):
        include = Path(f"build/engine/mujoco-{version}/mujoco/include")
        shutil.copytree(ROOT / include, tmp_path / include)
    return tmp_path


def replace(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


def test_a_row_that_is_wrong_by_one_byte_is_seen(other_checkout: Path) -> None:
    table = other_checkout / TABLE.relative_to(ROOT)
    (row,) = re.findall(r"^// MuJoCo 3\.4\.0\n(.*)$", table.read_text(), re.MULTILINE)
    replace(table, row, row.replace("632", "633"))
    finished = check(other_checkout, "3.4.0")
    assert finished.returncode == 1
    assert "the row of MuJoCo 3.4.0 is not what its headers say" in finished.stdout


CHANGES = {
    "type": ("3.4.0", "mjmodel.h", "mjtNum*   jnt_range;", "float*   jnt_range;", "jnt_range"),
    "name": ("3.17.0", "mjmodel.h", " actuator_ctrladr;", " actuator_adr;", "actuator_ctrladr"),
    "count": ("3.17.0", "mjmodel.h", "mjtSize nactuator;", "mjtSize n_actuator;", "nactuator"),
    "place": ("3.17.0", "mjplugin.h", "  int needstage;", "  int more[3]; int needstage;", "needstage"),
    "size": ("3.17.0", "mjplugin.h", "} mjpPlugin;", "void* more; } mjpPlugin;", "sizeof"),
}


@pytest.mark.parametrize(("version", "header", "old", "new", "named"), CHANGES.values(), ids=CHANGES.keys())
def test_what_the_plugin_does_not_know_is_refused(
    other_checkout: Path, version: str, header: str, old: str, new: str, named: str
) -> None:
    include = other_checkout / f"build/engine/mujoco-{version}/mujoco/include/mujoco"
    replace(include / header, old, new)
    finished = check(other_checkout, version)
    assert finished.returncode == 2, finished.stdout
    assert f"MuJoCo {version} has something that the plugin does not know" in finished.stderr
    assert re.search(rf"error: .*\b{named}\b|{named}.*\n.*\^", finished.stderr), finished.stderr


def test_a_version_that_is_not_pinned_is_refused() -> None:
    finished = check(ROOT, "3.99.0")
    assert finished.returncode == 2
    assert "3.99.0 is not in scripts/requirements/engines.txt" in finished.stderr
