# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Fig. 13 of the paper: the elbow's path while the arm goes round, and how sharply it bends."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from figure import Figure, NumberTable, rounded, significant
from girdle_program import Girdle, Numbers
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from style import GREY, INTERPOLATIONS, name_panel, save

NAME = "figure_13_elbow_path"

ELEVATIONS_DEG = (30, 60, 90, 120)
# The measured plane between the frontal and the sagittal one, where interpolations go from one cell
# to the next.
KNOT_PLANE_DEG = 40
LAST_PLANE_DEG = 90
# Between samples. Differences of second order are then off by less than a thousandth.
STEP_DEG = 0.25
# What is shown closer.
CORNER_ELEVATION_DEG = 30
CORNER_REACH_DEG = 14
QUICK_STEP_DEG = 2.5


@dataclass
class Path:
    """Where the elbow is, plane by plane, at one elevation."""

    planes_deg: Numbers
    p_mm: Numbers  # in the thorax: x forward, y up, z to the right; a row a plane

    @property
    def step_deg(self) -> float:
        return float(self.planes_deg[1] - self.planes_deg[0])

    @property
    def knot(self) -> int:
        """The sample at the knot."""
        return int(np.argmin(np.abs(self.planes_deg - KNOT_PLANE_DEG)))

    def length_mm(self) -> float:
        return float(np.linalg.norm(np.diff(self.p_mm, axis=0), axis=1).sum())

    def velocities_at_knot(self) -> tuple[Numbers, Numbers]:
        """Just before and just behind the knot [mm/deg], by one-sided differences."""
        p, k, h = self.p_mm, self.knot, self.step_deg
        before = (3 * p[k] - 4 * p[k - 1] + p[k - 2]) / (2 * h)
        behind = (-3 * p[k] + 4 * p[k + 1] - p[k + 2]) / (2 * h)
        return before, behind

    def kink_deg(self) -> float:
        """The angle by which the path changes its direction at the knot, at once."""
        before, behind = self.velocities_at_knot()
        across = np.linalg.norm(np.cross(before, behind))
        return float(np.degrees(np.arctan2(across, before @ behind)))

    def velocity_jump_mm_per_deg(self) -> float:
        before, behind = self.velocities_at_knot()
        return float(np.linalg.norm(behind - before))

    def speed(self) -> tuple[Numbers, Numbers]:
        """Planes and |r'| [mm/deg], with a gap at the knot as in `curvature`."""
        values = np.linalg.norm(self.p_mm[2:] - self.p_mm[:-2], axis=1) / (2 * self.step_deg)
        values[self.knot - 1] = np.nan
        return self.planes_deg[1:-1], values

    def curvature(self) -> tuple[Numbers, Numbers]:
        """Planes and |r' x r''| / |r'|^3 [1/m], by central differences.

        No difference reaches across the knot, where a path with a corner has no curvature: there
        stands a gap instead.
        """
        p, h = self.p_mm * 1e-3, self.step_deg
        first = (p[2:] - p[:-2]) / (2 * h)
        second = (p[2:] - 2 * p[1:-1] + p[:-2]) / h**2
        values = np.linalg.norm(np.cross(first, second), axis=1)
        values /= np.linalg.norm(first, axis=1) ** 3
        values[self.knot - 1] = np.nan
        return self.planes_deg[1:-1], values


# By interpolation and elevation.
Paths = dict[str, dict[int, Path]]


