# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Words that the program does not know any more or not at all, and its help for those it knows."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import SCENE, Girdle, Refuses, with_scene
from pseudo_terminal import run_on_terminal

VERBS = (
    *("solve", "generate", "simulate", "render", "verify", "compare"),
    *("smoothness", "smooth-table", "doctor", "fit-thorax"),
)
every_verb = pytest.mark.parametrize("verb", VERBS)

POSE = ("solve", "--elevation", "60", "--plane", "50")
RAISE = ("simulate", SCENE, "--elevation", "15:20")
RENDER = ("render", SCENE, "--out", "picture.png")
VERIFY = ("verify", SCENE)
GENERATE = ("generate", "--out", "new_model")

Words = tuple[str, ...]


def id_of(words: object) -> str:
    return " ".join(words) if isinstance(words, tuple) else str(words)


# --- Old words -----------------------------------------------------------------------------------

OLD_VERBS = {"continuity": "smoothness", "destep": "smooth-table", "thorax": "fit-thorax"}

# A command, an old option with its value, and the option's new name.
OLD_OPTIONS = [
    (("simulate", SCENE), ("--raise", "0:150"), "--elevation"),
    (("simulate", SCENE), ("--motion", "motion.csv"), "--in"),
    (RAISE, ("--trace", "joints.csv"), "--out"),
    (RAISE, ("--controls", "controls.csv"), "--out-controls"),
    (RAISE, ("--picture", "last.png"), "--out-picture"),
    (RAISE, ("--video", "motion.mp4"), "--out-video"),
    (POSE, ("--rates",), "--derivatives"),
    (("solve",), ("--pose", "relaxed"), "--posture"),
    ((*POSE, "--landmarks"), ("--thorax", "thorax.csv"), "--ellipsoids"),
    (GENERATE, ("--thorax", "thorax.csv"), "--ellipsoids"),
    (VERIFY, ("--thorax", "thorax.csv"), "--ellipsoids"),
    (("fit-thorax",), ("--thorax", "thorax.csv"), "--ellipsoids"),
]


@pytest.mark.parametrize(("old", "new"), OLD_VERBS.items())
def test_an_old_verb_is_told_its_new_name(refuses: Refuses, old: str, new: str) -> None:
    because = (rf"^girdle: girdle {old} is now called girdle {new}$",)
    for words in ((old,), (old, "--help"), (old, "--in", "table.csv"), ("help", old)):
        refuses(*words, because=because)


@pytest.mark.parametrize(("command", "option", "new"), OLD_OPTIONS, ids=id_of)
def test_an_old_option_is_told_its_new_name(
    refuses: Refuses, generated: Path, command: Words, option: Words, new: str
) -> None:
    because = (rf"^girdle: {option[0]}: is now called {new} in girdle {command[0]}$",)
    words = with_scene(command, generated)
    refuses(*words, *option, because=because)
    refuses(*words, "=".join(option), because=because)


@pytest.mark.parametrize(("command", "option", "new"), OLD_OPTIONS, ids=id_of)
def test_the_new_name_is_an_option_of_the_verb(
    girdle_fine: Girdle, command: Words, option: Words, new: str
) -> None:
    text = girdle_fine(command[0], "--help").text
    assert re.search(rf"^  {new}\b(?!-)", text, re.MULTILINE)
    assert not re.search(rf"^  {option[0]}\b(?!-)", text, re.MULTILINE)


def test_the_commands_for_how_fast_a_model_moves_keep_their_name(girdle_fine: Girdle) -> None:
    """`generate --rates` is another thing than `solve --rates` was."""
    assert girdle_fine(*GENERATE, "--rates").code == 0


@pytest.mark.parametrize(
    "command",
    [POSE, GENERATE, RAISE, VERIFY, ("compare",), ("smoothness",), ("fit-thorax",)],
    ids=id_of,
)
def test_the_old_name_of_the_smoothed_table_is_told_its_new_one(
    refuses: Refuses, generated: Path, command: Words
) -> None:
    because = ("--table destepped: the table destepped is now called smoothed",)
    refuses(*with_scene(command, generated), "--table", "destepped", because=because)


def test_the_old_name_of_the_hanging_keyframe_is_told_its_new_one(refuses: Refuses, generated: Path) -> None:
    because = ('no keyframe "rest"', "The keyframe rest is now called hanging")
    refuses(*with_scene(RENDER, generated), "--keyframe", "rest", because=because)


