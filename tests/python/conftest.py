# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What these tests run: the program, the plugin and the model, each named by the environment.

A missing one fails the test. A skip would let a build without the plugin pass.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO
from xml.etree import ElementTree

import mujoco
import pytest
from reference_rhythm import DATABASE, Position, ReferenceRhythm, read_database
from shared_results import SharedResults

# Generous: the longest run simulates one second, which takes a fraction of that.
PROGRAM_TIMEOUT_S = 120

RunProgram = Callable[..., str]


def path_from_environment(variable: str, meaning: str, *, executable: bool = False) -> Path:
    value = os.environ.get(variable)
    if not value:
        pytest.fail(f"{variable} is not set. Set it to the path of {meaning}.", pytrace=False)
    path = Path(value).resolve()
    if not path.is_file():
        pytest.fail(f"{variable}={value} is not a file. It must be {meaning}.", pytrace=False)
    if executable and not os.access(path, os.X_OK):
        pytest.fail(f"{variable}={value} is not executable.", pytrace=False)
    return path


@pytest.fixture(scope="session")
def program() -> Path:
    return path_from_environment("GIRDLE_PROGRAM", "the girdle program", executable=True)


@pytest.fixture(scope="session")
def plugin_library() -> Path:
    return path_from_environment("GIRDLE_PLUGIN", "the engine plugin")


@pytest.fixture(scope="session")
def model_path() -> Path:
    return path_from_environment("GIRDLE_MODEL", "scene.xml of the right shoulder")


@pytest.fixture(scope="session")
def run_program(program: Path) -> RunProgram:
    """Runs the program with these arguments; returns what it printed, fails where it failed."""

    def run(*arguments: str | Path) -> str:
        command = [str(program), *map(str, arguments)]
        finished = subprocess.run(
            command, capture_output=True, text=True, timeout=PROGRAM_TIMEOUT_S, check=False
        )
        if finished.returncode != 0:
            pytest.fail(
                f"exit code {finished.returncode} from: {' '.join(command)}\n"
                f"stdout: {finished.stdout}\nstderr: {finished.stderr}",
                pytrace=False,
            )
        return finished.stdout

    return run


@pytest.fixture(scope="session")
def database() -> list[Position]:
    if not DATABASE.is_file():
        pytest.fail(f"the measured table is missing: {DATABASE}", pytrace=False)
    return read_database()


@pytest.fixture(scope="session")
def reference(database: list[Position]) -> ReferenceRhythm:
    return ReferenceRhythm(database)


# --- The program as a person types it ------------------------------------------------------------

ABOVE_TOLERANCE = 1
REFUSED = 2


@dataclass(frozen=True)
class Finished:
    """What one run of the program gave: its exit code and what it wrote to both streams."""

    command: str
    code: int
    output: bytes
    message: str

    @property
    def text(self) -> str:
        return self.output.decode()


Girdle = Callable[..., Finished]
Refuses = Callable[..., str]


@pytest.fixture
def girdle(program: Path, tmp_path: Path) -> Girdle:
    """Runs the program in the test's own folder, whatever comes of it."""

    def run(
        *arguments: str | Path, stdin: bytes = b"", stdout: IO[bytes] | int = subprocess.PIPE
    ) -> Finished:
        command = [str(program), *map(str, arguments)]
        finished = subprocess.run(
            command,
            input=stdin,
            stdout=stdout,
            stderr=subprocess.PIPE,
            cwd=tmp_path,
            timeout=PROGRAM_TIMEOUT_S,
            check=False,
        )
        message = finished.stderr.decode(errors="replace")
        return Finished(" ".join(command), finished.returncode, finished.stdout or b"", message)

    return run


# For tests that compare more closely than the six decimals that `solve` writes by itself.
TWELVE_DIGITS = ("--digits", "12")

# What standard error says after a file of commands, and of each file that was written.
TALLY = re.compile(
    r"(girdle: .+: \d+ (row|simulated state)s?, \d+ clamped( \(.+\))?(, \d+ derived)?"
    r", \d+ modelled( \(.+\))?(, \d+ gaps?)?(, \d+ bridged)?(, axial from (rhythm|isb|swing))?"
    r"(, relative to hanging \((measured|derived|modelled)\))?\n"
    r"|girdle: .+: read '.+\n"
    r"|girdle: wrote [^\n:]+(: \d+ (row|frame|position)s?)?\n)+"
)


@pytest.fixture
def girdle_fine(girdle: Girdle) -> Girdle:
    """As `girdle`, for runs that must go well: exit code 0, and standard error has only notes."""

    def run(*arguments: str | Path, stdin: bytes = b"") -> Finished:
        finished = girdle(*arguments, stdin=stdin)
        assert finished.code == 0, (finished.command, finished.message)
        assert not finished.message or TALLY.fullmatch(finished.message), finished.command
        return finished

    return run


