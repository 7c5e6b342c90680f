# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Whose shoulder it is, as a person types it: measures and landmarks, in `generate` and `verify`."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import (
    ABOVE_TOLERANCE,
    MODEL_FILE,
    SCENE_FILE,
    Girdle,
    Refuses,
    contents,
    find_element,
    remove_element,
)

DATA = Path(__file__).resolve().parents[2] / "data"
EXAMPLE = DATA / "example_lab_landmarks.csv"
LANDMARKS = DATA / "landmarks.csv"

# Lengths to and from text.
ROUNDING_M = 1e-12
# The example is written to a micrometer, by which its frames turn a little.
EXAMPLE_M = 5e-6

# What the built-in shoulder is as tall as, by its README.
ADULT_STATURE_M = 1.71

Options = tuple[str, ...]
PEOPLE: list[Options] = [
    ("--stature", "1.85"),
    ("--stature", "1.5", "--body-mass", "48"),
    ("--humerus-length", "0.33"),
    ("--clavicle-length", "0.14", "--scapula-length", "0.12", "--stature", "1.6"),
    ("--anatomy", str(EXAMPLE)),
    ("--anatomy", str(EXAMPLE), "--body-mass", "90", "--stature", "1.8"),
]


def words(options: Options) -> str:
    return " ".join(options).replace(f"{DATA}/", "") or "nothing"


every_person = pytest.mark.parametrize("options", PEOPLE, ids=words)


def generated_model(girdle_fine: Girdle, tmp_path: Path, *options: str) -> ElementTree.Element:
    girdle_fine("generate", "--out", "model", *options)
    return ElementTree.parse(tmp_path / "model" / MODEL_FILE).getroot()


def site_m(model: ElementTree.Element, name: str) -> list[float]:
    position = find_element(model, f".//site[@name='{name}']").get("pos", "0 0 0")
    return [float(x) for x in position.split()]


def site_names(model: ElementTree.Element) -> list[str]:
    names = [site.get("name", "") for site in model.findall("worldbody//site")]
    assert len(names) > 15
    return names


def mass_kg(model: ElementTree.Element, body: str) -> float:
    return float(find_element(model, f".//body[@name='{body}']/inertial").get("mass", ""))


# --- Measures and files that are right -----------------------------------------------------------


@every_person
def test_a_model_verifies_as_the_person_it_was_made_for(girdle_fine: Girdle, options: Options) -> None:
    girdle_fine("generate", "--out", "model", *options)
    answer = json.loads(girdle_fine("verify", f"model/{SCENE_FILE}", "--json", *options).text)
    assert answer["passed"]


@pytest.mark.parametrize(
    "kind",
    [
        ("--assembly", "loop"),
        ("--assembly", "loop", "--lead", "scapula"),
        ("--side", "left"),
        ("--side", "both"),
        ("--actuation", "position"),
    ],
    ids=words,
)
@pytest.mark.parametrize(
    "person",
    [("--stature", "1.5"), ("--humerus-length", "0.33", "--clavicle-length", "0.14")],
    ids=words,
)
def test_every_kind_of_model_has_the_bones_of_its_person(
    girdle_fine: Girdle, tmp_path: Path, kind: Options, person: Options
) -> None:
    girdle_fine("generate", "--out", "model", *kind, *person)
    (scene,) = (tmp_path / "model").glob("scene*.xml")
    assert json.loads(girdle_fine("verify", scene, "--json", *person).text)["passed"]


@pytest.mark.parametrize(
    ("made_for", "held_against"),
    [
        (("--humerus-length", "0.33"), ("--stature", str(ADULT_STATURE_M))),
        ((), ("--humerus-length", "0.33")),
        (("--humerus-length", "0.33"), ("--humerus-length", "0.3301")),
        ((), ("--body-mass", "70")),
    ],
    ids=["of the adult", "of another", "of one 0.1 mm off", "of another mass"],
)
def test_a_model_has_no_other_persons_bones(
    girdle: Girdle, girdle_fine: Girdle, made_for: Options, held_against: Options
) -> None:
    girdle_fine("generate", "--out", "model", *made_for)
    finished = girdle("verify", f"model/{SCENE_FILE}", "--json", *held_against)
    assert (finished.code, finished.message) == (ABOVE_TOLERANCE, "")
    answer = json.loads(finished.text)
    failed = [line for line in answer["residuals"] if not line["passed"]]
    assert {line["group"] for line in failed} == {"bones"}
    assert answer["remark"] != ""


