# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The reach over elevation and plane: measured, derived, modelled, and what no arm takes."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle, Numbers, Rows
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch
from style import BLACK, BLUE, SKY, save

NAME = "reach"

STEP_DEG = 1
QUICK_STEP_DEG = 15
FIRST_PLANE_DEG = -180
LAST_PLANE_DEG = 180

BEYOND = "out of reach"
# From the surest to what no arm takes; grey ones of four lightnesses.
COLORS = {"measured": BLUE, "derived": SKY, "modelled": "#dbe9f1", BEYOND: "#8c8c8c"}

POSITIONS = Path(__file__).parents[2] / "data" / "functional_positions.csv"


def functional_positions() -> list[dict[str, str]]:
    """Where arms are for daily tasks, of the project's own data: position, elevation, plane."""
    lines = [line for line in POSITIONS.read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def kinds_of(rows: Rows) -> tuple[Numbers, Numbers, Numbers]:
    """Planes, elevations, and at [elevation, plane] the number of a word of COLORS."""
    words = list(COLORS)
    kinds = [
        BEYOND if clamped == "1" else origin
        for origin, clamped in zip(rows.words("origin"), rows.words("clamped"), strict=True)
    ]
    planes_deg, plane_index = np.unique(rows.numbers("plane_deg"), return_inverse=True)
    elevations_deg, elevation_index = np.unique(rows.numbers("elevation_deg"), return_inverse=True)
    field = np.full((len(elevations_deg), len(planes_deg)), np.nan)
    field[elevation_index, plane_index] = [words.index(kind) for kind in kinds]
    return planes_deg, elevations_deg, field


def draw_positions(axes: Axes, positions: list[dict[str, str]]) -> None:
    for number, position in enumerate(positions, start=1):
        at = (float(position["plane_deg"]), float(position["elevation_deg"]))
        axes.plot(*at, marker="o", color="white", markeredgecolor=BLACK, markersize=15)
        axes.annotate(str(number), at, ha="center", va="center", fontsize=9)


def make(girdle: Girdle, quick: bool) -> Figure:
    step = QUICK_STEP_DEG if quick else STEP_DEG
    rows = girdle.rows(
        "solve",
        "--elevation",
        f"0:180:{step}",
        "--plane",
        f"{FIRST_PLANE_DEG}:{LAST_PLANE_DEG}:{step}",
    )
    field = kinds_of(rows)
    positions = functional_positions()

    canvas, axes = plt.subplots(figsize=(8.8, 5))
    axes.pcolormesh(
        *field,
        cmap=ListedColormap(list(COLORS.values())),
        vmin=-0.5,
        vmax=len(COLORS) - 0.5,
        shading="nearest",
        rasterized=True,
    )
    draw_positions(axes, positions)
    axes.set_xticks(np.arange(FIRST_PLANE_DEG, LAST_PLANE_DEG + 1, 45))
    axes.set_yticks(np.arange(0, 181, 30))
    axes.set_xlabel("plane of elevation (deg): 0 frontal, 90 in front, negative behind")
    axes.set_ylabel("humeral elevation (deg)")
    handles = [Patch(facecolor=color, label=kind) for kind, color in COLORS.items()]
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 1.12), ncol=len(COLORS))
    save(canvas, girdle.folder, NAME)

    return Figure(
        NAME,
        "What an arm reaches, and where each part of it comes from",
        "Measured and derived are the table's; modelled goes on by a rule; a direction out of reach "
        "is answered by one that is reached, and the answer says so. Circles are where eight people's "
        "arms were for daily tasks and at the ends of their reach (Pearl et al. 1992), numbered as "
        "below. At elevations 0 and 180 all planes are one direction.",
        "A map of elevation over plane. A rectangle from plane 0 to 90 and elevation 15 to 120 is "
        "measured, its lower edge derived. Around it lies what is modelled, from plane -95 up to "
        "elevation 62.5, then less and less to plane -30 from elevation 115 on, and to plane 135 "
        "in front. The rest is out of reach. All numbered circles lie within.",
        [positions_table(girdle, positions)],
        girdle.take_commands(),
    )


def positions_table(girdle: Girdle, positions: list[dict[str, str]]) -> NumberTable:
    rows = []
    for number, position in enumerate(positions, start=1):
        answer = girdle.answer(
            "solve", "--elevation", position["elevation_deg"], "--plane", position["plane_deg"]
        )
        rows.append(
            [
                f"{number} {position['position']}",
                position["elevation_deg"],
                position["plane_deg"],
                answer["origin"],
                rounded(answer["distance_deg"], 0),
            ]
        )
    return NumberTable(
        "Functional positions (deg), and how far they are from measured directions",
        ["position", "elevation", "plane", "origin", "distance"],
        rows,
    )
