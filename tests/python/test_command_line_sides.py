# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Sides, assemblies and servos as a person types them: `generate` and `simulate`."""

from __future__ import annotations

import csv
import io
import itertools
import json
import os
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import Girdle, Refuses, contents
from shared_results import SharedResults

SIDES = {"right": ("_r",), "left": ("_l",), "both": ("_r", "_l")}
ASSEMBLIES: dict[str, tuple[str, ...]] = {
    "tree": (),
    "loop": ("--assembly", "loop"),
    "scapula leads": ("--assembly", "loop", "--lead", "scapula"),
}
POSITION = ("--actuation", "position")

# A short raise: what is asked is which words do what, not how the arm moves.
RAISE = ("--elevation", "0:60", "--seconds", "0.02")
STEPS = 10
SINGULAR = {"right": "shoulder", "left": "shoulder", "both": "shoulders"}


@pytest.fixture(scope="module")
def models(shared: SharedResults) -> Callable[..., Path]:
    """The scene of a model by the options that it was made with."""
    return lambda *options: shared.generate(*options).scene


def root_of(scene: Path) -> ElementTree.Element:
    """Of the model that a scene includes."""
    include = ElementTree.parse(scene).getroot().find("include")
    assert include is not None
    return ElementTree.parse(scene.parent / include.get("file", "")).getroot()


# --- Words of generate ---------------------------------------------------------------------------


@pytest.mark.parametrize(("side", "actuation"), list(itertools.product(SIDES, ["plugin", "position"])))
def test_the_names_of_the_files_say_side_and_servos(
    girdle_fine: Girdle, tmp_path: Path, side: str, actuation: str
) -> None:
    girdle_fine("generate", "--out", "model", "--side", side, "--actuation", actuation)
    servos = "_position" if actuation == "position" else ""
    scene = f"scene{'' if side == 'right' else '_' + side}{servos}.xml"
    assert contents(tmp_path / "model").keys() == {f"shoulder_{side}{servos}.xml", scene}
    root = root_of(tmp_path / "model" / scene)
    assert root.get("model") == f"girdle {side} {SINGULAR[side]}"


def test_variants_stand_beside_each_other_in_a_folder(girdle_fine: Girdle, tmp_path: Path) -> None:
    for side in SIDES:
        girdle_fine("generate", "--out", "model", "--side", side)
        girdle_fine("generate", "--out", "model", "--side", side, *POSITION)
    assert len(contents(tmp_path / "model")) == 12


