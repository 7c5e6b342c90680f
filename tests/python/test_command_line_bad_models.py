# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models and plugins that cannot be used, given to every verb that takes one."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import (
    MODEL_FILE,
    REFUSED,
    SCENE,
    SCENE_FILE,
    Edit,
    Girdle,
    Refuses,
    WriteModel,
    contents,
    expect_one_message,
    find_element,
    remove_element,
    with_scene,
)
from reference_rhythm import DATABASE

VERBS: dict[str, tuple[str, ...]] = {
    "verify": ("verify",),
    "simulate": ("simulate", "--elevation", "15:20", "--out", "trace.csv"),
}
every_verb = pytest.mark.parametrize("command", VERBS.values(), ids=VERBS.keys())

MAKE_ANEW = "girdle generate"


# --- Models with one thing broken ----------------------------------------------------------------


def remove(*paths: str) -> Edit:
    def edit(root: ElementTree.Element) -> None:
        for path in paths:
            remove_element(root, path)

    return edit


def put(path: str, attribute: str, value: str) -> Edit:
    return lambda root: find_element(root, path).set(attribute, value)


def put_config(key: str, value: str) -> Edit:
    return put(f".//config[@key='{key}']", "value", value)


def add_config(key: str, value: str) -> Edit:
    def edit(root: ElementTree.Element) -> None:
        ElementTree.SubElement(find_element(root, ".//instance"), "config", key=key, value=value)

    return edit


def actuator(name: str) -> str:
    return f"actuator/plugin[@name='{name}']"


def joint(name: str) -> str:
    return f".//joint[@name='{name}']"


def table_line(planes: tuple[str, ...] = ("0", "40", "90"), elevations: tuple[str, ...] | None = None) -> str:
    """Some rows of the measured table as a model carries one."""
    lines = [line for line in DATABASE.read_text().splitlines() if not line.startswith("#")]
    rows = [line.split(",") for line in lines[1:]]
    kept = [row for row in rows if row[0] in planes and (not elevations or row[1] in elevations)]
    return ";".join([lines[0], *(",".join(row) for row in kept)])


def add_command(name: str, root: ElementTree.Element) -> None:
    attributes = find_element(root, actuator("plane_r")).attrib | {"name": name}
    ElementTree.SubElement(find_element(root, "actuator"), "plugin", attributes)


def add_two_shrugs(root: ElementTree.Element) -> None:
    add_command("shrug_r", root)
    add_command("shrug_two_r", root)


def add_rate_command(root: ElementTree.Element) -> None:
    add_command("elevation_rate_r", root)
    put_config("interpolation", "squad")(root)
    put_config("range", "clamp")(root)


def repeat_actuator(name: str, second_name: str) -> Edit:
    def edit(root: ElementTree.Element) -> None:
        first = find_element(root, actuator(name))
        second = ElementTree.SubElement(find_element(root, "actuator"), "plugin", first.attrib)
        second.set("name", second_name)

    return edit


def replace_sensor(root: ElementTree.Element) -> None:
    """By one of another kind under the same name."""
    sensor = find_element(root, "sensor/plugin")
    sensor.tag = "jointpos"
    sensor.attrib.clear()
    sensor.attrib.update(name="rhythm_r", joint="gh_axial_r")


@dataclass(frozen=True)
class BrokenModel:
    """One thing broken in a model without keyframes, and what is said of it.

    Keyframes list all angles and controls: with them the engine itself refuses a model that lacks
    a hinge or an actuator, before Girdle can say which.
    """

    edit: Edit
    patterns: tuple[str, ...]


def broken(edit: Edit, *patterns: str) -> BrokenModel:
    return BrokenModel(edit, patterns)


KP = "1500 1500 1500 1000 1000 1000 500 500 500"
BAD_KP = {
    "eight numbers": KP.removeprefix("1500 "),
    "ten numbers": KP + " 500",
    "text": KP.replace("1500", "15OO", 1),
    "negative": KP.replace("1500", "-1500", 1),
    "zero": KP.replace("1500", "0", 1),
    "nan": KP.replace("1500", "nan", 1),
    "inf": KP.replace("1500", "inf", 1),
    "commas": KP.replace(" ", ","),
}

