# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The plugin where data travel: pickles, copies, a second copy of the library.

Each case runs in a process of its own, because what went wrong here ended the process.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import mujoco
import pytest
from conftest import Girdle, installed

TIMEOUT_S = 60

# Put before each script: a model and data that are in the middle of a motion.
START = """
import copy, gc, pickle, sys
import mujoco
def load(): mujoco.mj_loadPluginLibrary(sys.argv[1])
def start():
    model = mujoco.MjModel.from_xml_path(sys.argv[2])
    data = mujoco.MjData(model)
    data.ctrl[0] = 1.2
    mujoco.mj_step(model, data, 20)
    return model, data
def end(model, data):
    mujoco.mj_step(model, data, 50)
    return data.qpos.tolist(), data.sensordata.tolist()
"""


def run(
    script: str,
    *arguments: str | Path,
    folder: Path,
    first: str = "",
    stdin: bytes | None = None,
    **environment: str,
) -> subprocess.CompletedProcess[bytes]:
    """Runs a script after START, with `first` before all."""
    return subprocess.run(
        [sys.executable, "-c", first + START + script, *arguments],
        input=stdin,
        capture_output=True,
        cwd=folder,  # for MuJoCo's log
        timeout=TIMEOUT_S,
        check=False,
        env={**os.environ, **environment},
    )


def assert_says(finished: subprocess.CompletedProcess[bytes], text: str) -> None:
    assert finished.returncode == 0, finished.stderr.decode()
    assert finished.stdout.decode() == text
    assert finished.stderr.decode() == ""


