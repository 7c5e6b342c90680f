# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models in MuJoCo's binary format, MJB, which names plugins by their slot number in the process
that saved it."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
from conftest import PROGRAM_TIMEOUT_S, Girdle, Refuses

MODELS = Path(__file__).resolve().parents[2] / "model" / "shoulder_tree"
MODEL = MODELS / "shoulder_right.xml"
POSITION_MODEL = MODELS / "shoulder_right_position.xml"
BINARY = "model.mjb"

VERBS: dict[str, tuple[str, ...]] = {
    "verify": ("verify", BINARY),
    "simulate": ("simulate", BINARY, "--elevation", "15:20", "--seconds", "0.1", "--out", "out"),
    "render": ("render", BINARY, "--keyframe", "hanging", "--size", "64x48", "--out", "out.png"),
}
every_verb = pytest.mark.parametrize("command", VERBS.values(), ids=VERBS.keys())

MJB_FIX = "[Gg]ive its XML"

# A process that has MuJoCo with the named plugin alone; Python's bindings load others with it.
SAVE = """
import ctypes, sys
engine, plugin, model, binary = sys.argv[1:]
mujoco = ctypes.CDLL(engine, mode=ctypes.RTLD_GLOBAL)
mujoco.mj_loadXML.restype = ctypes.c_void_p
mujoco.mj_loadPluginLibrary(plugin.encode())
loaded = mujoco.mj_loadXML(model.encode(), None, None, 0)
mujoco.mj_saveModel(ctypes.c_void_p(loaded), binary.encode(), None, 0)
"""


def save_with_one_plugin(plugin: Path, model: Path, binary: Path) -> None:
    (engine,) = Path(mujoco.__file__).parent.glob("libmujoco.so*")
    command: list[str | Path] = [sys.executable, "-c", SAVE, engine, plugin, model, binary]
    subprocess.run(command, check=True, timeout=PROGRAM_TIMEOUT_S)


@pytest.fixture(scope="module")
def own_binary(plugin_library: Path, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The model, saved where girdle.rhythm is the only plugin, as it is in the program."""
    path = tmp_path_factory.mktemp("own") / BINARY
    save_with_one_plugin(plugin_library, MODEL, path)
    return path.read_bytes()


@every_verb
def test_a_binary_model_gives_what_its_text_gives(
    girdle_fine: Girdle, own_binary: bytes, tmp_path: Path, command: tuple[str, ...]
) -> None:
    (tmp_path / BINARY).write_bytes(own_binary)
    given = []
    for model in (tmp_path / BINARY, MODEL):
        text = girdle_fine(*(model if word == BINARY else word for word in command)).text
        files = [path.read_bytes() for path in tmp_path.glob("out*")]
        given.append((text.splitlines()[1:], files))  # the first line of a report names the model
    assert given[0] == given[1]


@every_verb
def test_a_binary_model_that_python_saved_is_refused_with_the_reason(
    refuses: Refuses, engine_with_plugin: None, tmp_path: Path, command: tuple[str, ...]
) -> None:
    model = mujoco.MjModel.from_xml_path(str(MODEL))
    assert model.plugin[0] != 0, "Python's MuJoCo has registered no other plugin"
    mujoco.mj_saveModel(model, str(tmp_path / BINARY))
    slot = model.plugin[0]
    refuses(*command, because=(BINARY, f"slot number, and {slot} is another", MJB_FIX, "Python"))


# An actuator of a plugin that MuJoCo brings along.
OTHER_PLUGIN = """
<mujoco>
  <extension>
    <plugin plugin="mujoco.pid">
      <instance name="pid"><config key="kp" value="1"/></instance>
    </plugin>
  </extension>
  <worldbody><body><joint name="hinge"/><geom size="1"/></body></worldbody>
  <actuator><plugin plugin="mujoco.pid" instance="pid" joint="hinge"/></actuator>
</mujoco>
"""


@every_verb
def test_a_slot_that_another_plugin_had_is_not_taken_for_this_one(
    refuses: Refuses, tmp_path: Path, command: tuple[str, ...]
) -> None:
    (tmp_path / "pid.xml").write_text(OTHER_PLUGIN)
    plugin = Path(mujoco.__file__).parent / "plugin" / "libactuator.so"
    save_with_one_plugin(plugin, tmp_path / "pid.xml", tmp_path / BINARY)
    refuses(*command, because=(BINARY, "slot number, and 0 is another", MJB_FIX))


def with_number(place: int, number: bytes) -> Callable[[bytes], bytes]:
    return lambda binary: binary[:place] + number + binary[place + len(number) :]


def size(index: int) -> int:
    """Where an MJB has this one of its sizes: after five numbers of four bytes."""
    return 5 * 4 + 8 * index


HUGE = struct.pack("q", 1 << 36)

BROKEN_BINARIES: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "nothing in it": (lambda _: b"", "is no binary model"),
    "the text of the model": (lambda _: MODEL.read_bytes(), "is no binary model"),
    "four bytes": (lambda binary: binary[:4], "is no binary model"),
    "another beginning": (with_number(0, b"\0"), "is no binary model"),
    "another version": (with_number(12, struct.pack("i", 3017000)), "another version of MuJoCo"),
    "cut short in its sizes": (lambda binary: binary[:300], "is cut short or damaged"),
    "cut short in its arrays": (lambda binary: binary[:-9], "is cut short or damaged"),
    "a byte too long": (lambda binary: binary + b"\0", "is cut short or damaged"),
    "too many degrees of freedom": (with_number(size(1), HUGE), "is cut short or damaged"),
    "too many of all": (with_number(size(0), HUGE * 90), "damaged|cannot load it"),
}


@every_verb
@pytest.mark.parametrize(("change", "reason"), BROKEN_BINARIES.values(), ids=BROKEN_BINARIES.keys())
def test_a_broken_binary_model_is_refused(
    refuses: Refuses,
    own_binary: bytes,
    tmp_path: Path,
    command: tuple[str, ...],
    change: Callable[[bytes], bytes],
    reason: str,
) -> None:
    (tmp_path / BINARY).write_bytes(change(own_binary))
    refuses(*command, because=(BINARY, reason, MJB_FIX))


@every_verb
def test_a_number_that_ends_mujoco_is_refused(
    refuses: Refuses, tmp_path: Path, command: tuple[str, ...]
) -> None:
    model = mujoco.MjModel.from_xml_path(str(POSITION_MODEL))
    model.body_jntadr[-1] = np.iinfo(np.int32).max
    mujoco.mj_saveModel(model, str(tmp_path / BINARY))
    reason = "is damaged: a process that stepped it|cannot load it"
    refuses(*command, because=(BINARY, reason, MJB_FIX))


@every_verb
@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir], ids=["pipe", "folder"])
def test_what_is_no_file_is_refused(
    refuses: Refuses, tmp_path: Path, command: tuple[str, ...], make: Callable[[Path], None]
) -> None:
    make(tmp_path / BINARY)
    refuses(*command, because=(BINARY, "is not a regular file", "girdle generate"))
