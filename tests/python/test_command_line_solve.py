# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle solve` as a person types it: one pose, tables of poses, pipes."""

from __future__ import annotations

import csv
import fcntl
import io
import json
import os
import re
import signal
import struct
import subprocess
import termios
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import numpy as np
import pytest
from conftest import (
    PROGRAM_TIMEOUT_S,
    REFUSED,
    TWELVE_DIGITS,
    Girdle,
    Refuses,
    expect_one_message,
)
from reference_rhythm import COORDINATES, DATABASE, ST_COORDINATES, ReferenceRhythm

SEED = 20090815

ALL_ANGLES = (*COORDINATES, *ST_COORDINATES)
SOLVED_COLUMNS = [
    *(f"{angle}_deg" for angle in ALL_ANGLES),
    *("clamped", "used_elevation_deg", "used_plane_deg", "distance_deg", "origin"),
    *("used_axial_deg", "used_axial_isb_deg", "used_shrug_deg", "used_protraction_deg"),
]
PUBLISHED = ("--interpolation", "squad", "--closure", "table")

# Two implementations in double precision differ by 1e-12 or so. An arc cosine of nearly one, a
# legitimate way to write slerp, costs up to 1e-6 deg.
AGREEMENT_DEG = 1e-6
# An angle that went through a quaternion and back.
ROUNDING_DEG = 1e-9
# Angles in text and tables are rounded to six decimals: half of the last one, and the rounding
# above.
TEXT_DEG = 0.5e-6 + ROUNDING_DEG