# --- Pickles and copies --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "copied", ["pickle.loads(pickle.dumps(data))", "copy.copy(data)", "copy.deepcopy(data)"]
)
def test_data_that_were_copied_go_on_as_their_original(
    copied: str, plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    """In any order of going on and of being deleted."""
    script = f"""
load()
model, data = start()
first, second = {copied}, {copied}
ends = [end(model, first)]
del first
gc.collect()
ends.append(end(model, data))
del data
gc.collect()
ends.append(end(model, second))
del second, model
gc.collect()
assert ends[0] == ends[1] == ends[2]
assert abs(ends[0][0][5]) > 1e-3  # it moves
print("same")
"""
    assert_says(run(script, plugin_library, model_path, folder=tmp_path), "same\n")


def test_data_that_are_deleted_give_their_memory_back(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    """A controller has some 100 kB: 3000 that stayed would be hundreds of megabytes."""
    script = """
load()
model, _ = start()
def pages_after(count):
    for _ in range(count):
        mujoco.mj_step(model, mujoco.MjData(model))
    return int(open("/proc/self/statm").read().split()[1])
before = pages_after(100)
print((pages_after(3000) - before) * 4096 < 20e6)
"""
    assert_says(run(script, plugin_library, model_path, folder=tmp_path), "True\n")


def test_pickled_data_go_on_in_another_process(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    send = """
load()
model, data = start()
sys.stdout.buffer.write(pickle.dumps((model, data, end(model, copy.copy(data)))))
"""
    receive = """
load()
model, data, expected = pickle.loads(sys.stdin.buffer.read())
assert end(model, data) == expected
again = pickle.loads(pickle.dumps(data))
assert end(model, again) == end(model, data)
del data, again
gc.collect()
print("same")
"""
    sent = run(send, plugin_library, model_path, folder=tmp_path)
    assert sent.returncode == 0, sent.stderr.decode()
    received = run(receive, plugin_library, model_path, folder=tmp_path, stdin=sent.stdout)
    assert_says(received, "same\n")


def test_many_data_that_come_and_go_and_are_copied_stay_apart(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    script = """
load()
model, data = start()
packed = pickle.dumps(data)
expected = end(model, data)
kept = []
for k in range(300):
    one = pickle.loads(packed) if k % 3 else mujoco.MjData(model)
    if k % 2: kept.append((k, one))
for k, one in kept:
    if k % 3: assert end(model, one) == expected, k
print("apart")
"""
    assert_says(run(script, plugin_library, model_path, folder=tmp_path), "apart\n")


# --- A second copy -------------------------------------------------------------------------------

LOAD_BOTH = """
load()
mujoco.mj_loadPluginLibrary(sys.argv[3])
print(len(end(*start())[0]))
"""


def test_a_load_line_after_the_packages_folder_does_no_harm(
    girdle_fine: Girdle, package: Path, plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    girdle_fine("doctor", "--install", "--engine", package)
    assert installed(package).is_file()
    script = "load()\nprint(len(end(*start())[0]))"
    site = str(package.parent)
    finished = run(script, plugin_library, model_path, folder=tmp_path, PYTHONPATH=site)
    assert_says(finished, "9\n")
    assert not (tmp_path / "MUJOCO_LOG.TXT").exists()


def test_a_second_copy_of_the_same_plugin_does_nothing(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    copied = shutil.copy(plugin_library, tmp_path / "libcopied.so")
    assert_says(run(LOAD_BOTH, plugin_library, model_path, copied, folder=tmp_path), "9\n")


def test_the_plugin_of_another_girdle_is_not_used_and_says_so(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    """Another build: the same with a byte behind its end."""
    other = tmp_path / "libother.so"
    other.write_bytes(plugin_library.read_bytes() + b"\0")
    finished = run(LOAD_BOTH, plugin_library, model_path, other, folder=tmp_path)
    assert finished.returncode == 0, finished.stderr.decode()
    # Before 3.5 the engine prints its warnings too, and C and Python have each a buffer.
    assert b"9\n" in finished.stdout
    said = (tmp_path / "MUJOCO_LOG.TXT").read_text()
    version = r"\(Girdle \d+\.\d+\.\d+\)"
    expected = (
        rf"girdle\.rhythm of {re.escape(str(other))} {version} is not used, because this process "
        rf"has the plugin of {re.escape(str(plugin_library))} {version} already\. "
        "Load one of them; after an update `girdle doctor --install`"
    )
    assert re.search(expected, said), said


# --- Engines that are not what they say ----------------------------------------------------------

# It says VERSION. Where a plugin registers with it, it calls the plugin's init with a model and data
# that are no structs of any version.
STRANGE_ENGINE = """
#include <cstdarg>
#include <cstdio>
#include <cstring>
extern "C" {
int mj_version() { return VERSION; }
const char* mj_versionString() { return "9.9.9"; }
void mju_warning(const char* text, ...) {
  va_list arguments;
  va_start(arguments, text);
  std::vprintf(text, arguments);
  va_end(arguments);
}
void mj_isSparse() {}
void mj_id2name() {}
void mj_getPluginConfig() {}
void mjp_defaultPlugin(void* plugin) { std::memset(plugin, 0, 152); }
void* mjp_getPlugin() { return nullptr; }
void mjp_registerPlugin(const char* plugin) {
  static unsigned char model[1 << 18], data[1 << 18];
  for (int i = 0; i < 1 << 18; ++i) model[i] = data[i] = i % 251;
  int (*init)(const void*, void*, int);
  std::memcpy(&init, plugin + 48, sizeof(init));
  std::printf("registered, init: %d\\n", init(model, data, 0));
  for (int i = 0; i < 1 << 18; ++i) if (data[i] != i % 251) return (void)std::puts("data written");
}
}
"""


def said_in_a_strange_engine(version: int, plugin: Path, folder: Path) -> str:
    """What is printed where the plugin meets an engine that says this version."""
    source, library = folder / "engine.cc", folder / "libmujoco.so.9.9.9"
    source.write_text(STRANGE_ENGINE)
    subprocess.run(["g++", "-shared", "-fPIC", f"-DVERSION={version}", source, "-o", library], check=True)
    load = "import ctypes, sys\nctypes.CDLL(sys.argv[1])\nctypes.CDLL(sys.argv[2])"
    command: list[str | Path] = [sys.executable, "-c", load, library, plugin]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.without_engine
def test_an_engine_of_a_version_that_nobody_knows_is_refused_with_the_fix(
    plugin_library: Path, tmp_path: Path
) -> None:
    said = said_in_a_strange_engine(9009009, plugin_library, tmp_path)
    assert "registered" not in said
    assert f"{plugin_library} (Girdle " in said
    assert "does not know MuJoCo 9.9.9" in said
    assert "Run a MuJoCo from 3.2.7 to 4.0.1" in said


@pytest.mark.without_engine
def test_an_engine_that_is_laid_out_otherwise_than_it_says_is_refused(
    plugin_library: Path, tmp_path: Path
) -> None:
    said = said_in_a_strange_engine(4000001, plugin_library, tmp_path)
    assert "its mjModel is laid out in another way" in said
    assert "registered, init: -1" in said
    assert "data written" not in said


def test_of_two_engines_the_one_that_is_known_gets_the_plugin(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    """The strange one is loaded first."""
    said_in_a_strange_engine(9009009, plugin_library, tmp_path)  # makes the library
    first = "import ctypes, sys; ctypes.CDLL(sys.argv[3])"
    script = "load()\nprint(len(end(*start())[0]))"
    strange = tmp_path / "libmujoco.so.9.9.9"
    finished = run(script, plugin_library, model_path, strange, folder=tmp_path, first=first)
    assert_says(finished, "9\n")


# --- Faults of single versions -------------------------------------------------------------------

SPARSE = """
load()
messages = []
mujoco.set_mju_user_warning(messages.append)
spec = mujoco.MjSpec.from_file(sys.argv[2])
spec.option.jacobian = mujoco.mjtJacobian.mjJAC_SPARSE
mujoco.MjData(spec.compile())
print(len(messages), messages[:1])
messages.clear()
spec.option.jacobian = mujoco.mjtJacobian.mjJAC_AUTO
mujoco.MjData(spec.compile())
print(len(messages))
"""


def test_sparse_models_are_warned_of_where_they_are_solved_wrongly(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    finished = run(SPARSE, plugin_library, model_path, folder=tmp_path)
    assert finished.returncode == 0, finished.stderr.decode()
    if mujoco.__version__ == "4.0.0":
        assert b'<option jacobian="dense"/>' in finished.stdout
        assert finished.stdout.endswith(b"]\n0\n")
    else:
        assert finished.stdout == b"0 []\n0\n"


ATTACHED = """
load()
messages = []
mujoco.set_mju_user_warning(messages.append)
for degree in (True, False):
    parent = mujoco.MjSpec()
    parent.compiler.degree = degree
    parent.attach(mujoco.MjSpec.from_file(sys.argv[2]), prefix="her_", frame=parent.worldbody.add_frame())
    try:
        mujoco.MjData(parent.compile())
    except ValueError as error:  # what the engine makes of a warning while it compiles
        messages.append(str(error))
    ours = [message for message in messages if "girdle.rhythm" in message]
    print(len(ours), *ours[:1])
    messages.clear()
"""


def test_ranges_that_are_taken_for_degrees_are_warned_of(
    plugin_library: Path, model_path: Path, tmp_path: Path
) -> None:
    finished = run(ATTACHED, plugin_library, model_path, folder=tmp_path)
    assert finished.returncode == 0, finished.stderr.decode()
    if mujoco.__version__ == "3.3.0":
        assert b"set compiler.degree of the parent to False before you attach\n0\n" in finished.stdout
    else:
        assert finished.stdout == b"0\n0\n"
