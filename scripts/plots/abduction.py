# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Figs. 11 and 12 of the paper: abduction from the front and from the back."""

from __future__ import annotations

from bodies import Body
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle
from panels import PANEL_PIXELS, View, compose, draw
from style import save

ELEVATIONS_DEG = (15, 30, 60, 90, 120)
PAPERS_NUMBER = {"front": 11, "back": 12}
ROWS = {"skin": "skin", "both": "bones in the skin"}
QUICK_PIXELS = 100


def bone_angles(girdle: Girdle) -> NumberTable:
    """What the bones in the pictures do, which is the same from the front and from the back."""
    quantities = {
        "sc_protraction": "clavicle: protraction",
        "sc_elevation": "elevation",
        "sc_rotation": "posterior rotation",
        "ac_internal_rotation": "AC: internal rotation",
        "ac_upward_rotation": "upward rotation",
        "ac_tilt": "posterior tilt",
    }
    rows = []
    for elevation in ELEVATIONS_DEG:
        answer = girdle.answer("solve", "--elevation", str(elevation), "--plane", "0")
        rows.append(
            [str(elevation)] + [rounded(answer["angles_deg"][name], 1) for name in quantities]
        )
    return NumberTable(
        "Angles of the bones (deg); elevation and upward rotation are negative upwards, as ISB "
        "counts them",
        ["elevation (deg)", *quantities.values()],
        rows,
    )


def make(girdle: Girdle, body: Body, camera: str, quick: bool) -> Figure:
    number = PAPERS_NUMBER[camera]
    name = f"figure_{number}_abduction_{camera}_{body.name}"
    height = QUICK_PIXELS if quick else PANEL_PIXELS
    pictures = [
        [
            draw(girdle, body, elevation, View(camera, show, height, height))
            for elevation in ELEVATIONS_DEG
        ]
        for show in ROWS
    ]
    columns = [f"{elevation}°" for elevation in ELEVATIONS_DEG]
    save(compose(pictures, columns, list(ROWS.values())), girdle.folder, name)
    return Figure(
        name,
        f"Fig. {number}. Abduction from the {camera}: {body.title}",
        "Both arms raised in the frontal plane to 15, 30, 60, 90 and 120 degrees, with the girdle "
        "as measured.",
        f"Two rows of five pictures from the {camera}: the body's skin, and below it the bones in "
        "a translucent skin, with the arms from hanging to well above the shoulders.",
        [bone_angles(girdle)],
        girdle.take_commands(),
    )