def wait_for(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + PROGRAM_TIMEOUT_S
    while not condition():
        assert time.monotonic() < deadline, "the program does not get there"
        time.sleep(0.01)


def read_rows(output: bytes | str) -> list[dict[str, str]]:
    text = output.decode() if isinstance(output, bytes) else output
    return list(csv.DictReader(io.StringIO(text, newline="")))


def angles_deg(row: dict[str, str]) -> dict[str, float]:
    return {angle: float(row[f"{angle}_deg"]) for angle in ALL_ANGLES}


# --- One pose ------------------------------------------------------------------------------------


def test_one_pose_as_json_agrees_with_the_reference(girdle_fine: Girdle, reference: ReferenceRhythm) -> None:
    pose = ("solve", "--elevation", "71.5", "--plane", "12", *PUBLISHED)
    answer = json.loads(girdle_fine(*pose, "--json").text)
    expected_deg = reference.solve(71.5, 12.0).angles_deg
    found_deg = {coordinate: answer["angles_deg"][coordinate] for coordinate in COORDINATES}
    assert found_deg == pytest.approx(expected_deg, abs=AGREEMENT_DEG)


def test_one_pose_as_text_gives_every_angle_of_the_json(girdle_fine: Girdle) -> None:
    pose = ("solve", "--elevation", "71.5", "--plane", "12")
    found = re.findall(r"^(\w+) +(\S+) deg$", girdle_fine(*pose).text, re.MULTILINE)
    assert [name for name, _ in found] == list(ALL_ANGLES)
    expected_deg = json.loads(girdle_fine(*pose, "--json").text)["angles_deg"]
    assert {name: float(text) for name, text in found} == pytest.approx(expected_deg, abs=TEXT_DEG)


def test_one_pose_as_text_names_the_papers_cell(girdle_fine: Girdle) -> None:
    """Theta 23, psi 50 is their example: t_theta = 3/5, t_psi = 10/50."""
    text = girdle_fine("solve", "--elevation", "23", "--plane", "50").text
    assert re.search(r"^elevation cell +20 to 25 deg, weight 0\.6$", text, re.MULTILINE)
    assert re.search(r"^plane cell +40 to 90 deg, weight 0\.2$", text, re.MULTILINE)


@pytest.mark.parametrize(
    ("elevation", "plane", "used", "distance"),
    [
        ("130", "50", "elevation 120 deg", "10"),
        ("12", "94", "elevation 15 deg, plane 90 deg", r"3\.\d+"),
        ("90", "-7", "plane 0 deg", "7"),
    ],
)
def test_text_says_what_a_clamped_pose_uses_and_how_far_it_is_outside(
    girdle_fine: Girdle, elevation: str, plane: str, used: str, distance: str
) -> None:
    text = girdle_fine("solve", "--elevation", elevation, "--plane", plane, *PUBLISHED).text
    assert re.search(rf"^clamped .*: {used}$", text, re.MULTILINE)
    origin = rf"^origin .*, in answer to a direction {distance} deg from measured positions$"
    assert re.search(origin, text, re.MULTILINE)


def test_text_says_nothing_of_clamping_where_there_is_none(girdle_fine: Girdle) -> None:
    assert "clamped" not in girdle_fine("solve", "--elevation", "60", "--plane", "50").text


@pytest.mark.parametrize("word", ["60", "+60", "60.", "6e1", "060", "60.000000000000000000000"])
def test_a_number_may_be_written_in_any_usual_way(girdle_fine: Girdle, word: str) -> None:
    expected = girdle_fine("solve", "--elevation", "60", "--plane", "50").output
    assert girdle_fine("solve", "--elevation", word, "--plane", "50").output == expected


@pytest.mark.parametrize("options", [(), ("--json",)])
def test_one_pose_in_a_file_is_the_pose_that_is_printed(
    girdle_fine: Girdle, tmp_path: Path, options: tuple[str, ...]
) -> None:
    pose = ("solve", "--elevation", "60", "--plane", "50", *options)
    assert girdle_fine(*pose, "--out", "pose").output == b""
    assert (tmp_path / "pose").read_bytes() == girdle_fine(*pose).output


@pytest.mark.parametrize("axial", [12.5, -40.0])
def test_axial_adds_to_the_axial_rotation_alone(girdle_fine: Girdle, axial: float) -> None:
    pose = ("solve", "--elevation", "71.5", "--plane", "12", "--json")
    expected_deg = json.loads(girdle_fine(*pose).text)["angles_deg"]
    expected_deg["gh_axial"] += axial
    turned_deg = json.loads(girdle_fine(*pose, "--axial", str(axial)).text)["angles_deg"]
    assert turned_deg == pytest.approx(expected_deg, abs=ROUNDING_DEG)


def test_axial_adds_to_the_axial_rotation_of_every_row(girdle_fine: Girdle) -> None:
    poses = b"elevation_deg,plane_deg\n71.5,12\n20,90\n"
    command = ("solve", "--in", "-", *TWELVE_DIGITS)
    plain = read_rows(girdle_fine(*command, stdin=poses).output)
    turned = read_rows(girdle_fine(*command, "--axial", "12.5", stdin=poses).output)
    assert len(turned) == 2
    for turned_row, plain_row in zip(turned, plain, strict=True):
        expected_deg = angles_deg(plain_row)
        expected_deg["gh_axial"] += 12.5
        assert angles_deg(turned_row) == pytest.approx(expected_deg, abs=ROUNDING_DEG)


# --- Tables of poses -----------------------------------------------------------------------------

POSES = b"elevation_deg,plane_deg\n23,50\n71.5,12\n130,95\n"


@pytest.fixture
def solved(girdle_fine: Girdle) -> bytes:
    """The answer to POSES."""
    return girdle_fine("solve", "--in", "-", stdin=POSES).output


def test_a_file_gives_the_same_bytes_as_standard_input(
    girdle_fine: Girdle, tmp_path: Path, solved: bytes
) -> None:
    (tmp_path / "poses.csv").write_bytes(POSES)
    assert girdle_fine("solve", "--in", "poses.csv").output == solved
    assert girdle_fine("solve", "--in", "poses.csv", "--out", "-").output == solved


def test_an_output_file_holds_what_standard_output_would(
    girdle_fine: Girdle, tmp_path: Path, solved: bytes
) -> None:
    assert girdle_fine("solve", "--in", "-", "--out", "angles.csv", stdin=POSES).output == b""
    assert (tmp_path / "angles.csv").read_bytes() == solved


def test_a_row_has_the_angles_of_the_one_pose(girdle_fine: Girdle, solved: bytes) -> None:
    for row in read_rows(solved):
        pose = ("--elevation", row["elevation_deg"], "--plane", row["plane_deg"])
        answer = json.loads(girdle_fine("solve", *pose, "--json").text)
        assert angles_deg(row) == pytest.approx(answer["angles_deg"], rel=0, abs=TEXT_DEG)
        assert row["clamped"] == str(int(answer["clamped"]))
        assert float(row["distance_deg"]) == pytest.approx(answer["distance_deg"], abs=TEXT_DEG)
        assert row["origin"] == answer["origin"]


def test_the_angles_stand_after_the_input_in_a_fixed_order(solved: bytes) -> None:
    header = solved.decode().splitlines()[0]
    assert header == (
        "elevation_deg,plane_deg,"
        "sc_protraction_deg,sc_elevation_deg,sc_rotation_deg,"
        "ac_internal_rotation_deg,ac_upward_rotation_deg,ac_tilt_deg,"
        "gh_elevation_deg,gh_flexion_deg,gh_axial_deg,"
        "st_internal_rotation_deg,st_upward_rotation_deg,st_tilt_deg,"
        "clamped,used_elevation_deg,used_plane_deg,distance_deg,origin,"
        "used_axial_deg,used_axial_isb_deg,used_shrug_deg,used_protraction_deg"
    )


def test_the_same_input_gives_the_same_bytes(girdle_fine: Girdle, solved: bytes) -> None:
    assert girdle_fine("solve", "--in", "-", stdin=POSES).output == solved


def test_columns_may_stand_in_any_order(girdle_fine: Girdle, solved: bytes) -> None:
    swapped = b"plane_deg,elevation_deg\n50,23\n12,71.5\n95,130\n"
    rows = read_rows(girdle_fine("solve", "--in", "-", stdin=swapped).output)
    assert list(rows[0]) == ["plane_deg", "elevation_deg", *SOLVED_COLUMNS]
    assert rows == read_rows(solved)


def test_further_columns_are_carried_along_to_the_letter(girdle_fine: Girdle) -> None:
    lines = [
        'trial,"who, when",elevation_deg,note,plane_deg',
        '007,"Kim, ""Jan""",23, spaces kept ,50',
        "8,,71.5,\u00fc #1,12",
        '"9","",130,1e3,"95"',
    ]
    poses = "\n".join(lines).encode()
    answered = girdle_fine("solve", "--in", "-", stdin=poses).output.decode().splitlines()
    assert len(answered) == len(lines)
    for answer, line in zip(answered, lines, strict=True):
        assert answer.startswith(line + ",")


def test_quoted_fields_do_not_shift_the_answer(girdle_fine: Girdle, solved: bytes) -> None:
    poses = b'"a,b",elevation_deg,plane_deg\n"x,""y",23,50\n",",71.5,12\n"",130,"95"\n'
    rows = read_rows(girdle_fine("solve", "--in", "-", stdin=poses).output)
    assert [row.pop("a,b") for row in rows] == ['x,"y', ",", ""]
    assert rows == read_rows(solved)


SAME_POSES = {
    "Windows line ends": POSES.replace(b"\n", b"\r\n"),
    "byte-order mark": b"\xef\xbb\xbf" + POSES,
    "byte-order mark and Windows line ends": b"\xef\xbb\xbf" + POSES.replace(b"\n", b"\r\n"),
    "comments before the header": b"# Trial 7, calm sea\n#,,\n" + POSES,
    "byte-order mark before a comment": b"\xef\xbb\xbf# Trial 7\n" + POSES,
    "empty lines before the header": b"\n\n" + POSES,
    "no line end at the end": POSES.removesuffix(b"\n"),
    "Windows line ends, none at the end": POSES.replace(b"\n", b"\r\n").removesuffix(b"\r\n"),
    "empty lines at the end": POSES + b"\n\n",
}


@pytest.mark.parametrize("poses", SAME_POSES.values(), ids=SAME_POSES.keys())
def test_what_editors_do_to_a_table_changes_nothing(girdle_fine: Girdle, solved: bytes, poses: bytes) -> None:
    assert girdle_fine("solve", "--in", "-", stdin=poses).output == solved


@pytest.mark.parametrize("poses", [b"elevation_deg,plane_deg\n", b"elevation_deg,plane_deg"])
def test_a_header_alone_gives_a_header_alone(girdle_fine: Girdle, poses: bytes) -> None:
    expected = ",".join(["elevation_deg", "plane_deg", *SOLVED_COLUMNS]) + "\n"
    assert girdle_fine("solve", "--in", "-", stdin=poses).text == expected


def test_an_output_link_stays_a_link(girdle_fine: Girdle, tmp_path: Path, solved: bytes) -> None:
    (tmp_path / "angles.csv").write_text("earlier\n")
    (tmp_path / "link.csv").symlink_to("angles.csv")
    girdle_fine("solve", "--in", "-", "--out", "link.csv", stdin=POSES)
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "angles.csv").read_bytes() == solved