BROKEN_MODELS = (
    {
        "hinge missing": broken(remove(joint("sc_elevation_r")), "sc_elevation_r", MAKE_ANEW),
        "hinge and its servo missing": broken(
            remove(joint("sc_elevation_r"), actuator("sc_elevation_r")), "sc_elevation"
        ),
        "servo missing": broken(
            remove(actuator("sc_elevation_r")), "no servo for sc_elevation", "Add <plugin"
        ),
        "no command actuator": broken(
            remove(*(actuator(f"{command}_r") for command in ("elevation", "plane", "axial"))),
            *("no command actuator for elevation", "Add <plugin", 'gear="0"'),
        ),
        "command twice": broken(
            repeat_actuator("plane_r", "plane_two_r"),
            *('"plane_two_r" is a second command actuator', "for plane", "Remove one"),
        ),
        "servo twice": broken(
            repeat_actuator("ac_tilt_r", "ac_tilt_two_r"),
            *('"ac_tilt_two_r" is a second servo', "for ac_tilt", "Remove one"),
        ),
        "command with an unknown name": broken(
            put(actuator("plane_r"), "name", "plain_r"),
            *('"plain_r" is a command actuator', "elevation plane axial", "Name it"),
        ),
        "servo with an unknown name": broken(
            put(actuator("sc_rotation_r"), "name", "turn_r"),
            *('"turn_r" is a servo', "sc_protraction sc_elevation sc_rotation", "Name it"),
        ),
        "servo with a gear": broken(
            put(actuator("sc_rotation_r"), "gear", "2"),
            *('"sc_rotation_r" has gear 2', "expected 1", "Remove gear"),
        ),
        "servo on a slide": broken(
            put(joint("sc_rotation_r"), "type", "slide"),
            *('"sc_rotation_r" does not act on a hinge', "Give it joint="),
        ),
        "unknown attribute": broken(add_config("speed", "fast"), "speed", MAKE_ANEW),
        "unknown interpolation": broken(
            put_config("interpolation", "cubic"),
            *('interpolation is "cubic"', '"smooth" or "squad" or "slerp"'),
        ),
        "unknown closure": broken(put_config("closure", "open"), 'closure is "open"', '"exact" or "table"'),
        "unknown range": broken(put_config("range", "all"), 'range is "all"', '"whole" or "clamp"'),
        "whole range without a rule for it": broken(
            put_config("interpolation", "squad"), "range whole needs", "smooth", "range clamp"
        ),
        "whole range with the table's closure": broken(
            put_config("closure", "table"), "range whole needs", "exact", "range clamp"
        ),
        "broken table": broken(put_config("table", "plane_deg"), '"table":1: ', "is missing"),
        "two planes": broken(
            put_config("table", table_line(planes=("0", "90"))),
            *("has 2 planes", "smooth", "at least 3", "squad or slerp"),
        ),
        "three elevations": broken(
            put_config("table", table_line(elevations=("30", "60", "90"))),
            *("has 3 elevations", "smooth", "at least 4", "squad or slerp"),
        ),
        "rate command without an interpolation that has rates": broken(
            add_rate_command, "elevation_rate", "squad", "no rates", "interpolation smooth"
        ),
        "shrug command twice": broken(add_two_shrugs, "second command actuator", "for shrug", "Remove one"),
        "unknown plugin": broken(
            put("extension/plugin", "plugin", "girdle.rhytm"), "girdle.rhytm", MAKE_ANEW
        ),
        "body missing": broken(
            put(".//body[@name='scapula_r']", "name", "blade_r"), 'no body "scapula_r"', MAKE_ANEW
        ),
        "site missing": broken(remove(".//site[@name='TS_r']"), 'no site "TS_r"', MAKE_ANEW),
        "sensor missing": broken(remove("sensor"), 'no sensor "rhythm_r"', MAKE_ANEW),
        # Its one number is no place to read nine targets from.
        "sensor of another kind": broken(replace_sensor, 'sensor "rhythm_r"', f"girdle.rhythm|{MAKE_ANEW}"),
    }
    | {
        f"kp: {name}": broken(put_config("kp", value), f'kp is "{value}"', "positive number", "or nine")
        for name, value in BAD_KP.items()
    }
    | {
        f"{command} command missing": broken(
            remove(actuator(f"{command}_r")), f"no command actuator for {command}", "Add <plugin"
        )
        for command in ("elevation", "plane", "axial")
    }
)


