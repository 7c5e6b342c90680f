# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Standard error says what every verb wrote, in which the rows are those of the file."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest
from conftest import REFUSED, SCENE, TALLY, Girdle, with_scene
from reference_rhythm import DATABASE

POSE = ("solve", "--elevation", "60", "--plane", "40")
SWEEP = ("solve", "--elevation", "0:100:20", "--plane", "200")
RAISE = ("simulate", SCENE, "--elevation", "10:20", "--seconds", "0.1")
COMPARE = ("compare", "--elevation", "30:60:30", "--plane", "0:90:45")
SMOOTH_TABLE = ("smooth-table", "--in", str(DATABASE))

Words = tuple[str, ...]


def id_of(words: object) -> str:
    return " ".join(words) if isinstance(words, tuple) else str(words)


def rows_of(path: Path) -> list[dict[str, str]]:
    """The rows of a CSV behind its comments."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


# Commands that write one file, its name, and what its rows are called if they are counted.
WRITTEN = [
    (POSE, "--out", "pose.txt", None),
    ((*POSE, "--json"), "--out", "pose.json", None),
    (("solve", "--posture", "relaxed"), "--out", "posture.txt", None),
    (RAISE, "--out", "joints.csv", "row"),
    ((*RAISE, "--json"), "--out", "joints.csv", "row"),
    (RAISE, "--out-controls", "controls.csv", "row"),
    (COMPARE, "--out", "map.csv", "row"),
    (COMPARE, "--out", "summary.json", None),
    (SMOOTH_TABLE, "--out", "smooth.csv", "position"),
    (("fit-thorax",), "--out", "thorax.csv", None),
]


@pytest.mark.parametrize(("command", "option", "name", "counted"), WRITTEN, ids=id_of)
def test_a_file_that_was_written_is_named_with_its_rows(
    girdle: Girdle,
    generated: Path,
    tmp_path: Path,
    command: Words,
    option: str,
    name: str,
    counted: str | None,
) -> None:
    finished = girdle(*with_scene(command, generated), option, name)
    assert finished.code == 0, finished.message
    count = f": {len(rows_of(tmp_path / name))} {counted}s" if counted else ""
    assert finished.message == f"girdle: wrote {name}{count}\n"
    assert TALLY.fullmatch(finished.message)


@pytest.mark.parametrize(
    ("command", "option"),
    [
        (POSE, "--out"),
        ((*POSE, "--json"), "--out"),
        (("solve", "--posture", "relaxed"), "--out"),
        (RAISE, "--out"),
        (RAISE, "--out-controls"),
        (SMOOTH_TABLE, "--out"),
        (("fit-thorax",), "--out"),
    ],
    ids=id_of,
)
def test_what_goes_to_standard_output_is_no_file(
    girdle: Girdle, generated: Path, command: Words, option: str
) -> None:
    finished = girdle(*with_scene(command, generated), option, "-")
    assert (finished.code, finished.message) == (0, "")
    assert finished.output != b""


def test_rows_that_were_solved_are_counted_by_what_became_of_them(girdle: Girdle, tmp_path: Path) -> None:
    finished = girdle(*SWEEP, "--out", "map.csv")
    rows = rows_of(tmp_path / "map.csv")
    clamped = sum(row["clamped"] == "1" for row in rows)
    modelled = sum(row["origin"] == "modelled" for row in rows)
    assert 0 < clamped < len(rows) == 6
    found = re.fullmatch(
        rf"girdle: wrote map\.csv: {len(rows)} rows, {clamped} clamped \({clamped} beyond what an arm "
        rf"reaches; see the columns used_\*\), {modelled} modelled \(up to (\S+) deg from measured "
        r"directions\)\n",
        finished.message,
    )
    assert found, finished.message
    farthest_deg = max(float(row["distance_deg"]) for row in rows)
    assert float(found[1]) == pytest.approx(farthest_deg, abs=0.05 + 1e-9)
    # On standard output it is named by what was solved.
    printed = girdle(*SWEEP)
    assert printed.message == finished.message.replace("wrote map.csv", "--elevation, --plane")
    assert printed.output == (tmp_path / "map.csv").read_bytes()


def test_every_file_of_a_simulation_has_a_line(girdle: Girdle, generated: Path, tmp_path: Path) -> None:
    """In the order of the options in the help, whatever the order in which they are typed."""
    files = ("--out-picture", "p.png", "--out-controls", "c.csv", "--out", "j.csv", "--size", "64x48")
    finished = girdle(*with_scene(RAISE, generated), *files)
    assert finished.code == 0, finished.message
    states = len(rows_of(tmp_path / "j.csv"))
    assert states > 50
    assert finished.message == (
        f"girdle: wrote j.csv: {states} rows\ngirdle: wrote c.csv: {states} rows\ngirdle: wrote p.png\n"
    )
    # The text is about the motion alone.
    assert re.fullmatch(r"simulated 0\.1 s in .*\n(up to .*\n)?", finished.text)


def test_a_picture_that_was_drawn_is_named(girdle: Girdle, generated: Path) -> None:
    command = with_scene(("render", SCENE, "--size", "64x48"), generated)
    finished = girdle(*command, "--out", "arm.png")
    assert (finished.code, finished.text) == (0, "")
    assert finished.message == "girdle: wrote arm.png\n"


def test_a_file_that_was_not_written_is_not_named(girdle: Girdle, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text("elevation_deg,plane_deg\n60,40\n60,4O\n")
    finished = girdle("solve", "--in", "poses.csv", "--out", "angles.csv")
    assert finished.code == REFUSED
    assert "wrote" not in finished.message
