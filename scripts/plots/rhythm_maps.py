# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Maps over elevation and plane: upward rotation, and the distance to each published rhythm."""

from __future__ import annotations

from typing import Any

import numpy as np
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle, Numbers, Rows
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from style import BLACK, DIVERGING, SEQUENTIAL, name_panel, save

ROTATION_NAME = "map_of_upward_rotation"
DISTANCE_NAME = "maps_of_published_rhythms"

MEASURED = "Girdle"
FROZEN = "frozen girdle"

ELEVATIONS = "0:180:{step}"
# From a multiple of every step, a little beyond what an arm reaches.
PLANES = "-105:135:{step}"
STEP_DEG = 1
QUICK_STEP_DEG = 15
# `compare` answers for six rhythms each.
COMPARED_STEP_DEG = 2.5

# Just outside of the table: where contours of the distance have the table's border.
BORDER_DEG = 1e-6
# What the colours of the published rhythms reach; the frozen girdle goes far beyond.
DIFFERENCE_DEG = 20
FROZEN_DIFFERENCE_DEG = 60


# Columns of the comparison, what they are called, and the sign with which they are counted here.
COMPARED = (
    ("st_upward_rotation_difference_deg", "more upward rotation", -1),
    ("sc_protraction_difference_deg", "more protraction", 1),
)


def prepare(axes: Axes) -> None:
    axes.set_xticks(np.arange(-90, 136, 45))
    axes.set_yticks(np.arange(0, 181, 30))
    for side in ("top", "right"):
        axes.spines[side].set_visible(True)


def draw_border(axes: Axes, distance: tuple[Numbers, Numbers, Numbers]) -> None:
    planes_deg, elevations_deg, distance_deg = distance
    axes.contour(planes_deg, elevations_deg, distance_deg, [BORDER_DEG], colors="white", linewidths=4)
    axes.contour(planes_deg, elevations_deg, distance_deg, [BORDER_DEG], colors=BLACK, linewidths=1.8)


def draw_lines(axes: Axes, field: tuple[Numbers, Numbers, Numbers], levels: Numbers, color: str) -> None:
    lines = axes.contour(*field, levels, colors=color, linewidths=0.8)
    axes.clabel(lines, fmt="%g", fontsize=9)


def directions(step_deg: float) -> tuple[str, ...]:
    """The options for a grid over all directions of the arm."""
    elevations, planes = (text.format(step=step_deg) for text in (ELEVATIONS, PLANES))
    return ("--elevation", elevations, "--plane", planes)


def measured_distance(girdle: Girdle, step_deg: float) -> tuple[Numbers, Numbers, Numbers]:
    rows = girdle.rows(
        "solve",
        *directions(step_deg),
    )
    return rows.map("distance_deg")


