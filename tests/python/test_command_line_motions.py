# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Angles of the arm as people write them, in files and options of every verb that reads them."""

from __future__ import annotations

import csv
import json
import math
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from conftest import SCENE_FILE, TALLY, TWELVE_DIGITS, Girdle, Refuses, contents

# An angle that went through a direction and back.
ROUNDING_DEG = 1e-9

Rows = list[dict[str, str]]
Traced = Callable[..., Rows]


def read_rows(text: str) -> Rows:
    return list(csv.DictReader(text.splitlines()))


def direction(elevation_deg: float, plane_deg: float) -> np.ndarray:
    """The humerus's unit vector in the thorax: x forward, y up, z to the right."""
    theta, psi = math.radians(elevation_deg), math.radians(plane_deg)
    return np.array([math.sin(theta) * math.sin(psi), -math.cos(theta), math.sin(theta) * math.cos(psi)])


def angle_deg(a: np.ndarray, b: np.ndarray) -> float:
    return math.degrees(math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b)))


def used(row: dict[str, str]) -> np.ndarray:
    return direction(float(row["used_elevation_deg"]), float(row["used_plane_deg"]))


def humerus(row: dict[str, str]) -> np.ndarray:
    """Where the simulated humerus points in the thorax, of a trace of a standing model.

    The world is z up: x to x, y to z, z to -y.
    """
    w, x, y, z = (float(row[f"humerus_q{part}"]) for part in "wxyz")
    # The third column of the rotation with its sign turned: the bone's -y, from GH to the elbow, as
    # the bones' own frames are in the world's axes.
    down = -np.array([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)])
    return np.array([down[0], down[2], -down[1]])


@pytest.fixture
def scene(generated: Path) -> Path:
    return generated / SCENE_FILE


