# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Fig. 14 of the paper: the skin near the AC joint, with the measured girdle and with GH alone."""

from __future__ import annotations

from bodies import Body
from figure import Figure, NumberTable, significant
from girdle_program import Girdle
from panels import View, compose, draw
from style import save

ELEVATIONS_DEG = (90, 120)
CAMERAS = ("front", "back")
GIRDLES = {"measured": "(a) measured girdle", "frozen": "(b) GH alone"}

SIZE = 1000
QUICK_SIZE = 200
# The shoulder that is raised, without elbow and head: it is the left one in a picture from the
# front.
KEPT = {"front": (0.12, 0.56, 0.16, 0.6), "back": (0.44, 0.88, 0.16, 0.6)}


def make(girdle: Girdle, body: Body, quick: bool) -> Figure:
    name = f"figure_14_skin_near_ac_{body.name}"
    size = QUICK_SIZE if quick else SIZE
    pictures = [
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
    save(compose(pictures, columns, list(GIRDLES.values())), girdle.folder, name)
    return Figure(
        name,
        f"Fig. 14. Skin near the AC joint: {body.title}",
        "(a) The girdle moves as measured. (b) Clavicle and scapula stay where the skin was bound "
        "and the arm turns in the glenohumeral joint alone, to where it points in (a). The numbers "
        "are those of girdle verify on the same model with either girdle; FAIL in the last column "
        "is what is meant to happen.",
        "Four close-ups of the right shoulder in two rows, from the front and the back at 90 and "
        "120 degrees. In the upper row the shoulder rises and rounds with the arm; in the lower one "
        "it stays down, and the skin folds where the arm is hinged.",
        [skin_lines(girdle, body)],
        girdle.take_commands(),
    )


def skin_lines(girdle: Girdle, body: Body) -> NumberTable:
    """What `girdle verify` says of the skin, of one girdle beside the other."""
    reports = {
        motion: {
            (line["group"], line["item"]): line
            for line in girdle.answer(
                "verify",
                body.scene,
                *(() if motion == "measured" else ("--girdle", motion)),
                may_exceed=True,
            )["residuals"]
            if line["group"].startswith("skin")
        }
        for motion in GIRDLES
    }
    rows = []
    for key in {**reports["measured"], **reports["frozen"]}:
        lines = [reports[motion].get(key) for motion in GIRDLES]
        line = next(line for line in lines if line is not None)
        # Groups may have more than skin in their name: "skin, frontal plane".
        row = [", ".join([part for part in (line["group"][len("skin") :].strip(" ,:"), line["item"]) if part])]
        for each in lines:
            row += ["-", ""] if each is None else [significant(each["value"], 3), verdict(each)]
        rows.append([*row, line["unit"], required(line)])
    return NumberTable(
        "Skin lines of girdle verify",
        ["of", "(a) measured", "", "(b) GH alone", "", "unit", "tolerance"],
        rows,
    )


def verdict(line: dict) -> str:
    if line["tolerance"] is None:
        return "stated"
    return "pass" if line["passed"] else "FAIL"


def required(line: dict) -> str:
    return "-" if line["tolerance"] is None else significant(line["tolerance"], 3)
