# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The summary that `girdle verify` prints says in a few lines what its JSON says in many."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from conftest import ABOVE_TOLERANCE, SCENE_FILE, Finished, Girdle, Refuses
from pseudo_terminal import run_on_terminal
from shared_results import SharedResults

MODELS = Path(__file__).resolve().parents[2] / "model"
SCENES = sorted(MODELS.glob("*/scene*.xml"))
every_scene = pytest.mark.parametrize("scene", SCENES, ids=lambda path: f"{path.parent.name}/{path.stem}")

MOST_LINES = 25
PIPED_COLUMNS = 80

# Numbers are written with three digits.
DIGITS = 3

Residual = dict[str, Any]

# A model that passes, and two that fail: by its bones and by what it does to the skin.
TREE = MODELS / "shoulder_tree" / SCENE_FILE
SKIN = MODELS / "shoulder_skin" / SCENE_FILE
FAILING: dict[str, tuple[Path, tuple[str, ...]]] = {
    "another stature": (TREE, ("--stature", "1.85")),
    "another stature of both sides": (TREE.with_name("scene_both.xml"), ("--stature", "1.5")),
    "a frozen skin": (SKIN, ("--girdle", "frozen")),
}
every_failure = pytest.mark.parametrize(("scene", "options"), FAILING.values(), ids=FAILING.keys())


def residuals_of(shared: SharedResults, scene: Path, *options: str) -> list[Residual]:
    residuals: list[Residual] = shared.verify(scene, *options).answer["residuals"]
    return residuals


def written(number: float) -> str:
    """As the reports write numbers: with three digits, and none to spare."""
    return f"{number:.{DIGITS}g}"


def checked(residuals: list[Residual]) -> list[Residual]:
    return [residual for residual in residuals if residual["tolerance"] is not None]


def failed(residuals: list[Residual]) -> list[Residual]:
    return [residual for residual in residuals if not residual["passed"]]


def verdict_of(residuals: list[Residual]) -> str:
    """What the first and the last line of a verdict have to say."""
    count, bad = len(checked(residuals)), len(failed(residuals))
    if not bad:
        return f"PASS: {count} residuals checked, all within their tolerances"
    tolerances = "its tolerance" if bad == 1 else "their tolerances"
    return f"FAIL: {bad} of {count} residuals outside {tolerances}"


def expect_verdict(lines: list[str], residuals: list[Residual]) -> None:
    """It is printed twice: behind what the report is about, and at the end."""
    verdicts = [line for line in lines if re.match("(PASS|FAIL): ", line)]
    assert verdicts == 2 * [verdict_of(residuals)]
    assert lines[-1] == verdicts[1]
    # Model, kind, rhythm and engine, each of them in several lines if it is long.
    head = lines[: lines.index(verdicts[0])]
    assert [line.split()[0] for line in head if line and line[0] != " "] == (
        ["model", "kind", "rhythm", "engine"]
    )
    assert head[-1] == ""


# --- The table of kinds --------------------------------------------------------------------------


def rows_of(text: str) -> dict[str, dict[str, str]]:
    """The rows of the table by their kind: what stands below each heading."""
    lines = text.splitlines()
    (top,) = (i for i, line in enumerate(lines) if re.match("kind +worst ", line))
    heading = lines[top]
    rows = {}
    for line in lines[top + 1 : lines.index("", top)]:
        found = re.fullmatch(
            r"(?P<kind>\S+(?: \S+)*?)  +(?P<worst>\S+ \S.*?)  (?P<tolerance>(?:<= |> |no )\S+)"
            r"  +(?P<checked>\d+)(?:, (?P<failed>\d+) FAIL)?(?:  +(?P<where>.*))?",
            line,
        )
        assert found, line
        # Numbers end where their heading ends, words begin where it begins.
        assert found.end("worst") == heading.index("worst") + len("worst"), line
        assert found.start("tolerance") == heading.index("required"), line
        assert found.start("checked") == heading.index("checked"), line
        rows[found["kind"]] = {name: text or "" for name, text in found.groupdict().items()}
    return rows


