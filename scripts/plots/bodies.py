# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The bodies that are drawn: models with a skin, made by the program."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path

from girdle_program import Girdle


@dataclass
class Body:
    """A model with both shoulders and a skin."""

    name: str  # of files
    title: str
    scene: str  # the model with light and floor, in the folder of the figures
    # The same to look into: without mouth and eyes, which a translucent head would show.
    translucent_scene: str
    # For `girdle verify`: whose bones the model has, if not the built-in ones.
    anatomy: tuple[str, ...] = ()


def implicit_body(girdle: Girdle) -> Body:
    """The body made of solids, which needs nothing but the program."""
    return _generated(girdle, "implicit", "body of solids", "--skin", "implicit")


def human_body(girdle: Girdle, folder: Path) -> Body:
    """The man, from the files that scripts/fetch_body has put into this folder."""
    # Relative, so that the page says nothing of this machine.
    skin = ("--skin", os.path.relpath(folder, girdle.folder))
    body = _generated(girdle, "man", "man", *skin)
    headless = _generated(girdle, "man_without_head", "man", *skin, "--head", "cut")
    return replace(body, translucent_scene=headless.scene)


def _generated(girdle: Girdle, name: str, title: str, *skin: str) -> Body:
    folder = f"models/{name}"
    girdle.run("generate", "--side", "both", *skin, "--out", folder)
    # A body that brings its own bones has them in a file beside its model.
    landmarks = f"{folder}/landmarks_both.csv"
    has_own_bones = (girdle.folder / landmarks).is_file()
    anatomy = ("--anatomy", landmarks) if has_own_bones else ()
    scene = f"{folder}/scene_both.xml"
    return Body(name, title, scene, scene, anatomy)