@pytest.mark.parametrize("words", [("--side", "right"), ("--assembly", "tree"), ("--actuation", "plugin")])
def test_a_word_that_says_the_default_changes_nothing(
    girdle_fine: Girdle, generated: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    girdle_fine("generate", "--out", "model", *words)
    assert contents(tmp_path / "model") == contents(generated)


def test_the_clavicle_leads_by_default(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("generate", "--out", "said", "--assembly", "loop", "--lead", "clavicle")
    girdle_fine("generate", "--out", "unsaid", "--assembly", "loop")
    assert contents(tmp_path / "said") == contents(tmp_path / "unsaid")


@pytest.mark.parametrize(("side", "assembly"), list(itertools.product(SIDES, ASSEMBLIES)))
@pytest.mark.parametrize("actuation", ["plugin", "position"])
def test_a_model_has_the_sides_assembly_and_servos_of_its_words(
    models: Callable[..., Path], side: str, assembly: str, actuation: str
) -> None:
    root = root_of(models("--side", side, *ASSEMBLIES[assembly], "--actuation", actuation))
    bodies = {body.get("name") for body in root.iterfind(".//body")}
    assert bodies == {"thorax"} | {
        bone + suffix for bone in ("clavicle", "scapula", "humerus") for suffix in SIDES[side]
    }
    connects = [connect.get("name") for connect in root.iterfind("equality/connect")]
    assert connects == ([] if assembly == "tree" else ["AC" + suffix for suffix in SIDES[side]])
    assert (root.find("extension") is None) == (actuation == "position")
    # Two angles that follow have no servo, three of the place have; the plugin's servos are all
    # there and have no stiffness instead.
    servos = 9 if assembly != "scapula leads" else 10 if actuation == "position" else 12
    commands = 3 if actuation == "plugin" else 0
    actuators = root.findall("actuator/*")
    assert len(actuators) == (servos + commands) * len(SIDES[side])


# The words, and what the message says.
REFUSED_WORDS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "side": (("--side", "middle"), ("--side", "middle", "right", "left", "both")),
    "assembly": (("--assembly", "chain"), ("--assembly", "chain", "tree", "loop")),
    "lead": (
        ("--assembly", "loop", "--lead", "humerus"),
        ("--lead", "humerus", "clavicle", "scapula"),
    ),
    "actuation": (("--actuation", "muscles"), ("--actuation", "muscles", "plugin", "position")),
    "a word in capitals": (("--side", "Left"), ("--side", "Left", "left")),
    "two words": (("--side", "left right"), ("--side", "left right")),
    "a lead of a tree": (
        ("--lead", "clavicle"),
        ("--lead clavicle: in a tree the scapula hangs from the clavicle", "--assembly loop"),
    ),
    "the scapula leads a tree": (
        ("--assembly", "tree", "--lead", "scapula"),
        ("--lead scapula: in a tree", "--assembly loop"),
    ),
    "offsets of servos": (("--offsets", *POSITION), ("--offsets", "--actuation plugin")),
    "rates of servos": (("--rates", *POSITION), ("--rates", "--actuation plugin")),
    "rates of a loop": (
        ("--rates", "--assembly", "loop"),
        ("--rates: not available for the assembly loop", "--assembly tree"),
    ),
}


@pytest.mark.parametrize(("words", "because"), REFUSED_WORDS.values(), ids=REFUSED_WORDS.keys())
def test_words_that_do_not_go_together_are_refused_and_nothing_is_written(
    refuses: Refuses, words: tuple[str, ...], because: tuple[str, ...]
) -> None:
    refuses("generate", "--out", "model", *words, because=because)


def test_a_loop_of_a_table_of_two_planes_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    header = (
        "plane_deg,elevation_deg,sc_protraction_deg,sc_elevation_deg,sc_rotation_deg,"
        "ac_internal_rotation_deg,ac_upward_rotation_deg,ac_tilt_deg,gh_elevation_deg,"
        "gh_flexion_deg,gh_axial_deg"
    )
    angles = "-20,-8,0,50,-4,-3,3,0,-51"
    rows = [f"{place},{angles}" for place in ("0,15", "0,20", "90,15", "90,20")]
    (tmp_path / "two.csv").write_text("\n".join([header, *rows]) + "\n")
    rhythm = ("--table", "two.csv", "--interpolation", "slerp", "--closure", "table")
    refuses(
        *("generate", "--out", "model", "--assembly", "loop", *rhythm),
        because=("two.csv: the assembly loop needs a table of at least 3 planes", "2 and 2"),
    )


# --- simulate --side -----------------------------------------------------------------------------


def rows_of(text: str) -> list[dict[str, float]]:
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


@pytest.mark.parametrize("assembly", ASSEMBLIES)
def test_the_trace_is_of_the_side_named(
    girdle_fine: Girdle, models: Callable[..., Path], assembly: str
) -> None:
    scene = models("--side", "both", *ASSEMBLIES[assembly])
    traces = {
        side: rows_of(girdle_fine("simulate", scene, *RAISE, "--out", "-", *words).text)
        for side, words in (("", ()), ("right", ("--side", "right")), ("left", ("--side", "left")))
    }
    assert traces[""] == traces["right"]
    last_right, last_left = traces["right"][-1], traces["left"][-1]
    assert last_right["GH_y_m"] < -0.1
    for column, value in last_right.items():
        across = column.endswith("_y_m")
        if not column.endswith(("_qw", "_qx", "_qy", "_qz")):
            assert last_left[column] == pytest.approx(-value if across else value, abs=1e-9), column


@pytest.mark.parametrize(("made", "asked"), [("right", "left"), ("left", "right")])
def test_a_side_that_the_model_lacks_is_refused(
    refuses: Refuses, models: Callable[..., Path], made: str, asked: str
) -> None:
    scene = models("--side", made)
    refuses(
        *("simulate", scene, *RAISE, "--side", asked, "--out", "trace.csv"),
        because=(f"has no {asked} shoulder", "girdle generate --side"),
    )


def test_a_trace_is_of_one_side(refuses: Refuses, models: Callable[..., Path]) -> None:
    refuses(
        *("simulate", models("--side", "both"), *RAISE, "--side", "both"),
        because=("--side", "both", "right", "left"),
    )


# --- simulate --out-controls -------------------------------------------------------------------------


def actuators_of(scene: Path) -> list[str]:
    return [actuator.get("name", "") for actuator in root_of(scene).findall("actuator/*")]


@pytest.mark.parametrize(("side", "assembly"), list(itertools.product(SIDES, ASSEMBLIES)))
def test_controls_have_a_column_for_every_servo_in_its_order(
    girdle_fine: Girdle, models: Callable[..., Path], tmp_path: Path, side: str, assembly: str
) -> None:
    words = ("--side", side, *ASSEMBLIES[assembly])
    servos = actuators_of(models(*words, *POSITION))
    slides = ("st_anterior", "st_superior", "st_lateral")
    columns = [name + ("_m" if name.startswith(slides) else "_rad") for name in servos]
    for scene in (models(*words), models(*words, *POSITION)):
        girdle_fine("simulate", scene, *RAISE, "--out-controls", "controls.csv")
        text = (tmp_path / "controls.csv").read_text()
        assert text.splitlines()[0].split(",") == ["time_s", *columns]
        rows = rows_of(text)
        assert [row["time_s"] for row in rows] == pytest.approx(
            [0.002 * step for step in range(STEPS + 1)], abs=1e-12
        )


def test_the_plugin_and_the_servos_write_the_same_controls(
    girdle_fine: Girdle, models: Callable[..., Path]
) -> None:
    for assembly in ASSEMBLIES.values():
        words = (*RAISE, "--out-controls", "-")
        plugin, position = (
            rows_of(girdle_fine("simulate", models(*assembly, *kind), *words).text) for kind in ((), POSITION)
        )
        assert len(plugin) == len(position) == STEPS + 1
        for one, other in zip(plugin, position, strict=True):
            assert one == pytest.approx(other, abs=1e-12)


def test_controls_to_a_file_are_said(girdle_fine: Girdle, generated: Path) -> None:
    command = ("simulate", generated / "scene.xml", *RAISE, "--out-controls", "c.csv")
    assert girdle_fine(*command).message == f"girdle: wrote c.csv: {STEPS + 1} rows\n"


def test_controls_to_standard_output_are_all_of_it(
    girdle_fine: Girdle, generated: Path, tmp_path: Path
) -> None:
    scene = generated / "scene.xml"
    text = girdle_fine("simulate", scene, *RAISE, "--out-controls", "-").text
    girdle_fine("simulate", scene, *RAISE, "--out-controls", "c.csv")
    assert text == (tmp_path / "c.csv").read_text()


def test_json_names_the_file_of_the_controls(girdle_fine: Girdle, generated: Path, tmp_path: Path) -> None:
    scene = generated / "scene.xml"
    words = ("simulate", scene, *RAISE, "--json")
    answer = json.loads(girdle_fine(*words, "--out-controls", "c.csv", "--out", "t.csv").text)
    assert (answer["out_controls"], answer["out"]) == ("c.csv", "t.csv")
    assert len((tmp_path / "c.csv").read_text().splitlines()) == answer["rows"] + 1
    assert json.loads(girdle_fine(*words).text)["out_controls"] is None


REFUSED_CONTROLS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "with json": (("--out-controls", "-", "--json"), ("--out-controls -", "standard output")),
    "with a trace": (("--out-controls", "-", "--out", "-"), ("--out-controls -", "standard output")),
    "into no folder": (("--out-controls", "absent/c.csv"), ("absent/c.csv",)),
    "into a folder": (("--out-controls", "."), (r"\.",)),
    "over the trace": (
        ("--out-controls", "same.csv", "--out", "same.csv"),
        ("same.csv", "--out", "--out-controls"),
    ),
    "over the trace by another name": (
        ("--out-controls", "./same.csv", "--out", "same.csv"),
        ("same.csv", "--out", "--out-controls"),
    ),
}


