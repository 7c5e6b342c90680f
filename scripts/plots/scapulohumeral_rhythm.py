# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Upward rotation and scapulohumeral ratio against elevation, among the published rhythms."""

from __future__ import annotations

import numpy as np
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle, Numbers, Rows
from matplotlib import pyplot as plt
from style import BLACK, RHYTHMS, name_panel, save

NAME = "scapulohumeral_rhythm"

MEASURED = "Girdle"
# A girdle that does not move has no ratio, and is in nobody's band.
FROZEN = "frozen girdle"
PLANES_DEG = (0, 40, 90)
PLANE_LINES = {0: "-", 40: (0, (6, 2)), 90: (0, (1, 1.2))}

# The ratio is of changes since here, as `girdle compare` has it, and steady enough from there on.
FROM_ELEVATION_DEG = 30
RATIO_FROM_DEG = 45
LAST_MEASURED_DEG = 120
STEP_DEG = 1
QUICK_STEP_DEG = 15


def upward_deg(rows: Rows, rhythm: str, plane_deg: int) -> tuple[Numbers, Numbers]:
    """Elevations and upward rotation, which is counted upwards here."""
    lines = rows.only("rhythm", rhythm)
    here = lines.numbers("plane_deg") == plane_deg
    return lines.numbers("elevation_deg")[here], -lines.numbers("st_upward_rotation_deg")[here]


def ratios(elevations_deg: Numbers, rotation_deg: Numbers) -> tuple[Numbers, Numbers]:
    """(Change of elevation - change of upward rotation) / change of upward rotation."""
    start = int(np.flatnonzero(elevations_deg == FROM_ELEVATION_DEG)[0])
    change_deg = rotation_deg - rotation_deg[start]
    late = elevations_deg >= RATIO_FROM_DEG
    raised_deg = (elevations_deg - FROM_ELEVATION_DEG)[late]
    return elevations_deg[late], (raised_deg - change_deg[late]) / change_deg[late]


def make(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else STEP_DEG
    # From the lowest measured elevation, in the planes that were measured.
    elevations = f"15:{LAST_MEASURED_DEG}:{step_deg}"
    map_file = f"{NAME}.csv"
    planes = "0:90:10"
    summary = girdle.answer("compare", "--elevation", elevations, "--plane", planes, "--out", map_file)
    rows = Rows((girdle.folder / map_file).read_text())
    published = [rhythm["name"] for rhythm in summary["rhythms"] if rhythm["name"] not in (MEASURED, FROZEN)]

    canvas, (rotation, ratio) = plt.subplots(1, 2, figsize=(12.6, 5.2))
    name_panel(rotation, "(a) upward rotation of the scapula")
    name_panel(ratio, f"(b) scapulohumeral ratio since {FROM_ELEVATION_DEG}°")
    for panel, curve in ((rotation, lambda e, r: (e, r)), (ratio, ratios)):
        curves = {
            (name, plane): curve(*upward_deg(rows, name, plane)) for name in published for plane in PLANES_DEG
        }
        axis_deg = next(iter(curves.values()))[0]
        values = np.array([value for _, value in curves.values()])
        panel.fill_between(
            axis_deg,
            values.min(axis=0),
            values.max(axis=0),
            color="#e8e8e8",
            linewidth=0,
            zorder=0,
            label="all published, planes 0 to 90",
        )
        for name in published:
            # In the scapular plane; a rhythm that knows planes is a band of its own.
            panel.plot(*curves[name, 40], label=f"{name}, plane 40", **RHYTHMS[name])
        for plane in PLANES_DEG:
            elevations_deg, value = curve(*upward_deg(rows, MEASURED, plane))
            panel.plot(
                elevations_deg,
                value,
                color=BLACK,
                linewidth=2.6,
                linestyle=PLANE_LINES[plane],
                label=f"measured, plane {plane}",
            )
        panel.set_xlabel("humeral elevation (deg)")
    rotation.set_ylabel("upward rotation (deg)")
    ratio.set_ylabel("glenohumeral : scapulothoracic")
    rotation.set_xlim(15, LAST_MEASURED_DEG)
    ratio.set_xlim(RATIO_FROM_DEG, LAST_MEASURED_DEG)
    handles, labels = rotation.get_legend_handles_labels()
    canvas.legend(handles, labels, loc="upper center", ncol=4, bbox_to_anchor=(0.5, 0.0))
    save(canvas, girdle.folder, NAME)

    names = [MEASURED, *published]
    table = NumberTable(
        f"Scapulohumeral ratio since elevation {FROM_ELEVATION_DEG}",
        ["plane, elevation (deg)", *names],
        [
            [f"{line['plane_deg']:g}, {line['elevation_deg']:g}"] + [rounded(line[name], 2) for name in names]
            for line in summary["scapulohumeral_ratio"]["rows"]
            if line["plane_deg"] in PLANES_DEG
        ],
    )
    sources = NumberTable(
        "Who says what",
        ["rhythm", "says", "source"],
        [
            [rhythm["name"], rhythm["says"], rhythm["source"]]
            for rhythm in summary["rhythms"]
            if rhythm["name"] in published
        ],
    )
    return Figure(
        NAME,
        "Scapulohumeral rhythm against elevation",
        "Upward rotation of the scapula, and how many degrees the glenohumeral joint turns for each "
        f"of them since elevation {FROM_ELEVATION_DEG}. The grey band holds what the published "
        "rhythms say between planes 0 and 90. Those of Inman and of Braman start from the relaxed "
        "posture and are the same in all planes.",
        "Measured upward rotation rises from about 10 to 45 degrees, in the middle of the published "
        "band; the measured ratio lies between 1.7 and 2.5, where the published ones go from 1.5 to "
        "2.3.",
        [table, sources],
        girdle.take_commands(),
    )
