# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The table of names in model/README.md and the emitted files say the same, in both directions."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import pytest
from shared_results import SharedResults

MODELS = Path(__file__).resolve().parents[2] / "model"
README = (MODELS / "README.md").read_text(encoding="utf-8")

# The table shows a tenth of a degree.
PRINTED_DEG = 0.051
ROUNDING = 1e-12

SIDES = {"right": ("_r",), "left": ("_l",), "both": ("_r", "_l")}

# Kinds of names by where they stand in a file: section and element, or the element alone.
KINDS = {
    "body": "body",
    "joint": "joint",
    "site": "site",
    "geom": "geom",
    "mesh": "mesh",
    "material": "material",
    "texture": "texture",
    "camera": "camera",
    "key": "keyframe",
    "instance": "plugin instance",
    "actuator/plugin": "actuator",
    "actuator/position": "actuator",
    "sensor/plugin": "sensor",
    "equality/connect": "equality",
    "tendon/spatial": "tendon",
    "contact/pair": "contact pair",
    "deformable/skin": "skin",
    "custom/numeric": "numeric",
    "custom/text": "text",
}


@dataclass(frozen=True)
class Row:
    kind: str
    names: tuple[str, ...]
    where: frozenset[str]
    unit: str
    limits: str


def table(header: str) -> list[list[str]]:
    """The cells of the rows below a header."""
    assert README.count(header) == 1
    body = README.split(header)[1].split("\n\n")[0]
    rows = [line.strip("|").split("|") for line in body.splitlines()[2:]]
    return [[cell.strip() for cell in row] for row in rows]


def rows_of_names() -> list[Row]:
    rows = []
    for kind, names, where, unit, limits, _ in table("| kind | name | where |"):
        found = tuple(re.findall(r"`([^`]+)`", names))
        assert found, (kind, names)
        rows.append(Row(kind, found, frozenset(where.split(" + ")), unit, limits))
    return rows


ROWS = rows_of_names()


@dataclass(frozen=True)
class Variant:
    """What is so of a file: the words of the column `where` that hold in it."""

    name: str
    path: Path
    side: str
    words: frozenset[str]

    def suffixes(self, row: Row) -> tuple[str, ...]:
        return tuple(s for s in SIDES[self.side] if "left" not in row.where or s == "_l")

    def has(self, row: Row) -> bool:
        return row.where - {"left"} <= self.words


def words_of(*options: str) -> frozenset[str]:
    leads = () if "--lead scapula" in options else ("clavicle leads",)
    counts = () if "--axial-from isb" in options else ("axial from rhythm",)
    return frozenset(("all", *options, *leads, *counts))


def variant_of(path: Path, assembly: str, *options: str) -> Variant:
    parts = path.stem.split("_")
    side = next((word for word in parts if word in SIDES), "right")
    scene = ("scene",) if parts[0] == "scene" else ()
    actuation = "position" if "position" in parts else "plugin"
    words = words_of(assembly, actuation, *options, *scene)
    return Variant(f"{path.parent.name}/{path.name}", path, side, words)


FAMILIES = {
    "shoulder_tree": ("tree",),
    "shoulder_loop": ("loop",),
    "shoulder_skin": ("tree", "--skin"),
}
COMMITTED = [variant_of(path, *FAMILIES[path.parent.name]) for path in sorted(MODELS.glob("*/*.xml"))]

# Models that are not committed and have names of their own.
FURTHER = {
    "offsets and rates": ("tree", "plugin", "--offsets", "--rates"),
    "axial from ISB's zero": ("tree", "plugin", "--axial-from isb"),
    "offsets in a loop": ("loop", "plugin", "--offsets"),
    "pressed by the thorax": ("tree", "plugin", "--thorax-contact"),
    "the scapula leads": ("loop", "plugin", "--lead scapula"),
    "the scapula leads, position": ("loop", "position", "--lead scapula"),
}


