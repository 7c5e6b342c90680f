# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Figs. 11 and 12 of the paper: abduction from the front and from the back."""

from __future__ import annotations

from bodies import Body
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle
from matplotlib import pyplot as plt
from panels import View, compose, draw, drawn

ELEVATIONS_DEG = (15, 30, 60, 90, 120)
PAPERS_NUMBER = {"front": 11, "back": 12}
COLUMNS = {"skin": "skin", "both": "bones in the skin"}
# Wide enough for both arms held out.
ASPECT = 2
HEIGHT = 640
QUICK_HEIGHT = 100
# Nothing is beside the hands.
KEPT = (0.2, 0.8, 0, 1)


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
        rows.append([str(elevation)] + [rounded(answer["angles_deg"][name], 1) for name in quantities])
    return NumberTable(
        "Angles of the bones (deg); elevation and upward rotation are negative upwards, as ISB counts them",
        ["elevation (deg)", *quantities.values()],
        rows,
    )


def pictures(girdle: Girdle, body: Body, camera: str, quick: bool) -> plt.Figure:
    height = QUICK_HEIGHT if quick else HEIGHT
    width = round(ASPECT * height)
    panels = [
        [draw(girdle, body, elevation, View(camera, show, width, height, kept=KEPT)) for show in COLUMNS]
        for elevation in ELEVATIONS_DEG
    ]
    rows = [f"{elevation}°" for elevation in ELEVATIONS_DEG]
    return compose(panels, list(COLUMNS.values()), rows, panel_width=3.2)


def make(girdle: Girdle, body: Body, camera: str, quick: bool) -> Figure:
    number = PAPERS_NUMBER[camera]
    figure = Figure(
        f"figure_{number}_abduction_{camera}_{body.name}",
        f"Fig. {number}. Abduction from the {camera}: {body.title}",
        "Both arms raised in the frontal plane to 15, 30, 60, 90 and 120 degrees, with the girdle "
        "as measured.",
        f"Five rows of two pictures from the {camera}: the body's skin, and beside it the bones in "
        "a translucent skin, with the arms from nearly hanging to well above the shoulders.",
        [bone_angles(girdle)],
    )
    return drawn(girdle, figure, lambda: pictures(girdle, body, camera, quick))
