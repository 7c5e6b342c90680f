# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Jumps of velocity over the measured table's knots, for the three interpolations."""

from __future__ import annotations

from figure import Figure, NumberTable, significant
from girdle_program import Girdle
from matplotlib import pyplot as plt
from style import GREY, INTERPOLATIONS, name_panel, save

NAME = "velocity_jumps"

JOINTS = ("SC", "AC", "GH")
# Of one joint.
BESIDE = {"slerp": -0.32, "squad": 0.0, "smooth": 0.32}
# Where `girdle smoothness` has its limit.
ROUNDING = 1e-9
VELOCITY = "velocity_deg_per_deg"


def make(girdle: Girdle, quick: bool) -> Figure:
    del quick  # it is quick anyway
    jumps = girdle.answer("smoothness")["jumps"]
    canvas, panels = plt.subplots(1, 2, figsize=(11, 4.2), sharey=True)
    for panel, over, title in zip(
        panels,
        ("elevation", "plane"),
        ("(a) over knots of elevation, 5° apart", "(b) over the plane of 40°"),
        strict=True,
    ):
        name_panel(panel, title)
        for line in jumps:
            if line["over"] != over:
                continue
            look = INTERPOLATIONS[line["interpolation"]]
            values = [line[joint][VELOCITY] for joint in JOINTS]
            # Side by side: two of them lie together.
            places = [joint + BESIDE[line["interpolation"]] for joint in range(len(JOINTS))]
            panel.plot(
                places,
                values,
                linestyle="none",
                color=look["color"],
                marker=look["marker"],
                markersize=8,
                label=line["interpolation"],
            )
            for place, value in zip(places, values, strict=True):
                if value < ROUNDING:
                    continue  # differs from machine to machine
                panel.annotate(
                    significant(value),
                    (place, value),
                    xytext=(0, 7),
                    textcoords="offset points",
                    ha="center",
                    fontsize=10,
                )
        panel.set_yscale("log")
        panel.axhspan(1e-12, ROUNDING, color="#eeeeee", zorder=0)
        panel.text(-0.55, ROUNDING, "rounding", va="top", color=GREY)
        panel.set_ylim(1e-12, 1e2)
        panel.set_xticks(range(len(JOINTS)), JOINTS)
        panel.set_xlim(-0.6, len(JOINTS) - 0.4)
        panel.yaxis.grid(True, color="#dddddd", linewidth=0.6)
        panel.set_axisbelow(True)
    panels[0].set_ylabel("largest jump of velocity (deg/deg)")
    handles, labels = panels[0].get_legend_handles_labels()
    canvas.legend(handles, labels, loc="upper center", ncol=3, bbox_to_anchor=(0.5, 0.0))
    save(canvas, girdle.folder, NAME)
    rows = [
        [f"{line['interpolation']}, over {line['over']}"]
        + [significant(line[joint][VELOCITY]) for joint in JOINTS]
        for line in jumps
    ]
    return Figure(
        NAME,
        "Jumps of velocity",
        "How far the joints' angular velocity jumps at the worst place of the table's inner knots, "
        "in degrees a degree of elevation or of plane. Below 1e-9, in grey, it is rounding. Squad, the "
        "paper's choice, has none over elevations and still one over the plane of 40 degrees.",
        "Jumps on a logarithmic scale for SC, AC and GH: slerp's stand near 1 in both panels, "
        "squad's at rounding over elevation and near 0.1 over the plane, smooth's at rounding in "
        "both.",
        [
            NumberTable(
                "Largest jump of velocity (deg/deg)",
                ["interpolation, direction", *JOINTS],
                rows,
            )
        ],
        girdle.take_commands(),
    )
