# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the README tells a reader to type works: its Python, its C++ and its command lines."""

from __future__ import annotations

import json
import math
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import TALLY
from shared_results import SharedResults

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


# What a reader types or saves, in its order: the language and the text of each block.
BLOCKS: list[tuple[str, str]] = re.findall(r"```(sh|python|cpp)\n(.*?)```", README, flags=re.DOTALL)


def block(language: str, word: str) -> str:
    """The one block that has this word."""
    (found,) = (text for kind, text in BLOCKS if kind == language and word in text)
    return found


def run(*command: str | Path, folder: Path) -> str:
    finished = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, check=False, timeout=120
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr
    assert not finished.stderr or TALLY.fullmatch(finished.stderr)
    return finished.stdout


@pytest.fixture(scope="module")
def emitted_model(shared: SharedResults) -> Path:
    """What scripts/run leaves in build/model."""
    return shared.generate("--skin", "implicit").folder


@pytest.fixture
def checkout(tmp_path: Path, program: Path, plugin_library: Path, emitted_model: Path) -> Path:
    """A folder in which the README's paths lead to what is tested."""
    release = tmp_path / "build" / "release"
    release.mkdir(parents=True)
    (release / plugin_library.name).symlink_to(plugin_library)
    (release / "girdle").symlink_to(program)
    (tmp_path / "build" / "engine").symlink_to(ROOT / "build" / "engine")
    for folder in ("data", "model"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    (tmp_path / "build" / "body").symlink_to(ROOT / "build" / "body")
    shutil.copytree(emitted_model, tmp_path / "build" / "model")
    return tmp_path


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+\.\d*(?:e[-+]\d+)?", text)]


def test_the_python_of_the_readme_raises_the_arm(checkout: Path) -> None:
    upward_rotation, elevation, plane = numbers(
        run(sys.executable, "-c", block("python", "ac_upward_rotation_r"), folder=checkout)
    )
    assert upward_rotation < -0.2  # upward rotation is negative
    assert elevation == pytest.approx(1.57, abs=1e-6)
    assert plane == pytest.approx(0.70, abs=1e-6)


def test_the_python_of_the_readme_attaches_the_shoulder(checkout: Path) -> None:
    attach = block("python", '"her_"')
    elevation, plane = numbers(run(sys.executable, "-c", attach, folder=checkout))
    assert elevation == pytest.approx(1.57, abs=1e-6)
    assert plane == pytest.approx(0, abs=1e-6)


def test_the_python_of_the_readme_puts_two_shoulders_on_a_torso(checkout: Path) -> None:
    attach = block("python", "torso")
    right, left = numbers(run(sys.executable, "-c", attach, folder=checkout))
    assert right == pytest.approx(1.57, abs=1e-6)
    assert left == pytest.approx(0.52, abs=1e-6)


def run_shell(text: str, folder: Path) -> str:
    """In a shell that has begun as the README says."""
    return run("bash", "-ec", f"export PATH=$PWD/build/release:$PATH\n{text}", folder=folder)


def test_the_readme_makes_every_kind_of_model(checkout: Path) -> None:
    run_shell(block("sh", "--assembly loop"), checkout)
    models = sorted(path.name for path in (checkout / "my_model").glob("shoulder_*"))
    assert models == ["shoulder_both.xml", "shoulder_left_position.xml", "shoulder_right.xml"]


# The motion ends at rest, where joints lag least.
ARRIVED_DEG = 1.0


def test_the_controls_of_the_readme_move_the_model_without_plugin(
    checkout: Path, program: Path
) -> None:
    run_shell(block("sh", "--out-controls"), checkout)
    play = block("python", "raise_controls.csv")
    (elevation_rad,) = numbers(run(sys.executable, "-c", play, folder=checkout))
    target = run(program, "solve", "--elevation", "120", "--plane", "40", "--json", folder=checkout)
    elevation_deg = json.loads(target)["angles_deg"]["gh_elevation"]
    assert math.degrees(elevation_rad) == pytest.approx(elevation_deg, abs=ARRIVED_DEG)


def test_the_c_plus_plus_of_the_readme_raises_the_arm(checkout: Path) -> None:
    (checkout / "arm.cc").write_text(block("cpp", "main"), encoding="utf-8")
    printed = run("bash", "-ec", block("sh", "g++"), folder=checkout)
    assert re.fullmatch(r"-0\.2\d+ rad\n", printed)


def readme_commands() -> list[str]:
    return re.findall(r"^\| `(girdle [^`]*)` \|", README, flags=re.MULTILINE)


def test_the_readme_shows_every_verb() -> None:
    assert {line.split()[1] for line in readme_commands()} == {
        "solve",
        "generate",
        "simulate",
        "render",
        "verify",
        "smooth-table",
        "thorax",
        "doctor",
        "compare",
        "smoothness",
    }


@pytest.mark.parametrize("line", readme_commands())
def test_a_command_line_of_the_readme_works(line: str, checkout: Path) -> None:
    run_shell(block("sh", "poses.csv") + line, checkout)


# Lines that download, and Python that needs a screen or what one of these lines downloads.
NOT_TYPED_HERE = (
    "scripts/run",
    "scripts/test",
    "python3 -m venv .venv && . .venv/bin/activate",
    "pip install mujoco",
    "scripts/fetch_body",
    "python3 -m venv .myo && .myo/bin/pip install myo-sim==0.2.4 mujoco==3.17.0",
)
NOT_RUN_HERE = ("launch_passive", "myo_sim")


def test_the_readme_can_be_typed_from_top_to_bottom(checkout: Path) -> None:
    """In one shell, in order: each line finds what the lines before it left."""
    typed: list[str] = []
    left_out: list[str] = []
    for number, (language, text) in enumerate(BLOCKS):
        if language == "sh":
            for line in text.splitlines():
                command = re.sub(r" +# .*", "", line)
                (left_out if command in NOT_TYPED_HERE else typed).append(command)
        elif language == "cpp":
            (checkout / "arm.cc").write_text(text, encoding="utf-8")
        elif not any(word in text for word in NOT_RUN_HERE):
            (checkout / f"{number}.py").write_text(text, encoding="utf-8")
            typed.append(f"{shlex.quote(sys.executable)} {number}.py")
    assert tuple(left_out) == NOT_TYPED_HERE
    assert len(typed) > 15
    run("bash", "-ec", "\n".join(typed), folder=checkout)


TINY = re.compile(r"[0-9.]+e-(?:0[89]|1[0-9])|0\.000[0-9]+|0")


def without_rounding(line: str) -> tuple[str, ...]:
    """Columns of a report's line without those that rounding makes: `where`, and a tiny value."""
    columns = re.split(" {2,}", line)
    if len(columns) != 7:
        return tuple(columns)
    group, item, value, tolerance, unit, result, _ = columns
    return (group, item, "tiny" if TINY.fullmatch(value) else value, tolerance, unit, result)


def test_the_report_of_the_readme_has_the_lines_of_the_program(
    checkout: Path, program: Path
) -> None:
    """Values that rounding makes, of skin in single precision, may differ from machine to machine;
    everything else is the same."""
    printed = run(program, "verify", "build/model/scene.xml", folder=checkout)
    kept = {without_rounding(line) for line in printed.splitlines()}
    shown = re.search(r"```\n(residual .*?)\n\nmodel:", README, re.DOTALL)
    assert shown
    lines = [line for line in shown[1].splitlines() if line not in ("...", "")]
    assert len(lines) > 20
    for line in lines:
        assert without_rounding(line) in kept, line


# How the lines of the report that the table shows begin, by its columns.
CHIEF_LINES = (
    ("joint constraint", {"AC", "AC at rest"}),
    ("joint constraint", {"AC", "AC at 1 Hz"}),
    ("emergent AC", {"measured AC, rms"}),
    ("tracking moving", {"SC", "AC", "ST", "GH"}),
)
DECIMALS = (3, 3, 2, 2)


def verified_models() -> dict[str, list[str]]:
    rows = re.findall(r"^\| `(shoulder_\w+/scene\w*\.xml)` \| (.*) \|$", README, flags=re.MULTILINE)
    return {model: cells.split(" | ") for model, cells in rows}


def test_the_readme_shows_the_verdict_on_every_committed_model() -> None:
    committed = {f"{path.parent.name}/{path.name}" for path in (ROOT / "model").glob("*/scene*")}
    assert verified_models().keys() == committed


@pytest.mark.parametrize("model", verified_models())
def test_the_verdict_of_the_readme_is_that_of_the_program(
    model: str, shared: SharedResults
) -> None:
    report = shared.verify(ROOT / "model" / model).answer
    shown = []
    for (group, items), decimals in zip(CHIEF_LINES, DECIMALS, strict=True):
        values = [
            line["value"]
            for line in report["residuals"]
            if line["group"] == group and re.sub(", (right|left)$", "", line["item"]) in items
        ]
        shown.append(f"{max(values):.{decimals}f}" if values else "-")
    assert [*shown, "pass" if report["passed"] else "fail"] == verified_models()[model]


SKIN_LINES = (
    "acromion's skin rises, plane 0",
    "acromion's bone rises, plane 0",
    "area below half, plane 0",
    "area below half, plane 90",
)


def test_the_skin_table_of_the_readme_is_that_of_the_program(
    checkout: Path, program: Path
) -> None:
    shown = re.search(r"\| measured \| `--girdle frozen` .*?\n\|[-|]+\|\n(.*?)\n\n", README, re.DOTALL)
    assert shown
    rows = [line.strip("| ").split(" | ")[1:3] for line in shown[1].splitlines()]
    columns = []
    for girdle, status in (("measured", 0), ("frozen", 1)):
        finished = subprocess.run(
            [program, "verify", "build/model/scene.xml", "--json", "--girdle", girdle],
            cwd=checkout, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert finished.returncode == status, finished.stdout + finished.stderr
        lines = json.loads(finished.stdout)["residuals"]
        values = {line["item"]: line["value"] for line in lines if line["group"] == "skin"}
        columns.append([f"{values[item]:.1f}" for item in SKIN_LINES])
    assert rows == [list(row) for row in zip(*columns, strict=True)]


def test_the_comparison_of_the_readme_has_the_lines_of_the_program(
    checkout: Path, program: Path
) -> None:
    printed = run(program, "compare", folder=checkout).splitlines()
    shown = re.search(r"```\n(difference  .*?)\n```", README, re.DOTALL)
    assert shown
    for line in shown[1].splitlines():
        assert line in ("...", "") or line in printed, line


def test_the_continuity_table_of_the_readme_is_that_of_the_program(
    checkout: Path, program: Path
) -> None:
    """What differences leave of rounding may differ from machine to machine; a jump may not."""
    rounding = re.compile(r" +[0-9.]+e-\d\d\b")
    printed = run(program, "smoothness", folder=checkout).splitlines()
    kept = {rounding.sub(" ~", line) for line in printed}
    shown = re.search(r"```\n(largest jump .*?)\n```", README, re.DOTALL)
    assert shown
    assert len(shown[1].splitlines()) == 8
    for line in shown[1].splitlines():
        assert rounding.sub(" ~", line) in kept, line


def test_the_speed_table_of_the_readme_has_the_rows_of_the_benchmark() -> None:
    """Timings are no test; that the README shows what the benchmark prints is."""
    source = (ROOT / "tests" / "benchmarks" / "speed.cc").read_text(encoding="utf-8")
    shown = re.search(r"```\n(one pose, all three joints.*?)\n```", README, re.DOTALL)
    assert shown
    rows = [re.split(r"  +", line)[0] for line in shown[1].splitlines() if line]
    assert len(rows) > 15
    for row in rows:
        # A row may be made of a place, "inside", and what is done there, ", one by one".
        place, comma, done = row.partition(", ")
        in_parts = f'"{place}"' in source and f'"{comma}{done}"' in source
        assert f'"{row}' in source or in_parts, row