@every_person
def test_a_model_carries_the_person_it_was_made_for(girdle_fine: Girdle, options: Options) -> None:
    """`verify` needs not be told of whom the bones are, and has nothing to remark."""
    girdle_fine("generate", "--out", "model", *options)
    alone = json.loads(girdle_fine("verify", f"model/{SCENE_FILE}", "--json").text)
    told = json.loads(girdle_fine("verify", f"model/{SCENE_FILE}", "--json", *options).text)
    assert (alone["passed"], alone["remark"]) == (True, "")
    assert alone == told


def carried_anatomy(model: ElementTree.Element) -> dict[str, str]:
    """The anatomy that a model carries: what each entry says by its name."""
    (text,) = model.findall("custom/text[@name='girdle_anatomy']")
    entries = [entry.partition(" ") for entry in text.get("data", "").split("; ")]
    return {name: numbers for name, _, numbers in entries}


def test_the_shipped_landmarks_give_the_built_in_model(
    girdle_fine: Girdle, generated: Path, tmp_path: Path
) -> None:
    """But for the ellipsoid, which is fitted to a person's bones, and how a stature scales them."""
    girdle_fine("generate", "--out", "model", "--anatomy", LANDMARKS)
    built_in, from_file = (
        ElementTree.parse(folder / MODEL_FILE).getroot() for folder in (generated, tmp_path / "model")
    )
    carried = carried_anatomy(built_in) | {
        name: numbers
        for name, numbers in carried_anatomy(from_file).items()
        if name in ("gliding", "adult_proportions")
    }
    assert carried_anatomy(from_file) == carried
    for model in (built_in, from_file):
        remove_element(model, ".//text[@name='girdle_anatomy']")
    assert ElementTree.tostring(from_file) == ElementTree.tostring(built_in)
    scenes = [(folder / SCENE_FILE).read_bytes() for folder in (generated, tmp_path / "model")]
    assert scenes[0] == scenes[1]


def test_the_adults_stature_gives_the_built_in_model(
    girdle_fine: Girdle, generated: Path, tmp_path: Path
) -> None:
    girdle_fine("generate", "--out", "model", "--stature", str(ADULT_STATURE_M))
    assert contents(tmp_path / "model") == contents(generated)


def test_the_example_gives_the_built_in_model_to_its_decimals(
    girdle_fine: Girdle, generated: Path, tmp_path: Path
) -> None:
    built_in = ElementTree.parse(generated / MODEL_FILE).getroot()
    example = generated_model(girdle_fine, tmp_path, "--anatomy", str(EXAMPLE))
    for name in site_names(built_in):
        assert site_m(example, name) == pytest.approx(site_m(built_in, name), abs=EXAMPLE_M), name


@pytest.mark.parametrize(
    ("option", "length_m", "ends"),
    [
        ("--clavicle-length", 0.14, [("PAC_r", 1.0)]),
        ("--scapula-length", 0.11, [("TS_r", 1.0)]),
        ("--humerus-length", 0.33, [("EM_r", 0.5), ("EL_r", 0.5)]),
    ],
)
def test_a_bone_has_the_length_that_is_given(
    girdle_fine: Girdle,
    tmp_path: Path,
    option: str,
    length_m: float,
    ends: list[tuple[str, float]],
) -> None:
    model = generated_model(girdle_fine, tmp_path, option, str(length_m), "--stature", "1.9")
    end_m = [sum(share * site_m(model, name)[k] for name, share in ends) for k in range(3)]
    assert math.hypot(*end_m) == pytest.approx(length_m, abs=ROUNDING_M)


