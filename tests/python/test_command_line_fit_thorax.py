# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle fit-thorax`: the ellipsoid that TS and AI glide on, and how far they are from it."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Girdle, Refuses
from reference_rhythm import (
    DATABASE,
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    Array,
    inverse,
    multiply,
    quaternion_from_euler,
)

DATA = DATABASE.parent
ELLIPSOIDS = DATA / "thorax_ellipsoids.csv"
LANDMARKS = ("TS", "AI")
SIX = ("center_x_m", "center_y_m", "center_z_m", "radius_x_m", "radius_y_m", "radius_z_m")

# Of the committed ellipsoid over the measured positions, as the residual report has it too.
COMMITTED_RMS_MM = 4.19
COMMITTED_ROUNDED_MM = 0.005
# The distance below is found by following the surface, to far less than what is printed.
SEARCHED_MM = 1e-4

Rows = list[dict[str, str]]


def rows_of(path: Path) -> Rows:
    lines = path.read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def ellipsoid_of(path: Path, name: str = "gliding") -> Array:
    (row,) = (row for row in rows_of(path) if row["ellipsoid"] == name)
    return np.array([float(row[column]) for column in SIX])


def landmark_m(name: str) -> Array:
    (row,) = (row for row in rows_of(DATA / "landmarks.csv") if row["landmark"] == name)
    return np.array([float(row[f"{axis}_m"]) for axis in "xyz"])


def turned(q: Array, vector: Array) -> Array:
    return multiply(multiply(q, np.array([0.0, *vector])), inverse(q))[1:]


def measured_positions(table: Path) -> Rows:
    return [row for row in rows_of(table) if row["origin"] == "measured"]


def in_thorax(row: dict[str, str], name: str) -> Array:
    def rotation(joint: str) -> Array:
        angles_deg = [float(row[f"{angle}_deg"]) for angle in JOINT_COORDINATES[joint]]
        return quaternion_from_euler(JOINT_SEQUENCES[joint], angles_deg)

    q_tc, q_cs = rotation("sc"), rotation("ac")
    at_pac = landmark_m("SC") + turned(q_tc, landmark_m("PAC"))
    return at_pac + turned(multiply(q_tc, q_cs), landmark_m(name))


def distance_mm(ellipsoid: Array, point: Array) -> float:
    """From the surface, outside positive: Newton's method on the distance along the normals."""
    radii, p = ellipsoid[3:], point - ellipsoid[:3]
    multiplier = 0.0  # p - x = multiplier * x / radii^2
    for _ in range(50):
        scale = radii**2 + multiplier
        excess = np.sum((radii * p / scale) ** 2) - 1.0
        multiplier += excess / np.sum(2.0 * (radii * p) ** 2 / scale**3)
    nearest = radii**2 * p / (radii**2 + multiplier)
    return float(np.copysign(1000.0 * np.linalg.norm(p - nearest), multiplier))


def distances_mm(ellipsoid: Array, table: Path, name: str) -> Array:
    return np.array([distance_mm(ellipsoid, in_thorax(row, name)) for row in measured_positions(table)])


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


@pytest.fixture
def report(girdle_fine: Girdle) -> dict[str, Any]:
    return json.loads(girdle_fine("fit-thorax", "--table", DATABASE, "--json").text)


@pytest.mark.parametrize("which", ["fitted", "anatomy"])
def test_the_distances_are_those_of_the_bones_from_the_ellipsoid(report: dict[str, Any], which: str) -> None:
    printed = report[which]
    ellipsoid = np.array([*printed["center_m"], *printed["radii_m"]])
    rows = measured_positions(DATABASE)
    assert report["positions"] == len(rows)
    for name in LANDMARKS:
        expected = distances_mm(ellipsoid, DATABASE, name)
        worst = int(np.argmax(np.abs(expected)))
        line = printed[name]
        assert line["rms_mm"] == pytest.approx(rms(expected), abs=SEARCHED_MM)
        assert line["worst_mm"] == pytest.approx(expected[worst], abs=SEARCHED_MM)
        assert (line["plane_deg"], line["elevation_deg"]) == (
            float(rows[worst]["plane_deg"]),
            float(rows[worst]["elevation_deg"]),
        )
    both = np.concatenate([distances_mm(ellipsoid, DATABASE, name) for name in LANDMARKS])
    assert printed["rms_mm"] == pytest.approx(rms(both), abs=SEARCHED_MM)


def test_the_fit_is_as_good_as_the_committed_one(report: dict[str, Any]) -> None:
    assert report["anatomy"]["rms_mm"] == pytest.approx(COMMITTED_RMS_MM, abs=COMMITTED_ROUNDED_MM)
    assert report["fitted"]["rms_mm"] <= report["anatomy"]["rms_mm"]
    assert [*report["anatomy"]["center_m"], *report["anatomy"]["radii_m"]] == list(ellipsoid_of(ELLIPSOIDS))


