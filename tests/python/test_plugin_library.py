# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The plugin as a library: it brings no second MuJoCo and offers one function to call."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import Girdle


def output_of(*command: str | Path) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


@pytest.mark.without_engine
def test_the_plugin_needs_no_mujoco_library(plugin_library: Path) -> None:
    needed = [line for line in output_of("readelf", "-dW", plugin_library).splitlines() if "NEEDED" in line]
    assert needed, "readelf lists no library at all"
    assert not [line for line in needed if "mujoco" in line]


@pytest.mark.without_engine
def test_the_plugin_exports_its_version_and_nothing_else(
    plugin_library: Path,
) -> None:
    listed = output_of("nm", "-D", "--defined-only", plugin_library).splitlines()
    names = [line.split()[-1] for line in listed]
    assert names == ["girdle_rhythm_version"]


@pytest.mark.without_engine
def test_the_plugin_says_its_version_in_a_process_without_mujoco(plugin_library: Path, program: Path) -> None:
    script = (
        "import ctypes, sys\n"
        "version = ctypes.CDLL(sys.argv[1]).girdle_rhythm_version\n"
        "version.restype = ctypes.c_char_p\n"
        "print('girdle', version().decode())\n"
    )
    said = output_of(sys.executable, "-c", script, plugin_library)
    assert said == output_of(program, "--version")


def test_a_plugin_folder_is_scanned_as_the_simulate_program_does(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    shutil.copy(plugin_library, tmp_path)
    script = (
        "import ctypes, mujoco, pathlib, sys\n"
        "engine = next(pathlib.Path(mujoco.__file__).parent.glob('libmujoco.so.*'))\n"
        "ctypes.CDLL(engine).mj_loadAllPluginLibraries(sys.argv[1].encode(), None)\n"
        "print(mujoco.MjModel.from_xml_path(sys.argv[2]).nplugin)\n"
    )
    assert output_of(sys.executable, "-c", script, tmp_path, model_path) == "1\n"


def test_the_installed_plugin_is_loaded_by_import_alone_in_spawned_workers_too(
    girdle_fine: Girdle, package: Path, model_path: Path, tmp_path: Path
) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "import multiprocessing, mujoco, sys\n"
        "def steps(path):\n"
        "    model = mujoco.MjModel.from_xml_path(path)\n"
        "    data = mujoco.MjData(model)\n"
        "    mujoco.mj_step(model, data)\n"
        "    return mujoco.__file__, data.time\n"
        "if __name__ == '__main__':\n"
        "    with multiprocessing.get_context('spawn').Pool(1) as pool:\n"
        "        file, time = pool.apply(steps, [sys.argv[1]])\n"
        "    print(file, time > 0, steps(sys.argv[1])[1] == time)\n"
    )
    girdle_fine("doctor", "--install", "--engine", package)
    finished = subprocess.run(
        [sys.executable, script, model_path],
        env={**os.environ, "PYTHONPATH": str(package.parent)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert finished.stdout.split() == [str(package / "__init__.py"), "True", "True"]


def test_the_report_says_what_mends_a_plugin_that_is_not_found(
    girdle: Girdle, program: Path, model_path: Path
) -> None:
    """The line for Python does; the sentence before it has the words that MuJoCo says."""
    text = girdle("doctor").text
    (line,) = re.findall(r"^  Python +(.*)$", text, re.MULTILINE)
    model = f"mujoco.MjModel.from_xml_path({str(model_path)!r})"
    command = [sys.executable, "-c"]
    without = subprocess.run(
        [*command, f"import mujoco; {model}"], capture_output=True, text=True, check=False
    )
    assert without.returncode != 0
    (words,) = re.findall(r"plugin girdle[.]rhythm not found", without.stderr)
    assert f'"{words}" means' in text
    subprocess.run([*command, f"import mujoco; {line}; {model}"], check=True)
    assert f"  type        {program} doctor --install\n" in text