def test_stature_moves_everything_in_proportion(girdle_fine: Girdle, generated: Path, tmp_path: Path) -> None:
    built_in = ElementTree.parse(generated / MODEL_FILE).getroot()
    tall = generated_model(girdle_fine, tmp_path, "--stature", str(1.2 * ADULT_STATURE_M))
    for name in site_names(built_in):
        expected_m = [1.2 * x for x in site_m(built_in, name)]
        assert site_m(tall, name) == pytest.approx(expected_m, abs=ROUNDING_M), name
    heights_m = [
        float(find_element(model, ".//body[@name='thorax']").get("pos", "").split()[2])
        for model in (built_in, tall)
    ]
    assert heights_m[1] == pytest.approx(1.2 * heights_m[0], abs=ROUNDING_M)


def test_stature_beside_a_file_raises_its_thorax_and_no_more(girdle_fine: Girdle, tmp_path: Path) -> None:
    model = generated_model(girdle_fine, tmp_path, "--anatomy", str(EXAMPLE), "--stature", "2")
    thorax = find_element(model, ".//body[@name='thorax']")
    assert float(thorax.get("pos", "").split()[2]) == pytest.approx(2 * 0.82)
    assert site_m(model, "PAC_r")[2] == pytest.approx(0.1575, abs=EXAMPLE_M)


@pytest.mark.parametrize("also", [(), ("--anatomy", str(EXAMPLE)), ("--stature", "1.5")], ids=words)
def test_the_upper_arm_has_its_share_of_the_body_mass(
    girdle_fine: Girdle, tmp_path: Path, also: Options
) -> None:
    model = generated_model(girdle_fine, tmp_path, "--body-mass", "90", *also)
    assert mass_kg(model, "humerus_r") == pytest.approx(0.028 * 90)
    # As in data/segments.csv.
    assert mass_kg(model, "thorax") / mass_kg(model, "humerus_r") == pytest.approx(20 / 2)


# --- Bad measures --------------------------------------------------------------------------------


BAD_MEASURES: list[tuple[Options, tuple[str, ...]]] = [
    (("--stature", "175"), ("--stature 175: not within", "not centimeters: 1.75")),
    (("--stature", "1750"), ("--stature 1750", "not millimeters: 1.75")),
    (("--stature", "0"), ("--stature 0: not within 0.5 to 2.8 m", "1.71")),
    (("--stature", "-1.8"), ("--stature -1.8: not within",)),
    (("--stature", "tall"), ("--stature 'tall': not a finite number", "--stature 1.71")),
    (("--stature", "nan"), ("--stature 'nan': not a finite number",)),
    (("--stature", "1.8m"), ("--stature '1.8m': not a finite number",)),
    (("--body-mass", "0"), ("--body-mass 0: not within 5 to 650 kg", "71 kg")),
    (("--body-mass", "-70"), ("--body-mass -70: not within",)),
    (("--body-mass", "70000"), ("not grams: 70",)),
    (("--body-mass", "inf"), ("--body-mass 'inf': not a finite number", "kilograms")),
    (("--clavicle-length", "157"), ("--clavicle-length 157", "not millimeters: 0.157")),
    (("--scapula-length", "12.9"), ("--scapula-length 12.9", "not centimeters: 0.129")),
    (("--humerus-length", "0"), ("--humerus-length 0: not within", "0.287")),
    (
        ("--anatomy", str(EXAMPLE), "--humerus-length", "0.3"),
        ("--anatomy", "lengths of the bones are those of its landmarks", "Leave out"),
    ),
    (("--anatomy", "nobody.csv"), ("nobody.csv: cannot be opened",)),
    (("--anatomy", "."), (r"\.: is a folder",)),
]


@pytest.mark.parametrize(
    ("options", "because"), BAD_MEASURES, ids=[words(options) for options, _ in BAD_MEASURES]
)
@pytest.mark.parametrize("verb", ["generate", "verify"])
def test_a_bad_measure_is_refused(
    refuses: Refuses, generated: Path, verb: str, options: Options, because: tuple[str, ...]
) -> None:
    command = {"generate": ("--out", "model"), "verify": (str(generated / SCENE_FILE),)}
    refuses(verb, *command[verb], *options, because=because)


