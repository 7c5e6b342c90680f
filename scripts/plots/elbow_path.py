# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Fig. 13 of the paper: the elbow's path while the arm goes round, and how sharply it bends."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from figure import Figure, NumberTable, rounded, significant
from girdle_program import Girdle, Numbers
from matplotlib import pyplot as plt
from style import GREY, INTERPOLATIONS, name_panel, save

NAME = "figure_13_elbow_path"

ELEVATIONS_DEG = (30, 60, 90, 120)
# The measured plane between the frontal and the sagittal one, where interpolations go from one cell
# to the next.
KNOT_PLANE_DEG = 40
LAST_PLANE_DEG = 90
# Between samples. Differences of second order are then off by less than a thousandth.
STEP_DEG = 0.25
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
        elevation: Path(
            planes_deg[elevation_of_row == elevation], elbow_mm[elevation_of_row == elevation]
        )
        for elevation in ELEVATIONS_DEG
    }


def draw(paths: dict[str, dict[int, Path]]) -> plt.Figure:
    canvas = plt.figure(figsize=(12.6, 8.4))
    left, right = canvas.subfigures(1, 2, width_ratios=[1, 1.25], wspace=0.03)
    above, height = left.subplots(2, 1, gridspec_kw={"height_ratios": [1.45, 1]})
    name_panel(above, "(a) path of the elbow, from above")
    name_panel(height, "(b) its height")
    for interpolation, by_elevation in paths.items():
        look = INTERPOLATIONS[interpolation]
        line = {"color": look["color"], "linestyle": look["linestyle"]}
        for elevation, path in by_elevation.items():
            label = interpolation if elevation == ELEVATIONS_DEG[0] else None
            x_mm, y_mm, z_mm = path.p_mm.T
            above.plot(z_mm, x_mm, label=label, **line)
            height.plot(path.planes_deg, y_mm, **line)
    for elevation, path in paths["squad"].items():
        x_mm, y_mm, z_mm = path.p_mm.T
        knot = path.knot
        above.plot(z_mm[knot], x_mm[knot], "o", color=GREY, markersize=4, zorder=0)
        above.annotate(
            f"{elevation}°",
            (z_mm[-1], x_mm[-1]),
            xytext=(0, 5),
            textcoords="offset points",
            ha="center",
        )
        height.annotate(
            f"{elevation}°",
            (path.planes_deg[-1], y_mm[-1]),
            xytext=(5, 0),
            textcoords="offset points",
            va="center",
            annotation_clip=False,
        )
    above.set_aspect("equal")
    above.margins(0.08)
    above.set_xlabel("to the right of the jugular notch (mm)")
    above.set_ylabel("in front of it (mm)")
    above.legend(loc="lower left")
    height.axvline(KNOT_PLANE_DEG, color=GREY, linewidth=0.8, zorder=0)
    height.set_xlabel("plane of elevation (deg)")
    height.set_ylabel("above the notch (mm)")
    height.set_xlim(0, LAST_PLANE_DEG)

    panels = right.subplots(len(ELEVATIONS_DEG), 1, sharex=True)
    for panel, elevation in zip(panels, ELEVATIONS_DEG, strict=True):
        kinks = []
        for interpolation, by_elevation in paths.items():
            look = INTERPOLATIONS[interpolation]
            planes_deg, per_m = by_elevation[elevation].curvature()
            panel.plot(planes_deg, per_m, color=look["color"], linestyle=look["linestyle"])
            kinks.append(f"{interpolation} {rounded(by_elevation[elevation].kink_deg(), 2)}°")
        panel.axvline(KNOT_PLANE_DEG, color=GREY, linewidth=0.8, zorder=0)
        name_panel(panel, f"elevation {elevation}°;  kink at 40°: {', '.join(kinks)}")
        panel.set_ylim(bottom=0)
        panel.set_xlim(0, LAST_PLANE_DEG)
    right.suptitle("(c) curvature of the path", x=0.09, ha="left", fontsize=11)
    right.supylabel("curvature (1/m)", fontsize=11)
    panels[-1].set_xlabel("plane of elevation (deg)")
    return canvas


def numbers(paths: dict[str, dict[int, Path]]) -> NumberTable:
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
        "The arm goes from the frontal plane to the sagittal one at four elevations. Slerp turns a "
        "corner at the measured plane of 40 degrees: there its curvature has no bound and the "
        "picture has a gap, and the kink says by how much the path changes its direction at once. "
        "Squad as published takes the corner off, not quite, because its planes are 40 and 50 "
        "degrees apart and its tangents take them for evenly spaced. Smooth has neither kink nor "
        f"step of curvature. Curvature is |r' x r''| / |r'|³ of positions {step_deg:g} degrees apart, "
        "by central differences that never reach across plane 40; velocities there are one-sided "
        "differences of second order, which leave a kink of a smooth path at their own error. All "
        "three interpolate the table as measured.",
        "Left: four arcs of the elbow seen from above, and its height against the plane of "
        "elevation. Right: curvature of the path against the plane, one panel an elevation; slerp's "
        "and squad's curves jump at plane 40, smooth's goes through.",
        [numbers(paths)],
        girdle.take_commands(),
    )