@pytest.mark.parametrize(("words", "because"), REFUSED_CONTROLS.values(), ids=REFUSED_CONTROLS.keys())
def test_controls_that_cannot_be_written_are_refused(
    refuses: Refuses, generated: Path, words: tuple[str, ...], because: tuple[str, ...]
) -> None:
    refuses("simulate", generated / "scene.xml", *RAISE, *words, because=because)


def test_a_trace_is_not_written_either_where_the_controls_cannot_be(
    refuses: Refuses, generated: Path, tmp_path: Path
) -> None:
    (tmp_path / "trace.csv").write_text("earlier\n")
    refuses(
        *("simulate", generated / "scene.xml", *RAISE, "--out", "trace.csv"),
        *("--out-controls", "absent/c.csv"),
        because=("absent/c.csv",),
    )


def test_offsets_of_servos_follow_the_motion(
    girdle_fine: Girdle, models: Callable[..., Path], tmp_path: Path
) -> None:
    """Position servos need no command for them: what they are given says all."""
    (tmp_path / "shrug.csv").write_text("time_s,elevation_deg,plane_deg,shrug_deg\n0,60,40,0\n0.02,60,40,8\n")
    words = ("--in", "shrug.csv", "--out-controls", "-")
    rows = rows_of(girdle_fine("simulate", models(*POSITION), *words).text)
    offsets = rows_of(girdle_fine("simulate", models("--offsets"), *words).text)
    assert rows[-1]["sc_elevation_r_rad"] < rows[0]["sc_elevation_r_rad"] - 0.1
    for one, other in zip(rows, offsets, strict=True):
        assert one == pytest.approx(other, abs=1e-12)