# --- Bad files -----------------------------------------------------------------------------------

Rows = list[list[str]]


def swap_names(a: str, b: str) -> Callable[[Rows], None]:
    def change(rows: Rows) -> None:
        names = {a: b, b: a}
        for row in rows:
            row[0] = names.get(row[0], row[0])

    return change


def drop(name: str) -> Callable[[Rows], None]:
    def change(rows: Rows) -> None:
        rows[:] = [row for row in rows if row[0] != name]

    return change


def scale(factor: float) -> Callable[[Rows], None]:
    def change(rows: Rows) -> None:
        for row in rows[1:]:
            row[2:] = [repr(factor * float(x)) for x in row[2:]]

    return change


def mirror(rows: Rows) -> None:
    for row in rows[1:]:
        row[4] = repr(-float(row[4]))


def repeat(rows: Rows) -> None:
    rows.append(list(rows[-1]))


def move_to(name: str, other: str) -> Callable[[Rows], None]:
    """Gives a landmark the position of another."""

    def change(rows: Rows) -> None:
        by_name = {row[0]: row for row in rows}
        by_name[name][2:] = by_name[other][2:]

    return change


def one_of_the_left(rows: Rows) -> None:
    """Takes EL to the other arm: as far beyond IJ as it was before it, along the shoulders."""
    by_name = {row[0]: row for row in rows}
    ij, gh, el = ([float(x) for x in by_name[name][2:]] for name in ("IJ", "GH", "EL"))
    across = [gh[0] - ij[0], gh[1] - ij[1]]
    length = math.hypot(*across)
    off = sum(a * (e - i) for a, e, i in zip(across, el, ij, strict=False)) / length
    by_name["EL"][2:4] = [repr(e - 2 * off * a / length) for e, a in zip(el, across, strict=False)]


def head(points_mm: list[tuple[float, float, float]]) -> Callable[[Rows], None]:
    """Gives points of the humeral head, counted from GH, in place of GH."""

    def change(rows: Rows) -> None:
        gh = next(row for row in rows if row[0] == "GH")
        rows.remove(gh)
        for number, point_mm in enumerate(points_mm, start=1):
            point = [repr(float(g) + p / 1e3) for g, p in zip(gh[2:], point_mm, strict=True)]
            rows.append([f"HH{number}", "lab", *point])

    return change


PLANE_MM = [(24.0, 0.0, 5.0), (0.0, 24.0, 5.0), (-24.0, 0.0, 5.0), (0.0, -24.0, 5.0)]
HEAD_MM = [(24.0, 0.0, 0.0), (0.0, 24.0, 0.0), (0.0, 0.0, 24.0), (-24.0, 0.0, 0.0)]


def onto_line(rows: Rows) -> None:
    """Puts AI behind TS, as seen from AC."""
    by_name = {row[0]: row for row in rows}
    ac, ts = ([float(x) for x in by_name[name][2:]] for name in ("AC", "TS"))
    by_name["AI"][2:] = [repr(t + 0.8 * (t - a)) for a, t in zip(ac, ts, strict=True)]


