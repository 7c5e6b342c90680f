# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle doctor`, with libraries that are broken, wrong or good in folders made for it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from conftest import PROGRAM_TIMEOUT_S, Girdle, Refuses, expect_one_message

# A version that never was: found nowhere else on the machine.
ODD = "3.2.1"


def number_of(version: str) -> int:
    major, minor, patch = map(int, version.split("."))
    return major * 1_000_000 + minor * 1_000 + patch


def compile_library(path: Path, code: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(
        [os.environ.get("CXX", "c++"), "-shared", "-fPIC", "-x", "c++", "-", "-o", path],
        input=code.encode(),
        check=True,
    )
    return path


def fake_engine(folder: Path, version: str) -> Path:
    """A library that says this version and can do nothing else."""
    code = f'extern "C" int mj_version() {{ return {number_of(version)}; }}'
    return compile_library(folder / f"libmujoco.so.{version}", code)


@dataclass(frozen=True)
class Report:
    code: int
    content: dict[str, Any]

    def engine(self, library: Path) -> dict[str, Any]:
        """What it says of this library."""
        (engine,) = [e for e in self.content["engines"] if e["library"] == str(library.resolve())]
        return engine

    def plugin(self, file: Path) -> dict[str, Any]:
        (plugin,) = [p for p in self.content["plugins"] if p["file"] == str(file)]
        return plugin


Doctor = Callable[..., Report]


@pytest.fixture(scope="module")
def engine(program: Path) -> Path:
    """The library that the program under test runs, as the system's own loader finds it."""
    module = program.parent / "libgirdle_simulation.so"
    listed = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    (line,) = [line for line in listed.splitlines() if "libmujoco.so" in line]
    return Path(line.split(" => ")[1].split(" (")[0]).resolve()


@pytest.fixture(scope="module")
def version(engine: Path) -> str:
    return engine.name.removeprefix("libmujoco.so.")


@pytest.fixture(scope="module")
def lone_program(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The program without anything beside it: no plugin, no simulation, no other build."""
    copy = tmp_path_factory.mktemp("alone") / "bin" / "build" / "girdle"
    copy.parent.mkdir(parents=True)
    shutil.copy(program, copy)
    return copy


@pytest.fixture
def doctor(lone_program: Path, tmp_path: Path) -> Doctor:
    """Runs the lone program in the test's own folder, with changes of the environment."""

    def run(*arguments: str | Path, **environment: str) -> Report:
        finished = subprocess.run(
            [lone_program, "doctor", "--json", *arguments],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env={**os.environ, **environment},
            timeout=PROGRAM_TIMEOUT_S,
            check=False,
        )
        assert finished.stderr == ""
        report = Report(finished.returncode, json.loads(finished.stdout))
        assert report.code == (0 if report.content["passed"] else 1)
        return report

    return run


# --- What works -----------------------------------------------------------------------------------


def test_the_programs_own_engine_works_with_the_plugin_beside_it(
    girdle: Girdle, program: Path, engine: Path, version: str
) -> None:
    finished = girdle("doctor", "--json")
    assert finished.message == ""
    assert finished.code == 0
    ours = Report(finished.code, json.loads(finished.text)).engine(engine)
    assert ours["works"]
    assert ours["version"] == version
    assert "this program" in ours["found_by"]
    assert ours["plugin"] == str(program.parent / "libgirdle_rhythm.so")
    assert ours["problem"] == ours["fix"] == ""


def test_an_engine_in_another_folder_works_with_a_plugin_of_its_version(
    doctor: Doctor, engine: Path, version: str, plugin_library: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "release" / "lib" / engine.name
    copy.parent.mkdir(parents=True)
    shutil.copy(engine, copy)
    report = doctor("--only", "--engine", tmp_path / "release", "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(copy)["works"]
    assert report.engine(copy)["version"] == version
    assert report.engine(copy)["plugin"] == str(plugin_library)
    assert len(report.content["engines"]) == 1


def test_links_to_one_library_are_one_engine(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    for place in ("first", "second"):
        (tmp_path / place / "lib").mkdir(parents=True)
        (tmp_path / place / "lib" / "libmujoco.so").symlink_to(engine)
    places = [tmp_path / "first", tmp_path / "second"]
    report = doctor(
        "--only", "--engine", places[0], "--engine", places[1], "--plugin", plugin_library
    )
    assert len(report.content["engines"]) == 1
    assert report.engine(engine)["found_by"] == [f"--engine {place}" for place in places]


def test_the_report_for_people_says_the_same(
    girdle: Girdle, program: Path, engine: Path, version: str
) -> None:
    finished = girdle("doctor", "--only", "--engine", engine)
    assert (finished.code, finished.message) == (0, "")
    lines = finished.text.splitlines()
    assert lines[0] == f"MuJoCo {version}  works"
    assert f"  library     {engine}" in lines
    assert f"  plugin      {program.parent / 'libgirdle_rhythm.so'}" in lines
    assert lines[-1] == "MuJoCo works with a plugin of Girdle: 1 of 1 found"


# --- What does not work ---------------------------------------------------------------------------


def test_where_there_is_no_engine_it_says_how_to_get_one(doctor: Doctor, tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    report = doctor("--only", "--engine", empty)
    assert report.code == 1
    assert report.content["engines"] == []
    assert report.content["fix"] == "python3 -m pip install mujoco-core==4.0.1"
    assert any(f"{empty} holds no libmujoco.so" in note for note in report.content["notes"])


def test_a_broken_library_is_told_with_the_loaders_reason(doctor: Doctor, tmp_path: Path) -> None:
    broken = tmp_path / "libmujoco.so.4.0.1"
    broken.write_text("not a library\n" * 100)
    report = doctor("--only", "--engine", broken)
    assert report.code == 1
    assert report.engine(broken)["version"] is None
    assert "invalid ELF header" in report.engine(broken)["problem"]
    assert "pip install" in report.engine(broken)["fix"]


def test_a_library_that_crashes_harms_no_other(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    code = "#include <csignal>\nstatic int crash = (std::signal(SIGSEGV, SIG_DFL), raise(SIGSEGV));"
    crashing = compile_library(tmp_path / "libmujoco.so.9.9.9", code)
    report = doctor(
        "--only", "--engine", crashing, "--engine", engine, "--plugin", plugin_library
    )
    assert report.code == 0
    assert "crashed" in report.engine(crashing)["problem"]
    assert report.engine(engine)["works"]


def test_a_library_that_is_no_mujoco_is_told(doctor: Doctor, tmp_path: Path) -> None:
    other = compile_library(tmp_path / "libmujoco.so", "int unrelated;")
    assert doctor("--only", "--engine", other).engine(other)["problem"] == "has no mj_version"


@pytest.mark.parametrize(
    ("version", "problem", "package"),
    [
        ("3.16.0", "too old: Girdle needs 3.17.0", "mujoco==3.17.0"),
        ("2.3.7", "too old: Girdle needs 3.17.0", "mujoco==3.17.0"),
        ("4.0.0", "its sparse factorisation is wrong", "mujoco-core==4.0.1"),
    ],
)
def test_a_version_that_girdle_does_not_take_is_refused_with_what_to_install(
    doctor: Doctor, tmp_path: Path, version: str, problem: str, package: str
) -> None:
    library = fake_engine(tmp_path, version)
    report = doctor("--only", "--engine", library)
    assert report.code == 1
    assert report.engine(library)["version"] == version
    assert problem in report.engine(library)["problem"]
    assert report.engine(library)["fix"] == f"python3 -m pip install {package}"


def test_an_engine_without_a_plugin_for_it_says_how_to_build_one(
    doctor: Doctor, plugin_library: Path, tmp_path: Path
) -> None:
    """The folder's name needs quotes in a shell."""
    root = tmp_path / "my releases" / "mujoco"
    library = fake_engine(root / "lib", "9.1.0")
    (root / "include" / "mujoco").mkdir(parents=True)
    (root / "include" / "mujoco" / "mujoco.h").touch()
    report = doctor("--only", "--engine", root, "--plugin", plugin_library)
    assert report.code == 1
    assert report.engine(library)["problem"] == "no plugin for it"
    fix = report.engine(library)["fix"]
    assert f"-DMUJOCO_ROOT='{root}'" in fix
    assert fix.startswith("cmake -S . -B ./build/mujoco-9.1.0 ")


def test_an_engine_without_headers_needs_another_one(doctor: Doctor, tmp_path: Path) -> None:
    library = fake_engine(tmp_path, "9.1.0")
    report = doctor("--only", "--engine", library)
    assert report.engine(library)["fix"] == "python3 -m pip install mujoco-core==4.0.1"


def test_the_line_names_the_python_that_the_engine_belongs_to(
    doctor: Doctor, tmp_path: Path
) -> None:
    library = fake_engine(tmp_path / "env/lib/python3.11/site-packages/mujoco", "4.0.0")
    python = tmp_path / "env" / "bin" / "python"
    python.parent.mkdir()
    python.touch()
    report = doctor("--only", "--engine", library)
    assert report.engine(library)["fix"] == f"{python} -m pip install mujoco-core==4.0.1"


def test_of_two_engines_each_has_its_own_answer(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    other = fake_engine(tmp_path, "9.1.0")
    report = doctor("--only", "--engine", engine, "--engine", other, "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(engine)["works"]
    assert not report.engine(other)["works"]


def test_a_plugin_for_another_version_is_told_with_what_to_install(
    doctor: Doctor, engine: Path
) -> None:
    plugin = Path(os.environ["GIRDLE_BUILD_DIR"]) / "tests" / "libgirdle_rhythm_other_version.so"
    report = doctor("--only", "--engine", engine, "--plugin", plugin)
    assert report.code == 1
    assert report.engine(engine)["problem"] == "no plugin for it"
    assert report.plugin(plugin)["version"] == "9.8.7"
    assert report.plugin(plugin)["problem"] == "no MuJoCo of this version here"
    assert report.plugin(plugin)["fix"] == "python3 -m pip install mujoco-core==9.8.7"


def test_a_library_that_only_says_it_is_a_plugin_does_not_work(
    doctor: Doctor, engine: Path, version: str, tmp_path: Path
) -> None:
    """Nothing is believed that was not tried."""
    code = f'extern "C" int girdle_rhythm_engine_version() {{ return {number_of(version)}; }}'
    impostor = compile_library(tmp_path / "libgirdle_rhythm.so", code)
    report = doctor("--only", "--engine", engine, "--plugin", impostor)
    assert report.code == 1
    assert report.engine(engine)["problem"] == "registers no plugin girdle.rhythm"
    assert report.engine(engine)["plugin"] == str(impostor)


def test_a_library_that_is_no_plugin_is_told(doctor: Doctor, tmp_path: Path) -> None:
    other = compile_library(tmp_path / "libgirdle_rhythm.so", "int unrelated;")
    assert "not a plugin of this Girdle" in doctor("--plugin", other).plugin(other)["problem"]


# --- Where it looks -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("folder", "name", "environment"),
    [
        ("root/lib", "MUJOCO_ROOT", {"MUJOCO_ROOT": "root"}),
        ("root/mujoco", "MUJOCO_ROOT", {"MUJOCO_ROOT": "root"}),
        ("env/lib/python3.11/site-packages/mujoco", "VIRTUAL_ENV", {"VIRTUAL_ENV": "env"}),
        ("env/lib/python3.12/site-packages/mujoco", "CONDA_PREFIX", {"CONDA_PREFIX": "env"}),
        (".venv/lib/python3.11/site-packages/mujoco", ".venv", {}),
        ("build/python/lib/python3.11/site-packages/mujoco", "build/python", {}),
        ("build/engine/mujoco-core-3.2.1/mujoco", "build/engine", {}),
        ("libraries", "LD_LIBRARY_PATH", {"LD_LIBRARY_PATH": "libraries"}),
        (".mujoco/mujoco-3.2.1/lib", "~/.mujoco", {"HOME": "."}),
    ],
)
def test_it_looks_where_people_keep_mujoco(
    doctor: Doctor, tmp_path: Path, folder: str, name: str, environment: dict[str, str]
) -> None:
    library = fake_engine(tmp_path / folder, ODD)
    whole = {variable: str(tmp_path / value) for variable, value in environment.items()}
    found = doctor(**whole).engine(library)
    assert found["found_by"] == [name]
    assert found["version"] == ODD


def test_it_asks_every_python_on_the_path(doctor: Doctor, tmp_path: Path) -> None:
    library = fake_engine(tmp_path / "packages" / "mujoco", ODD)
    python = tmp_path / "bin" / "python3"
    python.parent.mkdir()
    python.write_text(f"#!/bin/sh\necho '{library.parent}'\n")
    python.chmod(0o755)
    found = doctor(PATH=f"{python.parent}:{os.environ['PATH']}").engine(library)
    assert found["found_by"] == [str(python)]


def test_a_python_on_the_path_that_is_broken_is_passed_over(
    doctor: Doctor, tmp_path: Path
) -> None:
    python = tmp_path / "bin" / "python3"
    python.parent.mkdir()
    python.write_text("#!/no/such/interpreter\n")
    python.chmod(0o755)
    report = doctor(PATH=f"{python.parent}:{os.environ['PATH']}")
    assert all(str(python) not in engine["found_by"] for engine in report.content["engines"])


def test_a_mujoco_root_that_holds_none_is_told(doctor: Doctor, tmp_path: Path) -> None:
    report = doctor(MUJOCO_ROOT=str(tmp_path))
    assert f"MUJOCO_ROOT: {tmp_path} holds no libmujoco.so" in report.content["notes"]


def test_it_finds_the_plugins_of_builds_beside_the_programs(
    lone_program: Path, doctor: Doctor, plugin_library: Path, version: str
) -> None:
    beside = lone_program.parents[1] / "mujoco-other" / "libgirdle_rhythm.so"
    beside.parent.mkdir()
    shutil.copy(plugin_library, beside)
    try:
        assert doctor().plugin(beside)["version"] == version
    finally:
        shutil.rmtree(beside.parent)


# --- Bad input ------------------------------------------------------------------------------------


def test_an_engine_that_is_not_there_is_refused(refuses: Refuses) -> None:
    refuses("doctor", "--engine", "nowhere", because=("--engine nowhere: no such file or folder",))


def test_a_plugin_that_is_not_there_is_refused(refuses: Refuses) -> None:
    refuses("doctor", "--plugin", "nowhere.so", because=("--plugin nowhere.so: no such plugin",))


def test_an_empty_engine_is_refused(girdle: Girdle) -> None:
    expect_one_message(girdle("doctor", "--engine", ""), "--engine '': is empty")
