# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` puts somewhere works from there, for users and for other projects."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

CMAKE = os.environ["GIRDLE_CMAKE"]
CONSUMER = Path(__file__).resolve().parents[1] / "package"


def run(*command: str | Path) -> str:
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    run(CMAKE, "--install", os.environ["GIRDLE_BUILD_DIR"], "--prefix", folder)
    return folder


def test_another_project_finds_and_uses_the_package(prefix: Path, tmp_path: Path) -> None:
    run(CMAKE, "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}")
    run(CMAKE, "--build", tmp_path)
    # SC protraction of the table's own row: plane 0, elevation 90.
    assert run(tmp_path / "consumer") == "-40.600000\n"


def test_the_installed_program_finds_its_plugin_and_its_simulation(
    prefix: Path, tmp_path: Path
) -> None:
    program = prefix / "bin" / "girdle"
    run(program, "generate", "--out", tmp_path)
    assert "all residuals within" in run(program, "verify", tmp_path / "scene.xml")


def test_an_engine_that_has_moved_is_named_and_found_through_the_environment(
    prefix: Path, tmp_path: Path
) -> None:
    installed = tmp_path / "installed"
    shutil.copytree(prefix, installed)
    (module,) = installed.rglob("libgirdle_simulation.so")
    (engine_dir,) = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", run("readelf", "-dW", module))
    gone = "/gone".ljust(len(engine_dir), "_")
    module.write_bytes(module.read_bytes().replace(engine_dir.encode(), gone.encode()))
    program = installed / "bin" / "girdle"
    assert "not loaded: cannot run MuJoCo" in run(program, "generate", "--out", tmp_path)
    command: list[str | Path] = [program, "verify", tmp_path / "scene.xml"]
    refused = subprocess.run(command, capture_output=True, text=True, check=False)
    assert refused.returncode == 2
    assert re.search(r"libmujoco\.so\.\S+: cannot open shared object", refused.stderr)
    assert f"built with the MuJoCo in {engine_dir}. " in refused.stderr
    assert "set LD_LIBRARY_PATH to the folder" in refused.stderr
    run("env", f"LD_LIBRARY_PATH={engine_dir}", *command)


def test_the_installed_model_is_the_emitted_one(prefix: Path, tmp_path: Path) -> None:
    run(prefix / "bin" / "girdle", "generate", "--out", tmp_path)
    installed = prefix / "share" / "girdle" / "model" / "shoulder_tree" / "shoulder_right.xml"
    assert installed.read_bytes() == (tmp_path / "shoulder_right.xml").read_bytes()


def test_solve_works_without_anything_that_runs_mujoco(prefix: Path, tmp_path: Path) -> None:
    alone = tmp_path / "girdle"
    alone.write_bytes((prefix / "bin" / "girdle").read_bytes())
    alone.chmod(0o755)
    assert "sc_protraction" in run(alone, "solve", "--elevation", "30", "--plane", "0")
    assert "not loaded" in run(alone, "generate", "--out", tmp_path / "model")
    refused = subprocess.run(
        [alone, "verify", tmp_path / "model" / "scene.xml"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode == 2
    assert "needs MuJoCo" in refused.stderr