def test_a_model_with_servos_follows_the_rhythm_that_is_said(
    girdle_fine: Girdle, models: Callable[..., Path]
) -> None:
    words = ("--elevation", "20:60", "--seconds", "0.02", "--out-controls", "-")
    published = ("--interpolation", "squad", "--closure", "table")
    said = rows_of(girdle_fine("simulate", models(*POSITION), *words, *published).text)
    plugin = rows_of(girdle_fine("simulate", models(*published), *words).text)
    unsaid = rows_of(girdle_fine("simulate", models(*POSITION), *words).text)
    for one, other in zip(said, plugin, strict=True):
        assert one == pytest.approx(other, abs=1e-12)
    assert abs(said[-1]["gh_axial_r_rad"] - unsaid[-1]["gh_axial_r_rad"]) > 0.01


def test_a_motion_that_the_program_does_not_finish_leaves_no_half_written_controls(
    refuses: Refuses, generated: Path, tmp_path: Path
) -> None:
    (tmp_path / "shrug.csv").write_text("time_s,elevation_deg,plane_deg,shrug_deg\n0,60,40,0\n0.02,60,40,8\n")
    (tmp_path / "c.csv").write_text("earlier\n")
    refuses(
        *("simulate", generated / "scene.xml", "--in", "shrug.csv", "--out-controls", "c.csv"),
        because=("shrug is commanded", "girdle generate --offsets"),
    )
    assert os.listdir(tmp_path).count("c.csv") == 1


def test_controls_are_not_written_of_a_model_that_feeds_forward(girdle: Girdle, tmp_path: Path) -> None:
    """Position servos are given angles, not rates: they would not repeat its motion."""
    assert girdle("generate", "--rates", "--out", tmp_path).code == 0
    controls = tmp_path / "controls.csv"
    finished = girdle("simulate", tmp_path / "scene.xml", "--elevation", "0:60", "--out-controls", controls)
    assert finished.code == 2
    assert "without --rates" in finished.message
    assert not controls.exists()
