# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Tables with one mistake, given with --table to every verb that takes one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import pytest
from conftest import SCENE, Girdle, Refuses, with_scene
from reference_rhythm import DATABASE

# What the default model moves by.
SMOOTHED = DATABASE.with_name("ludewig2009_smoothed.csv")
PUBLISHED = ("--interpolation", "squad", "--closure", "table")

Table = list[list[str]]

# Lines of the table without its comments: the header, then 22 elevations 15, 20 .. 120 in each of
# the planes 0, 40 and 90.
ELEVATIONS = 22


def line_of(plane: int, elevation: int) -> int:
    return 2 + (0, 40, 90).index(plane) * ELEVATIONS + (elevation - 15) // 5


def shipped_table() -> Table:
    lines = [line for line in SMOOTHED.read_text().splitlines() if not line.startswith("#")]
    return [line.split(",") for line in lines]


def write_table(path: Path, table: Table) -> None:
    path.write_text("".join(",".join(row) + "\n" for row in table))


def put(line: int, column: str, text: str, table: Table) -> None:
    table[line - 1][table[0].index(column)] = text


def add_column(name: str, text: str, table: Table) -> None:
    table[0].append(name)
    for row in table[1:]:
        row.append(text)


def remove_column(name: str, table: Table) -> None:
    column = table[0].index(name)
    for row in table:
        del row[column]


def rename_column(old: str, new: str, table: Table) -> None:
    table[0][table[0].index(old)] = new


def remove_line(line: int, table: Table) -> None:
    del table[line - 1]


def repeat_line(line: int, table: Table) -> None:
    table.insert(line, table[line - 1])


def keep_lines(count: int, table: Table) -> None:
    del table[count:]


def shorten_line(line: int, table: Table) -> None:
    del table[line - 1][-1]


def renumber_plane(old: str, new: str, table: Table) -> None:
    for row in table:
        row[0] = new if row[0] == old else row[0]


@dataclass(frozen=True)
class WrongTable:
    """One mistake in the table, where it is noticed, what is said of it, and to which options."""

    edit: Callable[[Table], None]
    place: str
    patterns: tuple[str, ...]
    options: tuple[str, ...] = ()


def wrong(edit: Callable[[Table], None], line: int, *patterns: str) -> WrongTable:
    return WrongTable(edit, f"mine.csv:{line}: ", patterns)