def measured_paths(girdle: Girdle, interpolation: str, step_deg: float) -> dict[int, Path]:
    """By elevation, from the table as measured and with its own arm, so that only the interpolation
    differs."""
    elevations = f"{ELEVATIONS_DEG[0]}:{ELEVATIONS_DEG[-1]}:{ELEVATIONS_DEG[1] - ELEVATIONS_DEG[0]}"
    planes = f"0:{LAST_PLANE_DEG}:{step_deg:g}"
    choice = ("--table", "measured", "--interpolation", interpolation, "--closure", "table")
    sweep = ("--elevation", elevations, "--plane", planes)
    rows = girdle.rows("solve", *sweep, *choice, "--landmarks")
    elevation_of_row = rows.numbers("elevation_deg")
    planes_deg = rows.numbers("plane_deg")
    elbow_mm = np.stack([rows.numbers(f"elbow_{axis}_mm") for axis in "xyz"], axis=1)
    return {
        elevation: Path(planes_deg[elevation_of_row == elevation], elbow_mm[elevation_of_row == elevation])
        for elevation in ELEVATIONS_DEG
    }


def draw_from_above(axes: Axes, paths: Paths, elevation: int, label: bool = False) -> None:
    for interpolation, by_elevation in paths.items():
        look = INTERPOLATIONS[interpolation]
        path = by_elevation[elevation]
        axes.plot(
            path.p_mm[:, 2],
            path.p_mm[:, 0],
            color=look["color"],
            linestyle=look["linestyle"],
            label=interpolation if label else None,
        )
    axes.set_aspect("equal")
    axes.set_xlabel("to the right (mm)")
    axes.set_ylabel("forward (mm)")


def draw_paths(axes: Axes, paths: Paths) -> None:
    for elevation in ELEVATIONS_DEG:
        draw_from_above(axes, paths, elevation, label=elevation == ELEVATIONS_DEG[0])
        path = paths["squad"][elevation]
        axes.plot(path.p_mm[path.knot, 2], path.p_mm[path.knot, 0], "o", color=GREY, markersize=5)
        # At the end in the frontal plane, where the paths are apart.
        axes.annotate(
            f"{elevation}°",
            (path.p_mm[0, 2], path.p_mm[0, 0]),
            xytext=(0, -5),
            textcoords="offset points",
            ha="center",
            va="top",
        )
    axes.margins(0.1)
    axes.legend(loc="lower left")


def draw_corner(axes: Axes, paths: Paths) -> None:
    """The lowest path near the knot, where slerp's corner is sharpest."""
    draw_from_above(axes, paths, CORNER_ELEVATION_DEG)
    path = paths["squad"][CORNER_ELEVATION_DEG]
    near = np.abs(path.planes_deg - KNOT_PLANE_DEG) <= CORNER_REACH_DEG
    knot = path.p_mm[path.knot]
    axes.plot(knot[2], knot[0], "o", color=GREY, markersize=5)
    low, high = path.p_mm[near].min(axis=0), path.p_mm[near].max(axis=0)
    axes.set_aspect("equal", adjustable="datalim")
    # The aspect moves these limits, which newer versions of matplotlib warn of if they are fixed.
    axes.set_xlim(low[2], high[2], auto=True)
    axes.set_ylim(low[0], high[0], auto=True)


def draw_speed(axes: Axes, paths: Paths) -> None:
    for interpolation, by_elevation in paths.items():
        look = INTERPOLATIONS[interpolation]
        planes_deg, mm_per_deg = by_elevation[CORNER_ELEVATION_DEG].speed()
        axes.plot(planes_deg, mm_per_deg, color=look["color"], linestyle=look["linestyle"])
    axes.axvline(KNOT_PLANE_DEG, color=GREY, linewidth=0.8, zorder=0)
    axes.set_xlim(0, LAST_PLANE_DEG)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("plane of elevation (deg)")
    axes.set_ylabel("speed (mm/deg)")


def draw_curvatures(panels: Iterable[Axes], paths: Paths) -> None:
    for panel, elevation in zip(panels, ELEVATIONS_DEG, strict=True):
        kink_deg = paths["slerp"][elevation].kink_deg()
        for interpolation, by_elevation in paths.items():
            look = INTERPOLATIONS[interpolation]
            panel.plot(
                *by_elevation[elevation].curvature(),
                color=look["color"],
                linestyle=look["linestyle"],
            )
        panel.axvline(KNOT_PLANE_DEG, color=GREY, linewidth=0.8, zorder=0)
        what = "(d) curvature of the path (1/m), " if elevation == ELEVATIONS_DEG[0] else ""
        name_panel(panel, f"{what}elevation {elevation}°")
        panel.annotate(
            f"slerp: a corner of {rounded(kink_deg, 1)}°",
            (KNOT_PLANE_DEG, 0),
            xytext=(5, 8),
            textcoords="offset points",
            color=INTERPOLATIONS["slerp"]["color"],
        )
        panel.set_ylim(bottom=0)
        panel.set_xlim(0, LAST_PLANE_DEG)