@pytest.fixture(params=[*COMMITTED, *FURTHER], ids=lambda p: getattr(p, "name", p))
def variant(request: pytest.FixtureRequest, shared: SharedResults) -> Variant:
    if isinstance(request.param, Variant):
        return request.param
    assembly, actuation, *options = FURTHER[request.param]
    words = [word for option in options for word in option.split()]
    made = shared.generate("--side", "both", "--assembly", assembly, "--actuation", actuation, *words)
    return variant_of(made.model, assembly, *options)


def elements(path: Path) -> Iterator[tuple[str, ElementTree.Element]]:
    """All named elements of a file with their kinds; a scene's are its own alone."""
    root = ElementTree.parse(path).getroot()
    for section in root:
        for element in (section, *section.iter()):
            tag = f"{section.tag}/{element.tag}"
            kind = KINDS.get(tag, KINDS.get(element.tag))
            if element.tag == "default" and "class" in element.attrib:
                yield "default class", ElementTree.Element("d", name=element.attrib["class"])
            elif element.tag == "config":
                yield "config key", ElementTree.Element("c", name=element.attrib["key"])
            elif "name" in element.attrib:
                assert kind, f"no kind for a named {tag}"
                yield kind, element


def expected(variant: Variant) -> dict[tuple[str, str], Row]:
    names: dict[tuple[str, str], Row] = {}
    is_scene = "scene" in variant.words
    for row in ROWS:
        if not variant.has(row) or is_scene != ("scene" in row.where):
            continue
        for name in row.names:
            suffixes = variant.suffixes(row)
            sided = [name.replace("_*", suffix) for suffix in suffixes]
            for found in sided if "_*" in name else sided[:1]:
                assert (row.kind, found) not in names, f"twice in the table: {row.kind} {found}"
                names[row.kind, found] = row
    return names


def test_the_table_and_a_file_have_the_same_names(variant: Variant) -> None:
    in_file = {(kind, element.attrib["name"]) for kind, element in elements(variant.path)}
    in_table = expected(variant).keys()
    assert in_file - in_table == set(), "not in the table"
    assert in_table - in_file == set(), "not in the file"


def test_every_row_of_the_table_is_about_some_file() -> None:
    assert len(COMMITTED) == 36
    found = [variant.words for variant in COMMITTED]
    found += [words_of(*options) for options in FURTHER.values()]
    for row in ROWS:
        assert any(row.where - {"left"} <= words for words in found), row


def test_the_ranges_of_the_table_are_those_of_a_file(variant: Variant) -> None:
    rows = expected(variant)
    compared = 0
    for kind, element in elements(variant.path):
        if kind not in ("joint", "actuator"):
            continue
        row = rows[kind, element.attrib["name"]]
        limits = element.attrib.get("range" if kind == "joint" else "ctrlrange")
        assert row.unit == unit_of(element.attrib["name"]), row
        if limits is None:
            assert row.limits == "-", row
            continue
        low, high = (float(number) for number in row.limits.split(" to "))
        found = [float(number) for number in limits.split()]
        if row.unit == "rad":
            found, tolerance = [math.degrees(number) for number in found], PRINTED_DEG
        else:
            tolerance = ROUNDING
        assert found == pytest.approx([low, high], abs=tolerance), element.attrib["name"]
        compared += 1
    assert compared > 15 or "scene" in variant.words


def unit_of(name: str) -> str:
    if re.match("st_(anterior|superior|lateral)_", name):
        return "m"
    return "rad/s" if "_rate_" in name else "rad"


def test_the_values_of_the_sensor_follow_each_other_without_a_gap() -> None:
    """As many as the table of names says."""
    following = 0
    for values, _ in table("| value | what |"):
        first, _, last = values.partition("-")
        assert int(first) == following
        following = int(last or first) + 1
    (sensor,) = [row for row in ROWS if row.kind == "sensor"]
    assert sensor.names == ("rhythm_*",)
    assert f"| {following} values, below |" in README