WRONG_TABLES = {
    "hole": wrong(
        partial(remove_line, line_of(40, 60)),
        line_of(40, 60),
        *("plane 40 deg has elevation 65 deg", "60 deg is expected"),
    ),
    "hole at the end of a plane": wrong(
        partial(remove_line, line_of(40, 120)),
        line_of(40, 120),
        *("plane 40 deg ends without elevation 120 deg", "hole"),
    ),
    "hole at the end of the table": wrong(
        partial(remove_line, line_of(90, 120)),
        line_of(90, 115),
        *("plane 90 deg ends without elevation 120 deg", "hole"),
    ),
    "position twice": wrong(
        partial(repeat_line, line_of(40, 60)),
        line_of(40, 60) + 1,
        *("plane 40 deg, elevation 60 deg is given twice", "Remove one"),
    ),
    "elevations that do not increase": wrong(
        partial(put, line_of(0, 30), "elevation_deg", "24"),
        line_of(0, 30),
        *("elevation 24 deg does not increase", "previous 25"),
    ),
    "planes that do not increase": wrong(
        partial(renumber_plane, "90", "30"),
        line_of(90, 15),
        *("plane 30 deg does not increase", "previous 40"),
    ),
    "one plane": WrongTable(
        partial(keep_lines, 1 + ELEVATIONS), "mine.csv: ", ("planes: 1 given", "at least 2")
    ),
    "one elevation": WrongTable(
        lambda table: table.__setitem__(slice(1, None), table[1::ELEVATIONS]),
        "mine.csv: ",
        ("elevations: 1 given", "at least 2"),
    ),
    "no rows": wrong(partial(keep_lines, 1), 1, "no rows"),
    "nothing": wrong(partial(keep_lines, 0), 1, "no header", "must name the columns"),
    "missing plane column": wrong(
        partial(remove_column, "plane_deg"), 1, "'plane_deg' is missing", "header has: elevation"
    ),
    "missing angle column": wrong(
        partial(remove_column, "ac_tilt_deg"), 1, "'ac_tilt_deg' is missing", "header has: plane"
    ),
    "one of three columns missing": wrong(
        partial(remove_column, "st_upward_rotation_deg"), 1, "'st_upward_rotation_deg' is missing"
    ),
    "unknown column": wrong(
        partial(add_column, "remark", "fine"), 1, "'remark' is not known", "Remove .* or correct"
    ),
    "column twice": wrong(
        partial(rename_column, "origin", "plane_deg"), 1, "'plane_deg' is given twice", "Rename"
    ),
    "angle of 200": wrong(
        partial(put, line_of(40, 60), "gh_flexion_deg", "200"),
        line_of(40, 60),
        *("gh_flexion_deg is 200", "-180 to 180"),
    ),
    "scapulothoracic angle of -200": wrong(
        partial(put, line_of(40, 60), "st_tilt_deg", "-200"),
        line_of(40, 60),
        *("st_tilt_deg is -200", "-180 to 180"),
    ),
    "elevation below 0": wrong(
        partial(put, line_of(0, 15), "elevation_deg", "-15"),
        line_of(0, 15),
        *("elevation_deg is -15", "0 to 180"),
    ),
    "plane of 200": wrong(
        partial(put, line_of(90, 15), "plane_deg", "200"),
        line_of(90, 15),
        *("plane_deg is 200", "-180 to 180"),
    ),
    "text in an angle": wrong(
        partial(put, line_of(40, 60), "ac_tilt_deg", "4O"),
        line_of(40, 60),
        *("ac_tilt_deg is '4O'", "finite number such as"),
    ),
    "nan": wrong(
        partial(put, line_of(40, 60), "ac_tilt_deg", "nan"),
        line_of(40, 60),
        *("ac_tilt_deg is 'nan'", "finite number such as"),
    ),
    "empty angle": wrong(
        partial(put, line_of(40, 60), "ac_tilt_deg", ""),
        line_of(40, 60),
        *("ac_tilt_deg is ''", "finite number such as"),
    ),
    "unknown origin": wrong(
        partial(put, line_of(40, 60), "origin", "guessed"),
        line_of(40, 60),
        *("origin is 'guessed'", "measured or sc_ac_derived"),
    ),
    # The angles of a table are not in order if a joint turns that far from one knot to the next.
    "half a turn between two planes": WrongTable(
        partial(put, line_of(40, 60), "gh_flexion_deg", "179"),
        "mine.csv: ",
        ("GH", "180 deg", "planes 0.* and 40.* elevation 60"),
        PUBLISHED,
    ),
    "half a turn from all the others": WrongTable(
        partial(put, line_of(40, 60), "sc_protraction_deg", "150"),
        "mine.csv: ",
        ("SC", "17\\d.* deg from its mean", "at most 170", "Check the signs"),
    ),
    "an edge far from where the arm hangs": WrongTable(
        partial(put, line_of(0, 15), "sc_protraction_deg", "100"),
        "mine.csv: ",
        ("SC at plane 0", "elevation 15", "too far to go on", "range clamp"),
    ),
    "short row": wrong(partial(shorten_line, line_of(40, 60)), line_of(40, 60), "14 fields, expected 15"),
}

VERBS = {
    "solve": ("solve", "--elevation", "23", "--plane", "50"),
    "generate": ("generate", "--out", "new_model"),
    "verify": ("verify", SCENE),
}
every_verb = pytest.mark.parametrize("command", VERBS.values(), ids=VERBS.keys())