# The example's header is line 9, IJ line 10, and so on.
@pytest.mark.parametrize(
    ("change", "because"),
    [
        (drop("AA"), ("mine.csv:21: no row for AA",)),
        (drop("AC"), ("mine.csv:21: no row for PAC \\(or AC\\)",)),
        (repeat, ("mine.csv:23: 'EL' stands in line 22 already", "Remove one")),
        (mirror, ("mine.csv:14: .*left shoulder", "negate z_m")),
        (scale(1000), ("mine.csv:11: IJ to PX is 137 m", "not millimeters")),
        (scale(100), ("mine.csv:11: IJ to PX is 13.7 m", "not centimeters")),
        (scale(10), ("mine.csv:11: IJ to PX is 1.37 m", "Correct the positions")),
        (move_to("EM", "EL"), ("mine.csv:22: EM and EL are the same point",)),
        (onto_line, ("mine.csv:18: PAC, TS and AI lie nearly on a line, 0 mm",)),
        (swap_names("EM", "EL"), ("mine.csv:21: .*EM and EL have each other's place",)),
        (swap_names("TS", "AI"), ("mine.csv:17: .*TS and AI have each other's place",)),
        (swap_names("PX", "T8"), ("mine.csv:11: .*PX and T8 have each other's place",)),
        (swap_names("IJ", "C7"), ("mine.csv:10: .*IJ and C7 have each other's place",)),
        (swap_names("AC", "AA"), ("mine.csv:15: .*: AC and AA have each other's place",)),
        (swap_names("AC", "PC"), ("mine.csv:15: .*: AC and PC have each other's place",)),
        (swap_names("PC", "GH"), ("mine.csv:19: .*: PC and GH have each other's place",)),
        (one_of_the_left, ("mine.csv:22: EL lies .* two sides", "Give all of one side")),
        (head(PLANE_MM), ("mine.csv:25: HH1 HH2 HH3 HH4: lie nearly in a plane", "Add points")),
    ],
    ids=[
        "missing",
        "missing AC",
        "twice",
        "left",
        "millimeters",
        "centimeters",
        "ten times",
        "zero length",
        "on a line",
        "EM and EL",
        "TS and AI",
        "PX and T8",
        "IJ and C7",
        "AC and AA",
        "AC and PC",
        "PC and GH",
        "two sides",
        "head in a plane",
    ],
)
def test_a_bad_file_is_refused(
    refuses: Refuses,
    tmp_path: Path,
    change: Callable[[Rows], None],
    because: tuple[str, ...],
) -> None:
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    comments = [line for line in lines if line.startswith("#")]
    rows = [line.split(",") for line in lines[len(comments) :]]
    change(rows)
    mine = tmp_path / "mine.csv"
    mine.write_text("\n".join([*comments, *map(",".join, rows)]) + "\n", encoding="utf-8")
    refuses("generate", "--out", "model", "--anatomy", "mine.csv", because=because)


def test_a_file_that_only_loses_its_comments_is_fine(girdle_fine: Girdle, tmp_path: Path) -> None:
    """What the changes above start from is right."""
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    rows = [line for line in lines if not line.startswith("#")]
    (tmp_path / "mine.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    girdle_fine("generate", "--out", "model", "--anatomy", "mine.csv")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (drop("GH"), ("GH is estimated from PC, AC, AA, TS and AI", "Meskers", "2.3 mm", "15 mm")),
        (head(HEAD_MM), ("GH is the centre of the sphere through 4 points", "radius of 24 mm")),
    ],
    ids=["estimated", "sphere"],
)
def test_how_gh_was_found_is_said_where_no_row_gives_it(
    girdle: Girdle, tmp_path: Path, change: Callable[[Rows], None], said: tuple[str, ...]
) -> None:
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    rows = [line.split(",") for line in lines if not line.startswith("#")]
    change(rows)
    (tmp_path / "mine.csv").write_text("\n".join(map(",".join, rows)) + "\n", encoding="utf-8")
    finished = girdle("generate", "--out", "model", "--anatomy", "mine.csv", "--json")
    assert finished.code == 0
    assert finished.message.startswith("mine.csv: GH is ")
    gh = json.loads(finished.text)["gh"]
    for words_said in said:
        assert words_said in finished.message
    assert gh in finished.message


def test_how_gh_was_found_is_said_once_for_a_file(girdle: Girdle, tmp_path: Path) -> None:
    """The person's landmarks are read once, however often the file of arms is."""
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    rows = [line.split(",") for line in lines if not line.startswith("#")]
    drop("GH")(rows)
    (tmp_path / "mine.csv").write_text("\n".join(map(",".join, rows)) + "\n", encoding="utf-8")
    (tmp_path / "arms.csv").write_text("elevation_deg,plane_deg\n60,40\n")
    finished = girdle("solve", "--in", "arms.csv", "--landmarks", "--anatomy", "mine.csv")
    assert finished.code == 0
    assert finished.message.count("mine.csv: GH is ") == 1