def share(residual: Residual) -> float:
    """How much of its tolerance a residual takes: 1 at the tolerance, more beyond it."""
    value, tolerance = residual["value"], residual["tolerance"]
    if residual["bound"] == "at most":
        return value / tolerance
    return tolerance / value if value > 0 else float("inf")


def tolerance_text(residual: Residual) -> str:
    """What a row of the full report has as tolerance."""
    if residual["tolerance"] is None:
        return "-"
    return ("" if residual["bound"] == "at most" else "> ") + written(residual["tolerance"])


def limit_text(residual: Residual) -> str:
    """What a row of the summary's table has as tolerance."""
    if residual["tolerance"] is None:
        return "no limit"
    return ("<= " if residual["bound"] == "at most" else "> ") + written(residual["tolerance"])


def place_text(where: str) -> str:
    """A pose is short in the table: `flexion 120.1/90` for `flexion, elevation 120.1, plane 90`."""
    return re.sub(r",? ?elevation (.+?), plane ", r" \1/", where).strip()


def room_for_places(text: str) -> int:
    """Columns of a table behind its other columns; 0 if it has no places."""
    (heading,) = (line for line in text.splitlines() if re.match("kind +worst ", line))
    start = heading.find("at elevation/plane")
    return PIPED_COLUMNS - start if start >= 0 else 0


def place_within(room: int, where: str) -> str:
    """How a place stands in the table: whole, or where there is no room its direction alone."""
    whole = place_text(where)
    direction = whole.rsplit(" ", 1)[-1] if whole != where else ""
    return next((place for place in (whole, direction) if len(place) <= room), "")


def expect_worst(text: str, residuals: list[Residual]) -> None:
    """Each row is the residual that comes nearest to its tolerance, or exceeds it most."""
    rows, room = rows_of(text), room_for_places(text)
    kinds = list(dict.fromkeys(residual["group"] for residual in residuals))
    assert list(rows) == kinds
    for kind, row in rows.items():
        of_kind = [residual for residual in residuals if residual["group"] == kind]
        with_tolerance = checked(of_kind)
        assert row["checked"] == str(len(with_tolerance)), kind
        assert row["failed"] == (str(len(failed(of_kind))) if failed(of_kind) else ""), kind
        worst = max(map(share, with_tolerance), default=0)
        # Several are equally bad where they are 0, or worse than any number can tell.
        shown = [r for r in with_tolerance if share(r) == worst] or of_kind[:1]
        expected = {
            (f"{written(r['value'])} {r['unit']}", limit_text(r), place_within(room, r["where"]))
            for r in shown
        }
        assert (row["worst"], row["tolerance"], row["where"]) in expected, kind


# --- Sound models --------------------------------------------------------------------------------


@every_scene
def test_the_summary_of_a_sound_model_says_what_its_json_says(
    girdle_fine: Girdle, shared: SharedResults, tmp_path: Path, scene: Path
) -> None:
    residuals = residuals_of(shared, scene)
    # A short name, as in a checkout.
    (tmp_path / "model").symlink_to(scene.parent)
    text = girdle_fine("verify", f"model/{scene.name}").text
    lines = text.splitlines()
    assert len(lines) <= MOST_LINES
    assert [line for line in lines if len(line) > PIPED_COLUMNS] == []
    assert text.endswith("\n")
    assert verdict_of(residuals).startswith("PASS: ")
    expect_verdict(lines, residuals)
    expect_worst(text, residuals)
    stated = len(residuals) - len(checked(residuals))
    assert lines[-2] == (f"girdle verify --full shows every residual. {stated} values have no tolerance.")


@pytest.mark.parametrize("stature", ["1.6", "1.9"])
def test_the_summary_of_a_generated_model_cuts_nothing(
    girdle_fine: Girdle, shared: SharedResults, stature: str
) -> None:
    """Bones of its own, on both sides: the longest places."""
    made = shared.generate("--side", "both", "--stature", stature)
    text = girdle_fine("verify", made.scene).text
    assert [line for line in text.splitlines()[1:] if len(line) > PIPED_COLUMNS] == []
    assert "bones of its own" in text
    assert "..." not in "".join(text.splitlines(keepends=True)[1:])
    expect_worst(text, shared.verify(made.scene).answer["residuals"])