@every_verb
def test_the_table_is_fine_without_a_mistake(
    girdle_fine: Girdle, generated: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    write_table(tmp_path / "mine.csv", shipped_table())
    girdle_fine(*with_scene(command, generated), "--table", "mine.csv")


@every_verb
@pytest.mark.parametrize("mistake", WRONG_TABLES.values(), ids=WRONG_TABLES.keys())
def test_a_mistake_in_a_table_is_refused_with_its_place(
    refuses: Refuses,
    generated: Path,
    tmp_path: Path,
    command: tuple[str, ...],
    mistake: WrongTable,
) -> None:
    table = shipped_table()
    mistake.edit(table)
    assert table != shipped_table()
    write_table(tmp_path / "mine.csv", table)
    words = (*with_scene(command, generated), "--table", "mine.csv", *mistake.options)
    refuses(*words, because=(mistake.place, *mistake.patterns))


@every_verb
def test_an_absent_table_is_refused(refuses: Refuses, generated: Path, command: tuple[str, ...]) -> None:
    words = (*with_scene(command, generated), "--table", "absent.csv")
    refuses(*words, because=("absent.csv: ", "Check"))


@every_verb
def test_a_folder_is_no_table(
    refuses: Refuses, generated: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    (tmp_path / "mine.csv").mkdir()
    words = (*with_scene(command, generated), "--table", "mine.csv")
    refuses(*words, because=("mine.csv", "folder|directory"))


def drop_plane(plane: str, table: Table) -> None:
    table[1:] = [row for row in table[1:] if row[0] != plane]


def keep_elevations(kept: tuple[str, ...], table: Table) -> None:
    table[1:] = [row for row in table[1:] if row[1] in kept]


# Enough for squad and slerp, too few for two continuous derivatives.
SMALL_TABLES: dict[str, tuple[Callable[[Table], None], tuple[str, ...]]] = {
    "two planes": (partial(drop_plane, "40"), ("has 2 planes", "at least 3")),
    "three elevations": (
        partial(keep_elevations, ("30", "60", "90")),
        ("has 3 elevations", "at least 4"),
    ),
}
every_small_table = pytest.mark.parametrize(
    ("edit", "patterns"), SMALL_TABLES.values(), ids=SMALL_TABLES.keys()
)
SMALL_VERBS = VERBS | {
    "solve rows": ("solve", "--elevation", "30:60:30", "--plane", "0", "--out", "map.csv"),
    "simulate": ("simulate", SCENE, "--elevation", "30:60", "--out", "trace.csv"),
    "compare": ("compare", "--out", "map.csv"),
    "smoothness": ("smoothness",),
}


@every_small_table
@pytest.mark.parametrize("command", SMALL_VERBS.values(), ids=SMALL_VERBS.keys())
def test_a_table_too_small_for_smooth_is_refused_with_what_it_needs(
    refuses: Refuses,
    generated: Path,
    tmp_path: Path,
    command: tuple[str, ...],
    edit: Callable[[Table], None],
    patterns: tuple[str, ...],
) -> None:
    table = shipped_table()
    edit(table)
    write_table(tmp_path / "mine.csv", table)
    words = (*with_scene(command, generated), "--table", "mine.csv")
    because = ("mine.csv: ", *patterns, "smooth", "squad or slerp")
    refuses(*words, because=because)


@every_small_table
@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
def test_a_table_too_small_for_smooth_is_fine_with_the_others(
    girdle_fine: Girdle,
    tmp_path: Path,
    interpolation: str,
    edit: Callable[[Table], None],
    patterns: tuple[str, ...],
) -> None:
    table = shipped_table()
    edit(table)
    write_table(tmp_path / "mine.csv", table)
    how = ("--table", "mine.csv", "--interpolation", interpolation)
    girdle_fine("solve", "--elevation", "45", "--plane", "30", *how)
    girdle_fine("generate", "--out", "new_model", *how)


def test_a_table_beyond_the_joints_ranges_gives_no_model(refuses: Refuses, tmp_path: Path) -> None:
    """A valid table, so that `solve` takes it, of an arm that the model's joints do not allow."""
    table = shipped_table()
    put(line_of(40, 60), "gh_flexion_deg", "85", table)
    write_table(tmp_path / "mine.csv", table)
    refuses(
        *("generate", "--out", "new_model", "--table", "mine.csv", *PUBLISHED),
        because=("mine.csv", r"gh_flexion is 8\d.* deg at plane [34]\d, elev", "Check the signs"),
    )
