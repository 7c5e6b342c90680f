# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The plugin as a library: it brings no second MuJoCo and offers one function to call."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path


def output_of(*command: str | Path) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def test_the_plugin_needs_no_mujoco_library(plugin_library: Path) -> None:
    needed = [line for line in output_of("readelf", "-dW", plugin_library).splitlines() if "NEEDED" in line]
    assert needed, "readelf lists no library at all"
    assert not [line for line in needed if "mujoco" in line]


def test_the_plugin_exports_its_version_and_nothing_else(
    plugin_library: Path,
) -> None:
    names = [line.split()[-1] for line in output_of("nm", "-D", "--defined-only", plugin_library).splitlines()]
    assert names == ["girdle_rhythm_version"]


def test_the_plugin_says_its_version_in_a_process_without_mujoco(
    plugin_library: Path, program: Path
) -> None:
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
