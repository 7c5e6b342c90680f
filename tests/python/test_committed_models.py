# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The committed models are what the program emits today, byte for byte."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

MODELS = Path(__file__).resolve().parents[2] / "model"
FAMILIES = {
    "shoulder_tree": ["--assembly", "tree"],
    "shoulder_loop": ["--assembly", "loop"],
    "shoulder_skin": ["--skin", "implicit"],
}
SCENES = sorted(MODELS.glob("*/scene*.xml"))


@pytest.fixture(scope="module", params=FAMILIES)
def emitted(request: pytest.FixtureRequest, program: Path, tmp_path_factory) -> tuple[Path, Path]:
    """A family's committed folder and what the program emits into one today."""
    folder = tmp_path_factory.mktemp(request.param)
    for side in ("right", "left", "both"):
        for actuation in ("plugin", "position"):
            subprocess.run(
                [program, "generate", *FAMILIES[request.param], "--side", side]
                + ["--actuation", actuation, "--out", folder],
                check=True,
                capture_output=True,
            )
    return MODELS / request.param, folder


def test_every_family_is_tested() -> None:
    assert sorted(path.name for path in MODELS.iterdir() if path.is_dir()) == sorted(FAMILIES)
    assert len(SCENES) == 6 * len(FAMILIES)


def test_committed_models_are_regenerated_byte_for_byte(emitted: tuple[Path, Path]) -> None:
    committed, made = emitted
    emitted_names = {path.name for path in made.iterdir()}
    kept = {path.name for path in committed.iterdir() if path.suffix in (".xml", ".skn")}
    assert emitted_names == kept
    for path in made.iterdir():
        assert path.read_bytes() == (committed / path.name).read_bytes(), path.name


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_committed_model_passes_every_line_of_the_report(scene: Path, program: Path) -> None:
    """With the MuJoCo of this build; the tests run with each that is supported."""
    finished = subprocess.run(
        [program, "verify", scene], capture_output=True, text=True, check=False
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr
