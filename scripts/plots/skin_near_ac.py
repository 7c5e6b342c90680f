# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Fig. 14 of the paper: the skin near the AC joint, with the measured girdle and with a frozen one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from bodies import Body
from figure import Figure, NumberTable, significant
from girdle_program import Girdle
from matplotlib import pyplot as plt
from panels import View, compose, draw, drawn

# A line of `girdle verify --json`.
Line = dict[str, Any]

ELEVATIONS_DEG = (90, 120)
CAMERAS = ("front", "back")
GIRDLES = {"measured": "(a) measured girdle", "frozen": "(b) frozen girdle"}

# The first is the one in the picture.
SIDES = ("right", "left")

SIZE = 2340
QUICK_SIZE = 390
# Around the right shoulder, which is on the left of a picture from the front.
KEPT = {"front": (0.269, 0.5, 0.369, 0.6), "back": (0.5, 0.731, 0.369, 0.6)}
# Of what is kept: near the top of the shoulder.
LEVEL = 0.3


@dataclass(frozen=True)
class SkinReport:
    """What `girdle verify` says of the skin, with either girdle: lines by group and item."""

    lines: dict[str, dict[tuple[str, str], Line]]

    def value(self, motion: str, item: str) -> float:
        """The value of one line of the group skin."""
        return float(self.lines[motion]["skin", item]["value"])


def pictures(girdle: Girdle, body: Body, quick: bool) -> plt.Figure:
    size = QUICK_SIZE if quick else SIZE
    panels = [
        [
            draw(
                girdle,
                body,
                elevation,
                View(camera, "skin", size, size, motion, "right", KEPT[camera]),
            )
            for camera in CAMERAS
            for elevation in ELEVATIONS_DEG
        ]
        for motion in GIRDLES
    ]
    columns = [f"{camera}, {elevation}°" for camera in CAMERAS for elevation in ELEVATIONS_DEG]
    return compose(panels, columns, list(GIRDLES.values()), panel_width=2.6, level=LEVEL)


def make(girdle: Girdle, body: Body, skin: SkinReport, quick: bool) -> Figure:
    figure = Figure(
        f"figure_14_skin_near_ac_{body.name}",
        f"Fig. 14. Skin near the AC joint: {body.title}",
        "(a) The girdle moves as measured. (b) Clavicle and scapula stay where the skin was bound "
        "and the arm turns in the glenohumeral joint alone, to where it points in (a). The dashed line is "
        "at the same height in all pictures. The numbers "
        "are those of girdle verify on the same model with either girdle; in the columns of (b) "
        "FAIL is what is meant to happen.",
        "Four close-ups of the right shoulder in two rows, from the front and the back at 90 and "
        "120 degrees. In the upper row the shoulder rises and rounds with the arm; in the lower one "
        "it stays down, and the skin folds where the arm is hinged.",
        skin_lines(skin),
    )
    return drawn(girdle, figure, lambda: pictures(girdle, body, quick))


def verify_skin(girdle: Girdle, body: Body) -> SkinReport:
    lines = {}
    for motion in GIRDLES:
        words = [*body.anatomy, *([] if motion == "measured" else ["--girdle", motion])]
        # The frozen girdle has to exceed tolerances.
        report = girdle.answer("verify", body.scene, *words, may_exceed=motion == "frozen")
        lines[motion] = {
            (line["group"], line["item"]): line
            for line in report["residuals"]
            if line["group"].startswith("skin")
        }
    return SkinReport(lines)


def skin_lines(skin: SkinReport) -> list[NumberTable]:
    """One girdle beside the other: a table a side."""
    reports = skin.lines
    rows: dict[str, list[list[str]]] = {side: [] for side in SIDES}
    for key in {**reports["measured"], **reports["frozen"]}:
        lines = [reports[motion].get(key) for motion in GIRDLES]
        line = next(line for line in lines if line is not None)
        of, side = what_of(line), SIDES[0]
        for each in SIDES:
            if of.endswith(f", {each}"):
                of, side = of.removesuffix(f", {each}"), each
        row = [of]
        for of_girdle in lines:
            row += (
                ["-", ""] if of_girdle is None else [significant(of_girdle["value"], 3), verdict(of_girdle)]
            )
        rows[side].append([*row, line["unit"], required(line)])
    header = ["of", "(a) measured", "", "(b) frozen", "", "unit", "required"]
    return [
        NumberTable(f"Skin lines of girdle verify, {side} side", header, lines)
        for side, lines in rows.items()
    ]


def what_of(line: Line) -> str:
    """What a line is about, with what its group has in its name beside skin."""
    beside = line["group"].removeprefix("skin").strip(" ,:")
    return f"{beside}, {line['item']}" if beside else line["item"]


def verdict(line: Line) -> str:
    if line["tolerance"] is None:
        return "stated"
    return "pass" if line["passed"] else "FAIL"


def required(line: Line) -> str:
    if line["tolerance"] is None:
        return "-"
    sign = ">" if line["bound"] == "more than" else "≤"
    return f"{sign} {significant(line['tolerance'], 3)}"