def test_no_number_of_the_fit_is_known_worse_than_the_ribcage_tells_it(report: dict[str, Any]) -> None:
    """The pull towards the ribcage bounds what the points leave open, 70 mm for 4 mm of scatter."""
    fitted = report["fitted"]
    deviations = [*fitted["center_deviation_m"], *fitted["radii_deviation_m"]]
    most_m = 0.07 * fitted["rms_mm"] / 4.0
    assert min(deviations) > 0.001
    assert max(deviations) < most_m


def test_the_text_gives_the_numbers_of_the_json(girdle_fine: Girdle, report: dict[str, Any]) -> None:
    text = girdle_fine("fit-thorax", "--table", DATABASE).text
    lines = [" ".join(line.split()) for line in text.splitlines()]
    for label, which in (("fitted", "fitted"), ("the anatomy's", "anatomy")):
        printed = report[which]
        numbers = (f"{1000 * n:.1f}" for n in printed["center_m"] + printed["radii_m"])
        assert f"{label} {' '.join(numbers)}" in lines
        for name in LANDMARKS:
            line = printed[name]
            values = f"{line['rms_mm']:.2f} {line['worst_mm']:.2f}"
            place = f"plane {line['plane_deg']:g}, elevation {line['elevation_deg']:g}"
            assert f"{label} {name} {values} {place}" in lines
        assert f"{label} both {printed['rms_mm']:.2f}" in lines


def test_the_file_holds_the_fit_and_the_same_ribcage(
    girdle_fine: Girdle, report: dict[str, Any], tmp_path: Path
) -> None:
    girdle_fine("fit-thorax", "--table", DATABASE, "--out", "thorax.csv")
    written = tmp_path / "thorax.csv"
    assert list(ellipsoid_of(written)) == report["fitted"]["center_m"] + report["fitted"]["radii_m"]
    assert list(ellipsoid_of(written, "ribcage")) == list(ellipsoid_of(ELLIPSOIDS, "ribcage"))
    comments = "\n".join(line for line in written.read_text().splitlines() if line.startswith("#"))
    for words in ("girdle fit-thorax --table", str(DATABASE), "57 measured positions", "Units: meters"):
        assert words in comments


def test_ellipsoids_on_standard_output_are_alone_there(girdle_fine: Girdle, tmp_path: Path) -> None:
    girdle_fine("fit-thorax", "--out", "thorax.csv")
    assert girdle_fine("fit-thorax", "--out", "-").output == (tmp_path / "thorax.csv").read_bytes()


def test_the_default_table_is_the_default_rhythm_s(girdle_fine: Girdle) -> None:
    default, smoothed, measured = (
        girdle_fine("fit-thorax", *options).text
        for options in ((), ("--table", "smoothed"), ("--table", "measured"))
    )
    assert default == smoothed
    assert measured != smoothed


# --- Models on the thorax ------------------------------------------------------------------------


@pytest.mark.parametrize("assembly", ["tree", "loop"])
def test_a_model_on_the_thorax_verifies(girdle_fine: Girdle, assembly: str) -> None:
    girdle_fine("generate", "--assembly", assembly, "--thorax-contact", "--out", "model")
    report = json.loads(girdle_fine("verify", "model/scene.xml", "--json").text)
    values = {line["item"]: line["value"] for line in report["residuals"]}
    # 20 kN/m, at rest, in the measured position where the border is deepest.
    depth_mm = values["TS or AI in the ellipsoid"]
    assert values["force on TS or AI"] == pytest.approx(20.0 * depth_mm, rel=0.05)


# --- Bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "patterns"),
    [
        (("--table", "absent.csv"), ("absent.csv", "Check")),
        (("--table", "."), ("folder",)),
        (("--table", ELLIPSOIDS), ("thorax_ellipsoids.csv:6: column 'plane_deg' is missing",)),
        (("--out", "-", "--json"), ("--json and --out -", "to a file")),
        (("--out", "no/such/folder/thorax.csv"), ("no/such/folder/thorax.csv",)),
        (("--closure", "exact"), ("--closure", "--help")),
    ],
)
def test_a_wrong_command_is_refused(
    refuses: Refuses, options: tuple[str | Path, ...], patterns: tuple[str, ...]
) -> None:
    refuses("fit-thorax", *options, because=patterns)


def test_thorax_contact_is_not_for_a_scapula_that_leads(refuses: Refuses) -> None:
    refuses(
        *("generate", "--assembly", "loop", "--lead", "scapula", "--thorax-contact"),
        *("--out", "model"),
        because=("--thorax-contact: not available with --lead scapula", "--lead clavicle"),
    )


def test_a_table_without_measured_positions_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    lines = [line for line in DATABASE.read_text().splitlines() if not line.startswith("#")]
    derived = [line.replace(",measured,", ",sc_ac_derived,") for line in lines]
    (tmp_path / "mine.csv").write_text("\n".join(derived) + "\n")
    refuses(
        *("fit-thorax", "--table", "mine.csv", "--out", "thorax.csv"),
        because=("mine.csv: the table has 0 positions", "Take a table with more"),
    )


def test_a_refused_table_leaves_the_earlier_file(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "thorax.csv").write_text("earlier\n")
    refuses("fit-thorax", "--table", "absent.csv", "--out", "thorax.csv", because=("absent.csv",))
