# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle doctor`, with libraries that are broken, wrong or good in folders made for it."""

from __future__ import annotations

import errno
import functools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import pytest
from conftest import PROGRAM_TIMEOUT_S, Girdle, Refuses, contents, expect_one_message, installed

# A version that never was: found nowhere else on the machine.
ODD = "3.2.1"


ROOT = Path(__file__).resolve().parents[2]


@functools.cache
def compiled(code: str, linked: tuple[str, ...]) -> bytes:
    """The library that a code becomes; many tests want the same few."""
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "library.so"
        command: list[str | Path] = [os.environ.get("CXX", "c++"), "-shared", "-fPIC", "-x", "c++", "-", "-o"]
        subprocess.run([*command, library, *linked], input=code.encode(), check=True)
        return library.read_bytes()


def compile_library(path: Path, code: str, *linked: str | Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(compiled(code, tuple(map(str, linked))))
    path.chmod(0o755)
    return path


def fake_engine(folder: Path, version: str) -> Path:
    """A library that says this version and can do nothing else."""
    code = f'extern "C" const char* mj_versionString() {{ return "{version}"; }}'
    return compile_library(folder / f"libmujoco.so.{version}", code)


@dataclass(frozen=True)
class Report:
    code: int
    content: dict[str, Any]

    def engine(self, library: Path) -> dict[str, Any]:
        """What it says of this library."""
        (engine,) = [e for e in self.content["engines"] if e["library"] == str(library.resolve())]
        return engine


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
def checkout(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as Girdle's sources lie in it, with the program alone in build/release."""
    folder = tmp_path_factory.mktemp("checkout")
    (folder / "scripts").mkdir()
    (folder / "scripts" / "setup").touch()
    (folder / "generator" / "plugin").mkdir(parents=True)
    (folder / "build" / "release").mkdir(parents=True)
    shutil.copy(program, folder / "build" / "release")
    return folder


@pytest.fixture(scope="module")
def lone_program(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The program without anything beside it: no plugin, no simulation, no sources."""
    return Path(shutil.copy(program, tmp_path_factory.mktemp("alone")))


def run_doctor(
    program: Path, folder: Path, *arguments: str | Path, **environment: str
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [program, "doctor", *arguments],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, **environment},
        timeout=PROGRAM_TIMEOUT_S,
        check=False,
    )


def report_of(finished: subprocess.CompletedProcess[str]) -> Report:
    assert finished.stderr == ""
    report = Report(finished.returncode, json.loads(finished.stdout))
    assert report.code == (0 if report.content["passed"] else 1)
    return report


@pytest.fixture
def doctor(lone_program: Path, tmp_path: Path) -> Doctor:
    """Runs the lone program in the test's own folder, with changes of the environment."""
    return lambda *arguments, **environment: report_of(
        run_doctor(lone_program, tmp_path, "--json", *arguments, **environment)
    )


def write_python(folder: Path, script: str) -> Path:
    """A python3 that is a script of the shell."""
    folder.mkdir(parents=True, exist_ok=True)
    python = folder / "python3"
    python.write_text(f"#!/bin/sh\n{script}\n")
    python.chmod(0o755)
    return python


# --- What works -----------------------------------------------------------------------------------


def test_the_programs_own_engine_works_with_the_plugin_beside_it(
    girdle: Girdle, program: Path, engine: Path, version: str
) -> None:
    finished = girdle("doctor", "--json")
    assert (finished.code, finished.message) == (0, "")
    report = Report(finished.code, json.loads(finished.text))
    plugin = {"file": str(program.parent / "libgirdle_rhythm.so"), "version": "0.1.0", "problem": ""}
    assert report.content["plugin"] == plugin
    ours = report.engine(engine)
    assert ours["works"]
    assert ours["version"] == version
    assert "this program" in ours["found_by"]
    assert ours["problem"] == ours["fix"] == ours["installed"] == ""


def test_an_engine_in_another_folder_works(
    doctor: Doctor, engine: Path, version: str, plugin_library: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "release" / "lib" / engine.name
    copy.parent.mkdir(parents=True)
    shutil.copy(engine, copy)
    report = doctor("--only", "--engine", tmp_path / "release", "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(copy)["works"]
    assert report.engine(copy)["version"] == version
    assert len(report.content["engines"]) == 1


def test_links_to_one_library_are_one_engine(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    for place in ("first", "second"):
        (tmp_path / place / "lib").mkdir(parents=True)
        (tmp_path / place / "lib" / "libmujoco.so").symlink_to(engine)
    places = [tmp_path / "first", tmp_path / "second"]
    report = doctor("--only", "--engine", places[0], "--engine", places[1], "--plugin", plugin_library)
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
    assert lines[-1] == "MuJoCo works with the plugin: 1 of 1 found"


# --- What does not work ---------------------------------------------------------------------------


def test_where_there_is_no_engine_it_says_how_to_get_one(doctor: Doctor, tmp_path: Path) -> None:
    places = ("VIRTUAL_ENV", "CONDA_PREFIX", "MUJOCO_ROOT", "LD_LIBRARY_PATH", "PYTHONPATH")
    report = doctor(PATH=str(tmp_path), HOME=str(tmp_path), **dict.fromkeys(places, ""))
    if any(set(e["found_by"]) <= {"/opt", "/usr/local", "/usr/lib"} for e in report.content["engines"]):
        pytest.skip("this machine has a MuJoCo for all its users")
    assert report.code == 1
    assert report.content["engines"] == []
    assert "python3 -m venv .venv" in report.content["fix"]
    assert "pip install mujoco" in report.content["fix"]


def test_a_broken_library_is_told_with_the_loaders_reason(doctor: Doctor, tmp_path: Path) -> None:
    broken = tmp_path / "libmujoco.so.4.0.1"
    broken.write_text("not a library\n" * 100)
    report = doctor("--only", "--engine", broken)
    assert report.code == 1
    assert report.engine(broken)["version"] is None
    assert "invalid ELF header" in report.engine(broken)["problem"]
    assert report.engine(broken)["fix"] == "", "it belongs to no Python"


def test_a_library_that_crashes_harms_no_other(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    code = "#include <csignal>\nstatic int crash = (std::signal(SIGSEGV, SIG_DFL), raise(SIGSEGV));"
    crashing = compile_library(tmp_path / "libmujoco.so.9.9.9", code)
    report = doctor("--only", "--engine", crashing, "--engine", engine, "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(crashing)["problem"] == "was ended by a signal: Segmentation fault"
    assert report.engine(engine)["works"]


def test_a_library_that_is_no_mujoco_is_told(doctor: Doctor, tmp_path: Path) -> None:
    other = compile_library(tmp_path / "libmujoco.so", "int unrelated;")
    assert doctor("--only", "--engine", other).engine(other)["problem"] == "has no mj_versionString"


def test_the_line_names_the_python_that_the_engine_belongs_to(doctor: Doctor, tmp_path: Path) -> None:
    """The folder's name needs quotes in a shell."""
    package = tmp_path / "my env/lib/python3.11/site-packages/mujoco"
    broken = compile_library(package / "libmujoco.so", "int unrelated;")
    python = tmp_path / "my env" / "bin" / "python3"
    python.parent.mkdir()
    python.touch()
    report = doctor("--only", "--engine", broken)
    fix = report.engine(broken)["fix"]
    assert fix == f"'{python}' -m pip install --force-reinstall mujoco"


def test_an_engine_that_lacks_what_the_plugin_needs_is_told(doctor: Doctor, tmp_path: Path) -> None:
    """Its Python would install the same one again."""
    library = fake_engine(tmp_path / "lib/python3.11/site-packages/mujoco", ODD)
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3").touch()
    plugin = compile_library(tmp_path / "libgirdle_rhythm.so", "int unrelated;")
    report = doctor("--only", "--engine", library, "--plugin", plugin)
    assert report.code == 1
    assert report.engine(library)["version"] == ODD
    assert report.engine(library)["problem"].startswith("has no mj")
    assert report.engine(library)["fix"] == ""


def test_a_warning_of_the_plugin_is_the_problem_in_one_line(
    doctor: Doctor, engine: Path, tmp_path: Path
) -> None:
    """Whatever a terminal would obey is left out of it."""
    code = f"""
      #include <dlfcn.h>
      __attribute__((constructor)) static void warn() {{
        void* engine = dlopen("{engine}", RTLD_LAZY | RTLD_NOLOAD);
        auto* warning = reinterpret_cast<void (*)(const char*, ...)>(dlsym(engine, "mju_warning"));
        if (warning != nullptr) {{
          warning("too old:\\n\\x1b[31minstall another");
        }}
      }}
    """
    plugin = compile_library(tmp_path / "libgirdle_rhythm.so", code)
    report = doctor("--only", "--engine", engine, "--plugin", plugin)
    assert report.code == 1
    assert report.engine(engine)["problem"] == "too old:  [31minstall another"


# What stands in for a function of MuJoCo, and the problem that this is. `real` is that function.
MOODY_ENGINES: dict[str, tuple[str, str]] = {
    "steps nothing": ("void mj_step(void*, void*) {}", "does not step a model"),
    "warns at the start": (
        """void* mj_makeData(void* model) {
          mju_warning("no shoulder");
          return real<void*(void*)>("mj_makeData")(model);
        }""",
        "no shoulder",
    ),
    "warns in a step": (
        """void mj_step(void* model, void* data) {
          real<void(void*, void*)>("mj_step")(model, data);
          mju_warning("unstable");
        }""",
        "unstable",
    ),
    "fails in a step": (
        """void mj_step(void* model, void* data) {
          static int steps = 0;
          real<void(void*, void*)>("mj_step")(model, data);
          if (++steps == 5) {  // MuJoCo's own step of a model that it loads passes
            mju_error("broken");
          }
        }""",
        "broken",
    ),
    "is given a shoulder with the plugin": (
        """void* mj_parseXMLString(const char* xml, void*, char*, int) {
          const bool is_ours = std::strstr(xml, "<instance") && std::strstr(xml, "girdle.rhythm");
          mju_error(is_ours ? "ours" : xml);
          return nullptr;
        }""",
        "ours",
    ),
}


@pytest.mark.parametrize(("code", "problem"), MOODY_ENGINES.values(), ids=MOODY_ENGINES.keys())
def test_an_engine_that_works_but_for_one_function_does_not_work(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path, code: str, problem: str
) -> None:
    """All else is that of the real one, which it is linked with."""
    code = f"""
      #include <dlfcn.h>
      #include <cstring>
      extern "C" void mju_warning(const char*, ...);
      extern "C" void mju_error(const char*, ...);
      template <typename F> F* real(const char* name) {{
        return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
      }}
      extern "C" {{ {code} }}
    """
    linked = ("-Wl,--no-as-needed", "-xnone", engine, f"-Wl,-rpath,{engine.parent}")
    moody = compile_library(tmp_path / "lib" / "libmujoco.so.9.9.9", code, *linked)
    report = doctor("--only", "--engine", moody, "--plugin", plugin_library)
    assert report.code == 1
    assert report.engine(moody)["problem"] == problem


def test_of_two_engines_each_has_its_own_answer(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path
) -> None:
    other = fake_engine(tmp_path, "9.1.0")
    report = doctor("--only", "--engine", engine, "--engine", other, "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(engine)["works"]
    assert not report.engine(other)["works"]


def test_a_library_that_only_says_it_is_a_plugin_does_not_work(
    doctor: Doctor, engine: Path, tmp_path: Path
) -> None:
    """Nothing is believed that was not tried."""
    code = 'extern "C" const char* girdle_rhythm_version() { return "0.1.0"; }'
    impostor = compile_library(tmp_path / "libgirdle_rhythm.so", code)
    report = doctor("--only", "--engine", engine, "--plugin", impostor)
    assert report.code == 1
    assert report.content["plugin"]["version"] == "0.1.0"
    assert report.engine(engine)["problem"] == "registers no plugin girdle.rhythm"


def test_what_to_heed_in_four_zero_zero_is_told(doctor: Doctor, girdle: Girdle, plugin_library: Path) -> None:
    package = ROOT / "build/engine/mujoco-4.0.0/mujoco"
    words = ("--only", "--engine", package, "--plugin", plugin_library)
    (found,) = doctor(*words).content["engines"]
    assert found["works"]
    assert '<option jacobian="dense"/>' in found["caution"]
    assert f"  heed        {found['caution']}\n" in girdle("doctor", *words).text


def test_what_an_interrupted_install_left_is_removed(girdle_fine: Girdle, package: Path) -> None:
    before = contents(package)
    for words in ("--install", "--uninstall"):
        (package / "plugin" / "libgirdle_rhythm.so.123.part").touch()
        girdle_fine("doctor", words, "--engine", package)
        assert not list((package / "plugin").glob("*.part"))
    assert contents(package) == before


def test_a_library_that_is_no_plugin_is_told(doctor: Doctor, girdle: Girdle, tmp_path: Path) -> None:
    other = compile_library(tmp_path / "libgirdle_rhythm.so", "int unrelated;")
    text = girdle("doctor", "--plugin", other).text
    assert "This is not Girdle's plugin. Name libgirdle_rhythm.so" in text
    assert "mj_loadPluginLibrary" not in text
    plugin = doctor("--plugin", other).content["plugin"]
    assert plugin == {"file": str(other), "version": None, "problem": "has no girdle_rhythm_version"}


def test_a_program_without_a_plugin_says_so(doctor: Doctor, engine: Path, version: str) -> None:
    report = doctor("--only", "--engine", engine)
    assert report.code == 1
    assert report.content["plugin"]["file"] == ""
    assert "built without MuJoCo" in report.content["plugin"]["problem"]
    assert report.engine(engine)["version"] == version
    assert report.engine(engine)["problem"] == "there is no plugin to try it with"


# --- Where it looks -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("folder", "name", "environment"),
    [
        ("root/lib", "MUJOCO_ROOT", {"MUJOCO_ROOT": "root"}),
        ("root/mujoco", "MUJOCO_ROOT", {"MUJOCO_ROOT": "root"}),
        ("env/lib/python3.11/site-packages/mujoco", "VIRTUAL_ENV", {"VIRTUAL_ENV": "env"}),
        ("env/lib/python3.12/site-packages/mujoco", "CONDA_PREFIX", {"CONDA_PREFIX": "env"}),
        ("libraries", "LD_LIBRARY_PATH", {"LD_LIBRARY_PATH": "libraries"}),
        ("packages/mujoco", "PYTHONPATH", {"PYTHONPATH": "packages"}),
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


OF_CHECKOUT = [
    (".venv/lib/python3.11/site-packages/mujoco", ".venv"),
    ("build/python/lib/python3.11/site-packages/mujoco", "build/python"),
    ("build/engine/mujoco-core-3.2.1/mujoco", "build/engine"),
]


@pytest.mark.parametrize(("folder", "name"), OF_CHECKOUT)
def test_it_looks_in_the_checkout_that_the_program_lies_in(
    checkout: Path, tmp_path: Path, folder: str, name: str
) -> None:
    """Wherever one calls it."""
    library = fake_engine(checkout / folder, ODD)
    report = report_of(run_doctor(checkout / "build/release/girdle", tmp_path, "--json"))
    assert report.engine(library)["found_by"] == [name]


def test_an_engine_may_be_named_by_its_environment(doctor: Doctor, tmp_path: Path) -> None:
    library = fake_engine(tmp_path / ".venv/lib/python3.11/site-packages/mujoco", ODD)
    report = doctor("--only", "--engine", ".venv")
    assert report.engine(library)["found_by"] == ["--engine .venv"]


def test_it_asks_every_python_on_the_path(doctor: Doctor, tmp_path: Path) -> None:
    library = fake_engine(tmp_path / "packages" / "mujoco", ODD)
    python = write_python(tmp_path / "bin", f"echo 'girdle:{library.parent}'")
    found = doctor(PATH=f"{python.parent}:{os.environ['PATH']}").engine(library)
    assert found["found_by"] == [str(python)]


def test_a_python_may_print_lines_of_its_own(doctor: Doctor, tmp_path: Path) -> None:
    """A script that starts the real one, which ends with what the script was given."""
    wrapper = f"printf 'conda: activated'; '{sys.executable}' \"$@\"; echo conda: done"
    python = write_python(tmp_path / "bin", wrapper)
    report = doctor(PATH=f"{python.parent}:{os.environ['PATH']}")
    (found,) = [e for e in report.content["engines"] if str(python) in e["found_by"]]
    assert found["library"].startswith(str(Path(mujoco.__file__).parent))


def test_it_finds_what_a_user_has_installed_for_himself(doctor: Doctor, tmp_path: Path) -> None:
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    library = fake_engine(tmp_path / ".local/lib" / version / "site-packages/mujoco", ODD)
    python = Path(sys.base_prefix) / "bin" / "python3"
    report = doctor(HOME=str(tmp_path), PATH=str(python.parent))
    assert report.engine(library)["found_by"] == [str(python)]


def test_a_mujoco_root_that_holds_none_is_told(doctor: Doctor, tmp_path: Path) -> None:
    report = doctor(MUJOCO_ROOT=str(tmp_path))
    assert f"MUJOCO_ROOT: {tmp_path} holds no libmujoco.so" in report.content["notes"]


# --- What it does not run -------------------------------------------------------------------------


@pytest.mark.parametrize("folder", [folder for folder, _ in OF_CHECKOUT])
def test_it_looks_at_nothing_of_a_current_folder_that_it_does_not_belong_to(
    doctor: Doctor, tmp_path: Path, folder: str
) -> None:
    library = fake_engine(tmp_path / folder, ODD)
    report = doctor()
    assert str(library) not in [engine["library"] for engine in report.content["engines"]]


@pytest.mark.parametrize("variable", ["VIRTUAL_ENV", "CONDA_PREFIX", "LD_LIBRARY_PATH", "PYTHONPATH"])
def test_a_folder_that_depends_on_the_current_one_is_passed_over(
    doctor: Doctor, tmp_path: Path, variable: str
) -> None:
    library = fake_engine(tmp_path / "lib", ODD)
    report = doctor(**{variable: ".:lib:"})
    assert str(library) not in [engine["library"] for engine in report.content["engines"]]


@pytest.mark.parametrize("path", ["", ".", "bin"])
def test_a_python_below_a_relative_entry_of_the_path_is_not_run(
    doctor: Doctor, tmp_path: Path, path: str
) -> None:
    marker = tmp_path / "marker"
    for folder in (tmp_path, tmp_path / "bin"):
        write_python(folder, f"touch {marker}")
    report = doctor(PATH=f"{path}:{os.environ['PATH']}:{path}")
    assert not marker.exists()
    assert not [note for note in report.content["notes"] if "python3" in note]


@pytest.mark.parametrize("answer", ["girdle:packages/mujoco", "girdle:.", "packages/mujoco", ""])
def test_a_python_that_answers_no_whole_path_leads_to_nothing(
    doctor: Doctor, tmp_path: Path, answer: str
) -> None:
    fake_engine(tmp_path / "packages" / "mujoco", ODD)
    python = write_python(tmp_path / "bin", f"echo {answer}")
    report = doctor(PATH=f"{python.parent}:{os.environ['PATH']}")
    assert ODD not in [engine["version"] for engine in report.content["engines"]]
    problem = "asked for its package mujoco, gave another answer than a whole path"
    assert f"{python}, {problem}" in report.content["notes"]


def test_a_program_that_loads_no_mujoco_leads_to_nothing(lone_program: Path, tmp_path: Path) -> None:
    program = Path(shutil.copy(lone_program, tmp_path))
    compile_library(tmp_path / "libgirdle_simulation.so", "int unrelated;")
    fake_engine(tmp_path / "lib", ODD)
    report = report_of(run_doctor(program, tmp_path, "--json"))
    assert ODD not in [engine["version"] for engine in report.content["engines"]]
    problem = "loads no libmujoco.so by a whole path"
    assert f"this program cannot run MuJoCo: {problem}" in report.content["notes"]


@pytest.mark.parametrize("is_on_path", [False, True])
def test_a_python_reads_no_module_of_the_current_folder(
    doctor: Doctor, tmp_path: Path, is_on_path: bool
) -> None:
    """Not even where PYTHONPATH names the folder."""
    for name in ("contextlib", "importlib", "site", "mujoco", "sitecustomize"):
        (tmp_path / f"{name}.py").write_text(f"open('{tmp_path}/marker', 'w')\n")
    python = Path(sys.executable)
    variables = {"PYTHONPATH": str(tmp_path)} if is_on_path else {}
    report = doctor(PATH=f"{python.parent}:{os.environ['PATH']}", **variables)
    assert not (tmp_path / "marker").exists()
    mujoco_folder = str(Path(mujoco.__file__).parent)
    (found,) = [e for e in report.content["engines"] if str(python.parent / "python3") in e["found_by"]]
    assert found["library"].startswith(mujoco_folder)


# --- What is hostile ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("script", "problem"),
    [
        ("exit 3", "ended with status 3"),
        ("exec >&-; sleep 600", "did not end within 10 s"),
        ("exec yes /aaaaaaaaaaaaaaaaaaaaaaaa", "wrote more than 1 MB"),
        ("kill -9 $PPID; sleep 600", "was ended by a signal: Killed"),
    ],
)
def test_a_python_that_does_not_answer_is_told(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path, script: str, problem: str
) -> None:
    python = write_python(tmp_path / "bin", script)
    arguments = ("--engine", engine, "--plugin", plugin_library)
    report = doctor(*arguments, PATH=f"{python.parent}:{os.environ['PATH']}")
    assert report.code == 0
    assert f"{python}, asked for its package mujoco, {problem}" in report.content["notes"]


def test_a_python_that_cannot_be_run_is_told(doctor: Doctor, tmp_path: Path) -> None:
    python = write_python(tmp_path / "bin", "")
    python.write_text("#!/no/such/interpreter\n")
    report = doctor(PATH=f"{python.parent}:{os.environ['PATH']}")
    note = f"{python}, asked for its package mujoco, ended with status 127"
    assert note in report.content["notes"]


def test_nothing_that_a_python_leaves_behind_goes_on(doctor: Doctor, tmp_path: Path) -> None:
    script = f"(setsid sh -c 'sleep 2; touch {tmp_path}/marker' &); sleep 0.3"
    python = write_python(tmp_path / "bin", script)
    doctor(PATH=f"{python.parent}:{os.environ['PATH']}")
    time.sleep(3)
    assert not (tmp_path / "marker").exists()


@pytest.mark.parametrize(
    ("code", "problem"),
    [
        ("kill(getppid(), SIGKILL); pause();", "was ended by a signal: Killed"),
        ("for (;;) puts(__FILE__);", "wrote more than 1 MB"),
        ("_exit(0);", "ended the process that tried it"),
    ],
)
def test_a_library_that_is_hostile_harms_no_other(
    doctor: Doctor, engine: Path, plugin_library: Path, tmp_path: Path, code: str, problem: str
) -> None:
    code = (
        "#include <csignal>\n#include <cstdio>\n#include <unistd.h>\n"
        f"__attribute__((constructor)) static void attack() {{ {code} }}"
    )
    hostile = compile_library(tmp_path / "libmujoco.so.9.9.9", code)
    report = doctor("--only", "--engine", hostile, "--engine", engine, "--plugin", plugin_library)
    assert report.code == 0
    assert report.engine(hostile)["problem"] == problem
    assert not report.engine(hostile)["works"]
    assert report.engine(engine)["works"]


# --- Installing the plugin ------------------------------------------------------------------------


def test_it_installs_for_the_first_python_on_the_path(program: Path, package: Path, tmp_path: Path) -> None:
    first = write_python(tmp_path / "first", f"echo 'girdle:{package}'")
    second = write_python(tmp_path / "second", "echo girdle:/nowhere")
    finished = run_doctor(program, tmp_path, "--install", PATH=f"{first.parent}:{second.parent}")
    assert (finished.returncode, finished.stderr) == (0, "")
    assert installed(package).is_file()


def test_installing_again_says_that_it_is_there(girdle_fine: Girdle, package: Path) -> None:
    girdle_fine("doctor", "--install", "--engine", package)
    before = (installed(package).stat().st_ino, installed(package).stat().st_mtime_ns)
    text = girdle_fine("doctor", "--install", "--engine", package).text
    assert text.startswith(f"is there already: {installed(package)}\n")
    assert (installed(package).stat().st_ino, installed(package).stat().st_mtime_ns) == before


@pytest.mark.parametrize("is_link", [False, True])
def test_another_copy_is_told_and_replaced_by_the_line_that_the_report_gives(
    girdle_fine: Girdle, program: Path, plugin_library: Path, package: Path, tmp_path: Path,
    is_link: bool,
) -> None:  # fmt: skip
    """A link is replaced, not what it points to."""
    other = tmp_path / "other.so"
    other.write_bytes(plugin_library.read_bytes() + b"more")
    if is_link:
        installed(package).symlink_to(other)
    else:
        shutil.copy(other, installed(package))

    def diagnosed() -> dict[str, Any]:
        text = girdle_fine("doctor", "--json", "--only", "--engine", package).text
        (engine,) = json.loads(text)["engines"]
        return engine

    assert diagnosed()["works"]
    assert diagnosed()["installed"] == str(installed(package))
    assert diagnosed()["problem"] == "the plugin that `import mujoco` loads differs from this one"
    line = diagnosed()["fix"]
    assert line == f"{program} doctor --install --engine {package}"
    # As a person does it who types the line.
    done = subprocess.run(line, shell=True, capture_output=True, text=True, check=True)  # noqa: S602
    assert done.stdout.startswith(f"replaced {installed(package)}\n")
    assert diagnosed()["problem"] == diagnosed()["fix"] == ""
    assert not installed(package).is_symlink()
    assert other.read_bytes().endswith(b"more")


def test_where_only_the_installed_plugin_works_that_is_said(
    doctor: Doctor, girdle_fine: Girdle, package: Path, engine: Path
) -> None:
    girdle_fine("doctor", "--install", "--engine", package)
    report = doctor("--only", "--engine", package)
    (found,) = report.content["engines"]
    assert found["works"]
    assert found["problem"].endswith("not with this one: there is no plugin to try it with")


def test_what_it_installs_is_the_plugin_and_can_be_read_by_all(
    girdle_fine: Girdle, package: Path, plugin_library: Path
) -> None:
    text = girdle_fine("doctor", "--install", "--engine", package).text
    assert text.startswith(f"wrote {installed(package)}\nMuJoCo {mujoco.__version__} works with it")
    assert installed(package).read_bytes() == plugin_library.read_bytes()
    assert installed(package).stat().st_mode & 0o777 == 0o644


def test_uninstalling_leaves_the_package_as_it_was(girdle_fine: Girdle, package: Path) -> None:
    before = contents(package)
    girdle_fine("doctor", "--install", "--engine", package)
    assert contents(package) != before
    text = girdle_fine("doctor", "--uninstall", "--engine", package).text
    assert text == f"removed {installed(package)}\n"
    assert contents(package) == before
    text = girdle_fine("doctor", "--uninstall", "--engine", package).text
    assert text == f"is not there: {installed(package)}\n"


def test_a_plugin_that_does_not_work_is_not_installed(girdle: Girdle, package: Path, tmp_path: Path) -> None:
    broken = compile_library(tmp_path / "libgirdle_rhythm.so", "int unrelated;")
    before = contents(package)
    finished = girdle("doctor", "--install", "--engine", package, "--plugin", broken)
    expect_one_message(finished, "which is not installed: registers no plugin girdle.rhythm")
    assert contents(package) == before


@pytest.mark.parametrize("is_there", [False, True])
def test_a_plugin_that_does_not_work_where_it_would_be_is_not_installed(
    girdle: Girdle, plugin_library: Path, package: Path, tmp_path: Path, is_there: bool
) -> None:
    """What was there stays."""
    code = f"""
      #include <dlfcn.h>
      #include <cstring>
      __attribute__((constructor)) static void load() {{
        Dl_info own;
        dladdr(reinterpret_cast<void*>(load), &own);
        if (std::strstr(own.dli_fname, "{package}") == nullptr) {{
          dlopen("{plugin_library}", RTLD_NOW);
        }}
      }}
    """
    moody = compile_library(tmp_path / "libgirdle_rhythm.so", code)
    if is_there:
        shutil.copy(plugin_library, installed(package))
    before = contents(package)
    finished = girdle("doctor", "--install", "--engine", package, "--plugin", moody)
    expect_one_message(finished, "which is not installed: registers no plugin girdle.rhythm")
    assert contents(package) == before
    assert girdle("doctor", "--only", "--engine", package, "--plugin", moody).code == 0


# --- Bad input ------------------------------------------------------------------------------------


def test_an_engine_that_is_not_there_is_refused(refuses: Refuses) -> None:
    refuses("doctor", "--engine", "nowhere", because=("--engine nowhere: no such file or folder",))


@pytest.mark.parametrize("words", [(), ("--only",), ("--install",)])
def test_a_folder_without_an_engine_is_refused(
    refuses: Refuses, tmp_path: Path, words: tuple[str, ...]
) -> None:
    (tmp_path / "empty").mkdir()
    refuses("doctor", *words, "--engine", "empty", because=("--engine empty: holds no libmujoco.so",))


def test_a_plugin_that_is_not_there_is_refused(refuses: Refuses) -> None:
    refuses("doctor", "--plugin", "nowhere.so", because=("--plugin nowhere.so: no such plugin",))


def test_an_empty_engine_is_refused(girdle: Girdle) -> None:
    expect_one_message(girdle("doctor", "--engine", ""), "--engine '': is empty")


def test_a_folder_of_plugins_that_is_none_is_told(refuses: Refuses, package: Path) -> None:
    """Other rights would not help."""
    shutil.rmtree(package / "plugin")
    (package / "plugin").touch()
    cannot = f"{installed(package)}: cannot be"
    for words, failure in (("--install", "written"), ("--uninstall", "removed")):
        because = f"{cannot} {failure}: Not a directory\n"
        message = refuses("doctor", words, "--engine", package, because=(because,))
        assert "sudo" not in message


def test_a_folder_of_plugins_that_another_user_may_write_is_told_with_the_fix(
    refuses: Refuses, program: Path, package: Path
) -> None:
    """In /sys not even the superuser can make a file."""
    try:
        Path("/sys/kernel/libgirdle_rhythm.so").touch()
    except OSError as error:
        if error.errno not in (errno.EACCES, errno.EPERM):
            pytest.skip(f"there is no such /sys here: {error}")
    shutil.rmtree(package / "plugin")
    (package / "plugin").symlink_to("/sys/kernel")
    refuses(
        *("doctor", "--install", "--engine", package),
        because=(
            f"{installed(package)}: cannot be written: ",
            f"sudo {program} doctor --install --engine {package}",
            "virtual environment",
        ),
    )


def test_a_file_that_cannot_be_replaced_leaves_no_part_of_another(refuses: Refuses, package: Path) -> None:
    installed(package).mkdir()
    message = "cannot be written: Is a directory"
    refuses("doctor", "--install", "--engine", package, because=(message,))


def test_a_python_without_mujoco_is_told_what_to_type(program: Path, tmp_path: Path) -> None:
    python = write_python(tmp_path / "bin", "echo girdle:")
    finished = run_doctor(program, tmp_path, "--install", PATH=str(python.parent))
    assert finished.returncode == 2
    assert f"{python} has no package mujoco. Activate the environment that has it" in finished.stderr
    assert "python3 -m venv .venv && .venv/bin/pip install mujoco" in finished.stderr


def test_a_path_without_python_is_told(program: Path, tmp_path: Path) -> None:
    finished = run_doctor(program, tmp_path, "--install", PATH="/nowhere")
    assert finished.returncode == 2
    assert "no python3 on PATH" in finished.stderr


def test_a_library_outside_of_a_package_is_refused(refuses: Refuses, engine: Path, tmp_path: Path) -> None:
    library = tmp_path / "release" / "lib" / engine.name
    library.parent.mkdir(parents=True)
    shutil.copy(engine, library)
    refuses("doctor", "--install", "--engine", "release", because=("is not Python's package mujoco",))


@pytest.mark.parametrize("other", ["--uninstall", "--json", "--only", "--engine=. --engine=."])
def test_what_makes_no_sense_with_install_is_refused(refuses: Refuses, other: str) -> None:
    because = "--install and --uninstall: each goes with one --engine and --plugin alone"
    refuses("doctor", "--install", *other.split(), because=(because,))
