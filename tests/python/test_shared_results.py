# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What is kept for several tests is what the program would make again."""

from __future__ import annotations

from pathlib import Path

import pytest
from shared_results import SharedResults

TIMEOUT_S = 60

# Counts its runs, and ends as the scene says; makes what a model has.
PROGRAM = """#!/bin/sh
echo run >>"${0%/*}/runs"
case $1 in
  verify) echo report; code=$(cat "$2"); [ "$code" = crash ] && kill -9 $$; exit "$code" ;;
  generate)
    while [ "$1" != --out ]; do shift; done
    touch "$2/scene.xml" "$2/shoulder_right.xml" ;;
esac
"""


@pytest.fixture
def shared(tmp_path: Path) -> SharedResults:
    program = tmp_path / "girdle"
    program.write_text(PROGRAM)
    program.chmod(0o755)
    return SharedResults(program, tmp_path / "build", TIMEOUT_S)


def runs(folder: Path) -> int:
    return (folder / "runs").read_text().count("run")


def write_scene(folder: Path, says: str) -> Path:
    scene = folder / "model" / "scene.xml"
    scene.parent.mkdir(exist_ok=True)
    scene.write_text(says)
    return scene


@pytest.mark.parametrize("code", [0, 1])
def test_a_report_is_kept(shared: SharedResults, tmp_path: Path, code: int) -> None:
    scene = write_scene(tmp_path, str(code))
    first = shared.verify(scene)
    assert (first.code, first.text) == (code, "report\n")
    assert shared.verify(scene) == first
    assert runs(tmp_path) == 1


@pytest.mark.parametrize(("end", "code"), [("crash", -9), ("2", 2), ("3", 3), ("4", 4)])
def test_an_end_without_report_is_not_kept(
    shared: SharedResults, tmp_path: Path, end: str, code: int
) -> None:
    scene = write_scene(tmp_path, end)
    for count in (1, 2):
        with pytest.raises(AssertionError, match=rf"\({code}, ''\)"):
            shared.verify(scene)
        assert runs(tmp_path) == count


def test_another_scene_beside_the_same_words_is_verified(shared: SharedResults, tmp_path: Path) -> None:
    assert shared.verify(write_scene(tmp_path, "0")).code == 0
    assert shared.verify(write_scene(tmp_path, "1")).code == 1


@pytest.mark.parametrize("words", [("--table", "{}"), ("--table={}",)], ids=" ".join)
def test_a_file_with_other_bytes_makes_another_model(
    shared: SharedResults, tmp_path: Path, words: tuple[str, ...]
) -> None:
    table = tmp_path / "table.csv"
    command = [word.format(table) for word in words]
    table.write_text("1")
    first = shared.generate(*command)
    assert shared.generate(*command) == first
    assert runs(tmp_path) == 1
    table.write_text("2")
    assert shared.generate(*command) != first
    assert runs(tmp_path) == 2


def test_a_folder_with_another_file_makes_another_model(shared: SharedResults, tmp_path: Path) -> None:
    body = tmp_path / "body"
    (body / "targets").mkdir(parents=True)
    models = [shared.generate("--skin", body)]
    (body / "targets" / "a").write_text("1")
    models.append(shared.generate("--skin", body))
    (body / "targets" / "a").write_text("2")
    models.append(shared.generate("--skin", body))
    (body / "targets" / "a").rename(body / "targets" / "b")
    models.append(shared.generate("--skin", body))
    assert shared.generate("--skin", body) == models[-1]
    assert len({model.folder for model in models}) == runs(tmp_path) == 4