def contents(folder: Path) -> dict[str, str]:
    """Everything below a folder: the hash of each file by its path."""
    return {
        str(path.relative_to(folder)): (
            hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "not a file"
        )
        for path in folder.rglob("*")
    }


def expect_one_message(finished: Finished, *patterns: str) -> None:
    """Exit code 2 (a crash has another) and one message, which holds what each pattern finds."""
    assert finished.code == REFUSED, f"{finished.command}\n{finished.message}"
    assert finished.message.endswith("\n")
    starts = [line.startswith("girdle: ") for line in finished.message.splitlines()]
    assert starts[0], finished.message
    assert starts.count(True) == 1, finished.message
    for pattern in patterns:
        assert re.search(pattern, finished.message), f"no {pattern!r} in: {finished.message}"


@pytest.fixture
def refuses(girdle: Girdle, tmp_path: Path) -> Refuses:
    """Runs the program, which must refuse, print no result and leave its folder as it was."""

    def run(*arguments: str | Path, because: tuple[str, ...], stdin: bytes = b"") -> str:
        before = contents(tmp_path)
        finished = girdle(*arguments, stdin=stdin)
        expect_one_message(finished, *because)
        assert finished.output == b"", finished.command
        assert contents(tmp_path) == before, finished.command
        return finished.message

    return run


# --- Python's package mujoco ----------------------------------------------------------------------


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Python's package mujoco with a folder of plugins of its own; all else are links."""
    real = Path(mujoco.__file__).parent
    copy = tmp_path / "packages" / "mujoco"
    copy.mkdir(parents=True)
    for each in real.iterdir():
        if each.name != "plugin":
            (copy / each.name).symlink_to(each)
    ours = shutil.ignore_patterns("libgirdle_rhythm.so")
    shutil.copytree(real / "plugin", copy / "plugin", ignore=ours)
    return copy


def installed(package: Path) -> Path:
    """Where the plugin is put that `import mujoco` loads by itself."""
    return package / "plugin" / "libgirdle_rhythm.so"


# --- Models with a change ------------------------------------------------------------------------

MODEL_FILE = "shoulder_right.xml"
SCENE_FILE = "scene.xml"

# Stands for the scene of the generated model in a command.
SCENE = "SCENE"

Edit = Callable[[ElementTree.Element], None]
WriteModel = Callable[..., Path]


@pytest.fixture(scope="session")
def shared(program: Path) -> SharedResults:
    """Models and reports that other files of tests want as well, each made once in a build."""
    build = os.environ.get("GIRDLE_BUILD_DIR")
    if not build:
        pytest.fail("GIRDLE_BUILD_DIR is not set. Set it to the folder of the build.", pytrace=False)
    return SharedResults(program, Path(build), PROGRAM_TIMEOUT_S)


@pytest.fixture(scope="session")
def generated(shared: SharedResults) -> Path:
    """The folder of the default model, which no test writes to."""
    return shared.generate().folder


def with_scene(command: tuple[str, ...], folder: Path) -> list[str]:
    return [str(folder / SCENE_FILE) if word == SCENE else word for word in command]


@pytest.fixture
def write_model(generated: Path, tmp_path: Path) -> WriteModel:
    """Writes the generated model with these edits into the test's folder; returns its scene."""

    def write(*edits: Edit) -> Path:
        tree = ElementTree.parse(generated / MODEL_FILE)
        for edit in edits:
            before = ElementTree.tostring(tree.getroot())
            edit(tree.getroot())
            assert ElementTree.tostring(tree.getroot()) != before, "the edit changes nothing"
        tree.write(tmp_path / MODEL_FILE)
        scene = tmp_path / SCENE_FILE
        scene.write_bytes((generated / SCENE_FILE).read_bytes())
        return scene

    return write


def find_element(root: ElementTree.Element, path: str) -> ElementTree.Element:
    """The one element at a path such as `.//site[@name='TS_r']`."""
    (element,) = root.findall(path)
    return element


def remove_element(root: ElementTree.Element, path: str) -> None:
    find_element(root, path + "/..").remove(find_element(root, path))


@pytest.fixture(scope="session")
def engine_with_plugin(plugin_library: Path) -> None:
    """The process's MuJoCo knows the plugin."""
    mujoco.mj_loadPluginLibrary(str(plugin_library))


@pytest.fixture
def no_warning(engine_with_plugin: None) -> Iterator[None]:
    """Any warning of the engine fails the test that it was raised in."""
    messages: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(messages.append)
    yield
    mujoco.set_mju_user_warning(before)
    assert not messages
