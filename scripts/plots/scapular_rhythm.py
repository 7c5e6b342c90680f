# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Scapula and clavicle in the thorax against humeral elevation, as laboratories plot them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle, Numbers, Rows
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from style import BLACK, BLUE, BROWN, GREEN, GREY, PURPLE, RHYTHMS, VERMILION, name_panel, save

NAME = "scapular_rhythm"

GIRDLE = "Girdle"
FROZEN = "frozen girdle"
# The published rhythms are drawn in this one; two of them know no plane.
COMPARED_PLANE_DEG = 40
PLANES: dict[int, dict[str, Any]] = {
    0: {"color": BLUE, "marker": "o"},
    40: {"color": VERMILION, "marker": "s"},
    90: {"color": GREEN, "marker": "^"},
}
LAST_ELEVATION_DEG = 150
STEP_DEG = 1
QUICK_STEP_DEG = 15
FADED = 0.45  # of lines where nothing was measured

# Thin, and in other colours than the planes: Girdle is what the picture is of.
OTHER_COLORS = {
    "Inman": BLACK,
    "Braman": BLACK,
    "de Groot and Brand": BROWN,
    "MoBL-ARMS": PURPLE,
    FROZEN: GREY,
}

MEASURED_TABLE = Path(__file__).parents[2] / "data" / "ludewig2009.csv"
# In its column origin: the scapula in the thorax was measured there, the clavicle was not.
CLAVICLE_DERIVED = "sc_ac_derived"

TABLE_ELEVATIONS_DEG = (30, 60, 90, 120)


@dataclass(frozen=True)
class Angle:
    """An angle as laboratories plot it."""

    column: str  # of the program and of the measured table
    sign: int  # by which that is multiplied
    bone: str
    name: str
    more: str  # what a larger value means

    @property
    def label(self) -> str:
        sign = "-" if self.sign < 0 else ""
        return f"{self.more} (deg) →\n{sign}{self.column}"


ANGLES = (
    Angle("st_upward_rotation_deg", -1, "scapula", "upward rotation", "more upward rotation"),
    Angle("st_tilt_deg", 1, "scapula", "posterior tilt", "more posterior tilt"),
    Angle("st_internal_rotation_deg", 1, "scapula", "internal rotation", "more internal rotation"),
    Angle("sc_elevation_deg", -1, "clavicle", "elevation", "more elevation"),
    Angle("sc_protraction_deg", -1, "clavicle", "retraction", "more retraction"),
)


def measured_rows() -> Rows:
    """The measured table of the project's own data."""
    lines = MEASURED_TABLE.read_text().splitlines(keepends=True)
    return Rows("".join(line for line in lines if not line.startswith("#")))


def curve(rows: Rows, angle: Angle, plane_deg: int) -> tuple[Numbers, Numbers]:
    """Elevations and the angle as it is plotted, in one plane."""
    here = rows.numbers("plane_deg") == plane_deg
    return rows.numbers("elevation_deg")[here], angle.sign * rows.numbers(angle.column)[here]


def draw_published(panel: Axes, rows: Rows, names: list[str], angle: Angle) -> None:
    for name in names:
        elevations_deg, values_deg = curve(rows.only("rhythm", name), angle, COMPARED_PLANE_DEG)
        if np.isfinite(values_deg).any():
            panel.plot(elevations_deg, values_deg, **published_look(name))


def published_look(name: str) -> dict[str, Any]:
    return {
        "color": OTHER_COLORS.get(name, BLACK),
        "linestyle": RHYTHMS[name]["linestyle"],
        "linewidth": 1.2,
        "zorder": 1,
    }


def draw_girdle(panel: Axes, rows: Rows, angle: Angle) -> None:
    """Strong where the table has positions, pale beyond."""
    rhythm = rows.only("rhythm", GIRDLE)
    for plane_deg, look in PLANES.items():
        elevations_deg, values_deg = curve(rhythm, angle, plane_deg)
        inside = rhythm.numbers("in_table")[rhythm.numbers("plane_deg") == plane_deg] == 1
        panel.plot(elevations_deg, values_deg, color=look["color"], alpha=FADED, linewidth=1.4)
        panel.plot(elevations_deg[inside], values_deg[inside], color=look["color"], linewidth=2)


def draw_points(panel: Axes, table: Rows, angle: Angle) -> None:
    """Filled where the angle was measured, hollow where it was derived."""
    derived = np.array([word == CLAVICLE_DERIVED for word in table.words("origin")])
    if angle.bone != "clavicle":
        derived[:] = False
    planes_deg = table.numbers("plane_deg")
    for plane_deg, look in PLANES.items():
        elevations_deg, values_deg = curve(table, angle, plane_deg)
        hollow = derived[planes_deg == plane_deg]
        for chosen, face in ((~hollow, look["color"]), (hollow, "white")):
            panel.plot(
                elevations_deg[chosen],
                values_deg[chosen],
                linestyle="none",
                marker=look["marker"],
                markersize=4.2,
                markerfacecolor=face,
                markeredgecolor=look["color"],
                markeredgewidth=0.8,
                zorder=4,
            )


