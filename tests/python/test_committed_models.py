# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The committed models are what the program emits today, byte for byte."""

from __future__ import annotations

from pathlib import Path

import pytest
from shared_results import SharedResults

MODELS = Path(__file__).resolve().parents[2] / "model"
FAMILIES = {
    "shoulder_tree": ["--assembly", "tree"],
    "shoulder_loop": ["--assembly", "loop"],
    "shoulder_skin": ["--skin", "implicit"],
}
SCENES = sorted(MODELS.glob("*/scene*.xml"))


@pytest.fixture(scope="module", params=FAMILIES)
def emitted(request: pytest.FixtureRequest, shared: SharedResults) -> tuple[Path, dict[str, Path]]:
    """A family's committed folder, and the files that the program emits for it today."""
    files: dict[str, Path] = {}
    for side in ("right", "left", "both"):
        for actuation in ("plugin", "position"):
            words = ("--side", side, "--actuation", actuation)
            folder = shared.generate(*FAMILIES[request.param], *words).folder
            files |= {path.name: path for path in folder.iterdir()}
    return MODELS / request.param, files


def test_every_family_is_tested() -> None:
    assert sorted(path.name for path in MODELS.iterdir() if path.is_dir()) == sorted(FAMILIES)
    assert len(SCENES) == 6 * len(FAMILIES)


def test_committed_models_are_regenerated_byte_for_byte(
    emitted: tuple[Path, dict[str, Path]],
) -> None:
    committed, made = emitted
    kept = {path.name for path in committed.iterdir() if path.suffix in (".xml", ".skn")}
    assert made.keys() == kept
    for name, path in made.items():
        assert path.read_bytes() == (committed / name).read_bytes(), name


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_committed_model_passes_every_line_of_the_report(scene: Path, shared: SharedResults) -> None:
    """With the MuJoCo of this build; the tests run with each that is supported."""
    verified = shared.verify(scene)
    assert (verified.code, verified.message) == (0, ""), verified.text
    assert verified.answer["passed"]
