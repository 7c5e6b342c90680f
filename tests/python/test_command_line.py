# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What all verbs of the program have in common: help, wrong words, full and unwritable places."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import SCENE, Girdle, Refuses, contents, expect_one_message, with_scene
from reference_rhythm import DATABASE

VERBS = ("solve", "generate", "simulate", "verify", "compare", "smoothness", "smooth-table")

# A complete command of each verb, given the scene of a model.
ONE_POSE = ("solve", "--elevation", "23", "--plane", "50")
TABLE_OF_POSES = ("solve", "--in", "poses.csv")
RAISE = ("simulate", SCENE, "--elevation", "15:20", "--seconds", "0.1")
VERIFY = ("verify", SCENE)
GENERATE = ("generate", "--out", "new_model")
SMOOTHNESS = ("smoothness", "--interpolation", "slerp", "--closure", "table")
COMPARE = ("compare", "--elevation", "30:120:30", "--plane", "0:90:45")
SMOOTH_TABLE = ("smooth-table", "--in", str(DATABASE), "--out", "smooth.csv")

POSES = "elevation_deg,plane_deg\n23,50\n"

Command = tuple[str, ...]


def commands(*rows: Command) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("command", rows, ids=[" ".join(row) for row in rows])


every_verb = commands(ONE_POSE, TABLE_OF_POSES, RAISE, VERIFY, GENERATE, COMPARE, SMOOTHNESS, SMOOTH_TABLE)


# --- Help ----------------------------------------------------------------------------------------


def test_help_names_every_verb(girdle_fine: Girdle) -> None:
    text = girdle_fine("--help").text
    assert [verb for verb in VERBS if verb not in text] == []


@pytest.mark.parametrize("verb", VERBS)
def test_the_help_of_a_verb_gives_an_example(girdle_fine: Girdle, verb: str) -> None:
    assert re.search(rf"^  girdle {verb}\b", girdle_fine(verb, "--help").text, re.MULTILINE)


def test_the_version_is_printed_alone(girdle_fine: Girdle) -> None:
    name, version = girdle_fine("--version").text.split()
    assert name == "girdle"
    assert [part.isdigit() for part in version.split(".")] == [True, True, True]


# --- Wrong words ---------------------------------------------------------------------------------


def test_without_a_verb_the_message_points_to_them(refuses: Refuses) -> None:
    refuses(because=("girdle --help|Verbs are: solve",))


def test_an_unknown_verb_is_refused_with_the_known_ones(refuses: Refuses) -> None:
    refuses("slove", "--elevation", "23", "--plane", "50", because=("'slove'", *VERBS))


