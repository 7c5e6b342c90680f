# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`scripts/figures`: the pictures, the numbers on the page, and runs that fail.

The plots are run as the script does it, with the python3 that has matplotlib.
"""

from __future__ import annotations

import csv
import io
import json
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import REFUSED, RunProgram, contents

ROOT = Path(__file__).resolve().parents[2]
PLOTS = ROOT / "scripts" / "plots" / "make_page.py"
# Debian's python3-matplotlib belongs to this one, not to the environment of the tests.
PYTHON = "/usr/bin/python3"
TIMEOUT_S = 240
FAILED = 1

NOTE = "The man is missing: <no network> & no body"
LEFT_OVER = "of_an_earlier_run.png"
PICTURED = [
    "upper_body_implicit",
    "figure_11_abduction_front_implicit",
    "figure_12_abduction_back_implicit",
    "figure_14_skin_near_ac_implicit",
]
PLOTTED = [
    "scapular_rhythm",
    "figure_13_elbow_path",
    "velocity_jumps",
    "scapulohumeral_rhythm",
    "reach",
    "map_of_upward_rotation",
    "maps_of_published_rhythms",
    "axial_zero",
]

# A table has the digits that its reader needs: half of the last one.
ONE_DECIMAL = 0.05 + 1e-9
TWO_DECIMALS = 0.005 + 1e-9
TWO_DIGITS_SHARE = 0.051
THREE_DIGITS_SHARE = 0.0051


# Of a report of `girdle verify`.
Lines = list[dict[str, Any]]


# --- The page as a reader has it -----------------------------------------------------------------


@dataclass
class Section:
    """What the page has under one heading."""

    pictures: list[dict[str, str]] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    tables: list[list[list[str]]] = field(default_factory=list)
    text: str = ""


class Page(HTMLParser):
    """Sections by their id; anything in an element that is not closed fails."""

    EMPTY = ("img", "meta", "br")

    def __init__(self, text: str) -> None:
        super().__init__()
        self.sections: dict[str, Section] = {"": Section()}
        self.elements: set[str] = set()
        self._open: list[str] = []
        self._id = ""
        self._cell: list[str] | None = None
        self.feed(text)
        self.close()
        assert self._open == []

    @property
    def section(self) -> Section:
        return self.sections[self._id]

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attributes}
        self.elements.add(tag)
        if tag not in self.EMPTY:
            self._open.append(tag)
        if tag == "section":
            self._id = given["id"]
            self.sections[self._id] = Section()
        elif tag == "img":
            self.section.pictures.append(given)
        elif tag == "a":
            self.section.links.append(given["href"])
        elif tag == "table":
            assert "details" in self._open, "a table that is not folded"
            self.section.tables.append([])
        elif tag == "tr":
            self.section.tables[-1].append([])
        elif tag in ("td", "th"):
            self._cell = []

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag
        if tag == "section":
            self._id = ""
        elif tag in ("td", "th"):
            assert self._cell is not None
            self.section.tables[-1][-1].append("".join(self._cell))
            self._cell = None

    def handle_data(self, text: str) -> None:
        self.section.text += text
        if self._cell is not None:
            self._cell.append(text)


def read_page(folder: Path) -> Page:
    return Page((folder / "index.html").read_text())


# --- Running it ----------------------------------------------------------------------------------


def make_figures(
    program: Path, out: Path, *words: str, environment: dict[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    # Not the variables of the tests' own Python.
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    command = [PYTHON, "-B", str(PLOTS), "--program", str(program), "--out", str(out), "--quick"]
    return subprocess.run(
        [*command, *words],
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        env=clean | (environment or {}),
        check=False,
    )


@pytest.fixture(scope="session")
def figures(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of figures, which no test writes to."""
    out = tmp_path_factory.mktemp("made") / "figures"
    finished = make_figures(program, out)
    assert (finished.returncode, finished.stderr) == (0, "")
    return out


@pytest.fixture(scope="session")
def page(figures: Path) -> Page:
    return read_page(figures)