# --- Models that fail ----------------------------------------------------------------------------


def summary_of_failing(girdle: Girdle, scene: Path, options: tuple[str, ...]) -> Finished:
    finished = girdle("verify", scene, *options)
    assert (finished.code, finished.message) == (ABOVE_TOLERANCE, "")
    return finished


def failures_of(text: str) -> list[str]:
    """Each failure in one line, however many it takes in the summary."""
    blocks = re.findall(r"^FAIL +.*(?:\n     .*)*", text, re.MULTILINE)
    return [" ".join(block.split()) for block in blocks]


@every_failure
def test_every_failed_residual_is_named_in_full(
    girdle: Girdle, shared: SharedResults, scene: Path, options: tuple[str, ...]
) -> None:
    residuals = residuals_of(shared, scene, *options)
    bad = failed(residuals)
    assert len(bad) > 1
    text = summary_of_failing(girdle, scene, options).text
    limits = {"at most": "must be at most", "more than": "must be more than"}
    assert failures_of(text) == [
        f"FAIL {r['group']}, {r['item']}: {written(r['value'])} {r['unit']}, {limits[r['bound']]} "
        f"{written(r['tolerance'])} {r['unit']}" + (f" ({r['where']})" if r["where"] else "")
        for r in bad
    ]


@every_failure
def test_the_summary_of_a_model_that_fails_has_the_same_form(
    girdle: Girdle, shared: SharedResults, scene: Path, options: tuple[str, ...]
) -> None:
    residuals = residuals_of(shared, scene, *options)
    text = summary_of_failing(girdle, scene, options).text
    expect_verdict(text.splitlines(), residuals)
    expect_worst(text, residuals)
    folder = f"{scene.parent}/"
    too_long = [line for line in text.splitlines() if len(line) > PIPED_COLUMNS]
    assert [line for line in too_long if folder not in line] == []


def test_a_model_of_another_person_is_told_apart_from_a_broken_one(
    girdle: Girdle, shared: SharedResults
) -> None:
    answers = {words: shared.verify(TREE, *words).answer for words in ((), ("--stature", "1.85"))}
    assert answers[()]["remark"] == ""
    remark = answers["--stature", "1.85"]["remark"]
    assert "generated with another anatomy than --anatomy" in remark
    text = summary_of_failing(girdle, TREE, ("--stature", "1.85")).text
    assert remark in " ".join(text.split())
    assert remark in girdle("verify", TREE, "--stature", "1.85", "--full").text.splitlines()
    assert "bones as given" in text


# --- All residuals -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("scene", "options"),
    [*FAILING.values(), (TREE, ()), (SKIN, ()), (MODELS / "shoulder_loop" / "scene_both.xml", ())],
    ids=[*FAILING.keys(), "tree", "skin", "loop"],
)
def test_the_full_report_has_one_line_a_residual_in_a_pipe(
    girdle: Girdle, shared: SharedResults, scene: Path, options: tuple[str, ...]
) -> None:
    residuals = residuals_of(shared, scene, *options)
    lines = girdle("verify", scene, *options, "--full").text.splitlines()
    assert lines[-1] == verdict_of(residuals)
    (top,) = (i for i, line in enumerate(lines) if line.startswith("residual "))
    table = lines[top + 1 : lines.index("", top)]
    assert [re.split("  +", line) for line in table] == [
        [
            residual["group"],
            residual["item"],
            written(residual["value"]),
            tolerance_text(residual),
            residual["unit"],
            result_of(residual),
            *filter(None, [residual["where"]]),
        ]
        for residual in residuals
    ]


def result_of(residual: Residual) -> str:
    if residual["follows"]:
        return "follows"
    if residual["tolerance"] is None:
        return "stated"
    return "pass" if residual["passed"] else "FAIL"