def make_rotation(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else STEP_DEG
    distance = measured_distance(girdle, step_deg)
    map_file = f"{ROTATION_NAME}.csv"
    girdle.run(
        "compare",
        *directions(step_deg),
        "--out",
        map_file,
    )
    rows = Rows((girdle.folder / map_file).read_text()).only("rhythm", MEASURED)
    planes_deg, elevations_deg, rotation_deg = rows.map("st_upward_rotation_deg")
    upward = (planes_deg, elevations_deg, -rotation_deg)

    canvas, axes = plt.subplots(figsize=(8.4, 6))
    colors = axes.pcolormesh(*upward, cmap=SEQUENTIAL, shading="nearest", rasterized=True)
    draw_lines(axes, upward, np.arange(-10.0, 71.0, 10.0), "white")
    draw_border(axes, distance)
    prepare(axes)
    axes.set_xlabel("plane of elevation (deg): 0 frontal, 40 scapular, 90 sagittal")
    axes.set_ylabel("humeral elevation (deg)")
    canvas.colorbar(colors, label="upward rotation (deg)")
    save(canvas, girdle.folder, ROTATION_NAME)

    at = [0, 30, 60, 90, 120, 150, 180]
    shown_planes = [-90, -60, -30, 0, 45, 90, 135]
    table = NumberTable(
        "Upward rotation (deg) by elevation (deg) and plane",
        ["elevation", *(f"plane {plane}" for plane in shown_planes)],
        [
            [str(elevation)] + [value_at(upward, plane, elevation) for plane in shown_planes]
            for elevation in at
        ],
    )
    return Figure(
        ROTATION_NAME,
        "Upward rotation of the scapula over all that an arm reaches",
        "Inside the black border are the table's positions (of elevations below 30 the clavicle's "
        "and the AC joint's are derived) and what lies between; outside, the rhythm "
        "goes on by a rule, and how far from the border it is stands in the column distance_deg of "
        "girdle solve. Where nothing is drawn, the arm does not get.",
        "A map of upward rotation, some 5 to 60 degrees, which grows with elevation in all planes. "
        "A black rectangle from elevation 15 to 120 and plane 0 to 90 marks the table.",
        [table],
        girdle.take_commands(),
    )


def value_at(field: tuple[Numbers, Numbers, Numbers], plane_deg: float, elevation_deg: float) -> str:
    """A value of the map for a table; a dash where it has none."""
    planes_deg, elevations_deg, values = field
    value = values[elevations_deg == elevation_deg, planes_deg == plane_deg]
    return rounded(value[0], 1) if value.size and np.isfinite(value[0]) else "-"


def make_distances(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else COMPARED_STEP_DEG
    distance = measured_distance(girdle, step_deg)
    map_file = f"{DISTANCE_NAME}.csv"
    summary = girdle.answer(
        "compare",
        *directions(step_deg),
        "--out",
        map_file,
    )
    rows = Rows((girdle.folder / map_file).read_text())
    names = [rhythm["name"] for rhythm in summary["rhythms"] if rhythm["name"] != MEASURED]
    canvas, panels = plt.subplots(
        2, len(names), figsize=(3.05 * len(names), 6.6), sharex=True, sharey=True, squeeze=False
    )
    for row, (column, what, sign) in zip(panels, COMPARED, strict=True):
        for axes, name in zip(row, names, strict=True):
            planes_deg, elevations_deg, values = rows.only("rhythm", name).map(column)
            if not np.isfinite(values).any():
                axes.axis("off")
                axes.text(
                    0.5,
                    0.5,
                    "says nothing\nof the clavicle",
                    ha="center",
                    va="center",
                    transform=axes.transAxes,
                )
                continue
            difference = (planes_deg, elevations_deg, sign * values)
            reach_deg = FROZEN_DIFFERENCE_DEG if name == FROZEN else DIFFERENCE_DEG
            colors = axes.pcolormesh(
                *difference,
                cmap=DIVERGING,
                vmin=-reach_deg,
                vmax=reach_deg,
                shading="nearest",
                rasterized=True,
            )
            draw_lines(axes, difference, np.arange(-90, 91, reach_deg / 4), BLACK)
            draw_border(axes, distance)
            prepare(axes)
            axes.tick_params(labelbottom=True)
            if name in (FROZEN, [n for n in names if n != FROZEN][-1]):
                canvas.colorbar(colors, ax=axes, extend="both", label=f"{what} (deg)")
    for axes, name in zip(panels[0], names, strict=True):
        name_panel(axes, name)
    for axes in panels[1]:
        axes.set_xlabel("plane (deg)")
    for axes in panels[:, 0]:
        axes.set_ylabel("elevation (deg)")
    save(canvas, girdle.folder, DISTANCE_NAME)
    return Figure(
        DISTANCE_NAME,
        "Published rhythms beside the measured one",
        "How much more upward rotation of the scapula (upper row) and protraction of the clavicle "
        "(lower row) each rhythm has than the measured one. The frozen girdle, that of an arm that "
        "turns in the glenohumeral joint alone, has its own scale. The black border is that of the "
        "measured data.",
        "Maps over plane and elevation for five rhythms. Within the measured border the published "
        "ones differ by up to ten degrees, the frozen girdle by up to 42 degrees at elevation 120.",
        difference_tables(summary, names),
        girdle.take_commands(),
    )


def difference_tables(summary: dict[str, Any], names: list[str]) -> list[NumberTable]:
    """The program's own summary: within the table, and on all of the map."""
    quantities = {
        "st_upward_rotation": "upward rotation",
        "sc_protraction": "clavicular protraction",
    }
    by_name = {rhythm["name"]: rhythm for rhythm in summary["rhythms"]}
    rows = []
    for name in names:
        for difference in by_name[name]["differences"]:
            if difference["of"] not in quantities or difference["in_table"] is None:
                continue
            inside, everywhere = difference["in_table"], difference["on_map"]
            rows.append(
                [f"{name}, {quantities[difference['of']]}"]
                + [
                    text
                    for part in (inside, everywhere)
                    for text in (rounded(part["rms_deg"], 1), rounded(part["largest_deg"], 1))
                ]
            )
    header = ["rhythm, of", "rms in the table (deg)", "largest (deg)", "rms on the map", "largest"]
    caption = (
        "As girdle compare prints it: rhythm minus measured, with ISB's sign, so + is less upward rotation"
    )
    return [NumberTable(caption, header, rows)]