# --- Slips ---------------------------------------------------------------------------------------

SLIPS_OF_VERBS = {
    "slove": "solve",
    "sovle": "solve",
    "simulte": "simulate",
    "Verify": "verify",
    "generat": "generate",
    "smoothnes": "smoothness",
    "smooth_table": "smooth-table",
    "fitthorax": "fit-thorax",
    "docter": "doctor",
}

SLIPS_OF_OPTIONS = [
    (("solve", "--plane", "50"), ("--elevaton", "60"), "--elevation"),
    (("solve", "--elevation", "60"), ("--plnae", "50"), "--plane"),
    (POSE, ("--landmark",), "--landmarks"),
    (POSE, ("--derivative",), "--derivatives"),
    (POSE, ("--relative", "hanging"), "--relative-to"),
    (RAISE, ("--out-contols", "controls.csv"), "--out-controls"),
    (RENDER, ("--keyfrme", "hanging"), "--keyframe"),
    (VERIFY, ("--ful",), "--full"),
    (GENERATE, ("--assembley", "loop"), "--assembly"),
]

# A command, an option with a slip of one of its words, and the word.
SLIPS_OF_WORDS = [
    (POSE, ("--interpolation", "smoth"), "smooth"),
    (POSE, ("--interpolation", "SQUAD"), "squad"),
    (POSE, ("--closure", "exakt"), "exact"),
    (POSE, ("--range", "hole"), "whole"),
    (POSE, ("--as", "quaternion"), "quaternions"),
    ((*POSE, "--axial", "5"), ("--axial-from", "swign"), "swing"),
    (GENERATE, ("--side", "rigth"), "right"),
    (GENERATE, ("--assembly", "lop"), "loop"),
    (GENERATE, ("--actuation", "positon"), "position"),
    (VERIFY, ("--girdle", "frozn"), "frozen"),
]


@pytest.mark.parametrize(("typed", "meant"), SLIPS_OF_VERBS.items())
def test_a_slip_of_a_verb_is_told_what_is_meant(refuses: Refuses, typed: str, meant: str) -> None:
    because = (f"'{typed}' is not a verb", rf"Did you mean '{meant}'\?", *VERBS)
    refuses(typed, *POSE[1:], because=because)
    refuses("help", typed, because=because)


@pytest.mark.parametrize(("command", "option", "meant"), SLIPS_OF_OPTIONS, ids=id_of)
def test_a_slip_of_an_option_is_told_what_is_meant(
    refuses: Refuses, generated: Path, command: Words, option: Words, meant: str
) -> None:
    verb = command[0]
    because = (
        f"^girdle: {option[0]}: girdle {verb} has no such option",
        rf"Did you mean '{meant}'\?",
        f"See girdle {verb} --help",
    )
    words = with_scene(command, generated)
    refuses(*words, *option, because=because)
    refuses(*words, "=".join(option), because=because)


@pytest.mark.parametrize(("command", "option", "meant"), SLIPS_OF_WORDS, ids=id_of)
def test_a_slip_of_a_word_is_told_what_is_meant(
    refuses: Refuses, generated: Path, command: Words, option: Words, meant: str
) -> None:
    because = (
        f"{' '.join(option)}: not known",
        rf"Did you mean '{meant}'\?",
        rf"Choose one of: .*\b{meant}\b",
    )
    refuses(*with_scene(command, generated), *option, because=because)


@pytest.mark.parametrize(("typed", "meant"), [("smothed", "smoothed"), ("mesured", "measured")])
def test_a_slip_of_a_table_is_told_what_is_meant(refuses: Refuses, typed: str, meant: str) -> None:
    because = (f"--table {typed}: there is no such file", rf"Did you mean the table {meant}\?")
    refuses(*POSE, "--table", typed, because=because)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("hangin", "hanging"), ("relaxd", "relaxed"), ("flexion90", "flexion_90")],
)
def test_a_slip_of_a_keyframe_is_told_what_is_meant(
    refuses: Refuses, generated: Path, typed: str, meant: str
) -> None:
    because = (f'no keyframe "{typed}"', rf"Did you mean '{meant}'\?", "Choose one of: hanging")
    refuses(*with_scene(RENDER, generated), "--keyframe", typed, because=because)


