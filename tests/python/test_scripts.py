# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the scripts say where a machine or a checkout is not as they expect it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
TIMEOUT_S = 60

PRESETS = """{"version": 6, "configurePresets": [
  {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"}]}"""

# Takes every command for good, as far as scripts/setup looks.
PYTHON = """#!/bin/sh
case "$*" in
  "-m venv "*) mkdir -p "$3/bin" && cp "$0" "$3/bin/python" && cp "${0%/*}/npm" "$3/bin" ;;
  *" --target "*) for folder; do :; done; mkdir -p "$folder" ;;
esac
"""


def run(*command: str | Path, path: Path | None = None, **more: str) -> subprocess.CompletedProcess[str]:
    """Runs a command with `path` first in PATH."""
    environment = {**os.environ, **more}
    if path is not None:
        environment["PATH"] = f"{path}:{environment['PATH']}"
    return subprocess.run(
        command, capture_output=True, text=True, timeout=TIMEOUT_S, check=False, env=environment
    )


def write_program(file: Path, text: str) -> None:
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A checkout with nothing to build."""
    folder = tmp_path / "checkout"
    shutil.copytree(SCRIPTS, folder / "scripts")
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25...3.31)\nproject(Nothing LANGUAGES NONE)\n"
    )
    (folder / "CMakePresets.json").write_text(PRESETS)
    return folder


@pytest.fixture
def old_cmake(tmp_path: Path) -> Path:
    """A folder with a cmake that is too old."""
    write_program(tmp_path / "old" / "cmake", "#!/bin/sh\necho cmake version 3.9.1\n")
    return tmp_path / "old"


def test_an_old_cmake_is_passed_over_and_named(checkout: Path, old_cmake: Path) -> None:
    finished = run(checkout / "scripts" / "configure", path=old_cmake)
    assert finished.returncode == 0, finished.stderr
    assert f"{old_cmake}/cmake is CMake 3.9.1, and 3.25 or newer is needed" in finished.stderr
    taken = finished.stdout.strip()
    assert f"taking {taken} (" in finished.stderr
    assert Path(taken).is_file()
    assert Path(taken).parent != old_cmake


def test_setup_without_a_new_enough_cmake_is_refused(checkout: Path, old_cmake: Path) -> None:
    top = checkout / "CMakeLists.txt"
    top.write_text(top.read_text().replace("3.25...3.31", "99.1...99.2"))
    finished = run(checkout / "scripts" / "setup", path=old_cmake, GIRDLE_SKIP_PACKAGES="1")
    assert finished.returncode == 2
    assert f"{old_cmake}/cmake is CMake 3.9.1, and 99.1 or newer is needed" in finished.stderr
    assert "pip install 'cmake>=99.1'" in finished.stderr
    assert not (checkout / "build").exists()


def test_a_build_copied_with_its_checkout_is_configured_afresh(checkout: Path, tmp_path: Path) -> None:
    first = run(checkout / "scripts" / "configure", "release")
    assert (first.returncode, first.stderr) == (0, "")
    copied = tmp_path / "copied"
    shutil.copytree(checkout, copied)
    second = run(copied / "scripts" / "configure", "release")
    assert second.returncode == 0, second.stderr
    assert f"build/release was made for the checkout in {checkout}: configuring it afresh" in second.stderr
    cache = (copied / "build" / "release" / "CMakeCache.txt").read_text()
    assert f"CMAKE_HOME_DIRECTORY:INTERNAL={copied}\n" in cache
    third = run(copied / "scripts" / "configure", "release")
    assert (third.returncode, third.stderr) == (0, "")


@pytest.mark.parametrize(
    ("code", "is_about_certificates"),
    [("SELF_SIGNED_CERT_IN_CHAIN", True), ("UNABLE_TO_VERIFY_LEAF_SIGNATURE", True), ("ENOTFOUND", False)],
)
def test_a_certificate_that_node_does_not_trust_is_named(
    checkout: Path, tmp_path: Path, code: str, is_about_certificates: bool
) -> None:
    programs = tmp_path / "programs"
    write_program(programs / "python3", PYTHON)
    says_bundle = 'echo "bundle: $NODE_EXTRA_CA_CERTS" >&2'
    npm = f"#!/bin/sh\necho npm error code {code} >&2\n{says_bundle}\nexit 1\n"
    write_program(programs / "npm", npm)
    header = tmp_path / "include" / "mujoco" / "mujoco.h"
    header.parent.mkdir(parents=True)
    header.touch()
    finished = run(
        checkout / "scripts" / "setup",
        "--python",
        path=programs,
        GIRDLE_SKIP_PACKAGES="1",
        MUJOCO_ROOT=str(tmp_path),
        NODE_EXTRA_CA_CERTS="",
    )
    assert finished.returncode == 1
    # What the system trusts, if setup finds it.
    system = Path("/etc/ssl/certs/ca-certificates.crt")
    assert f"bundle: {system if system.is_file() else ''}\n" in finished.stderr
    assert f"npm error code {code}" in finished.stderr
    assert ("NODE_EXTRA_CA_CERTS" in finished.stderr) == is_about_certificates
    assert not (checkout / "build" / "node" / ".stamp").exists()


def test_a_mujoco_root_without_headers_is_refused(checkout: Path, tmp_path: Path) -> None:
    setup = checkout / "scripts" / "setup"
    finished = run(setup, GIRDLE_SKIP_PACKAGES="1", MUJOCO_ROOT=str(tmp_path))
    assert finished.returncode == 2
    assert f"MUJOCO_ROOT is {tmp_path}, and there is no include/mujoco/mujoco.h" in finished.stderr


@pytest.mark.parametrize("script", ["configure", "figures", "fresh", "fuzz", "run", "seeds", "setup", "test"])
def test_help_is_all_that_help_does(checkout: Path, script: str) -> None:
    finished = run(checkout / "scripts" / script, "--help")
    assert (finished.returncode, finished.stderr) == (0, "")
    assert finished.stdout.startswith(f"Usage: scripts/{script}")
    assert not (checkout / "build").exists()


@pytest.mark.parametrize("script", ["configure", "figures", "fresh", "fuzz", "run", "seeds", "setup"])
def test_an_unknown_argument_is_refused_before_anything_is_done(checkout: Path, script: str) -> None:
    finished = run(checkout / "scripts" / script, "--unknown")
    assert finished.returncode == 2
    assert "--unknown" in finished.stderr.splitlines()[-1]
    assert finished.stdout == ""
    assert not (checkout / "build").exists()


FUZZ_PRESETS = """{"version": 6,
  "configurePresets": [
    {"name": "fuzz", "generator": "Ninja", "binaryDir": "${sourceDir}/build/fuzz"}],
  "buildPresets": [{"name": "fuzz", "configurePreset": "fuzz"}]}"""

# A fuzzer that finds nothing, and one that keeps the input it was given last.
CALM = """#!/bin/sh
printf '%s\\n' "$*" >&2
echo 'stat::number_of_executed_units: 1234'
"""
ALARMED = """#!/bin/sh
for word; do case $word in -artifact_prefix=*) prefix=${word#*=} ;; esac; done
echo 'finding: an exception other than InputError: stoi'
echo smallest >"${prefix}crash-0123"
echo 'stat::number_of_executed_units: 56'
exit 77
"""


@pytest.fixture
def fuzzed(checkout: Path, tmp_path: Path) -> Path:
    """A checkout with a compiler that has libFuzzer, and two fuzzers that are built already."""
    (checkout / "CMakePresets.json").write_text(FUZZ_PRESETS)
    (checkout / "tests" / "fuzz").mkdir(parents=True)
    built = checkout / "build" / "fuzz" / "tests" / "fuzz"
    built.mkdir(parents=True)
    for name, text in (("calm", CALM), ("alarmed", ALARMED)):
        (checkout / "tests" / "fuzz" / f"fuzz_{name}.cc").touch()
        write_program(built / f"fuzz_{name}", text)
    write_program(tmp_path / "clang" / "clang++", "#!/bin/sh\n")
    return checkout


def test_fuzzers_without_a_finding_are_counted(fuzzed: Path, tmp_path: Path) -> None:
    finished = run(fuzzed / "scripts" / "fuzz", "--seconds", "7", "calm", path=tmp_path / "clang")
    assert (finished.returncode, finished.stderr) == (0, "")
    header, row = (line.split() for line in finished.stdout.splitlines())
    assert header == ["target", "inputs", "seconds", "findings"]
    assert (row[:2], row[3]) == (["calm", "1234"], "0")
    assert not (fuzzed / "build" / "fuzz" / "findings").exists()


def test_the_input_of_a_finding_is_kept_and_named(fuzzed: Path, tmp_path: Path) -> None:
    finished = run(fuzzed / "scripts" / "fuzz", path=tmp_path / "clang")
    assert finished.returncode == 1
    rows = sorted(line.split() for line in finished.stdout.splitlines()[1:])
    assert [(row[0], row[1], row[3]) for row in rows] == [("alarmed", "56", "1"), ("calm", "1234", "0")]
    kept = "build/fuzz/findings/alarmed-crash-0123"
    assert (fuzzed / kept).read_text() == "smallest\n"
    assert f"{kept}, and {kept}.words:\nfinding: an exception other than InputError: stoi" in finished.stderr
    assert "an exception" in (fuzzed / f"{kept}.words").read_text()


def test_a_fuzzer_that_is_not_there_is_refused_with_those_that_are(fuzzed: Path, tmp_path: Path) -> None:
    finished = run(fuzzed / "scripts" / "fuzz", "clam", path=tmp_path / "clang")
    assert (finished.returncode, finished.stdout) == (2, "")
    assert "there is no fuzzer 'clam'. Choose among: alarmed calm" in finished.stderr


@pytest.mark.parametrize("seconds", ["0", "1.5", "-3", "ten", ""])
def test_fuzzing_for_other_than_whole_seconds_is_refused(fuzzed: Path, tmp_path: Path, seconds: str) -> None:
    finished = run(fuzzed / "scripts" / "fuzz", "--seconds", seconds, path=tmp_path / "clang")
    assert (finished.returncode, finished.stdout) == (2, "")
    assert f"--seconds needs a whole number of seconds, at least 1, and not '{seconds}'" in finished.stderr


def test_fuzzing_without_libfuzzer_names_what_installs_it(fuzzed: Path, tmp_path: Path) -> None:
    write_program(tmp_path / "clang" / "clang++", "#!/bin/sh\necho cannot find libclang_rt >&2\nexit 1\n")
    finished = run(fuzzed / "scripts" / "fuzz", path=tmp_path / "clang")
    assert (finished.returncode, finished.stdout) == (2, "")
    assert "cannot find libclang_rt" in finished.stderr
    assert "apt-get install clang libclang-rt-dev" in finished.stderr


@pytest.fixture
def rooms(tmp_path: Path) -> Path:
    """Two rooms, of which `below` uses `above`."""
    for room, text in (("above", ""), ("below", '#include "above/a.h"\n')):
        (tmp_path / room).mkdir()
        (tmp_path / room / f"{room[0]}.h").write_text(text)
    (tmp_path / "README.md").write_text(
        "| room | what it holds | uses |\n|---|---|---|\n| `above` | a | |\n| `below` | b | `above` |\n"
    )
    return tmp_path


def check_rooms(folder: Path) -> subprocess.CompletedProcess[str]:
    return run(SCRIPTS / "check_rooms", folder)


def test_rooms_that_use_each_other_as_their_table_says_pass(rooms: Path) -> None:
    checked = check_rooms(rooms)
    assert (checked.returncode, checked.stdout) == (0, "")


def test_an_include_that_runs_up_is_named_with_its_line(rooms: Path) -> None:
    (rooms / "above" / "c.cc").write_text('#include "above/a.h"\n#include "below/b.h"\n')
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert checked.stdout == f"{rooms}/above/c.cc:2: `above` does not use `below` (README.md)\n"


@pytest.mark.parametrize(
    ("source", "spelled", "fault"),
    [
        ("above/c.cc", "<below/b.h>", "`above` does not use `below` (README.md)"),
        ("above/c.cc", '"../below/b.h"', "`above` does not use `below` (README.md)"),
        ("above/c.cc", "<girdle/below/b.h>", "`above` does not use `below` (README.md)"),
        ("below/c.cc", "<above/a.h>", '<above/a.h> is written "above/a.h" here'),
        ("below/c.cc", '"../above/a.h"', '"../above/a.h" is written "above/a.h" here'),
        ("below/c.cc", '"above//a.h"', '"above//a.h" is written "above/a.h" here'),
        ("below/c.cc", "<girdle/above/a.h>", '<girdle/above/a.h> is written "above/a.h" here'),
        ("below/c.cc", '"b.h"', '"b.h" is written "below/b.h" here'),
        ("below/c.cc", '"girdle.h"', "girdle.h is for other projects"),
        ("below/c.cc", "<girdle/girdle.h>", "girdle.h is for other projects"),
        ("below/c.cc", '"above/none.h"', 'there is no "above/none.h"; a library\'s is in <>'),
        ("below/c.cc", "A_HEADER", "`A_HEADER` names no file that can be read here"),
        ("above/a.h", "<girdle/above/c.h>", "is public (girdle.h), and above/c.h is not installed with it"),
    ],
)
@pytest.mark.parametrize("begin", ["#include ", "#include", " # include "], ids=repr)
def test_an_include_in_another_form_is_named(
    rooms: Path, source: str, spelled: str, fault: str, begin: str
) -> None:
    (rooms / "girdle.h").write_text('#include "above/a.h"\n')
    show_public_headers(rooms, "| `above/a.h` | a |")
    (rooms / "above" / "c.h").touch()
    assert check_rooms(rooms).returncode == 0
    if begin == "#include" and spelled[0] not in '"<':
        begin += " "
    (rooms / source).write_text(f"#include <vector>\n{begin}{spelled}  // why\n")
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert checked.stdout.replace("  // why", "") == f"{rooms}/{source}:2: {fault}\n"


def show_public_headers(folder: Path, *rows: str) -> None:
    with (folder / "README.md").open("a") as readme:
        readme.write("\n".join(["\n| header | what for |", "|---|---|", *rows, ""]))


def test_the_table_of_public_headers_is_that_of_girdle_h(rooms: Path) -> None:
    (rooms / "girdle.h").write_text('#include "above/a.h"\n')
    (rooms / "above" / "c.h").touch()
    show_public_headers(rooms, "| `above/c.h` | c |")
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert checked.stdout == (
        f"{rooms}/README.md: shows no public header above/a.h\n"
        f"{rooms}/README.md: above/c.h is not in girdle.h\n"
    )
    (rooms / "girdle.h").write_text('#include "above/a.h"\n#include "above/c.h"\n')
    show_public_headers(rooms, "| `above/a.h` `above/c.h` | both |")
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert checked.stdout == f"{rooms}/README.md: shows above/c.h twice\n"


def test_a_public_header_that_includes_one_that_is_not_is_named(rooms: Path) -> None:
    umbrella = rooms / "girdle.h"
    umbrella.write_text('#include "below/b.h"\n')
    show_public_headers(rooms, "| `below/b.h` | b |")
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert (
        checked.stdout
        == f"{rooms}/below/b.h:1: is public (girdle.h), and above/a.h is not installed with it\n"
    )
    umbrella.write_text('#include "above/a.h"\n#include "below/b.h"\n')
    show_public_headers(rooms, "| `above/a.h` | a |")
    assert check_rooms(rooms).returncode == 0


def test_a_room_that_is_not_in_the_table_is_named(rooms: Path) -> None:
    (rooms / "new").mkdir()
    checked = check_rooms(rooms)
    assert checked.returncode == 1
    assert checked.stdout == f"{rooms}/new: is not in the table of README.md\n"


def test_a_table_whose_rooms_use_rooms_below_them_is_refused(rooms: Path) -> None:
    table = rooms / "README.md"
    table.write_text(table.read_text().replace("| a | |", "| a | `below` |"))
    checked = check_rooms(rooms)
    assert checked.returncode == 2
    assert f"{table}:3: `below` does not stand above what uses it" in checked.stderr


# Stands for scripts/configure and the cmake that it names: says how sources are compiled, which is
# to write their names into a file.
CONFIGURE = """#!/usr/bin/env python3
import json, os, sys
from pathlib import Path
folder = Path(sys.argv[0]).resolve().parents[3]
alone = folder / "build" / "lint-single"
together = folder / "build" / "lint"
unit = together / "Unity" / "unit_0.cc"
for place in (alone, unit.parent):
    place.mkdir(parents=True, exist_ok=True)
def write(build, *files):
    entries = [
        {"directory": str(build), "command": f"echo >>{folder}/build/compiled -o x", "file": str(file)}
        for file in files
    ]
    (build / "compile_commands.json").write_text(json.dumps(entries, indent=1))
sources = [folder / name for name in os.environ["SOURCES"].split()]
unit.write_text("".join(f'#include "{source}"\\n' for source in sorted(folder.glob("generator/*/*.cc"))))
write(together, unit)
made = [alone / "generator" / "a_verify_interface_header_sets" / "a.h.cxx", alone / "generator" / "made.cc"]
write(alone, *made, *sources)
print(sys.argv[0])
"""
LINTED = "generator/above/a.cc generator/above/b.cc"


@pytest.fixture
def linted(checkout: Path, tmp_path: Path) -> Path:
    """A checkout, in a folder named build, in which lint finds nothing; tools find nothing anyway."""
    folder = tmp_path / "build" / "checkout"
    folder.parent.mkdir()
    checkout.rename(folder)
    tools = folder / "build" / "python" / "bin"
    tools.mkdir(parents=True)
    for tool in ("clang-tidy", "ruff", "mypy", "clang-format", "shellcheck"):
        write_program(tools / tool, "#!/bin/sh\n")
    (tools / "python").symlink_to(sys.executable)
    write_program(tools / "configure", CONFIGURE)
    write_program(folder / "scripts" / "configure", f"#!/bin/sh\nexec {tools}/configure\n")
    (folder / ".gitignore").write_text("/build/\n__pycache__/\n")
    shutil.copy(SCRIPTS.parent / "pyproject.toml", folder)
    for source in LINTED.split():
        (folder / source).parent.mkdir(parents=True, exist_ok=True)
        (folder / source).touch()
    (folder / "generator" / "README.md").write_text("| `above` | a | |\n")
    run("git", "init", "-q", folder)
    return folder


def lint(folder: Path, *, sources: str = LINTED, programs: Path | None = None) -> tuple[int, str]:
    """How lint ends, and what it finds."""
    tools = folder / "build" / "python" / "bin"
    path = tools if programs is None else Path(f"{programs}:{tools}")
    finished = run(folder / "scripts" / "lint", path=path, SOURCES=sources)
    return finished.returncode, finished.stderr.replace("lint: failed; see above\n", "")


def test_lint_compiles_each_source_below_a_folder_named_build(linted: Path) -> None:
    assert lint(linted) == (0, "")
    compiled = (linted / "build" / "compiled").read_text()
    assert f" {linted}/generator/above/b.cc\n" in compiled
    assert "/a.h.cxx\n" in compiled
    assert "made.cc" not in compiled


def test_lint_that_compiles_no_source_fails(linted: Path) -> None:
    assert lint(linted, sources="") == (1, "lint: CMake compiles no source of generator/\n")


@pytest.mark.parametrize("is_tracked", [False, True])
def test_lint_finds_what_a_merge_left(linted: Path, is_tracked: bool) -> None:
    (linted / "notes.md").write_text("a\n<<<<<<< HEAD\n")
    if is_tracked:
        assert run("git", "-C", linted, "add", "notes.md").returncode == 0
    left = "notes.md:2:<<<<<<< HEAD\nlint: a merge left its marks; see above\n"
    assert lint(linted) == (1, left)


def test_lint_fails_where_git_cannot_look_for_what_a_merge_left(linted: Path, tmp_path: Path) -> None:
    git = f'#!/bin/sh\n[ "$1" = grep ] && exit 128\nexec {shutil.which("git")} "$@"\n'
    write_program(tmp_path / "programs" / "git", git)
    found = lint(linted, programs=tmp_path / "programs")
    assert found == (1, "lint: git cannot look for what a merge left\n")


@pytest.mark.parametrize(
    ("name", "first_line"),
    [("scripts/new", "#!/usr/bin/env python3"), ("new", "#!/usr/bin/python3 -I")],
)
def test_lint_finds_python_without_suffix_that_its_tools_do_not_see(
    linted: Path, name: str, first_line: str
) -> None:
    (linted / name).parent.mkdir(exist_ok=True)
    (linted / name).write_text(f"{first_line}\n")
    assert lint(linted) == (
        1,
        f"lint: ruff does not see {name}: add it to its extend-include in pyproject.toml\n"
        f"lint: mypy does not see {name}: add it to its files in pyproject.toml\n",
    )
    settings = linted / "pyproject.toml"
    listed = '"scripts/check_rooms", '
    assert settings.read_text().count(listed) == 2
    settings.write_text(settings.read_text().replace(listed, f'{listed}"{name}", '))
    assert lint(linted) == (0, "")


def test_lint_finds_python_that_mypy_does_not_see(linted: Path) -> None:
    (linted / "new.py").touch()
    assert lint(linted) == (
        1,
        "lint: mypy does not see new.py: add it to its files in pyproject.toml\n",
    )