@every_verb
def test_an_unknown_option_is_refused_by_its_name(
    refuses: Refuses, generated: Path, tmp_path: Path, command: Command
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    refuses(*with_scene(command, generated), "--quick", because=("--quick", "--help"))


@commands(("--quick",), ("--quick", *ONE_POSE))
def test_an_unknown_option_before_the_verb_is_refused_by_its_name(refuses: Refuses, command: Command) -> None:
    refuses(*command, because=("--quick", "--help"))


@every_verb
def test_a_further_word_is_refused(
    refuses: Refuses, generated: Path, tmp_path: Path, command: Command
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    refuses(*with_scene(command, generated), "surplus", because=("surplus", "--help"))


def test_a_missing_folder_is_named(refuses: Refuses) -> None:
    refuses("generate", because=("--out", "--help"))


@commands(("simulate", "--elevation", "15:20"), ("verify",))
def test_a_missing_model_is_named(refuses: Refuses, command: Command) -> None:
    refuses(*command, because=("MODEL is required", f"girdle {command[0]} --help"))


# --- Choosing the rhythm -------------------------------------------------------------------------

every_verb_that_chooses = commands(
    ONE_POSE, TABLE_OF_POSES, RAISE, VERIFY, GENERATE, COMPARE, ("smoothness",)
)


@every_verb_that_chooses
@pytest.mark.parametrize(
    ("option", "word", "known"),
    [
        ("--interpolation", "cubic", ("smooth, squad, slerp",)),
        ("--interpolation", "SQUAD", ("smooth, squad, slerp",)),
        ("--closure", "open", ("exact, table",)),
        ("--range", "all", ("whole, clamp",)),
    ],
)
def test_an_unknown_word_for_the_rhythm_is_refused_with_the_known_ones(
    refuses: Refuses,
    generated: Path,
    tmp_path: Path,
    command: Command,
    option: str,
    word: str,
    known: tuple[str, ...],
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    refuses(*with_scene(command, generated), option, word, because=(option, word, *known))


@every_verb_that_chooses
@pytest.mark.parametrize("option", ["--table", "--interpolation", "--closure", "--range"])
def test_an_empty_word_for_the_rhythm_is_refused(
    refuses: Refuses, generated: Path, tmp_path: Path, command: Command, option: str
) -> None:
    """As typed with a shell variable that is not set; the default would be a silent surprise."""
    (tmp_path / "poses.csv").write_text(POSES)
    refuses(*with_scene(command, generated), option, "", because=(option,))


@every_verb_that_chooses
@pytest.mark.parametrize(
    "options",
    [("--interpolation", "squad"), ("--interpolation", "slerp"), ("--closure", "table")],
    ids=" ".join,
)
def test_the_whole_range_needs_what_has_a_rule_for_it(
    refuses: Refuses, generated: Path, tmp_path: Path, command: Command, options: Command
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    words = (*with_scene(command, generated), *options, "--range", "whole")
    because = ("these options do not go together", "range whole", "smooth", "exact", "range clamp")
    refuses(*words, because=because)


# --- Places that cannot be written ---------------------------------------------------------------

# Root may write everywhere that permissions forbid: these cannot be written by anybody.
NO_FILE = ["a_file/below", "absent/below", "a_folder", "/proc/nope", "/dev/full"]
NO_FOLDER = ["a_file", "a_file/below", "/proc/nope", "/dev/full"]


@pytest.mark.parametrize("place", NO_FILE)
@commands(
    (*ONE_POSE, "--out"),
    (*ONE_POSE, "--json", "--out"),
    (*TABLE_OF_POSES, "--out"),
    (*RAISE, "--out"),
    SMOOTH_TABLE[:-1],
)
def test_a_file_that_cannot_be_written_is_refused(
    refuses: Refuses, generated: Path, tmp_path: Path, command: Command, place: str
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    (tmp_path / "a_file").write_text("kept\n")
    (tmp_path / "a_folder").mkdir()
    refuses(*with_scene(command, generated), place, because=(place, "cannot be written", "Choose"))


@pytest.mark.parametrize("place", NO_FOLDER)
def test_a_folder_that_cannot_be_made_is_refused(refuses: Refuses, tmp_path: Path, place: str) -> None:
    (tmp_path / "a_file").write_text("kept\n")
    refuses("generate", "--out", place, because=(place, "cannot be", "--out"))


@commands(
    (*ONE_POSE, "--out"),
    (*RAISE, "--out"),
    ("generate", "--out"),
    SMOOTH_TABLE[:-1],
    (*COMPARE, "--out"),
)
def test_a_place_without_a_name_is_refused_by_its_option(
    refuses: Refuses, generated: Path, command: Command
) -> None:
    refuses(*with_scene(command, generated), "", because=(command[-1],))


@commands(
    ("--help",),
    ("--version",),
    ("solve", "--help"),
    ONE_POSE,
    (*ONE_POSE, "--json"),
    TABLE_OF_POSES,
    (*TABLE_OF_POSES, "--out", "/dev/stdout"),
    RAISE,
    (*RAISE, "--json"),
    (*RAISE, "--out", "-"),
    VERIFY,
    (*VERIFY, "--json"),
    (*SMOOTH_TABLE[:-1], "-"),
    (*SMOOTH_TABLE[:-1], "/dev/stdout"),
    COMPARE,
    (*COMPARE, "--json"),
    SMOOTHNESS,
    (*SMOOTHNESS, "--json"),
    ("solve", "--posture", "relaxed"),
    ("solve", "--elevation", "0:180:5", "--plane", "0"),
)
def test_a_full_standard_output_is_an_error(
    girdle: Girdle, generated: Path, tmp_path: Path, command: Command
) -> None:
    (tmp_path / "poses.csv").write_text(POSES)
    before = contents(tmp_path)
    with Path("/dev/full").open("wb") as full:
        finished = girdle(*with_scene(command, generated), stdout=full)
    expect_one_message(finished, "standard output|/dev/stdout", "cannot be written", "Choose")
    assert contents(tmp_path) == before


@pytest.mark.parametrize("options", [(), ("--json",)])
def test_a_model_is_complete_even_where_its_summary_cannot_be_printed(
    girdle: Girdle, generated: Path, tmp_path: Path, options: tuple[str, ...]
) -> None:
    with Path("/dev/full").open("wb") as full:
        finished = girdle(*GENERATE, *options, stdout=full)
    expect_one_message(finished, "standard output", "Choose")
    assert contents(tmp_path / "new_model") == contents(generated)