@pytest.mark.parametrize(
    ("words", "because"),
    [
        (("unlike", *POSE[1:]), ("'unlike' is not a verb", *VERBS)),
        ((*POSE, "--unlike"), ("--unlike: girdle solve has no such option",)),
        ((*POSE, "--closure", "unlike"), ("Choose one of: exact, table",)),
        ((*POSE, "--table", "unlike.csv"), ("unlike.csv: ",)),
    ],
    ids=id_of,
)
def test_nothing_is_guessed_for_a_word_that_is_like_no_other(
    refuses: Refuses, words: Words, because: Words
) -> None:
    assert "Did you mean" not in refuses(*words, because=because)


# --- Options of other verbs ----------------------------------------------------------------------

ELSEWHERE = [
    (POSE, ("--keyframe", "hanging"), ("girdle render",)),
    (POSE, ("--skin", "implicit"), ("girdle generate", "girdle smoothness")),
    (POSE, ("--out-video", "motion.mp4"), ("girdle simulate",)),
    (RENDER, ("--digits", "3"), ("girdle solve",)),
    (GENERATE, ("--seconds", "2"), ("girdle simulate",)),
    (RAISE, ("--mapping", "arm.csv"), ("girdle verify",)),
    (("doctor",), ("--full",), ("girdle verify",)),
]


@pytest.mark.parametrize(("command", "option", "owners"), ELSEWHERE, ids=id_of)
def test_an_option_of_another_verb_is_told_where_it_belongs(
    refuses: Refuses, generated: Path, command: Words, option: Words, owners: Words
) -> None:
    because = (
        f"^girdle: {option[0]}: girdle {command[0]} has no such option",
        rf"It belongs to {', '.join(owners)}\. ",
    )
    refuses(*with_scene(command, generated), *option, because=because)


# --- Empty words ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "place"),
    [
        (("",), "the first word"),
        (("solve", ""), "solve"),
        (("solve", "--elevation", "", "--plane", "50"), "--elevation"),
        (("solve", "--elevation=", "--plane", "50"), "--elevation"),
        ((*POSE, "--out", ""), "--out"),
        ((*POSE, ""), "50"),
        (("verify", ""), "verify"),
        (("help", ""), ""),
    ],
    ids=repr,
)
def test_an_empty_word_is_refused_with_its_place(refuses: Refuses, words: Words, place: str) -> None:
    """As it comes from a shell variable that is not set."""
    refuses(*words, because=(f"^girdle: {place}.*'': is empty", "Give it a value or omit it"))


# --- Values --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "because"),
    [
        ((*POSE, "--digits"), "--digits: has no value. Write it as --digits N"),
        (("solve", "--plane", "40", "--elevation"), "--elevation: has no value. Write it as --elevation DEG"),
        (
            (*POSE, "--out", "-x.csv"),
            "--out: has no value, because '-x.csv' is read as an option. Write "
            "--out=-x.csv if it is the value",
        ),
        (
            (*POSE, "--out", "--json"),
            "--out: has no value, because the option --json follows. Write it as --out FILE",
        ),
        (
            ("solve", "-elevation", "90"),
            "-elevation: options begin with two dashes. Did you mean '--elevation'?",
        ),
        ((*POSE, "-p", "3"), "-p: options begin with two dashes. See girdle solve --help"),
        ((*POSE, "--json", "yes"), "'yes': belongs to no option, and girdle solve takes no word alone. See"),
        (("simulate", "a.xml", "b.csv"), "takes only 1 word alone. If it is a file, write --in b.csv. See"),
        (("solve", "90", "40"), "'90': belongs to no option, and girdle solve takes no word alone. See"),
        (
            ("-version",),
            "-version: options begin with two dashes. Did you mean '--version'? See girdle --help",
        ),
        (("--version=1",), "--version: takes no value"),
        (("--hlep",), "--hlep: girdle has no such option. Did you mean '--help'?"),
        (("solve", "trial.csv"), "If it is a file, write --in trial.csv."),
        ((*POSE, "--digits", "3", "--digits=4"), "--digits: is given twice. Omit one of them"),
        ((*POSE, "--json", "--json"), "--json: is given twice"),
        ((*POSE, "--json=yes"), "--json: takes no value. Write --json alone, or omit it"),
        (
            (*POSE, "flexion"),
            "'flexion': belongs to no option, and girdle solve takes no word alone. See girdle solve --help",
        ),
        (
            ("verify", "a.xml", "b.xml"),
            "'b.xml': belongs to no option, and girdle verify takes only 1 word alone. See",
        ),
    ],
    ids=repr,
)
def test_a_word_in_a_wrong_place_is_refused(refuses: Refuses, words: Words, because: str) -> None:
    refuses(*words, because=(("^girdle: " if because[0] in "-'" else "") + re.escape(because),))