@every_verb
def test_a_model_without_keyframes_is_fine(
    girdle_fine: Girdle, write_model: WriteModel, command: tuple[str, ...]
) -> None:
    girdle_fine(*command, write_model(remove("keyframe")))


@every_verb
@pytest.mark.parametrize("model", BROKEN_MODELS.values(), ids=BROKEN_MODELS.keys())
def test_a_broken_model_is_refused_with_what_is_broken(
    refuses: Refuses, write_model: WriteModel, command: tuple[str, ...], model: BrokenModel
) -> None:
    scene = write_model(remove("keyframe"), model.edit)
    refuses(*command, scene, because=(re.escape(str(scene)), *model.patterns))


@every_verb
@pytest.mark.parametrize(
    "edit",
    [
        remove(joint("sc_elevation_r")),
        remove(joint("sc_elevation_r"), actuator("sc_elevation_r")),
        remove(actuator("sc_elevation_r")),
        remove(actuator("plane_r")),
        repeat_actuator("plane_r", "plane_two_r"),
    ],
    ids=["hinge", "hinge and servo", "servo", "command", "second command"],
)
def test_a_model_with_keyframes_that_lacks_something_is_refused(
    refuses: Refuses, write_model: WriteModel, command: tuple[str, ...], edit: Edit
) -> None:
    scene = write_model(edit)
    refuses(*command, scene, because=(re.escape(str(scene)), MAKE_ANEW))


@pytest.mark.parametrize("name", ["unknown interpolation", "kp: text", "command twice"])
def test_what_the_plugin_says_is_said_once(refuses: Refuses, write_model: WriteModel, name: str) -> None:
    model = BROKEN_MODELS[name]
    message = refuses("verify", write_model(remove("keyframe"), model.edit), because=())
    assert len(re.findall(model.patterns[0], message)) == 1, message


# --- Files that are no model ---------------------------------------------------------------------


