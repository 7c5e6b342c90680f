# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""ISB's axial rotation of the rhythm's own humerus: how far the two zeros are apart."""

from __future__ import annotations

import numpy as np
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle
from matplotlib import pyplot as plt
from rhythm_maps import (
    ELEVATIONS,
    PLANES,
    QUICK_STEP_DEG,
    STEP_DEG,
    draw_border,
    draw_lines,
    prepare,
    value_at,
)
from style import BLACK, BLUE, GREEN, SEQUENTIAL, VERMILION, WHITE, name_panel, save

NAME = "axial_zero"

LINES = {0: (BLUE, "-"), 40: (GREEN, (0, (5, 2))), 90: (VERMILION, (0, (1, 1.2)))}
SHOWN_ELEVATIONS = (0, 15, 30, 60, 90, 120, 150, 180)
SHOWN_PLANES = (-90, -45, 0, 40, 90, 135)


def make(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else STEP_DEG
    rows = girdle.rows(
        "solve",
        "--elevation",
        ELEVATIONS.format(step=step_deg),
        "--plane",
        PLANES.format(step=step_deg),
    )
    planes_deg, elevations_deg, axial_deg = rows.map("used_axial_isb_deg")
    # Hanging, planes that no arm reaches are answered by others, and are not clamped.
    is_reached = (rows.map("clamped")[2] == 0) & (rows.map("used_plane_deg")[2] == planes_deg)
    field = (planes_deg, elevations_deg, np.where(is_reached, axial_deg, np.nan))
    lines = {
        plane: girdle.rows("solve", "--elevation", ELEVATIONS.format(step=step_deg), "--plane", str(plane))
        for plane in SHOWN_PLANES
    }
    canvas, (curves, axes) = plt.subplots(1, 2, figsize=(12, 5))
    name_panel(curves, "(a) over elevation")
    for plane, (color, dashes) in LINES.items():
        curves.plot(
            lines[plane].numbers("elevation_deg"),
            lines[plane].numbers("used_axial_isb_deg"),
            color=color,
            linestyle=dashes,
            label=f"plane {plane}",
        )
    curves.set_xticks(np.arange(0, 181, 30))
    curves.set_xlabel("humeral elevation (deg)")
    curves.set_ylabel("ISB's axial rotation of axial 0 (deg)")
    curves.legend(loc="upper right")
    name_panel(axes, "(b) over elevation and plane")
    colors = axes.pcolormesh(*field, cmap=SEQUENTIAL, shading="nearest", rasterized=True)
    # Where the map is dark, and where it is not.
    draw_lines(axes, field, np.arange(-120.0, -50.0, 20.0), WHITE)
    draw_lines(axes, field, np.arange(-40.0, 100.0, 20.0), BLACK)
    draw_border(axes, rows.map("distance_deg"))
    prepare(axes)
    axes.set_xlabel("plane of elevation (deg)")
    axes.set_ylabel("humeral elevation (deg)")
    canvas.colorbar(colors, label="ISB's axial rotation (deg)")
    save(canvas, girdle.folder, NAME)
    table = NumberTable(
        "ISB's axial rotation (deg) of the rhythm's own humerus, by elevation (deg) and plane",
        ["elevation", *(f"plane {plane}" for plane in SHOWN_PLANES)],
        [
            [str(elevation)]
            + [
                value_at(lines[plane].map("used_axial_isb_deg"), plane, elevation)
                if value_at(lines[plane].map("clamped"), plane, elevation) == rounded(0, 1)
                else "-"
                for plane in SHOWN_PLANES
            ]
            for elevation in SHOWN_ELEVATIONS
        ],
    )
    return Figure(
        NAME,
        "What an axial rotation of a laboratory is to the rhythm",
        "ISB's axial rotation is the third angle of Y-X'-Y'' of the humerus in the thorax. The figure "
        "shows it for --axial 0, which is the rhythm's own humerus. Measured angles of ISB that are given "
        "as --axial without --axial-from isb are wrong by this much. At elevations 0 and 180 the angle "
        "has a meaning only together with the plane.",
        "Three curves, of planes 0, 40 and 90, that fall from near zero or minus eighty to between "
        "minus fifty and minus eighty degrees, and a map over plane and elevation that goes from "
        "positive behind the body to minus 130 across the chest.",
        [table],
        girdle.take_commands(),
    )
