# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What came out, in three sentences, for the top of the page. All numbers are the program's."""

from __future__ import annotations

from typing import Any

from bodies import Body
from figure import rounded
from girdle_program import Girdle, Rows
from scapular_rhythm import ANGLES, FROZEN, GIRDLE, curve
from skin_near_ac import SkinReport

MAP_FILE = "outcome.csv"
# Between these elevations all angles of the table are measured, none is derived.
FROM_ELEVATION_DEG, TO_ELEVATION_DEG = 30, 120
PLANE_DEG = 40
ROTATION = "st_upward_rotation"


def sentences(girdle: Girdle, body: Body, skin: SkinReport) -> list[str]:
    summary = girdle.answer(
        "compare", "--elevation", f"{FROM_ELEVATION_DEG}:{TO_ELEVATION_DEG}:5",
        "--plane", "0:90:10", "--out", MAP_FILE,
    )  # fmt: skip
    rows = Rows((girdle.folder / MAP_FILE).read_text())
    return [motion_of_the_bones(rows), distance_of_rhythms(summary), rise_of_the_skin(body, skin)]


def motion_of_the_bones(rows: Rows) -> str:
    rhythm = rows.only("rhythm", GIRDLE)
    changes = {}
    for angle in ANGLES:
        elevations_deg, values_deg = curve(rhythm, angle, PLANE_DEG)
        (first,) = values_deg[elevations_deg == FROM_ELEVATION_DEG]
        (last,) = values_deg[elevations_deg == TO_ELEVATION_DEG]
        changes[angle.name] = rounded(last - first, 1)
    return (
        f"While the arm rises from {FROM_ELEVATION_DEG} to {TO_ELEVATION_DEG} degrees in the "
        f"scapular plane, Girdle turns the scapula upward by {changes['upward rotation']} degrees "
        f"and tilts it to the back by {changes['posterior tilt']} degrees; it raises the clavicle by "
        f"{changes['elevation']} degrees and retracts it by {changes['retraction']} degrees."
    )


def distance_of_rhythms(summary: dict[str, Any]) -> str:
    """Of rhythms within the measured positions."""
    differences = {
        rhythm["name"]: difference["in_table"]
        for rhythm in summary["rhythms"]
        for difference in rhythm["differences"]
        if difference["of"] == ROTATION and rhythm["name"] != GIRDLE
    }
    frozen = differences.pop(FROZEN)
    name, closest = min(differences.items(), key=lambda item: float(item[1]["rms_deg"]))
    return (
        "Between these elevations and in planes 0 to 90, a frozen girdle misses Girdle's upward "
        f"rotation of the scapula by {rounded(frozen['rms_deg'], 1)} degrees rms and by "
        f"{rounded(abs(frozen['largest_deg']), 1)} degrees at most; the closest of the other "
        f"rhythms, {name}, misses it by {rounded(closest['rms_deg'], 1)} degrees rms and by "
        f"{rounded(abs(closest['largest_deg']), 1)} degrees at most."
    )


def rise_of_the_skin(body: Body, skin: SkinReport) -> str:
    rises = {
        motion: skin.value(motion, "acromion's skin rises, plane 0, right")
        for motion in ("measured", "frozen")
    }
    return (
        f"Between the same elevations in the frontal plane, the skin over the acromion of the "
        f"{body.title} {rises_or_sinks(rises['measured'])} when the girdle moves as measured, and "
        f"{rises_or_sinks(rises['frozen'])} when the girdle is frozen."
    )


def rises_or_sinks(rise_mm: float) -> str:
    return f"{'rises' if rise_mm >= 0 else 'sinks'} by {rounded(abs(rise_mm), 1)} mm"
