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
UMBRELLA = Path(__file__).resolve().parents[2] / "generator" / "girdle.h"

# Switches of GLM with which everything stays as it is; doubles are aligned with two of them only ...
HARMLESS_SWITCHES = [
    "GLM_FORCE_CTOR_INIT",
    "GLM_FORCE_DEFAULT_ALIGNED_GENTYPES+GLM_FORCE_INTRINSICS",
    "GLM_FORCE_PRECISION_LOWP_DOUBLE",
    "GLM_FORCE_SWIZZLE",
    "GLM_FORCE_XYZW_ONLY",
]
# ... and those that are refused: w first in memory, w last in the constructor, functions' names.
REFUSED_SWITCHES = {
    "GLM_FORCE_QUAT_DATA_WXYZ": "Remove the GLM switch GLM_FORCE_QUAT_DATA_WXYZ",
    "GLM_FORCE_QUAT_DATA_XYZW": "Remove the switch",
    "GLM_FORCE_QUAT_CTOR_XYZW": "Remove the switch",
    "GLM_FORCE_SIZE_T_LENGTH": "Remove the GLM switch GLM_FORCE_SIZE_T_LENGTH",
}


def run(*command: str | Path) -> str:
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    run(CMAKE, "--install", os.environ["GIRDLE_BUILD_DIR"], "--prefix", folder)
    return folder


@pytest.fixture(scope="module")
def project(prefix: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Another project, configured."""
    folder = tmp_path_factory.mktemp("project")
    switches = ";".join(["none", *HARMLESS_SWITCHES, *REFUSED_SWITCHES])
    run(CMAKE, "-S", CONSUMER, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DGLM_SWITCHES={switches}")
    return folder


def test_another_project_finds_and_uses_the_package(project: Path) -> None:
    run(CMAKE, "--build", project)
    # SC protraction of the table's own row: plane 0, elevation 90.
    protraction, error = run(project / "consumer").splitlines()
    assert protraction == "-40.600000"
    assert error == "table.csv:1: column 'elevation_deg' is missing. The header has: plane_deg"


def test_only_the_headers_of_the_umbrella_are_installed(prefix: Path) -> None:
    folder = prefix / "include" / "girdle"
    installed = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    included = re.findall(r'^#include "(.+)"$', UMBRELLA.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(included) > 10
    assert installed == {"girdle.h", *included}
    assert list((prefix / "include").iterdir()) == [folder]


@pytest.fixture(scope="module")
def numbers(project: Path) -> dict[str, str]:
    """What a program prints that is compiled with a switch of GLM."""
    switches = ["none", *HARMLESS_SWITCHES]
    run(CMAKE, "--build", project, "--target", *(f"consumer_{switch}" for switch in switches))
    return {switch: run(project / f"consumer_{switch}") for switch in switches}


@pytest.mark.parametrize("switch", HARMLESS_SWITCHES)
def test_a_switch_of_glm_changes_no_number(numbers: dict[str, str], switch: str) -> None:
    # The clavicle of an arm that is raised by 90 degrees: turned by less than a right angle.
    assert float(numbers["none"].split()[0]) > 0.7
    assert numbers[switch] == numbers["none"]


@pytest.mark.parametrize("switch", REFUSED_SWITCHES)
def test_a_switch_of_glm_that_girdle_cannot_take_is_refused(project: Path, switch: str) -> None:
    command: list[str | Path] = [CMAKE, "--build", project, "--target", f"consumer_{switch}"]
    refused = subprocess.run(command, capture_output=True, text=True, check=False)
    assert refused.returncode != 0
    assert REFUSED_SWITCHES[switch] in refused.stdout + refused.stderr


def test_the_installed_program_finds_its_plugin_and_its_simulation(prefix: Path, tmp_path: Path) -> None:
    program = prefix / "bin" / "girdle"
    run(program, "generate", "--out", tmp_path)
    report = run(program, "verify", tmp_path / "scene.xml")
    assert report.endswith(" residuals checked, all within their tolerances\n")


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
