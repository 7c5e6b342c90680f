# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The bodies that are drawn: models with a skin, made by the program."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from girdle_program import Girdle


@dataclass
class Body:
    """A model with both shoulders and a skin."""

    name: str  # of files
    title: str
    scene: str  # the model with light and floor, in the folder of the figures
    # For `girdle verify`: whose bones the model has, if not the built-in ones.
    anatomy: tuple[str, ...] = ()


def implicit_body(girdle: Girdle) -> Body:
    """The body made of solids, which needs nothing but the program."""
    return _generated(girdle, "implicit", "body of solids", "implicit")


def human_body(girdle: Girdle, folder: Path) -> Body:
    """The man, from the files that scripts/fetch_body has put into this folder."""
    # Relative, so that the page says nothing of this machine.
    return _generated(girdle, "man", "man", os.path.relpath(folder, girdle.folder))


def _generated(girdle: Girdle, name: str, title: str, skin: str) -> Body:
    folder = f"models/{name}"
    girdle.run("generate", "--side", "both", "--skin", skin, "--out", folder)
    # A body that brings its own bones has them in a file beside its model.
    landmarks = f"{folder}/landmarks_both.csv"
    has_own_bones = (girdle.folder / landmarks).is_file()
    anatomy = ("--anatomy", landmarks) if has_own_bones else ()
    return Body(name, title, f"{folder}/scene_both.xml", anatomy)