# --- Numbers -------------------------------------------------------------------------------------


@pytest.mark.parametrize("option", [("--elevation", "1e308"), ("--plane", "-1e308"), ("--axial", "1e300")])
def test_no_finite_command_gives_an_angle_that_is_not_a_number(
    girdle: Girdle, option: tuple[str, str]
) -> None:
    """However far the command is: either it is refused or all that comes out is finite."""
    pose = {"--elevation": "60", "--plane": "50", "--axial": "0"} | dict([option])
    finished = girdle("solve", "--json", *(word for pair in pose.items() for word in pair))
    if finished.code != 0:
        expect_one_message(finished, *option)
        return
    answer = json.loads(finished.text)
    numbers = answer["angles_deg"] | {"distance": answer["distance_deg"]}
    # JSON has no word for what is not a finite number but null.
    assert [name for name, number in numbers.items() if number is None] == []


# --- Another table -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("plane", "elevation", "column", "shift_deg"),
    [
        ("0", "15", "sc_protraction_deg", 1.5),
        ("40", "60", "gh_flexion_deg", -2.25),
        ("90", "120", "ac_tilt_deg", 0.1),
    ],
)
def test_a_changed_angle_of_a_table_comes_out_at_its_position(
    girdle_fine: Girdle,
    tmp_path: Path,
    plane: str,
    elevation: str,
    column: str,
    shift_deg: float,
) -> None:
    comments, header, rows = read_measured_table()
    (row,) = (row for row in rows if row[:2] == [plane, elevation])
    row[header.index(column)] = repr(float(row[header.index(column)]) + shift_deg)
    write_table(tmp_path / "mine.csv", comments, [header, *rows])

    pose = ("--elevation", elevation, "--plane", plane)
    answer = girdle_fine("solve", *pose, *PUBLISHED, "--table", "mine.csv", "--json").text
    expected_deg = {c: float(row[header.index(f"{c}_deg")]) for c in COORDINATES}
    found_deg = {c: json.loads(answer)["angles_deg"][c] for c in COORDINATES}
    assert found_deg == pytest.approx(expected_deg, abs=ROUNDING_DEG)


