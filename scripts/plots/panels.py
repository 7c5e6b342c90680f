# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures that the program draws, put side by side under labels."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from bodies import Body
from figure import Figure
from girdle_program import Girdle, NoPictures, Numbers
from matplotlib import pyplot as plt
from style import save


@dataclass(frozen=True)
class View:
    """What is drawn of a body, and which part of the picture is kept."""

    camera: str
    show: str
    width: int
    height: int
    girdle: str = "measured"
    side: str = ""
    # Left, right, upper and lower edge of what is kept, as shares of width and height.
    kept: tuple[float, float, float, float] = (0, 1, 0, 1)


def draw(girdle: Girdle, body: Body, elevation_deg: int, view: View) -> Numbers:
    """The picture of a body with its arms abducted."""
    words = ["--elevation", str(elevation_deg), "--plane", "0"]
    if view.girdle != "measured":
        words += ["--girdle", view.girdle]
    if view.side:
        words += ["--side", view.side]
    (girdle.folder / "panels").mkdir(exist_ok=True)
    what = [body.name, view.camera, view.show, view.girdle, str(elevation_deg)]
    file = f"panels/{'_'.join(what)}.png"
    size = f"{view.width}x{view.height}"
    words += ["--camera", view.camera, "--size", size, "--show", view.show, "--out", file]
    scene = body.translucent_scene if view.show == "both" else body.scene
    girdle.run("render", scene, *words)
    picture = plt.imread(girdle.folder / file)
    left, right, upper, lower = view.kept
    height, width = picture.shape[:2]
    return picture[round(upper * height) : round(lower * height), round(left * width) : round(right * width)]


def compose(
    pictures: list[list[Numbers]],
    columns: list[str],
    rows: list[str],
    panel_width: float,
    level: float | None = None,
) -> plt.Figure:
    """One picture of many, all of one size: a label above each column and left of each row.

    `panel_width` is in inches. At `level`, a share of the height from above, all have a line to
    compare heights by.
    """
    height, width = pictures[0][0].shape[:2]
    panel_height = panel_width * height / width
    canvas, panels = plt.subplots(
        len(rows),
        len(columns),
        figsize=(panel_width * len(columns) + 0.4, panel_height * len(rows) + 0.35),
        squeeze=False,
    )
    canvas.get_layout_engine().set(w_pad=0.02, h_pad=0.02, wspace=0, hspace=0)
    for row, row_label in enumerate(rows):
        for column, column_label in enumerate(columns):
            panel = panels[row][column]
            panel.imshow(pictures[row][column], interpolation="antialiased")
            if level is not None:
                panel.axhline(level * height, color="white", linewidth=1, linestyle=(0, (4, 3)))
            panel.set_xticks([])
            panel.set_yticks([])
            for spine in panel.spines.values():
                spine.set_visible(False)
            if row == 0:
                panel.set_title(column_label)
        panels[row][0].set_ylabel(row_label)
    return canvas


def drawn(girdle: Girdle, figure: Figure, compose_pictures: Callable[[], plt.Figure]) -> Figure:
    """The figure with its files, or with why this machine cannot draw it beside its numbers."""
    try:
        save(compose_pictures(), girdle.folder, figure.name)
    except NoPictures as error:
        figure.missing = f"Not drawn. {error}"
    figure.commands += girdle.take_commands()
    return figure