@pytest.mark.parametrize("columns", [80, 120])
@pytest.mark.parametrize("scene", [TREE, SKIN, TREE.with_name("scene_both_position.xml")], ids=str)
def test_the_full_report_fits_the_terminal(
    program: Path, shared: SharedResults, scene: Path, columns: int
) -> None:
    place = scene.relative_to(MODELS.parent)
    lines = run_on_terminal(
        [str(program), "verify", str(place), "--full"],
        MODELS.parent,
        columns=columns,
        variables={"NO_COLOR": "1"},
        messages=False,
    ).lines
    assert [line for line in lines if len(line) > columns] == []
    words = " ".join(lines)
    residuals = residuals_of(shared, scene)
    for residual in residuals:
        number = re.escape(written(residual["value"]))
        item = re.escape(residual["item"])
        where = re.escape(residual["where"])
        # The pose stands behind the result, or on a line of its own.
        tolerance, unit = re.escape(tolerance_text(residual)), re.escape(residual["unit"])
        line = rf" {item} +{number} +{tolerance} +{unit} +{result_of(residual)} *{where}"
        assert re.search(line, words), residual
    assert lines[-2:] == [verdict_of(residuals), ""]


def test_all_lines_as_a_table_and_as_json_exclude_each_other(refuses: Refuses) -> None:
    refuses("verify", TREE, "--full", "--json", because=("--full", "--json", "Omit --full"))


# --- Colour --------------------------------------------------------------------------------------

ESCAPE = "\x1b"
GREEN, RED, PLAIN = "\x1b[32m", "\x1b[31m", "\x1b[0m"
every_form = pytest.mark.parametrize("form", [(), ("--full",)], ids=["summary", "full"])


def on_terminal(program: Path, *words: str, **variables: str) -> str:
    command = [str(program), "verify", str(TREE), *words]
    return run_on_terminal(
        command, MODELS, columns=PIPED_COLUMNS, variables=variables, messages=False
    ).written.replace("\r\n", "\n")


@every_form
@pytest.mark.parametrize(
    ("options", "colour"), [((), GREEN), (("--stature", "1.85"), RED)], ids=["sound", "failing"]
)
def test_the_verdict_has_a_colour_on_a_terminal(
    program: Path, form: tuple[str, ...], options: tuple[str, ...], colour: str
) -> None:
    text = on_terminal(program, *form, *options)
    assert re.search(rf"{re.escape(colour)}(PASS|FAIL): .*{re.escape(PLAIN)}\n$", text)
    # Every colour ends, and no other is there.
    escapes = re.findall(r"\x1b\[\d*m|\x1b", text)
    assert escapes == [colour, PLAIN] * (len(escapes) // 2)


@every_form
@pytest.mark.parametrize("options", [(), ("--stature", "1.85")], ids=["sound", "failing"])
@pytest.mark.parametrize("variables", [{"NO_COLOR": "1"}, {"TERM": "dumb"}], ids=str)
def test_a_terminal_that_wants_no_colour_gets_none(
    program: Path, form: tuple[str, ...], options: tuple[str, ...], variables: dict[str, str]
) -> None:
    coloured = on_terminal(program, *form, *options)
    plain = on_terminal(program, *form, *options, **variables)
    assert ESCAPE not in plain
    assert re.sub(r"\x1b\[\d*m", "", coloured) == plain


@every_form
@pytest.mark.parametrize("options", [(), ("--stature", "1.85")], ids=["sound", "failing"])
def test_there_is_no_colour_in_a_pipe(
    girdle: Girdle, form: tuple[str, ...], options: tuple[str, ...]
) -> None:
    text = girdle("verify", TREE, *form, *options).text
    assert text.endswith(("tolerances\n", "tolerance\n"))
    assert ESCAPE not in text


def test_a_summary_that_goes_to_a_file_has_no_colour_though_messages_go_to_a_terminal(
    program: Path, tmp_path: Path
) -> None:
    command = [str(program), "verify", str(TREE)]
    run_on_terminal(command, tmp_path, output=tmp_path / "report.txt", columns=PIPED_COLUMNS)
    assert (tmp_path / "report.txt").read_text().startswith("model ")
    assert ESCAPE not in (tmp_path / "report.txt").read_text()