def draw_legend(panel: Axes, names: list[str]) -> None:
    """In a panel of its own, which has no axes."""
    panel.axis("off")
    words = {0: "frontal", 40: "scapular", 90: "sagittal"}
    planes = [
        Line2D([], [], linewidth=2, markersize=5, label=f"{plane_deg}° ({words[plane_deg]})", **look)
        for plane_deg, look in PLANES.items()
    ]
    first = panel.legend(
        handles=planes,
        title="plane of elevation:\npoints measured, line Girdle",
        loc="upper left",
        bbox_to_anchor=(-0.12, 1.1),
        alignment="left",
        fontsize=11,
        title_fontsize=11,
    )
    panel.add_artist(first)
    panel.legend(
        handles=[Line2D([], [], **published_look(name), label=name) for name in names],
        title=f"other rhythms, plane {COMPARED_PLANE_DEG}°",
        loc="lower left",
        bbox_to_anchor=(-0.12, -0.2),
        alignment="left",
        fontsize=11,
        title_fontsize=11,
        handlelength=2.8,
    )


def make(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else STEP_DEG
    map_file = f"{NAME}.csv"
    summary = girdle.answer(
        "compare", "--elevation", f"0:{LAST_ELEVATION_DEG}:{step_deg}", "--plane", "0:90:10",
        "--out", map_file,
    )  # fmt: skip
    rows = Rows((girdle.folder / map_file).read_text())
    table = measured_rows()
    names = [rhythm["name"] for rhythm in summary["rhythms"] if rhythm["name"] != GIRDLE]

    canvas, panels = plt.subplots(2, 3, figsize=(9.4, 6.4))
    canvas.get_layout_engine().set(w_pad=0.06, h_pad=0.06, hspace=0.03)
    *drawn, legend = panels.flat
    for panel, angle in zip(drawn, ANGLES, strict=True):
        name_panel(panel, f"{angle.bone}: {angle.name}")
        draw_published(panel, rows, names, angle)
        draw_girdle(panel, rows, angle)
        draw_points(panel, table, angle)
        # The arrow points up: the label is turned.
        panel.set_ylabel(angle.label, fontsize=9)
        panel.set_xlim(0, LAST_ELEVATION_DEG)
        panel.set_xticks(range(0, LAST_ELEVATION_DEG + 1, 30))
        panel.set_xlabel("humeral elevation (deg)", fontsize=10)
        panel.grid(True, color="#e4e4e4", linewidth=0.6)
    draw_legend(legend, names)
    canvas.supxlabel(
        "Points: Ludewig et al., J Bone Joint Surg Am 2009;91:378-389, mean of 12 people; "
        "hollow: clavicle derived.\n"
        "Lines: Girdle, pale beyond the measured elevations. It follows the table's clavicle and "
        "its scapula in the clavicle;\n"
        "the table's own scapula in the thorax, which the points show, differs from the two together.",
        fontsize=10,
        x=0.01,
        ha="left",
    )
    save(canvas, girdle.folder, NAME)
    return Figure(
        NAME,
        "Scapula and clavicle in the thorax",
        "Points are the published mean angles. Lines are Girdle, which interpolates clavicle in "
        "thorax and scapula in clavicle; the published scapula in the thorax differs a little from "
        "these two together, so that the lines of the scapula pass beside the points. The signs are "
        "those of laboratories: up is more upward rotation, more posterior tilt, more internal "
        "rotation, a more elevated and a more retracted clavicle. Each axis names the column of "
        "girdle solve, with a minus where its sign is the opposite. The other rhythms are those of "
        f"girdle compare in plane {COMPARED_PLANE_DEG}. Inman and Braman say nothing but upward "
        "rotation.",
        "Five plots against humeral elevation. The scapula turns upward and tilts to the back while "
        "the arm rises, the clavicle rises and retracts; the scapula's internal rotation changes "
        "little. The three planes lie beside one another, and the frozen girdle is a level line.",
        [angle_table(rows, table), sources(summary)],
        girdle.take_commands(),
    )


def angle_table(rows: Rows, table: Rows) -> NumberTable:
    """Girdle beside what was measured."""
    rhythm = rows.only("rhythm", GIRDLE)
    lines = []
    for plane_deg in PLANES:
        for elevation_deg in TABLE_ELEVATIONS_DEG:
            line = [f"{plane_deg}, {elevation_deg}"]
            for angle in ANGLES:
                for source in (rhythm, table):
                    elevations_deg, values_deg = curve(source, angle, plane_deg)
                    (value_deg,) = values_deg[elevations_deg == elevation_deg]
                    line.append(rounded(value_deg, 1))
            lines.append(line)
    header = ["plane, elevation (deg)"]
    for angle in ANGLES:
        header += [f"{angle.bone}: {angle.name}", "measured"]
    return NumberTable(
        "Girdle beside the measurement (deg), each angle with the sign of the plot", header, lines
    )


def sources(summary: dict[str, Any]) -> NumberTable:
    return NumberTable(
        "The other rhythms",
        ["rhythm", "says", "source"],
        [
            [rhythm["name"], rhythm["says"], rhythm["source"]]
            for rhythm in summary["rhythms"]
            if rhythm["name"] != GIRDLE
        ],
    )