@pytest.mark.parametrize(
    "words",
    [
        *((("solve", "--help", "--elevation")), ("solve", "trial.csv", "--help"), ("solve", "-h", "-h")),
        *((("help", "--help")), ("help", "-h"), ("-h",)),
    ],
    ids=" ".join,
)
def test_who_asks_for_help_gets_it(girdle_fine: Girdle, words: Words) -> None:
    assert "\nUsage: girdle" in girdle_fine(*words).text


def test_values_may_begin_with_a_minus(girdle_fine: Girdle, tmp_path: Path) -> None:
    pose = ("solve", "--elevation", "60", "--plane", "-40")
    assert girdle_fine(*pose).text == girdle_fine(*pose, "--axial", "-.0", "--out", "-").text
    girdle_fine(*pose, "--out=-x.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["-x.csv"]


# --- Help ----------------------------------------------------------------------------------------

PIPED_COLUMNS = 80
NARROW_COLUMNS = 60
WIDE_COLUMNS = 200

# Whatever `--help` may stand behind.
every_help = pytest.mark.parametrize("words", [(), *((verb,) for verb in VERBS)], ids=repr)


def test_these_are_all_verbs(girdle_fine: Girdle) -> None:
    lines = girdle_fine("--help").text.partition("\nVerbs:\n")[2].partition("\n\n")[0]
    assert sorted(re.findall(r"^  (\S+)", lines, re.MULTILINE)) == sorted(VERBS)


@every_verb
def test_help_may_stand_before_the_verb(girdle_fine: Girdle, verb: str) -> None:
    expected = girdle_fine(verb, "--help").text
    assert expected.partition("\nUsage: ")[2].startswith(f"girdle {verb} ")
    assert girdle_fine("help", verb).text == expected


def test_help_alone_is_that_of_the_program(girdle_fine: Girdle) -> None:
    assert girdle_fine("help").text == girdle_fine("--help").text


@every_help
def test_no_line_of_the_help_is_longer_than_a_screen(girdle_fine: Girdle, words: Words) -> None:
    lines = girdle_fine(*words, "--help").text.splitlines()
    assert [line for line in lines if len(line) > PIPED_COLUMNS] == []


def help_on_terminal(program: Path, folder: Path, words: Words, columns: int) -> list[str]:
    seen = run_on_terminal([str(program), *words, "--help"], folder, columns=columns)
    assert seen.code == 0
    return seen.lines


@every_help
def test_the_help_fits_a_narrow_terminal(program: Path, tmp_path: Path, words: Words) -> None:
    lines = help_on_terminal(program, tmp_path, words, NARROW_COLUMNS)
    assert [line for line in lines if len(line) > NARROW_COLUMNS] == []


@every_help
def test_the_help_makes_use_of_a_wide_terminal(program: Path, tmp_path: Path, words: Words) -> None:
    lines = help_on_terminal(program, tmp_path, words, WIDE_COLUMNS)
    assert PIPED_COLUMNS < max(map(len, lines)) <= WIDE_COLUMNS


def without_line_ends(text: str) -> list[str]:
    """The words of a help; an example that is broken has backslashes where it is."""
    return text.replace(" \\\n", " ").split()


def test_an_example_of_the_help_is_broken_as_a_shell_allows(program: Path, tmp_path: Path) -> None:
    lines = help_on_terminal(program, tmp_path, ("solve",), NARROW_COLUMNS)
    broken = [line for line in lines if line.endswith(" \\")]
    assert broken
    assert all(line.startswith("  girdle solve ") for line in broken)


@every_help
def test_no_word_of_the_help_is_cut(girdle_fine: Girdle, program: Path, tmp_path: Path, words: Words) -> None:
    """Where lines end depends on the terminal, what they say does not."""
    expected = without_line_ends(girdle_fine(*words, "--help").text)
    for columns in (NARROW_COLUMNS, WIDE_COLUMNS):
        lines = help_on_terminal(program, tmp_path, words, columns)
        assert without_line_ends("\n".join(lines)) == expected
