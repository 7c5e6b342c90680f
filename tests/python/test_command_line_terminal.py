# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What a person sees on a terminal and a pipe does not: progress."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import (
    REFUSED,
    SCENE,
    TALLY,
    Girdle,
    WriteModel,
    find_element,
    with_scene,
)
from pseudo_terminal import Seen, run_on_terminal

# Long enough that every percent has its turn.
LONG_ROWS = 100_000
LONG_TABLE = "elevation_deg,plane_deg\n" + "60,50\n" * LONG_ROWS

LONG_WORK = {
    "solve": ("solve", "--in", "poses.csv", "--out", "angles.csv"),
    "simulate": ("simulate", SCENE, "--elevation", "15:120"),
    "verify": ("verify", SCENE),
}
every_long_work = pytest.mark.parametrize("command", LONG_WORK.values(), ids=LONG_WORK.keys())


def without_tally(lines: list[str]) -> list[str]:
    """What stands there but for how many rows were clamped."""
    return [line for line in lines if not TALLY.fullmatch(line + "\n")]


@pytest.fixture
def typed(program: Path, generated: Path, tmp_path: Path, command: tuple[str, ...]) -> list[str]:
    (tmp_path / "poses.csv").write_text(LONG_TABLE)
    return [str(program), *with_scene(command, generated)]


@every_long_work
def test_progress_counts_up_on_a_terminal(typed: list[str], tmp_path: Path) -> None:
    seen = run_on_terminal(typed, tmp_path, output=tmp_path / "output")
    percents = [int(percent) for percent in re.findall(r"\r\w+ (\d+) %", seen.written)]
    assert seen.code == 0
    assert percents == sorted(set(percents))
    # Most whole percents, not only the ends.
    assert len(percents) > 50


@every_long_work
def test_nothing_of_the_progress_is_left_in_the_end(typed: list[str], tmp_path: Path) -> None:
    seen = run_on_terminal(typed, tmp_path, output=tmp_path / "output")
    assert seen.code == 0
    assert without_tally(seen.lines) == [""]


@pytest.mark.parametrize(
    "command",
    [("solve", "--in", "poses.csv"), LONG_WORK["simulate"], LONG_WORK["verify"]],
    ids=LONG_WORK.keys(),
)
def test_a_terminal_changes_nothing_in_a_result_that_goes_to_a_file(
    girdle_fine: Girdle, typed: list[str], tmp_path: Path
) -> None:
    run_on_terminal(typed, tmp_path, output=tmp_path / "output")
    assert (tmp_path / "output").read_bytes() == girdle_fine(*typed[1:]).output


@pytest.mark.parametrize(
    "command",
    [*LONG_WORK.values(), ("solve", "--in", "poses.csv"), (*LONG_WORK["simulate"], "--out", "-")],
    ids=[*LONG_WORK.keys(), "solve to the terminal", "simulate to the terminal"],
)
def test_a_result_on_the_terminal_is_free_of_progress(
    girdle_fine: Girdle, typed: list[str], tmp_path: Path
) -> None:
    # Colour is for terminals alone.
    seen = run_on_terminal(typed, tmp_path, variables={"NO_COLOR": "1"})
    expected = [line.rstrip() for line in girdle_fine(*typed[1:]).text.split("\n")]
    assert seen.code == 0
    lines = without_tally(seen.lines)
    assert len(lines) == len(expected)
    pairs = zip(lines, expected, strict=True)
    assert [(found, line) for found, line in pairs if found != line][:3] == []


def expect_a_line_of_its_own(seen: Seen) -> None:
    assert seen.code == REFUSED
    assert re.search(r"\d+ %", seen.written), "it breaks off before there is any progress"
    line, end = seen.lines
    assert line.startswith("girdle: ")
    assert end == ""


@pytest.mark.parametrize("verb", ["simulate", "verify"])
def test_a_message_after_progress_begins_its_own_line(
    program: Path, write_model: WriteModel, tmp_path: Path, verb: str
) -> None:
    """Wind and water so strong that the simulation breaks off on the way."""
    scene = write_model(
        lambda root: find_element(root, "option").attrib.update(density="1000", wind="400 0 0")
    )
    typed = [str(program), *with_scene(LONG_WORK[verb], scene.parent)]
    expect_a_line_of_its_own(run_on_terminal(typed, tmp_path))


def test_a_message_after_many_rows_begins_its_own_line(program: Path, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text(LONG_TABLE + "60,5O\n")
    typed = [str(program), *LONG_WORK["solve"]]
    expect_a_line_of_its_own(run_on_terminal(typed, tmp_path))


@pytest.mark.parametrize("options", [(), ("--json",)])
def test_solving_one_pose_shows_no_progress(program: Path, tmp_path: Path, options: tuple[str, ...]) -> None:
    typed = [str(program), "solve", "--elevation", "23", "--plane", "50", *options]
    assert run_on_terminal(typed, tmp_path, output=tmp_path / "output").written == ""