def test_the_measured_table_in_a_file_gives_the_same_bytes_as_the_built_in_one(girdle_fine: Girdle) -> None:
    by_name, by_file = (
        girdle_fine("solve", "--in", "-", "--table", table, stdin=POSES).output
        for table in ("measured", DATABASE)
    )
    assert by_file == by_name


def read_measured_table() -> tuple[list[str], list[str], list[list[str]]]:
    """Comment lines, header and rows."""
    lines = DATABASE.read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    header, *rows = (line.split(",") for line in lines if not line.startswith("#"))
    return comments, header, rows


def write_table(path: Path, comments: list[str], rows: list[list[str]]) -> None:
    lines = [*comments, *(",".join(row) for row in rows)]
    path.write_text("\n".join(lines) + "\n")


# --- Long tables ---------------------------------------------------------------------------------

FEW_ROWS = 1_000
MANY_ROWS = 2_000_000
BLOCK_ROWS = 1_000
# The program reads in blocks of some kilobytes, a few at a time. Kept in memory, the rows and their
# angles would take more than 100 MB.
MEMORY_GROWTH_KB = 3_000


def peak_memory_kb(process: subprocess.Popen[bytes]) -> int:
    """Of the program alone: rusage would count the Python that it was forked from."""
    status = Path(f"/proc/{process.pid}/status").read_text()
    found = re.search(r"^VmHWM:\s+(\d+) kB$", status, re.MULTILINE)
    assert found, status
    return int(found[1])