def draw(paths: Paths) -> plt.Figure:
    canvas = plt.figure(figsize=(14, 8.2))
    left, middle, right = canvas.subfigures(1, 3, width_ratios=[1, 0.9, 1.1])
    above = left.subplots()
    name_panel(above, "(a) path of the elbow, from above")
    draw_paths(above, paths)
    corner, speed = middle.subplots(2, 1)
    name_panel(corner, f"(b) the same at {CORNER_ELEVATION_DEG}°, near plane {KNOT_PLANE_DEG}")
    draw_corner(corner, paths)
    name_panel(speed, f"(c) speed of the elbow at {CORNER_ELEVATION_DEG}°")
    draw_speed(speed, paths)
    panels = right.subplots(len(ELEVATIONS_DEG), 1, sharex=True)
    draw_curvatures(panels, paths)
    panels[-1].set_xlabel("plane of elevation (deg)")
    return canvas


def numbers(paths: Paths) -> NumberTable:
    rows = []
    for elevation in ELEVATIONS_DEG:
        for interpolation, by_elevation in paths.items():
            path = by_elevation[elevation]
            _, per_m = path.curvature()
            rows.append(
                [
                    f"{elevation}, {interpolation}",
                    significant(path.kink_deg()),
                    significant(path.velocity_jump_mm_per_deg()),
                    rounded(per_m[path.knot - 2], 2),
                    rounded(per_m[path.knot], 2),
                    rounded(np.nanmax(per_m), 2),
                    rounded(path.length_mm(), 1),
                ]
            )
    return NumberTable(
        "At plane 40, where cells meet, and along the whole path",
        [
            "elevation (deg), interpolation",
            "kink (deg)",
            "jump of velocity (mm/deg)",
            "curvature before (1/m)",
            "curvature behind (1/m)",
            "largest curvature (1/m)",
            "length (mm)",
        ],
        rows,
    )


def make(girdle: Girdle, quick: bool) -> Figure:
    step_deg = QUICK_STEP_DEG if quick else STEP_DEG
    paths = {name: measured_paths(girdle, name, step_deg) for name in INTERPOLATIONS}
    save(draw(paths), girdle.folder, NAME)
    return Figure(
        NAME,
        "Fig. 13. The elbow's path while the plane goes from 0 to 90",
        "The arm goes from the frontal plane to the sagittal one at four elevations; the dots are at "
        f"the measured plane of {KNOT_PLANE_DEG} degrees. There slerp turns a corner: its curvature "
        "has no bound, and in its place stands the angle by which the path changes direction at "
        "once. Squad as published goes on in the same direction, but at another speed, because its "
        "planes are 40 and 50 degrees apart and its tangents take them for evenly spaced; its "
        "curvature has a peak. Smooth has neither. Curvature is |r' x r''| / |r'|³ of positions "
        f"{step_deg:g} degrees apart, by central differences that never reach across plane "
        f"{KNOT_PLANE_DEG}; velocities there are one-sided differences of second order, whose error "
        "is what smooth's kink shows. All three interpolate the table as measured, closure table.",
        "Arcs of the elbow seen from above; a closer view in which slerp's path has a corner; the "
        "elbow's speed, which jumps for slerp and squad and not for smooth; and the curvature of "
        "the path against the plane at four elevations, where squad has a peak at plane 40, slerp "
        "a step and smooth neither.",
        [numbers(paths)],
        girdle.take_commands(),
    )