@pytest.fixture
def traced(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> Traced:
    """The trace of a motion file's text."""

    def run(text: str, *options: str) -> Rows:
        (tmp_path / "motion.csv").write_text(text)
        words = ("--in", "motion.csv", "--out", "-", *options)
        return read_rows(girdle_fine("simulate", scene, *words).text)

    return run


# --- Planes are angles ---------------------------------------------------------------------------

SWING = ((0, 8, -90), (0.3, 20, -90), (0.6, 32, -90), (0.9, 45, -90), (1.2, 20, -90), (1.5, 10, 90))


def motion_text(rows: tuple[tuple[float, ...], ...]) -> str:
    return "time_s,elevation_deg,plane_deg\n" + "".join(",".join(map(str, row)) + "\n" for row in rows)


def test_an_arm_that_swings_back_goes_where_it_is_told_to(traced: Traced) -> None:
    rows = traced(motion_text(SWING))
    by_time = {round(float(row["time_s"]), 6): row for row in rows}
    for time_s, elevation_deg, plane_deg in SWING:
        assert angle_deg(used(by_time[time_s]), direction(elevation_deg, plane_deg)) < 1
        # The servos lag behind by a degree at 44 deg/s.
        if time_s < 1:
            assert angle_deg(humerus(by_time[time_s]), direction(elevation_deg, plane_deg)) < 1
    for row in rows:
        assert angle_deg(used(row), humerus(row)) < 3, row["time_s"]


def test_a_file_of_positions_swings_back_as_a_motion_does(girdle_fine: Girdle) -> None:
    poses = "elevation_deg,plane_deg\n" + "".join(f"{e},{p}\n" for _, e, p in SWING)
    rows = read_rows(girdle_fine("solve", "--in", "-", stdin=poses.encode()).text)
    for row, (_, elevation_deg, plane_deg) in zip(rows, SWING, strict=True):
        assert angle_deg(used(row), direction(elevation_deg, plane_deg)) < 1


def walking_text() -> str:
    """Ten seconds of an arm that swings from 28 degrees behind the body to 18 in front, 7 degrees
    from its side, at 100 Hz, with stamps of a day's clock, turned outward behind and inward in
    front."""
    rows = []
    for frame in range(1001):
        time_s = frame / 100
        forward = math.radians(-5 + 23 * math.sin(2 * math.pi * 0.9 * time_s))
        aside = math.radians(7)
        x = math.sin(forward)
        z = math.cos(forward) * math.sin(aside)
        elevation_deg = math.degrees(math.atan2(math.hypot(x, z), math.cos(forward) * math.cos(aside)))
        plane_deg = math.degrees(math.atan2(x, z))
        axial_deg = 8 * math.sin(2 * math.pi * 0.9 * time_s)
        rows.append(f"{3600 + time_s:.2f},{elevation_deg:.4f},{plane_deg:.4f},{axial_deg:.4f}")
    return "time_s,elevation_deg,plane_deg,axial_deg\n" + "\n".join(rows) + "\n"


def test_a_walking_arm_is_followed_in_every_row(girdle: Girdle, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "walk.csv").write_text(walking_text())
    solved = girdle("solve", "--in", "walk.csv", "--out", "walked.csv")
    assert (solved.code, solved.output) == (0, b"")
    assert solved.message.startswith("girdle: wrote walked.csv: 1001 rows, 0 clamped, ")
    planes_deg = [float(row["plane_deg"]) for row in read_rows((tmp_path / "walked.csv").read_text())]
    assert min(planes_deg) < -75
    simulated = girdle("simulate", scene, "--in", "walk.csv", "--out", "trace.csv")
    assert simulated.code == 0
    assert "walk.csv: 5001 simulated states, 0 clamped, " in simulated.message
    for row in read_rows((tmp_path / "trace.csv").read_text()):
        assert angle_deg(used(row), humerus(row)) < 3, row["time_s"]


CROSSING = ((0, 90, 12), (0.5, 90, 1), (0.52, 90, 359.6), (1, 90, 349))


def test_a_motion_crosses_plane_zero_whatever_planes_are_called(traced: Traced) -> None:
    rows = traced(motion_text(CROSSING))
    same = traced(motion_text(((0, 90, 12), (0.5, 90, 1), (0.52, 90, -0.4), (1, 90, -11))))
    assert len(rows) == len(same)
    for row, other in zip(rows, same, strict=True):
        numbers, expected = ([float(v) for v in r.values()] for r in (row, other))
        assert numbers == pytest.approx(expected, abs=ROUNDING_DEG), row["time_s"]
    planes_deg = [float(row["plane_deg"]) for row in rows]
    assert max(planes_deg) <= 12 + ROUNDING_DEG
    assert min(planes_deg) >= -11 - ROUNDING_DEG


@pytest.mark.parametrize(("plane", "same"), [("350", "-10"), ("400", "40"), ("181", "-179")])
def test_a_plane_is_an_angle_in_every_verb(
    girdle_fine: Girdle, scene: Path, tmp_path: Path, plane: str, same: str
) -> None:
    solved, raised, drawn = [], [], []
    for word in (plane, same):
        poses = f"elevation_deg,plane_deg\n60,{word}\n".encode()
        (row,) = read_rows(girdle_fine("solve", "--in", "-", stdin=poses).text)
        solved.append({name: v for name, v in row.items() if name != "plane_deg"})
        motion = ("--elevation", "60:60", "--seconds", "0.01", f"--plane={word}", "--out", "-")
        raised.append(girdle_fine("simulate", scene, *motion).output)
        picture = ("--elevation", "60", f"--plane={word}", "--size", "32x24", "--out", "arm.png")
        drawn.append((girdle_fine("render", scene, *picture).text, contents(tmp_path)["arm.png"]))
    assert solved[0] == solved[1]
    assert raised[0] == raised[1]
    assert drawn[0] == drawn[1]


def test_the_plugin_takes_planes_all_round(traced: Traced) -> None:
    """The engine does not clip what the rhythm answers: beyond reach as solve does."""
    (row, *_) = traced(motion_text(((0, 90, 200), (0.01, 90, 200))))
    assert float(row["plane_deg"]) == pytest.approx(-160, abs=ROUNDING_DEG)
    assert float(row["used_plane_deg"]) == pytest.approx(20, abs=ROUNDING_DEG)
    assert float(row["used_elevation_deg"]) == pytest.approx(
        90 * math.cos(math.radians(65)), abs=ROUNDING_DEG
    )


# --- Signs and units -----------------------------------------------------------------------------

ISB = ((-15, 40), (-45, 40), (-90, 40), (-120, 40))
ISB_TEXT = "elevation_deg,plane_deg\n" + "".join(f"{e},{p}\n" for e, p in ISB)
ISB_SAID = ("ISB's Y-X'-Y''", "--convention isb")


def test_negative_elevations_are_refused_with_isbs_sign_named(
    refuses: Refuses, scene: Path, tmp_path: Path
) -> None:
    (tmp_path / "isb.csv").write_text(ISB_TEXT)
    because = (r"isb.csv:2: elevation_deg is -15: ", *ISB_SAID)
    refuses("solve", "--in", "isb.csv", "--out", "angles.csv", because=because)
    refuses("solve", "--in", "isb.csv", "--convention", "girdle", because=because)
    (tmp_path / "motion.csv").write_text("time_s,elevation_deg,plane_deg\n0,15,40\n1,-15,40\n")
    because = (r"motion.csv:3: elevation_deg is -15: ", *ISB_SAID)
    words = ("simulate", scene, "--in", "motion.csv", "--out", "trace.csv")
    refuses(*words, because=because)


def test_an_axial_option_beside_negative_elevations_is_told_what_becomes_of_it(
    refuses: Refuses, tmp_path: Path
) -> None:
    (tmp_path / "isb.csv").write_text(ISB_TEXT)
    because = (*ISB_SAID, "which reads axial as ISB's third angle, too")
    refuses("solve", "--in", "isb.csv", "--axial", "3", because=because)


def test_the_sign_of_raise_is_shown_as_the_convention_has_it(refuses: Refuses, scene: Path) -> None:
    words = ("simulate", scene, "--elevation=15:120", "--convention", "isb")
    refuses(*words, because=("such as -15:-120 are read$",))


HAND_BEHIND_THE_BACK = ((0, -45, -60, 90), (0.2, -50, -65, 100), (0.6, -50, -65, 60))


def test_a_model_turns_the_arm_as_far_as_the_rhythm(traced: Traced) -> None:
    """Controls bound no turn that the joint has room for."""
    text = "time_s,elevation_deg,plane_deg,axial_deg\n" + "".join(
        f"{','.join(map(str, row))}\n" for row in HAND_BEHIND_THE_BACK
    )
    rows = traced(text, "--convention", "isb")
    by_time = {round(float(row["time_s"]), 6): row for row in rows}
    for time_s, *_, axial_deg in HAND_BEHIND_THE_BACK:
        assert float(by_time[time_s]["used_axial_isb_deg"]) == pytest.approx(axial_deg, abs=ROUNDING_DEG)


def test_what_the_table_answers_is_not_called_modelled(girdle_fine: Girdle, tmp_path: Path) -> None:
    folder = tmp_path / "clamp"
    girdle_fine("generate", "--range", "clamp", "--out", folder)
    (tmp_path / "motion.csv").write_text(motion_text(((0, 150, 40), (0.1, 170, 40))))
    finished = girdle_fine("simulate", folder / "scene.xml", "--in", "motion.csv")
    assert "51 clamped (51 beyond the table), 0 modelled" in finished.message
    assert "modelled" not in finished.text
    said = girdle_fine("solve", "--elevation", "180", "--plane", "0", "--range", "clamp").text
    origin = r"^origin +measured, in answer to a direction 60 deg from measured positions$"
    assert re.search(origin, said, re.MULTILINE)


@pytest.mark.parametrize(
    ("words", "place"),
    [
        (("solve", "--elevation=-90", "--plane=40"), "--elevation -90: "),
        (("solve", "--elevation=-90:0:10", "--plane=40"), "--elevation -90: "),
        (("simulate", "SCENE", "--elevation=-20:60"), "--elevation '-20:60': -20: "),
        (("render", "SCENE", "--elevation=-90", "--out", "arm.png"), "--elevation -90: "),
        (("compare", "--elevation=-90:0:10"), "--elevation '-90:0:10': "),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_negative_elevations_of_options_are_refused(
    refuses: Refuses, scene: Path, words: tuple[str, ...], place: str
) -> None:
    command = [str(scene) if word == "SCENE" else word for word in words]
    refuses(*command, because=(re.escape(place), "elevation counts from 0"))


def test_isbs_elevations_are_read_where_that_is_said(girdle_fine: Girdle, traced: Traced) -> None:
    rows = read_rows(girdle_fine("solve", "--in", "-", "--convention", "isb", stdin=ISB_TEXT.encode()).text)
    ours = ISB_TEXT.replace("-", "")
    expected = read_rows(girdle_fine("solve", "--in", "-", stdin=ours.encode()).text)
    for row, same, (elevation_deg, _) in zip(rows, expected, ISB, strict=True):
        assert float(row["elevation_deg"]) == elevation_deg, "the row stands as it was"
        assert float(row["used_elevation_deg"]) == pytest.approx(-elevation_deg, abs=ROUNDING_DEG)
        del row["elevation_deg"], same["elevation_deg"]
        assert row == same
    isb = motion_text(((0, -20, 40), (0.1, -60, 40)))
    assert traced(isb, "--convention", "isb") == traced(isb.replace("-", ""))


def test_isbs_elevations_of_options_are_read_where_that_is_said(girdle_fine: Girdle, scene: Path) -> None:
    isb = ("--convention", "isb")

    def same(verb: tuple[str | Path, ...], elevation: str, negative: str) -> None:
        ours, theirs = (*verb, elevation), (*verb, negative, *isb)
        assert girdle_fine(*theirs).output == girdle_fine(*ours).output

    same(("solve", "--plane=40", "--json"), "--elevation=90", "--elevation=-90")
    same(("simulate", scene, "--seconds=0.05", "--out=-"), "--elevation=20:60", "--elevation=-20:-60")
    swept = read_rows(girdle_fine("solve", "--elevation=-90:-30:30", "--plane=40", *isb).text)
    assert [float(row["elevation_deg"]) for row in swept] == [-90, -60, -30]
    assert [float(row["used_elevation_deg"]) for row in swept] == pytest.approx([90, 60, 30])


def test_an_axial_turn_beside_another_sign_is_spoken_of(refuses: Refuses, tmp_path: Path) -> None:
    by_hand = ("--convention isb, which reads axial as ISB's third angle", "give --axial-from isb$")
    (tmp_path / "poses.csv").write_text("elevation_deg,plane_deg,axial_deg\n-15,40,-60\n")
    refuses("solve", "--in", "poses.csv", because=("poses.csv:2: elevation_deg is -15", *by_hand))
    pose = ("--plane=40", "--axial=-60")
    refuses("solve", "--elevation=-15", *pose, because=("--elevation -15: ", *by_hand))
    refuses("solve", "--elevation=-15:0:5", *pose, because=("--elevation -15: ", *by_hand))


def test_a_sweep_stands_as_it_was_typed(girdle_fine: Girdle) -> None:
    isb = ("--convention", "isb")
    given = ("--axial=-40", "--shrug=2.5", "--protraction=-3")
    swept = read_rows(girdle_fine("solve", "--elevation=-90:-30:30", "--plane=400", *isb, *given).text)
    typed = list(swept[0])[:5]
    assert typed == ["elevation_deg", "plane_deg", "axial_deg", "shrug_deg", "protraction_deg"]
    rows = [",".join(row[name] for name in typed) for row in swept]
    assert rows == [f"{elevation},400,-40,2.5,-3" for elevation in (-90, -60, -30)]
    # So it can be read again, in the same way.
    again = "\n".join([",".join(typed), *rows, ""]).encode()
    assert read_rows(girdle_fine("solve", "--in", "-", *isb, stdin=again).text) == swept
    plain = girdle_fine("solve", "--elevation=30:90:30", "--plane=40").text
    assert plain.startswith("elevation_deg,plane_deg,sc_protraction_deg,")


def test_a_convention_that_contradicts_the_file_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text("elevation_deg,plane_deg\n-15,40\n45,40\n")
    contradicted = ("poses.csv:3: elevation_deg is 45: ISB's", "--convention girdle", r"plane \+ 180")
    refuses("solve", "--in", "poses.csv", "--convention", "isb", because=contradicted)
    unknown = ("--convention ISO: not known", "girdle, isb")
    refuses("solve", "--in", "poses.csv", "--convention", "ISO", because=unknown)


def test_hanging_may_be_rounded(girdle_fine: Girdle) -> None:
    poses = b"elevation_deg,plane_deg\n-0.5,40\n180.5,40\n"
    rows = read_rows(girdle_fine("solve", "--in", "-", stdin=poses).text)
    assert [(float(r["used_elevation_deg"]), r["clamped"]) for r in rows] == [(0, "0"), (180, "0")]


RADIANS = "elevation_deg,plane_deg\n" + "".join(f"{0.1 + 0.2 * i},0.7\n" for i in range(10))


@pytest.mark.parametrize("out", ["-", "angles.csv"])
def test_a_file_that_looks_like_radians_is_refused(refuses: Refuses, tmp_path: Path, out: str) -> None:
    (tmp_path / "poses.csv").write_text(RADIANS)
    because = ("poses.csv: in 10 rows", "look like radians", "--angles rad", "--angles deg")
    refuses("solve", "--in", "poses.csv", "--out", out, because=because)


def test_a_stream_that_looks_like_radians_is_refused(refuses: Refuses) -> None:
    because = ("standard input: in 10 rows", "look like radians")
    words = ("solve", "--in", "-", "--out", "angles.csv")
    refuses(*words, because=because, stdin=RADIANS.encode())


def test_a_motion_that_looks_like_radians_is_refused(refuses: Refuses, scene: Path, tmp_path: Path) -> None:
    rows = tuple((i / 10, 0.1 + 0.2 * i, 0.7) for i in range(10))
    (tmp_path / "motion.csv").write_text(motion_text(rows))
    words = ("simulate", scene, "--in", "motion.csv", "--out", "trace.csv")
    refuses(*words, because=("motion.csv: in 10 rows", "look like radians", "--angles rad"))


def test_radians_with_planes_up_to_a_whole_turn_are_refused(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text(RADIANS.replace(",0.7", ",5.6"))
    because = ("poses.csv: in 10 rows", "plane_deg 5.6 to 5.6", "look like radians")
    refuses("solve", "--in", "poses.csv", because=because)


def test_the_unit_is_the_one_that_is_said(girdle_fine: Girdle) -> None:
    words = ("solve", "--in", "-", *TWELVE_DIGITS, "--angles")
    for unit, factor in (("rad", math.degrees(1)), ("deg", 1)):
        rows = read_rows(girdle_fine(*words, unit, stdin=RADIANS.encode()).text)
        for row in rows:
            expected_deg = float(row["elevation_deg"]) * factor
            assert float(row["used_elevation_deg"]) == pytest.approx(expected_deg, abs=ROUNDING_DEG)


def test_the_unit_of_options_is_degrees(refuses: Refuses) -> None:
    because = ("--angles rad", "options are degrees")
    refuses("solve", "--elevation=1", "--plane=1", "--angles", "rad", because=because)
    refuses("solve", "--elevation=0:1:1", "--plane=1", "--angles", "rad", because=because)


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("181,40", "elevation_deg is 181: expected 0 to 180"),
        ("60,1e300", r"plane_deg is 1e\+300: expected an angle within -3600 to 3600"),
        ("60,inf", "plane_deg is 'inf', expected a finite number"),
    ],
)
def test_what_is_no_direction_is_refused(refuses: Refuses, tmp_path: Path, row: str, reason: str) -> None:
    (tmp_path / "poses.csv").write_text(f"elevation_deg,plane_deg\n60,40\n{row}\n")
    words = ("solve", "--in", "poses.csv", "--out", "angles.csv")
    refuses(*words, because=(r"poses.csv:3: ", reason))


# --- Columns -------------------------------------------------------------------------------------


def test_a_motion_may_have_other_columns(traced: Traced) -> None:
    framed = "frame,time_s,elevation_deg,plane_deg\n1,0,20,40\n2,0.05,60,40\n"
    assert traced(framed) == traced(motion_text(((0, 20, 40), (0.05, 60, 40))))


def test_a_trace_is_a_motion_as_it_stands(girdle_fine: Girdle, scene: Path, traced: Traced) -> None:
    raised = ("simulate", scene, "--elevation", "15:120", "--plane", "40", "--seconds", "0.1")
    trace = girdle_fine(*raised, "--out", "-").text
    for row, same in zip(traced(trace), read_rows(trace), strict=True):
        numbers, expected = ([float(v) for v in r.values()] for r in (row, same))
        assert numbers == pytest.approx(expected, abs=ROUNDING_DEG)


@pytest.mark.parametrize(
    ("column", "meant"), [("axial", "axial_deg"), ("shrug_degs", "shrug_deg"), ("Plane", "plane_deg")]
)
def test_a_column_that_is_nearly_known_is_refused_by_every_verb(
    refuses: Refuses, scene: Path, tmp_path: Path, column: str, meant: str
) -> None:
    text = f"time_s,elevation_deg,plane_deg,{column}\n0,20,40,1\n1,60,40,1\n"
    (tmp_path / "arm.csv").write_text(text)
    because = (f"arm.csv:1: column '{column}' is not known. Did you mean '{meant}'",)
    refuses("solve", "--in", "arm.csv", "--out", "angles.csv", because=because)
    words = ("simulate", scene, "--in", "arm.csv", "--out", "trace.csv")
    refuses(*words, because=because)


# --- Times ---------------------------------------------------------------------------------------


def test_a_motion_starts_at_its_first_time(traced: Traced) -> None:
    def motion(first_s: float) -> str:
        return motion_text(((first_s, 20, 40), (first_s + 0.25, 40, 40), (first_s + 0.5, 60, 40)))

    rows = traced(motion(3600.0))
    assert len(rows) == 251
    assert rows == traced(motion(0.0))
    assert rows == traced(motion(-8.0))


def test_a_motion_may_be_longer_where_that_is_said(refuses: Refuses, scene: Path, tmp_path: Path) -> None:
    """What is refused is then the trace, which the disk has no room for."""
    free = shutil.disk_usage(tmp_path).free
    step_s, least_bytes_of_a_row = 0.002, 1000
    seconds = math.ceil(free / least_bytes_of_a_row * step_s) + 3600
    (tmp_path / "motion.csv").write_text(motion_text(((0, 20, 40), (seconds, 60, 40))))
    words = ("simulate", scene, "--in", "motion.csv", "--out", "trace.csv")
    refuses(*words, because=("motion.csv:3: ", "at most 3600", "--longest"))
    because = ("--out trace.csv: takes about", "GB are free", "shorter motion")
    refuses(*words, "--longest", str(seconds), because=because)


# --- What is said at the end ---------------------------------------------------------------------

MIXED = "elevation_deg,plane_deg,axial_deg\n60,40,0\n60,-40,0\n90,200,0\n60,40,170\n"


def test_a_file_ends_with_a_line_that_counts(girdle: Girdle, scene: Path, tmp_path: Path) -> None:
    finished = girdle("solve", "--in", "-", "--out", "angles.csv", stdin=MIXED.encode())
    rows = read_rows((tmp_path / "angles.csv").read_text())
    assert [row["clamped"] for row in rows] == ["0", "0", "1", "1"]
    assert [row["origin"] for row in rows].count("modelled") == 2
    farthest_deg = max(float(row["distance_deg"]) for row in rows)
    assert TALLY.fullmatch(finished.message)
    assert finished.message == (
        "girdle: wrote angles.csv: 4 rows, 2 clamped (1 beyond what an arm reaches, 1 beyond the "
        "range of a joint or control; see the columns used_*), 2 modelled (up to "
        f"{round(farthest_deg, 1):g} deg from measured directions), axial from rhythm\n"
    )
    one = girdle("solve", "--in", "-", stdin=b"elevation_deg,plane_deg\n60,40\n")
    assert one.message == "girdle: standard input: 1 row, 0 clamped, 0 modelled\n"
    (tmp_path / "motion.csv").write_text(motion_text(((0, 60, 40), (0.01, 60, 40))))
    words = ("simulate", scene, "--in", "motion.csv", "--json")
    finished = girdle(*words)
    assert finished.message == "girdle: motion.csv: 6 simulated states, 0 clamped, 0 modelled\n"
    summary = json.loads(finished.text)
    assert (summary["rows"], summary["clamped_rows"], summary["modelled_rows"]) == (6, 0, 0)


def test_columns_are_pointed_to_where_they_are_written(girdle: Girdle, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "motion.csv").write_text(motion_text(((0, 60, 200), (0.01, 60, 200))))
    words = ("simulate", scene, "--in", "motion.csv")
    said = "girdle: motion.csv: 6 simulated states, 6 clamped (6 beyond what an arm reaches"
    assert girdle(*words).message.startswith(f"{said}), ")
    traced = girdle(*words, "--out", "trace.csv").message
    assert traced.startswith(f"{said}; see the columns used_*), ")


def test_stamps_that_may_be_milliseconds_are_pointed_out(
    girdle: Girdle, girdle_fine: Girdle, scene: Path, tmp_path: Path
) -> None:
    stamps = [10.0 * i for i in range(12)]
    (tmp_path / "motion.csv").write_text(motion_text(tuple((s, 60, 40) for s in stamps)))
    simulated = girdle("simulate", scene, "--in", "motion.csv")
    assert simulated.code == 0
    assert simulated.message.startswith(
        "girdle: motion.csv: its 12 rows are 10 s apart (median), 110 s in all. If time_s is in "
        "milliseconds, divide it by 1000\ngirdle: motion.csv: "
    )
    (tmp_path / "motion.csv").write_text(motion_text(tuple((s / 1000, 60, 40) for s in stamps)))
    girdle_fine("simulate", scene, "--in", "motion.csv")


def test_a_picture_says_which_direction_it_shows(girdle_fine: Girdle, scene: Path) -> None:
    words = ("--elevation", "60", "--plane=-100", "--size", "32x24", "--out", "arm.png")
    text = girdle_fine("render", scene, *words).text
    foot_deg = math.degrees(math.atan(math.tan(math.radians(60)) * math.cos(math.radians(5))))
    assert f"shown instead: elevation {round(foot_deg, 3)}, plane -95\n" in text