def unread_bytes(pipe: IO[bytes]) -> int:
    answer = fcntl.ioctl(pipe.fileno(), termios.FIONREAD, b"\0" * struct.calcsize("i"))
    return int(struct.unpack("i", answer)[0])


def wait_until_read(pipe: IO[bytes]) -> None:
    wait_for(lambda: unread_bytes(pipe) == 0)


def peak_memory_of_rows_kb(program: Path, rows: int) -> int:
    """After the last row was taken from the pipe and before the program may end."""
    random = np.random.default_rng(SEED)
    poses = zip(random.uniform(15.0, 120.0, BLOCK_ROWS), random.uniform(0.0, 90.0, BLOCK_ROWS), strict=True)
    block = "".join(f"{elevation:.3f},{plane:.3f}\n" for elevation, plane in poses).encode()
    with subprocess.Popen(
        [str(program), "solve", "--in", "-"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
    ) as process:
        assert process.stdin
        process.stdin.write(b"elevation_deg,plane_deg\n")
        for _ in range(rows // BLOCK_ROWS):
            process.stdin.write(block)
        process.stdin.flush()
        wait_until_read(process.stdin)
        peak_kb = peak_memory_kb(process)
        process.stdin.close()
        assert process.wait(PROGRAM_TIMEOUT_S) == 0
    return peak_kb


# The address sanitizer keeps what was freed for a while: with it the memory does grow.
@pytest.mark.plain_build
def test_memory_does_not_grow_with_the_number_of_rows(program: Path) -> None:
    few_kb = peak_memory_of_rows_kb(program, FEW_ROWS)
    many_kb = peak_memory_of_rows_kb(program, MANY_ROWS)
    assert many_kb - few_kb < MEMORY_GROWTH_KB, f"{few_kb} kB and {many_kb} kB"


# --- Threads -------------------------------------------------------------------------------------

THREADS = ["1", "2", "3", "7"]
# Many blocks of some kilobytes, which the threads take in turn.
THREADED_ROWS = 20_000


def threaded_lines() -> list[str]:
    """A header, then rows of uneven length, some with quoted fields."""
    random = np.random.default_rng(SEED)
    poses = random.uniform((0.0, -30.0), (140.0, 110.0), (THREADED_ROWS, 2))
    decimals = random.integers(0, 15, THREADED_ROWS)
    return [
        "note,elevation_deg,plane_deg",
        *(
            f"{'x' * (i % 50)},{elevation:.{count}f},{plane}"
            if i % 3
            else f'"{i}, ""{i}""","{elevation}",{plane:.{count}f}'
            for i, ((elevation, plane), count) in enumerate(zip(poses, decimals, strict=True))
        ),
    ]


@pytest.mark.parametrize("line_end", ["\n", "\r\n"], ids=["LF", "CRLF"])
@pytest.mark.parametrize("source", ["poses.csv", "-"])
def test_the_bytes_are_the_same_whatever_the_number_of_threads(
    girdle_fine: Girdle, tmp_path: Path, line_end: str, source: str
) -> None:
    poses = line_end.join(threaded_lines()).encode()
    (tmp_path / "poses.csv").write_bytes(poses)
    command = ("solve", "--in", source, "--threads")
    outputs = [girdle_fine(*command, threads, stdin=poses).output for threads in THREADS]
    answered = outputs[0].decode().splitlines()
    lines = threaded_lines()
    assert len(answered) == len(lines)
    assert all(answer.startswith(f"{line},") for answer, line in zip(answered, lines, strict=True))
    assert [output == outputs[0] for output in outputs] == [True] * len(THREADS)


def test_rows_of_many_blocks_are_those_of_few(girdle_fine: Girdle) -> None:
    """Each row by itself gives what it gives among all."""
    header, *lines = threaded_lines()
    whole = girdle_fine("solve", "--in", "-", stdin="\n".join([header, *lines]).encode()).text
    answered = whole.splitlines()[1:]
    for i in range(0, THREADED_ROWS, THREADED_ROWS // 20):
        alone = girdle_fine("solve", "--in", "-", stdin=f"{header}\n{lines[i]}".encode()).text
        assert alone.splitlines()[1:] == [answered[i]]


WRONG_LINES = {
    "in the first rows": (3,),
    "in the middle": (THREADED_ROWS // 2,),
    "in the last row": (THREADED_ROWS + 1,),
    "twice": (THREADED_ROWS // 2, THREADED_ROWS),
    "in many rows": tuple(range(THREADED_ROWS // 3, THREADED_ROWS, 100)),
    "side by side": (THREADED_ROWS // 2, THREADED_ROWS // 2 + 1),
}


@pytest.mark.parametrize(
    "wrong",
    [
        pytest.param(lines, id=name, marks=() if name in ("twice", "in many rows") else pytest.mark.numbers)
        for name, lines in WRONG_LINES.items()
    ],
)
@pytest.mark.parametrize("threads", THREADS)
def test_the_first_mistake_is_named_whatever_the_number_of_threads(
    refuses: Refuses, tmp_path: Path, threads: str, wrong: tuple[int, ...]
) -> None:
    lines = threaded_lines()
    for number in wrong:
        lines[number - 1] = f"mistake,{number}O,50"
    (tmp_path / "poses.csv").write_text("\n".join(lines))
    message = f"^girdle: poses.csv:{wrong[0]}: elevation_deg is '{wrong[0]}O'"
    command = ("solve", "--in", "poses.csv", "--out", "angles.csv")
    refuses(*command, "--threads", threads, because=(message,))


@pytest.mark.parametrize("threads", THREADS)
def test_standard_output_gets_whole_rows_before_a_mistake_and_none_after(
    girdle: Girdle, tmp_path: Path, threads: str
) -> None:
    lines = threaded_lines()
    lines[THREADED_ROWS // 2] = "mistake,5O,50"
    (tmp_path / "poses.csv").write_text("\n".join(lines))
    finished = girdle("solve", "--in", "poses.csv", "--threads", threads)
    expect_one_message(finished, f"poses.csv:{THREADED_ROWS // 2 + 1}: ")
    assert finished.text.endswith("\n")
    answered = finished.text.splitlines()
    assert 1 < len(answered) <= THREADED_ROWS // 2
    assert all(answer.startswith(f"{line},") for answer, line in zip(answered, lines, strict=False))


@pytest.mark.parametrize("word", ["1", "64", "+2", "2.0"])
def test_a_number_of_threads_is_accepted(girdle_fine: Girdle, solved: bytes, word: str) -> None:
    assert girdle_fine("solve", "--in", "-", "--threads", word, stdin=POSES).output == solved


@pytest.mark.parametrize("word", ["0", "-1", "x", "65", "1.5", "nan", "1e9", " 2", "2x"])
def test_what_is_no_number_of_threads_is_refused(refuses: Refuses, word: str) -> None:
    because = (f"--threads '{word}'", "from 1 to 64", "such as --threads 2")
    refuses("solve", "--in", "-", f"--threads={word}", because=because, stdin=POSES)


def test_an_empty_word_is_no_number_of_threads(refuses: Refuses) -> None:
    refuses("solve", "--in", "-", "--threads", "", because=("--threads", "empty"), stdin=POSES)


def test_one_pose_has_no_threads(refuses: Refuses) -> None:
    pose = ("--elevation", "60", "--plane", "50")
    refuses("solve", *pose, "--threads", "2", because=("--threads", "file", "omit it"))


@pytest.mark.parametrize("threads", THREADS)
def test_a_row_is_answered_before_the_next_one_is_asked(program: Path, threads: str) -> None:
    with subprocess.Popen(
        [str(program), "solve", "--in", "-", "--threads", threads],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    ) as process:
        assert process.stdin
        assert process.stdout
        process.stdin.write(b"elevation_deg,plane_deg\n23,50\n")
        process.stdin.flush()
        assert process.stdout.readline().startswith(b"elevation_deg,plane_deg,")
        assert process.stdout.readline().startswith(b"23,50,")
        for row in (b"71.5,12", b"20,90"):
            process.stdin.write(row + b"\n")
            process.stdin.flush()
            assert process.stdout.readline().startswith(row + b",")
        process.stdin.close()
        assert process.wait(PROGRAM_TIMEOUT_S) == 0


@pytest.mark.parametrize("threads", THREADS)
def test_a_mistake_is_told_before_more_is_asked(program: Path, threads: str) -> None:
    with subprocess.Popen(
        [str(program), "solve", "--in", "-", "--threads", threads],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdin
        assert process.stderr
        process.stdin.write(LONG.encode() + b"60,5O\n")
        process.stdin.flush()
        # The input stays open: the program ends by itself.
        assert process.wait(PROGRAM_TIMEOUT_S) == REFUSED
        assert b"standard input:20002: " in process.stderr.read()


# --- Runs that fail ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "option",
    ["--elevation", *(pytest.param(o, marks=pytest.mark.numbers) for o in ("--plane", "--axial"))],
)
@pytest.mark.parametrize("word", ["4O", "nan", "inf", "-inf", "1e999", " ", "0x20", "1,5", "--"])
def test_a_word_that_is_not_a_finite_number_is_refused(refuses: Refuses, option: str, word: str) -> None:
    pose = {"--elevation": "60", "--plane": "50", "--axial": "0"} | {option: word}
    words = [f"{name}={value}" for name, value in pose.items()]
    refuses("solve", *words, because=(option, re.escape(f"'{word}'"), rf"such as {option} [\d.]+"))


@pytest.mark.parametrize("option", ["--elevation", "--plane", "--axial"])
def test_an_empty_word_is_no_number(refuses: Refuses, option: str) -> None:
    pose = {"--elevation": "60", "--plane": "50", "--axial": "0"} | {option: ""}
    words = [word for pair in pose.items() for word in pair]
    refuses("solve", *words, because=(option, "empty|such as"))


@pytest.mark.parametrize(
    ("words", "patterns"),
    [
        ((), ("nothing to solve", "--elevation", "--plane", "--in")),
        (("--elevation", "60"), ("--plane is missing",)),
        (("--plane", "50"), ("--elevation is missing",)),
        (("--axial", "5"), ("nothing to solve", "--elevation", "--plane", "--in")),
        (("--elevation", "60", "--plane", "50", "--in", "-"), ("--in", "exclude")),
        (("--in", "-", "--json"), ("--json", "CSV")),
        (("--elevation", "60", "--elevation", "61", "--plane", "50"), ("--elevation", "given twice")),
        (("--elevation",), ("--elevation: has no value",)),
    ],
)
def test_an_incomplete_or_contradictory_question_is_refused(
    refuses: Refuses, words: tuple[str, ...], patterns: tuple[str, ...]
) -> None:
    refuses("solve", *words, because=patterns, stdin=POSES)


VALID_LINES = ("trial,elevation_deg,plane_deg", "a,20,3", "b,30,4", "c,40,5")


@dataclass(frozen=True)
class WrongTable:
    """A table of poses with one mistake, the line that has it, and what is said of it."""

    poses: str
    line: int
    patterns: tuple[str, ...]


def mistake(line: int, text: str, *patterns: str) -> WrongTable:
    """The valid lines with this one in the place of another."""
    lines = list(VALID_LINES)
    lines[line - 1] = text
    return WrongTable("\n".join(lines) + "\n", line, patterns)


WRONG_TABLES = {
    "missing column": mistake(1, "trial,elevation_deg,psi", "'plane_deg' is missing", "psi$"),
    "nearly a column": mistake(1, "trial,elevation_deg,plane", "'plane' is not known", "mean 'plane_deg'"),
    "duplicate column": mistake(
        1, "plane_deg,elevation_deg,plane_deg", "'plane_deg' is given twice", "Rename or remove"
    ),
    "column without a name": mistake(1, ",elevation_deg,plane_deg", "column 1 has no name"),
    "short row": mistake(3, "b,30", "2 fields, expected 3", "trial,elevation_deg,plane_deg"),
    "long row": mistake(3, "b,30,4,5", "4 fields, expected 3", "trial,elevation_deg,plane_deg"),
    "text in a number": mistake(3, "b,3O,4", "elevation_deg is '3O'", "such as 22.5"),
    "number with a unit": mistake(3, "b,30 deg,4", "elevation_deg is '30 deg'", "such as 22.5"),
    "inf": mistake(3, "b,30,-inf", "plane_deg is '-inf'", "finite", "such as 22.5"),
    "too large": mistake(3, "b,1e999,4", "elevation_deg is '1e999'", "finite"),
    "unclosed quote": mistake(3, '"b,30,4', "quote is not closed"),
    "text behind a quote": mistake(3, '"b"c,30,4', "closing quote", "whole field in quotes"),
    "empty line": mistake(3, "", "empty line", "Remove"),
    "empty file": WrongTable("", 1, ("no header", "must name the columns")),
    "comments alone": WrongTable("# nothing\n", 2, ("no header", "must name the columns")),
} | {
    f"input column {name}": mistake(
        1, f"{name},elevation_deg,plane_deg", f"'{name}' would be there twice", "Rename"
    )
    for name in SOLVED_COLUMNS
}

wrong_tables = pytest.mark.parametrize("wrong", WRONG_TABLES.values(), ids=WRONG_TABLES.keys())


def test_the_table_is_fine_without_a_mistake(girdle_fine: Girdle) -> None:
    poses = "\n".join(VALID_LINES).encode()
    assert len(read_rows(girdle_fine("solve", "--in", "-", stdin=poses).output)) == 3


@wrong_tables
@pytest.mark.parametrize("out", ["-", "angles.csv"])
def test_a_mistake_in_a_file_is_refused_with_file_and_line(
    refuses: Refuses, tmp_path: Path, wrong: WrongTable, out: str
) -> None:
    (tmp_path / "poses.csv").write_text(wrong.poses)
    place = f"poses.csv:{wrong.line}: "
    refuses("solve", "--in", "poses.csv", "--out", out, because=(place, *wrong.patterns))


@wrong_tables
def test_a_mistake_on_standard_input_is_refused_with_its_line(refuses: Refuses, wrong: WrongTable) -> None:
    place = f"standard input:{wrong.line}: "
    refuses("solve", "--in", "-", because=(place, *wrong.patterns), stdin=wrong.poses.encode())


def test_an_absent_file_is_refused(refuses: Refuses) -> None:
    refuses("solve", "--in", "absent.csv", because=("absent.csv: ", "Check"))


def test_a_folder_is_no_table(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").mkdir()
    refuses("solve", "--in", "poses.csv", because=("poses.csv", "folder|directory"))


# So many that rows have been written when the mistake at the end comes.
LONG = "elevation_deg,plane_deg\n" + "60,50\n" * 20_000


@pytest.mark.parametrize("before", [None, b"earlier\n"])
def test_a_late_mistake_leaves_no_half_written_file(
    refuses: Refuses, tmp_path: Path, before: bytes | None
) -> None:
    (tmp_path / "poses.csv").write_text(LONG + "60,5O\n")
    if before is not None:
        (tmp_path / "angles.csv").write_bytes(before)
    refuses("solve", "--in", "poses.csv", "--out", "angles.csv", because=("poses.csv:20002: ", "'5O'"))


def test_a_late_mistake_leaves_the_earlier_file(refuses: Refuses, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text(LONG + "60,5O\n")
    (tmp_path / "angles.csv").write_text("earlier\n")
    refuses("solve", "--in", "poses.csv", "--out", "angles.csv", because=("poses.csv:20002: ",))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_run_leaves_the_earlier_file_and_no_other(
    program: Path, tmp_path: Path, number: signal.Signals
) -> None:
    (tmp_path / "angles.csv").write_text("earlier\n")
    with subprocess.Popen(
        # Whoever runs the tests in the background has SIGINT ignored, and children inherit that.
        ["env", "--default-signal", str(program), "solve", "--in", "-", "--out", "angles.csv"],
        stdin=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=tmp_path,
    ) as process:
        assert process.stdin
        process.stdin.write(LONG.encode())
        process.stdin.flush()
        wait_until_read(process.stdin)
        process.send_signal(number)
        assert process.wait(PROGRAM_TIMEOUT_S) != 0
    assert (tmp_path / "angles.csv").read_text() == "earlier\n"
    assert os.listdir(tmp_path) == ["angles.csv"]
