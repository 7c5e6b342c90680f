# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the README tells a reader to type works: its Python, its C++ and its command lines."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    found = re.findall(rf"```{language}\n(.*?)```", README, flags=re.DOTALL)
    assert found, f"the README has no {language}"
    return found


def run(*command: str | Path, folder: Path) -> str:
    finished = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, check=False, timeout=120
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr
    assert finished.stderr == ""
    return finished.stdout


@pytest.fixture
def checkout(tmp_path: Path, program: Path, plugin_library: Path) -> Path:
    """A folder in which the README's paths lead to what is tested."""
    release = tmp_path / "build" / "release"
    release.mkdir(parents=True)
    (release / plugin_library.name).symlink_to(plugin_library)
    (tmp_path / "build" / "engine").symlink_to(ROOT / "build" / "engine")
    (tmp_path / "data").symlink_to(ROOT / "data")
    run(program, "generate", "--out", tmp_path / "build" / "model", folder=tmp_path)
    return tmp_path


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+\.\d*(?:e[-+]\d+)?", text)]


def test_the_python_of_the_readme_raises_the_arm(checkout: Path) -> None:
    upward_rotation, elevation, plane = numbers(
        run(sys.executable, "-c", blocks("python")[0], folder=checkout)
    )
    assert upward_rotation < -0.2  # upward rotation is negative
    assert elevation == pytest.approx(1.57, abs=1e-6)
    assert plane == pytest.approx(0.70, abs=1e-6)


def test_the_python_of_the_readme_attaches_the_shoulder(checkout: Path) -> None:
    elevation, plane = numbers(run(sys.executable, "-c", blocks("python")[1], folder=checkout))
    assert elevation == pytest.approx(1.57, abs=1e-6)
    assert plane == pytest.approx(0, abs=1e-6)


def test_the_c_plus_plus_of_the_readme_raises_the_arm(checkout: Path) -> None:
    (checkout / "arm.cc").write_text(blocks("cpp")[0], encoding="utf-8")
    build = next(text for text in blocks("sh") if "g++" in text)
    run("bash", "-ec", build, folder=checkout)
    assert re.fullmatch(r"-0\.2\d+ rad\n", run(checkout / "arm", folder=checkout))


def readme_commands() -> list[str]:
    return re.findall(r"^\| `(girdle [^`]*)` \|", README, flags=re.MULTILINE)


def test_the_readme_shows_every_verb() -> None:
    assert {line.split()[1] for line in readme_commands()} == {
        "solve",
        "generate",
        "simulate",
        "verify",
        "destep",
        "thorax",
        "compare",
        "continuity",
    }


@pytest.mark.parametrize("line", readme_commands())
def test_a_command_line_of_the_readme_works(line: str, checkout: Path, program: Path) -> None:
    (checkout / "poses.csv").write_text("elevation_deg,plane_deg\n23,50\n", encoding="utf-8")
    words = [word if word != "scene.xml" else "build/model/scene.xml" for word in shlex.split(line)]
    run(program, *words[1:], folder=checkout)


def test_the_report_of_the_readme_has_the_lines_of_the_program(
    checkout: Path, program: Path
) -> None:
    """Values that rounding makes may differ from machine to machine; everything else is the same."""
    tiny = re.compile(r" +[0-9.]+e-(?:09|1[0-9]) | +0 ")
    printed = run(program, "verify", "build/model/scene.xml", folder=checkout).splitlines()
    kept = {tiny.sub(" ~ ", line).rsplit("  ", 1)[0].split("~")[0].rstrip() for line in printed}
    shown = re.search(r"```\n(residual .*?)\n\nmodel:", README, re.DOTALL)
    assert shown
    for line in shown[1].splitlines():
        if line not in ("...", ""):
            assert tiny.sub(" ~ ", line).rsplit("  ", 1)[0].split("~")[0].rstrip() in kept, line


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
    printed = run(program, "continuity", folder=checkout).splitlines()
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
        assert f'"{row}' in source, row
