# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""No verb writes over a file that it reads, whatever the file is called."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from conftest import MODEL_FILE, SCENE_FILE, Girdle, Refuses
from reference_rhythm import DATABASE

MOTION = "time_s,elevation_deg,plane_deg\n0,20,40\n0.01,21,40\n"
LANDMARKS = DATABASE.parent / "landmarks.csv"
LAB_LANDMARKS = DATABASE.parent / "example_lab_landmarks.csv"
ELLIPSOIDS = DATABASE.parent / "thorax_ellipsoids.csv"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, generated: Path) -> None:
    """Files of every kind that is read, and other names of some."""
    for name in (MODEL_FILE, SCENE_FILE):
        shutil.copy(generated / name, tmp_path)
    (tmp_path / "motion.csv").write_text(MOTION)
    shutil.copy(DATABASE, tmp_path / "table.csv")
    shutil.copy(LANDMARKS, tmp_path / "landmarks.csv")
    shutil.copy(ELLIPSOIDS, tmp_path / "ellipsoids.csv")
    (tmp_path / "link.csv").symlink_to("motion.csv")
    (tmp_path / "hard.csv").hardlink_to(tmp_path / "motion.csv")
    (tmp_path / "link.png").symlink_to(SCENE_FILE)
    (tmp_path / "my").mkdir()
    shutil.copy(DATABASE, tmp_path / "my" / MODEL_FILE)
    for name in ("motion.so", "so.png", "table.png", "my/deep.xml", "my/floor.png", "parts/bone.obj"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    (tmp_path / "lab").mkdir()
    (tmp_path / "lab" / "leaf.obj").write_text("")
    (tmp_path / "parts" / "my").mkdir()
    (tmp_path / "parts" / "my" / "arm.skn").write_text("")
    shutil.copy(LAB_LANDMARKS, tmp_path / "parts" / "bones.csv")
    (tmp_path / "lab" / "scene.xml").hardlink_to(tmp_path / "parts" / "bones.csv")
    (tmp_path / "parts" / "hard.obj").hardlink_to(tmp_path / "my" / MODEL_FILE)
    (tmp_path / "my" / "deep.xml").write_text(
        '<mujoco><asset><texture fileup="floor.png"/><skin file="arm.skn"/></asset></mujoco>'
    )
    (tmp_path / "leaf.xml").write_text('<mujoco><asset><mesh file="lab/leaf.obj"/></asset></mujoco>')
    (tmp_path / "my" / "child" / "meshes").mkdir(parents=True)
    (tmp_path / "my" / "child" / "meshes" / "z.obj").write_text("")
    (tmp_path / "my" / "child" / "c.xml").write_text(
        '<mujoco><compiler meshdir="meshes"/><include file="part/p.xml"/></mujoco>'
    )
    (tmp_path / "my" / "child" / "part").mkdir()
    (tmp_path / "my" / "child" / "part" / "p.xml").write_text(
        '<mujoco><asset><mesh file="z.obj"/></asset></mujoco>'
    )
    (tmp_path / "whole.xml").write_text(
        '<mujoco><compiler meshdir="parts" strippath="true"/><include file="my/deep.xml"/>'
        '<include file="whole.xml"/><asset><mesh file="gone/bone.obj"/><model file="leaf.xml"/>'
        '<model file="my/child/c.xml"/></asset></mujoco>'
    )


SIMULATE = ("simulate", SCENE_FILE, "--in", "motion.csv")
POSE = ("solve", "--elevation=60", "--plane=40")


@pytest.mark.parametrize(
    ("words", "written", "read"),
    [
        ((*SIMULATE, "--out", "motion.csv"), "--out motion.csv", "--in motion.csv"),
        ((*SIMULATE, "--out", "./my/../motion.csv"), "--out ./my/../motion.csv", "--in"),
        ((*SIMULATE, "--out", "link.csv"), "--out link.csv", "--in motion.csv"),
        ((*SIMULATE, "--out", "hard.csv"), "--out hard.csv", "--in motion.csv"),
        ((*SIMULATE, "--out", SCENE_FILE), f"--out {SCENE_FILE}", f"the model {SCENE_FILE}"),
        ((*SIMULATE, "--out-controls", "link.csv"), "--out-controls link.csv", "--in motion.csv"),
        ((*SIMULATE, "--out-picture", "link.png"), "--out-picture link.png", f"the model {SCENE_FILE}"),
        (
            (*SIMULATE, "--table", "table.csv", "--out", "table.csv"),
            "--out table.csv",
            "--table table.csv",
        ),
        (("solve", "--in", "motion.csv", "--out", "link.csv"), "--out link.csv", "--in motion.csv"),
        ((*POSE, "--table", "table.csv", "--out", "table.csv"), "--out table.csv", "--table table.csv"),
        (
            (*POSE, "--landmarks", "--anatomy", "landmarks.csv", "--out", "landmarks.csv"),
            "--out landmarks.csv",
            "--anatomy landmarks.csv",
        ),
        (
            (*POSE, "--landmarks", "--ellipsoids", "ellipsoids.csv", "--out", "ellipsoids.csv"),
            "--out ellipsoids.csv",
            "--ellipsoids ellipsoids.csv",
        ),
        (
            ("render", SCENE_FILE, "--out", "link.png"),
            "--out link.png",
            f"the model {SCENE_FILE}",
        ),
        (("smooth-table", "--in", "table.csv", "--out", "table.csv"), "--out table.csv", "--in table.csv"),
        (
            ("compare", "--table", "table.csv", "--out", "./table.csv"),
            "--out ./table.csv",
            "--table table.csv",
        ),
        (
            ("fit-thorax", "--anatomy", "landmarks.csv", "--out", "landmarks.csv"),
            "--out landmarks.csv",
            "--anatomy landmarks.csv",
        ),
        (
            ("fit-thorax", "--table", "table.csv", "--out", "table.csv"),
            "--out table.csv",
            "--table table.csv",
        ),
        (
            ("fit-thorax", "--ellipsoids", "ellipsoids.csv", "--out", "ellipsoids.csv"),
            "--out ellipsoids.csv",
            "--ellipsoids ellipsoids.csv",
        ),
        *(
            (
                ("generate", option, f"my/{MODEL_FILE}", "--out", "my"),
                f"--out my/{MODEL_FILE}",
                f"{option} my/{MODEL_FILE}",
            )
            for option in ("--anatomy", "--ellipsoids", "--plugin")
        ),
        (
            ("generate", "--skin", "parts/hard.obj", "--skin-landmarks", "parts/bones.csv", "--out", "my"),
            f"--out my/{MODEL_FILE}",
            "--skin parts/hard.obj",
        ),
        (
            ("generate", "--skin", "parts/bone.obj", "--skin-landmarks", "parts/bones.csv", "--out", "lab"),
            "--out lab/scene.xml",
            "--skin-landmarks parts/bones.csv",
        ),
        (
            (*SIMULATE, "--plugin", "motion.so", "--out", "motion.so"),
            "--out motion.so",
            "--plugin motion.so",
        ),
        (
            ("render", SCENE_FILE, "--plugin", "so.png", "--out", "so.png"),
            "--out so.png",
            "--plugin so.png",
        ),
        (
            ("render", SCENE_FILE, "--elevation", "9", "--table", "table.png", "--out", "table.png"),
            "--out table.png",
            "--table table.png",
        ),
        ((*SIMULATE, "--out", MODEL_FILE), f"--out {MODEL_FILE}", f"the model's file {MODEL_FILE}"),
        (
            ("simulate", "whole.xml", "--in", "motion.csv", "--out", "my/deep.xml"),
            "--out my/deep.xml",
            "the model's file my/deep.xml",
        ),
        (
            ("simulate", "whole.xml", "--in", "motion.csv", "--out-controls", "parts/bone.obj"),
            "--out-controls parts/bone.obj",
            "the model's file parts/bone.obj",
        ),
        (
            ("simulate", "whole.xml", "--in", "motion.csv", "--out", "parts/my/arm.skn"),
            "--out parts/my/arm.skn",
            "the model's file parts/my/arm.skn",
        ),
        (
            ("simulate", "whole.xml", "--in", "motion.csv", "--out", "lab/leaf.obj"),
            "--out lab/leaf.obj",
            "the model's file lab/leaf.obj",
        ),
        (
            ("simulate", "whole.xml", "--in", "motion.csv", "--out", "my/child/meshes/z.obj"),
            "--out my/child/meshes/z.obj",
            "the model's file my/child/meshes/z.obj",
        ),
        (
            ("render", "whole.xml", "--out", "my/floor.png"),
            "--out my/floor.png",
            "the model's file my/floor.png",
        ),
        (
            ("generate", "--table", f"my/{MODEL_FILE}", "--out", "my"),
            f"--out my/{MODEL_FILE}",
            f"--table my/{MODEL_FILE}",
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_an_output_that_is_an_input_is_refused(
    refuses: Refuses, words: tuple[str, ...], written: str, read: str
) -> None:
    because = (f"^girdle: {re.escape(written)}: would replace {re.escape(read)}", "another place$")
    message = refuses(*words, because=because)
    assert message.count("\n") == 1


def test_standard_output_that_leads_to_the_input_is_refused(girdle: Girdle, tmp_path: Path) -> None:
    """As with >>: a file that is read while it grows has no end."""
    with (tmp_path / "motion.csv").open("ab") as appended:
        finished = girdle("solve", "--in", "motion.csv", stdout=appended)
    assert finished.code == 2
    assert finished.message.startswith("girdle: standard output: would replace --in motion.csv, ")
    assert (tmp_path / "motion.csv").read_text() == MOTION


def test_other_files_and_devices_are_written(girdle_fine: Girdle, tmp_path: Path) -> None:
    """A file of the name of a built-in table is no table that is read."""
    girdle_fine("solve", "--in", "motion.csv", "--table", "measured", "--out", "measured")
    assert (tmp_path / "measured").is_file()
    girdle_fine(*SIMULATE, "--out", "/dev/null", "--out-controls", "/dev/null")