@pytest.fixture(scope="session")
def figures_without_gl(program: Path, figures: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same of a machine that cannot draw, in the place of an earlier page."""
    out = tmp_path_factory.mktemp("without_gl") / "figures"
    out.mkdir()
    shutil.copy(figures / "index.html", out)
    (out / LEFT_OVER).touch()
    finished = make_figures(program, out, "--note", NOTE, environment={"GIRDLE_GL": "none"})
    assert (finished.returncode, finished.stderr) == (0, "")
    return out


def failing_program(program: Path, folder: Path, verb: str) -> Path:
    """The program, but for one verb that fails as a verb does."""
    script = folder / "girdle"
    script.write_text(
        f'#!/bin/sh\nif [ "$1" = {verb} ]; then\n'
        f'  echo "girdle: the moon is full. Wait a week" >&2\n  exit {REFUSED}\nfi\n'
        f'exec "{program}" "$@"\n'
    )
    script.chmod(0o755)
    return script


# --- The figures ---------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*PICTURED, *PLOTTED])
def test_a_figure_is_there_as_png_and_is_not_blank(figures: Path, name: str) -> None:
    look = "import sys, matplotlib.image as i; p = i.imread(sys.argv[1]); print(*p.shape, p.std())"
    printed = subprocess.run(
        [PYTHON, "-c", look, str(figures / f"{name}.png")],
        capture_output=True,
        text=True,
        check=True,
        timeout=TIMEOUT_S,
    ).stdout.split()
    height, width, spread = int(printed[0]), int(printed[1]), float(printed[-1])
    assert min(height, width) > 100
    # White with thin lines, the emptiest of them, has a tenth.
    assert spread > 0.05


@pytest.mark.parametrize("name", [*PICTURED, *PLOTTED])
def test_a_figure_is_there_as_svg_with_its_text_as_text(figures: Path, name: str) -> None:
    svg = ElementTree.parse(figures / f"{name}.svg").getroot()
    texts = ["".join(text.itertext()) for text in svg.iter("{http://www.w3.org/2000/svg}text")]
    assert len([text for text in texts if text.strip()]) > 4


@pytest.mark.parametrize(
    ("name", "units"),
    [
        ("figure_13_elbow_path", ["(mm)", "(mm/deg)", "(1/m)", "(deg)"]),
        ("velocity_jumps", ["(deg/deg)"]),
        ("scapular_rhythm", ["humeral elevation (deg)", "more upward rotation (deg) →"]),
        ("scapulohumeral_rhythm", ["(deg)", "glenohumeral : scapulothoracic"]),
        ("reach", ["(deg)"]),
        ("map_of_upward_rotation", ["(deg)"]),
        ("maps_of_published_rhythms", ["(deg)"]),
        ("axial_zero", ["(deg)"]),
    ],
)
def test_axes_have_units(figures: Path, name: str, units: list[str]) -> None:
    text = (figures / f"{name}.svg").read_text()
    assert [unit for unit in units if unit not in text] == []


@pytest.mark.parametrize("name", [*PICTURED, *PLOTTED])
def test_the_page_shows_a_figure_with_its_words_and_commands(page: Page, name: str) -> None:
    section = page.sections[name]
    (picture,) = section.pictures
    assert picture["src"] == f"{name}.png"
    assert len(picture["alt"]) > 80
    assert re.search(r"^girdle \w+", section.text, re.MULTILINE)
    assert len(section.tables) >= 1
    assert all(len(row) == len(table[0]) for table in section.tables for row in table)


def test_every_file_that_the_page_names_is_there_and_nothing_is_fetched(figures: Path, page: Page) -> None:
    sections = page.sections.values()
    pictures = [picture["src"] for section in sections for picture in section.pictures]
    links = [link for section in sections for link in section.links if not link.startswith("#")]
    assert [name for name in [*pictures, *links] if not (figures / name).is_file()] == []
    assert page.elements.isdisjoint({"script", "link", "iframe"})


def test_the_contents_lead_to_every_figure(page: Page) -> None:
    places = [link[1:] for link in page.sections[""].links if link.startswith("#")]
    assert places == [name for name in page.sections if name]


def test_the_rhythm_comes_before_the_skin(page: Page) -> None:
    figures = [name for name in page.sections if name]
    assert figures[0] == "scapular_rhythm"
    assert figures[len(PLOTTED)] == "upper_body_implicit"
    assert sorted(figures[: len(PLOTTED)]) == sorted(PLOTTED)


def test_figures_are_the_same_bytes_again(figures: Path, figures_without_gl: Path) -> None:
    for name in PLOTTED:
        for suffix in ("svg", "png"):
            file = f"{name}.{suffix}"
            assert (figures / file).read_bytes() == (figures_without_gl / file).read_bytes(), file


# --- The numbers ---------------------------------------------------------------------------------


def table_by_row(page: Page, name: str, index: int = 0) -> dict[str, list[str]]:
    _, *rows = page.sections[name].tables[index]
    return {row[0]: row[1:] for row in rows}


def test_the_angles_of_the_bones_are_those_of_solve(page: Page, run_program: RunProgram) -> None:
    shown = table_by_row(page, "figure_11_abduction_front_implicit")
    assert list(shown) == ["15", "30", "60", "90", "120"]
    for elevation, row in shown.items():
        pose = ("--elevation", elevation, "--plane", "0", "--json")
        angles_deg = json.loads(run_program("solve", *pose))["angles_deg"]
        expected = list(angles_deg.values())[:6]  # SC and AC
        assert [float(text) for text in row] == pytest.approx(expected, abs=ONE_DECIMAL)


def elbow_mm(run_program: RunProgram, elevation: str, plane: str, interpolation: str) -> np.ndarray:
    pose = ("--elevation", elevation, "--plane", plane, "--table", "measured")
    how = ("--interpolation", interpolation, "--closure", "table", "--landmarks", "--json")
    return np.array(json.loads(run_program("solve", *pose, *how))["landmarks_mm"]["elbow"])


@pytest.mark.parametrize("elevation", ["30", "60", "90", "120"])
@pytest.mark.parametrize("interpolation", ["slerp", "squad", "smooth"])
def test_the_corner_of_the_elbows_path_is_that_of_secants_ever_shorter(
    page: Page, run_program: RunProgram, elevation: str, interpolation: str
) -> None:
    """By another step and formula than the figure's."""
    before, at, behind = (
        elbow_mm(run_program, elevation, plane, interpolation) for plane in ("39.999", "40", "40.001")
    )
    first, second = at - before, behind - at
    cosine = first @ second / np.linalg.norm(first) / np.linalg.norm(second)
    kink_deg = np.degrees(np.arccos(min(1.0, cosine)))
    jump = np.linalg.norm(second - first) / 0.001
    shown = table_by_row(page, "figure_13_elbow_path")[f"{elevation}, {interpolation}"]
    # The coarse steps of a quick run leave an error of some hundredths.
    coarse_deg = 0.1
    assert float(shown[0]) == pytest.approx(kink_deg, rel=TWO_DIGITS_SHARE, abs=coarse_deg)
    assert float(shown[1]) == pytest.approx(jump, rel=TWO_DIGITS_SHARE, abs=0.005)


def test_only_slerp_turns_a_corner(page: Page) -> None:
    for of, (kink_deg, *_) in table_by_row(page, "figure_13_elbow_path").items():
        assert (float(kink_deg) > 1) == of.endswith("slerp"), of


def test_jumps_of_velocity_are_those_of_continuity(page: Page, run_program: RunProgram) -> None:
    shown = table_by_row(page, "velocity_jumps")
    jumps = json.loads(run_program("smoothness", "--json"))["jumps"]
    assert len(shown) == len(jumps) == 6
    for line in jumps:
        expected = [line[joint]["velocity_deg_per_deg"] for joint in ("SC", "AC", "GH")]
        row = shown[f"{line['interpolation']}, over {line['over']}"]
        assert [float(text) for text in row] == pytest.approx(expected, rel=TWO_DIGITS_SHARE)


def test_axial_rotations_of_the_rhythm_are_those_of_solve(page: Page, run_program: RunProgram) -> None:
    header, *rows = page.sections["axial_zero"].tables[0]
    planes = [name.removeprefix("plane ") for name in header[1:]]
    shown = 0
    for elevation, *row in rows:
        for plane, text in zip(planes, row, strict=True):
            pose = ("--elevation", elevation, "--plane", plane, "--json")
            answer = json.loads(run_program("solve", *pose))
            assert answer["clamped"] == (text == "-")
            if text != "-":
                expected = answer["used"]["axial_isb_deg"]
                assert float(text) == pytest.approx(expected, abs=ONE_DECIMAL)
                shown += 1
    assert shown > 35


def numbers_in(text: str) -> list[float]:
    return [float(word) for word in re.findall(r"(?<![\w.])\d+\.\d", text)]


def test_the_page_begins_with_how_far_the_bones_turn(page: Page, run_program: RunProgram) -> None:
    poses = ("--elevation", "30:120:90", "--plane", "40")
    low, high = csv.DictReader(io.StringIO(run_program("solve", *poses)))

    def upward_and_tilt_deg(row: dict[str, str]) -> list[float]:
        matrix = yxz_deg(row, "sc") @ yxz_deg(row, "ac")
        # R = Ry Rx Rz: -sin(x) in its second row, third column; z from its second row.
        radians = np.arcsin(matrix[1, 2]), np.arctan2(matrix[1, 0], matrix[1, 1])
        return [float(angle) for angle in np.degrees(radians)]

    turned = np.subtract(upward_and_tilt_deg(high), upward_and_tilt_deg(low))
    clavicle = [float(low[name]) - float(high[name]) for name in ("sc_elevation_deg", "sc_protraction_deg")]
    first, _, _ = opening(page)
    assert numbers_in(first) == pytest.approx([*turned, *clavicle], abs=ONE_DECIMAL)


def test_the_page_says_how_far_other_rhythms_are(page: Page, run_program: RunProgram) -> None:
    words = ("--elevation", "30:120:5", "--plane", "0:90:10", "--json")
    rhythms = json.loads(run_program("compare", *words))["rhythms"]
    apart = {
        rhythm["name"]: (part["in_table"]["rms_deg"], abs(part["in_table"]["largest_deg"]))
        for rhythm in rhythms
        for part in rhythm["differences"]
        if part["of"] == "st_upward_rotation"
    }
    _, second, _ = opening(page)
    (closest,) = re.findall("the closest of the other rhythms, (.*), misses", second)
    assert numbers_in(second) == pytest.approx([*apart["frozen girdle"], *apart[closest]], abs=ONE_DECIMAL)
    others = {name: rms for name, (rms, _) in apart.items() if name not in ("Girdle", "frozen girdle")}
    assert others[closest] == min(others.values())


def test_the_page_says_how_the_skin_rises(page: Page, skin_lines: tuple[Lines, Lines]) -> None:
    item = "acromion's skin rises, plane 0, right"
    measured, frozen = (next(line["value"] for line in lines if line["item"] == item) for lines in skin_lines)
    _, _, third = opening(page)
    assert numbers_in(third) == pytest.approx([abs(measured), abs(frozen)], abs=ONE_DECIMAL)
    assert re.findall("rises|sinks", third) == ["rises" if mm >= 0 else "sinks" for mm in (measured, frozen)]
    shown = table_by_row(page, "upper_body_implicit")["acromion's skin rises"]
    assert [float(text) for text in shown] == pytest.approx([measured, frozen], abs=ONE_DECIMAL)


def opening(page: Page) -> list[str]:
    """The sentences under the page's heading."""
    _, words = page.sections[""].text.split("Figures of Girdle\n")[-2:]
    return words.split("\n")[:3]


def test_angles_in_the_thorax_are_those_of_the_table_and_of_compare(
    page: Page, tmp_path: Path, run_program: RunProgram
) -> None:
    lines = (ROOT / "data" / "ludewig2009.csv").read_text().splitlines()
    measured = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    out = tmp_path / "map.csv"
    run_program("compare", "--elevation", "30:120:30", "--plane", "0:90:10", "--out", str(out))
    rhythm = [row for row in csv.DictReader(out.open()) if row["rhythm"] == "Girdle"]
    signs = {
        "st_upward_rotation_deg": -1,
        "st_tilt_deg": 1,
        "st_internal_rotation_deg": 1,
        "sc_elevation_deg": -1,
        "sc_protraction_deg": -1,
    }

    def plotted(rows: list[dict[str, str]], plane: str, elevation: str) -> list[float]:
        (row,) = (row for row in rows if (row["plane_deg"], row["elevation_deg"]) == (plane, elevation))
        return [sign * float(row[column]) for column, sign in signs.items()]

    shown = table_by_row(page, "scapular_rhythm")
    assert len(shown) == 12
    for where, row in shown.items():
        plane, elevation = where.split(", ")
        values = [float(text) for text in row]
        assert values[0::2] == pytest.approx(plotted(rhythm, plane, elevation), abs=ONE_DECIMAL)
        assert values[1::2] == pytest.approx(plotted(measured, plane, elevation), abs=ONE_DECIMAL)


def test_scapulohumeral_ratios_are_those_of_compare(page: Page, run_program: RunProgram) -> None:
    header, *_ = page.sections["scapulohumeral_rhythm"].tables[0]
    shown = table_by_row(page, "scapulohumeral_rhythm")
    words = ("--elevation", "30:120:30", "--plane", "0:90:10", "--json")
    lines = json.loads(run_program("compare", *words))["scapulohumeral_ratio"]["rows"]
    expected = {
        f"{line['plane_deg']:g}, {line['elevation_deg']:g}": [line[name] for name in header[1:]]
        for line in lines
        if line["plane_deg"] in (0, 40, 90)
    }
    assert header[1] == "Girdle"
    assert list(shown) == list(expected)
    for where, ratios in expected.items():
        assert [float(text) for text in shown[where]] == pytest.approx(ratios, abs=TWO_DECIMALS)


def test_all_functional_positions_are_in_the_table_of_the_reach(page: Page) -> None:
    lines = (ROOT / "data" / "functional_positions.csv").read_text().splitlines()
    positions = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    shown = table_by_row(page, "reach")
    assert len(shown) == len(positions) == 8
    for number, position in enumerate(positions, start=1):
        elevation, plane, origin, distance = shown[f"{number} {position['position']}"]
        assert (elevation, plane) == (position["elevation_deg"], position["plane_deg"])
        inside = 15 <= float(elevation) <= 120 and 0 <= float(plane) <= 90
        assert (origin == "modelled", float(distance) > 0) == (not inside, not inside)


def test_upward_rotation_on_the_map_is_that_of_compare(page: Page, run_program: RunProgram) -> None:
    shown = table_by_row(page, "map_of_upward_rotation")
    planes = ["-90", "-60", "-30", "0", "45", "90", "135"]
    rows = csv.DictReader(
        io.StringIO(run_program("solve", "--elevation", "0:180:30", "--plane", "-105:135:15"))
    )
    # ST by its own formula: the angles Y-X'-Z'' of SC followed by AC.
    for row in rows:
        if row["plane_deg"] not in planes:
            continue
        text = shown[row["elevation_deg"]][planes.index(row["plane_deg"])]
        if row["clamped"] == "1":
            assert text == "-"
            continue
        matrix = yxz_deg(row, "sc") @ yxz_deg(row, "ac")
        # R = Ry Rx Rz has -sin(x) in its second row, third column; upward rotation is -x.
        upward_deg = np.degrees(np.arcsin(matrix[1, 2]))
        assert float(text) == pytest.approx(upward_deg, abs=ONE_DECIMAL)


def yxz_deg(row: dict[str, str], joint: str) -> np.ndarray:
    y, x, z = (np.radians(float(text)) for name, text in row.items() if name.startswith(f"{joint}_"))
    about_y = [[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]]
    about_x = [[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]]
    about_z = [[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]]
    return np.array(about_y) @ np.array(about_x) @ np.array(about_z)


def test_differences_of_published_rhythms_are_those_of_compare(page: Page, run_program: RunProgram) -> None:
    shown = table_by_row(page, "maps_of_published_rhythms")
    words = ("--elevation", "0:180:15", "--plane", "-105:135:15", "--json")
    rhythms = json.loads(run_program("compare", *words))["rhythms"]
    seen = 0
    for rhythm in rhythms:
        for difference in rhythm["differences"]:
            row = shown.get(f"{rhythm['name']}, upward rotation")
            if difference["of"] != "st_upward_rotation" or row is None:
                continue
            seen += 1
            parts = (difference["in_table"], difference["on_map"])
            expected = [part[of] for part in parts for of in ("rms_deg", "largest_deg")]
            assert [float(text) for text in row] == pytest.approx(expected, abs=ONE_DECIMAL)
    assert seen == 5


def test_skin_lines_are_those_of_verify(page: Page, skin_lines: tuple[Lines, Lines]) -> None:
    tables = page.sections["figure_14_skin_near_ac_implicit"].tables
    shown = {
        f"{row[0]}, {side}": row
        for side, (_, *rows) in zip(("right", "left"), tables, strict=True)
        for row in rows
    }
    for lines, place in zip(skin_lines, (1, 3), strict=True):
        assert sorted(shown) == sorted(line["item"] for line in lines)
        for line in lines:
            value, verdict = shown[line["item"]][place : place + 2]
            assert float(value) == pytest.approx(line["value"], rel=THREE_DIGITS_SHARE)
            stated = line["tolerance"] is None
            assert verdict == ("stated" if stated else "pass" if line["passed"] else "FAIL")


def test_the_frozen_girdle_fails_where_the_measured_one_passes(page: Page) -> None:
    for _, *rows in page.sections["figure_14_skin_near_ac_implicit"].tables:
        assert "FAIL" not in [row[2] for row in rows]
        assert ["pass", "FAIL"] in [[row[2], row[4]] for row in rows]


@pytest.fixture(scope="session")
def skin_lines(program: Path, figures: Path) -> tuple[Lines, Lines]:
    """The skin lines of the model of the figures: measured, frozen."""
    reports = []
    for words in ((), ("--girdle", "frozen")):
        scene = figures / "models" / "implicit" / "scene_both.xml"
        finished = subprocess.run(
            [str(program), "verify", str(scene), *words, "--json"],
            capture_output=True,
            text=True,
            timeout=TIMEOUT_S,
            check=False,
        )
        assert finished.returncode == (1 if words else 0), finished.stderr
        residuals = json.loads(finished.stdout)["residuals"]
        reports.append([line for line in residuals if line["group"].startswith("skin")])
    return reports[0], reports[1]


# --- Runs that fail ------------------------------------------------------------------------------


def test_without_opengl_the_page_says_so_and_has_all_plots(figures_without_gl: Path) -> None:
    page = read_page(figures_without_gl)
    missing = [section for section in page.sections.values() if "Not drawn. " in section.text]
    assert len(missing) == len(PICTURED)
    assert all("cannot draw pictures" in section.text and not section.pictures for section in missing)
    assert all(page.sections[name].pictures for name in PLOTTED)


def test_a_remark_stands_on_the_page(figures_without_gl: Path) -> None:
    assert NOTE in read_page(figures_without_gl).sections[""].text


@pytest.mark.parametrize("verb", ["generate", "solve", "smoothness"])
def test_a_failing_program_is_reported_and_leaves_nothing(program: Path, tmp_path: Path, verb: str) -> None:
    script = failing_program(program, tmp_path, verb)
    before = contents(tmp_path)
    # Without OpenGL, since the pictures are none of this.
    finished = make_figures(script, tmp_path / "figures", environment={"GIRDLE_GL": "none"})
    assert finished.returncode == FAILED
    assert finished.stderr.startswith("figures: girdle: the moon is full. Wait a week\n")
    assert f"from: girdle {verb}" in finished.stderr
    assert contents(tmp_path) == before


def test_an_earlier_page_stays_when_the_program_fails(
    program: Path, figures_without_gl: Path, tmp_path: Path
) -> None:
    out = tmp_path / "figures"
    shutil.copytree(figures_without_gl, out)
    script = failing_program(program, tmp_path, "smoothness")
    before = contents(tmp_path)
    assert make_figures(script, out, environment={"GIRDLE_GL": "none"}).returncode == FAILED
    assert contents(tmp_path) == before


def test_a_program_that_is_not_there_is_reported(tmp_path: Path) -> None:
    finished = make_figures(tmp_path / "absent", tmp_path / "figures")
    assert finished.returncode == FAILED
    assert re.match(r"figures: .*absent: No such file or directory", finished.stderr)
    assert contents(tmp_path) == {}


def test_an_earlier_page_makes_way_for_a_new_one(figures_without_gl: Path) -> None:
    assert not (figures_without_gl / LEFT_OVER).exists()
    assert list(figures_without_gl.parent.iterdir()) == [figures_without_gl]


def test_a_folder_of_something_else_is_left_alone(program: Path, tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text("<p>my page</p>")
    finished = make_figures(program, tmp_path)
    assert finished.returncode == REFUSED
    assert "is not a folder of figures" in finished.stderr
    assert list(contents(tmp_path)) == ["index.html"]


@pytest.mark.parametrize("words", [("--fast",), ("one", "two"), ("",)])
def test_the_script_refuses_a_command_line_that_it_does_not_know(
    tmp_path: Path, words: tuple[str, ...]
) -> None:
    finished = subprocess.run(
        [str(ROOT / "scripts" / "figures"), *words],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    assert finished.returncode == REFUSED
    assert "Usage: scripts/figures" in finished.stderr
    assert contents(tmp_path) == {}