def half(text: str) -> str:
    return text[: len(text) // 2]


NO_MODELS: dict[str, tuple[Callable[[str], str], tuple[str, ...]]] = {
    "nothing in it": (lambda _: "", ("other.xml", MAKE_ANEW)),
    "a table": (lambda _: "elevation_deg,plane_deg\n23,50\n", ("other.xml", MAKE_ANEW)),
    "cut short": (half, ("other.xml", MAKE_ANEW)),
    "another XML": (lambda _: "<html><body/></html>", ("other.xml", MAKE_ANEW)),
    "a model without the plugin": (
        lambda _: "<mujoco><worldbody><body><geom size='1'/></body></worldbody></mujoco>",
        ("other.xml", "no instance of the plugin girdle.rhythm", MAKE_ANEW),
    ),
}


@every_verb
@pytest.mark.parametrize(("change", "patterns"), NO_MODELS.values(), ids=NO_MODELS.keys())
def test_a_file_that_is_no_model_is_refused(
    refuses: Refuses,
    generated: Path,
    tmp_path: Path,
    command: tuple[str, ...],
    change: Callable[[str], str],
    patterns: tuple[str, ...],
) -> None:
    (tmp_path / "other.xml").write_text(change((generated / MODEL_FILE).read_text()))
    refuses(*command, "other.xml", because=patterns)


@every_verb
@pytest.mark.parametrize("name", ["absent.xml", "absent/scene.xml", "."])
def test_an_absent_model_is_refused(refuses: Refuses, command: tuple[str, ...], name: str) -> None:
    refuses(*command, name, because=(f"{re.escape(name)}: ", MAKE_ANEW))


@every_verb
def test_a_scene_whose_model_is_gone_is_refused(
    refuses: Refuses, generated: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    (tmp_path / SCENE_FILE).write_bytes((generated / SCENE_FILE).read_bytes())
    refuses(*command, SCENE_FILE, because=(SCENE_FILE, MODEL_FILE, MAKE_ANEW))


# --- Plugins -------------------------------------------------------------------------------------

WITH_PLUGIN: dict[str, tuple[str, ...]] = {
    "verify": ("verify", SCENE),
    "simulate": ("simulate", SCENE, "--elevation", "15:20", "--out", "trace.csv"),
    "generate": ("generate", "--out", "new_model"),
}
every_verb_with_plugin = pytest.mark.parametrize("command", WITH_PLUGIN.values(), ids=WITH_PLUGIN.keys())


def mathematics_library() -> Path:
    """A library that is on every machine and no plugin, where this process has it from."""
    ctypes.CDLL("libm.so.6")
    maps = Path("/proc/self/maps").read_text()
    found = re.search(r"/\S*libm[.-]\S*$", maps, re.MULTILINE)
    assert found, maps
    return Path(found[0])


@every_verb_with_plugin
def test_a_plugin_may_be_named_by_its_path(
    girdle_fine: Girdle, generated: Path, plugin_library: Path, command: tuple[str, ...]
) -> None:
    girdle_fine(*with_scene(command, generated), "--plugin", plugin_library)


@every_verb_with_plugin
@pytest.mark.parametrize("name", ["my_plugin.so", "./my_plugin.so"])
def test_a_plugin_in_this_folder_may_be_named_by_its_name(
    girdle_fine: Girdle,
    generated: Path,
    plugin_library: Path,
    tmp_path: Path,
    command: tuple[str, ...],
    name: str,
) -> None:
    (tmp_path / "my_plugin.so").symlink_to(plugin_library)
    girdle_fine(*with_scene(command, generated), "--plugin", name)


NO_PLUGINS = ("absent.so", "./text.so", "./folder.so", "LIBRARY")


def no_plugin(name: str, folder: Path) -> str:
    (folder / "text.so").write_text("no library\n")
    (folder / "folder.so").mkdir()
    return str(mathematics_library()) if name == "LIBRARY" else name


@every_verb_with_plugin
@pytest.mark.parametrize("name", NO_PLUGINS)
def test_a_file_that_is_no_plugin_is_refused_with_the_fix(
    girdle: Girdle, generated: Path, tmp_path: Path, command: tuple[str, ...], name: str
) -> None:
    plugin = no_plugin(name, tmp_path)
    finished = girdle(*with_scene(command, generated), "--plugin", plugin)
    expect_one_message(finished, re.escape(plugin.removeprefix("./")), "--plugin")
    assert finished.output == b""


@every_verb_with_plugin
@pytest.mark.parametrize("name", NO_PLUGINS)
def test_without_a_plugin_nothing_is_written(
    girdle: Girdle, generated: Path, tmp_path: Path, command: tuple[str, ...], name: str
) -> None:
    plugin = no_plugin(name, tmp_path)
    before = contents(tmp_path)
    assert girdle(*with_scene(command, generated), "--plugin", plugin).code == REFUSED
    assert contents(tmp_path) == before


def test_without_a_plugin_an_earlier_model_stays_as_it_was(
    girdle: Girdle, generated: Path, tmp_path: Path
) -> None:
    (tmp_path / "new_model").mkdir()
    (tmp_path / "new_model" / SCENE_FILE).write_text("earlier\n")
    before = contents(tmp_path)
    assert girdle("generate", "--out", "new_model", "--plugin", "absent.so").code == REFUSED
    assert contents(tmp_path) == before
