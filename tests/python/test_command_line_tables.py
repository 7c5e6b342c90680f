# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of poses and motions as spreadsheets, MATLAB and motion capture write them."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import Girdle, Refuses

POSES = "trial;elevation_deg;plane_deg\na;30,5;40\nb;60,25;40,0\n"
PLAIN = "trial,elevation_deg,plane_deg\na,30.5,40\nb,60.25,40.0\n"


def translated(plain: str, separator: str, mark: str) -> str:
    """A plain table, whose fields have no commas, with other separators and decimal marks."""
    return plain.replace(",", separator).replace(".", mark)


@pytest.fixture
def plain_answer(girdle_fine: Girdle) -> str:
    return girdle_fine("solve", "--in", "-", stdin=PLAIN.encode()).text


@pytest.mark.parametrize(("separator", "mark"), [(";", ","), (";", "."), ("\t", ","), ("\t", ".")])
def test_an_answer_is_written_as_the_table_is(
    girdle_fine: Girdle, plain_answer: str, separator: str, mark: str
) -> None:
    poses = translated(PLAIN, separator, mark)
    answer = girdle_fine("solve", "--in", "-", stdin=poses.encode()).text
    assert answer == translated(plain_answer, separator, mark)


def test_fields_of_the_input_stay_to_the_letter(girdle_fine: Girdle) -> None:
    lines = ['"who; when"; elevation_deg ;plane_deg;note', '"Kim; ""Jan"""; 30,50 ;"40,0";1,000']
    poses = "\r".join(lines).encode()
    answer = girdle_fine("solve", "--in", "-", stdin=poses).output.decode().splitlines()
    assert len(answer) == len(lines)
    for answered, line in zip(answer, lines, strict=True):
        assert answered.startswith(line + ";")


def test_a_line_that_names_the_separator_is_written_back(girdle_fine: Girdle, plain_answer: str) -> None:
    answer = girdle_fine("solve", "--in", "-", stdin=b"sep=;\r\n" + POSES.encode()).text
    assert answer == "sep=;\n" + translated(plain_answer, ";", ",")


@pytest.mark.parametrize(("encoding", "mark"), [("utf-16-le", b"\xff\xfe"), ("utf-16-be", b"\xfe\xff")])
def test_utf_16_comes_out_as_utf_8(girdle_fine: Girdle, encoding: str, mark: bytes) -> None:
    poses = "Prüfling\televation_deg\tplane_deg\r\n中\t30,5\t40\r\n"
    answer = girdle_fine("solve", "--in", "-", stdin=mark + poses.encode(encoding))
    in_utf_8 = girdle_fine("solve", "--in", "-", stdin=poses.encode())
    assert answer.output == in_utf_8.output
    assert "中\t30,5\t40\t" in answer.text


def test_utf_16_without_a_mark_is_refused(refuses: Refuses) -> None:
    refuses("solve", "--in", "-", because=("input:1: a byte 0", "UTF-8"), stdin=PLAIN.encode("utf-16-le"))


@pytest.mark.parametrize("line_end", ["\r", "\r\n", "\n"])
def test_line_ends_of_every_system_are_read(girdle_fine: Girdle, plain_answer: str, line_end: str) -> None:
    poses = PLAIN.replace("\n", line_end).encode()
    assert girdle_fine("solve", "--in", "-", stdin=poses).text == plain_answer


def test_mixed_line_ends_are_read(girdle_fine: Girdle, plain_answer: str) -> None:
    header, first, second, _ = PLAIN.split("\n")
    poses = f"{header}\r{first}\r\n{second}".encode()
    assert girdle_fine("solve", "--in", "-", stdin=poses).text == plain_answer


def test_a_file_without_a_header_is_shown_one(refuses: Refuses, model_path: Path, tmp_path: Path) -> None:
    refuses("solve", "--in", "-", because=("input:1: .*such as elevation_deg,plane_deg$",), stdin=b"30,40\n")
    (tmp_path / "motion.csv").write_text("0;30,5;40\n1;31,5;40\n")
    refuses(
        *("simulate", model_path, "--in", "motion.csv"),
        because=("motion.csv:1: .*names its 3 columns.*such as time_s;elevation_deg;plane_deg$",),
    )


MIXED_MARKS = {
    "a thousands separator": ("a;1.234,5;40", 2, "'1.234,5'.*none between thousands"),
    "two marks in one row": ("a;30,5;40.5", 2, "'30,5' has a decimal comma and '40.5' a decimal point"),
    "another mark in a later row": ("a;30,5;40\nb;31.5;40", 3, "'31.5'.*file is a comma.*one mark"),
}


@pytest.mark.parametrize(("rows", "line", "reason"), MIXED_MARKS.values(), ids=MIXED_MARKS.keys())
def test_an_ambiguous_number_is_refused(refuses: Refuses, rows: str, line: int, reason: str) -> None:
    poses = f"trial;elevation_deg;plane_deg\n{rows}\n".encode()
    refuses("solve", "--in", "-", because=(f"input:{line}: ", reason), stdin=poses)


def test_a_motion_is_read_in_any_dialect(girdle_fine: Girdle, model_path: Path, tmp_path: Path) -> None:
    plain = "time_s,elevation_deg,plane_deg\n0,30.5,40\n0.01,31.5,40\n"
    (tmp_path / "motion.csv").write_text(plain)
    expected = girdle_fine("simulate", model_path, "--in", "motion.csv", "--out", "-").output
    (tmp_path / "motion.csv").write_bytes(
        b"\xff\xfe" + translated(plain, "\t", ",").replace("\n", "\r").encode("utf-16-le")
    )
    assert girdle_fine("simulate", model_path, "--in", "motion.csv", "--out", "-").output == expected


def test_many_rows_are_the_same_in_any_dialect_and_number_of_threads(girdle_fine: Girdle) -> None:
    plain = "elevation_deg,plane_deg\n" + "".join(f"{i / 100},40.5\n" for i in range(5000))
    expected = girdle_fine("solve", "--in", "-", stdin=plain.encode()).text
    poses = b"\xfe\xff" + translated(plain, ";", ",").encode("utf-16-be")
    for threads in ("1", "4"):
        answer = girdle_fine("solve", "--in", "-", "--threads", threads, stdin=poses).text
        assert answer == translated(expected, ";", ",")


# --- Inputs without bounds, and what reaches a terminal ---------------------------------------------


def test_a_file_of_zeros_is_refused(refuses: Refuses) -> None:
    refuses("solve", "--in", "/dev/zero", because=("/dev/zero:1: a byte 0",))


def test_a_line_without_end_is_refused_in_a_few_words(refuses: Refuses) -> None:
    poses = b"elevation_deg,plane_deg\n" + b"7" * 5_000_000 + b",3\n"
    message = refuses("solve", "--in", "-", because=("input:2: the line has more than 1 MiB",), stdin=poses)
    assert len(message) < 200


def test_a_long_value_is_cut_in_the_message(refuses: Refuses) -> None:
    poses = b"elevation_deg,plane_deg\n" + b"x" * 100_000 + b",3\n"
    message = refuses("solve", "--in", "-", because=(r"x\.\.\. \(100000 bytes\)'",), stdin=poses)
    assert len(message) < 300


def test_too_many_columns_are_refused(refuses: Refuses) -> None:
    header = ",".join(f"c{i}" for i in range(100_000)).encode()
    message = refuses("solve", "--in", "-", because=("input:1: 100000 columns, at most 4096",), stdin=header)
    assert len(message) < 200


def test_control_characters_do_not_reach_the_terminal(girdle: Girdle) -> None:
    poses = b"elevation_deg,plane_deg\n\x1b]0;owned\x07\x1b[31mred\x9b\xe9,2\n"
    finished = girdle("solve", "--in", "-", stdin=poses)
    assert r"elevation_deg is '\x1b]0;owned\x07\x1b[31mred\x9b\xe9'" in finished.message
    assert "\x1b" not in finished.message


def test_control_characters_of_a_name_do_not_reach_the_terminal(girdle: Girdle, tmp_path: Path) -> None:
    (tmp_path / "a\x1b[31m.csv").write_text(PLAIN)
    finished = girdle("solve", "--in", "a\x1b[31m.csv", "--out", "b\x1b[31m.csv")
    assert r"wrote b\x1b[31m.csv" in finished.message


# --- Names of columns -----------------------------------------------------------------------------


def note_and_answer(girdle: Girdle, *arguments: str, stdin: str) -> tuple[str, list[str]]:
    """The first line about the table on standard error, and the answer without the table's own fields."""
    finished = girdle("solve", "--in", "-", *arguments, stdin=stdin.encode())
    assert finished.code == 0, finished.message
    width = len(stdin.split("\n", 1)[0].split(","))
    rows = [",".join(line.split(",")[width:]) for line in finished.text.splitlines()]
    return finished.message.splitlines()[0], rows


def test_columns_have_the_names_that_are_given(girdle: Girdle) -> None:
    _, expected = note_and_answer(girdle, stdin="elevation_deg,plane_deg\n30,40\n60,50\n")
    note, found = note_and_answer(
        girdle,
        "--columns",
        "elevation_deg=Elevation (deg),plane_deg=psi",
        stdin="psi,Elevation (deg)\n40,30\n50,60\n",
    )
    assert note == "girdle: standard input: read 'Elevation (deg)' as elevation_deg, 'psi' as plane_deg"
    assert found == expected


def test_coordinates_of_mobl_arms_are_read(girdle: Girdle) -> None:
    # shoulder_rot is ISB's third angle plus the plane.
    _, expected = note_and_answer(
        *(girdle, "--axial-from", "isb"), stdin="elevation_deg,plane_deg,axial_deg\n30,40,-50\n60,50,-30\n"
    )
    note, found = note_and_answer(
        girdle, stdin="time,elv_angle,shoulder_elv,shoulder_rot\n0,40,30,-10\n1,50,60,20\n"
    )
    assert note == (
        "girdle: standard input: read 'shoulder_elv' as elevation_deg, 'elv_angle' as plane_deg, "
        "'shoulder_rot' as axial_deg + plane_deg from isb"
    )
    assert found == expected


def test_an_option_excludes_a_column_under_another_name(refuses: Refuses) -> None:
    poses = b"shoulder_elv,elv_angle,shoulder_rot\n30,40,5\n"
    refuses("solve", "--in", "-", "--axial", "3", because=("shoulder_rot and --axial exclude",), stdin=poses)


WRONG_NAMES = {
    "not in the file": ("elevation_deg=theta", ":1: .*no column 'theta'. Did you mean 'thetas'?"),
    "known name is there, too": ("plane_deg=thetas", ":1: .*'plane_deg' is there, too"),
    "given twice": ("elevation_deg=thetas,elevation_deg=psi", "'elevation_deg' is given twice"),
    "unknown": ("elevatio_deg=thetas", "'elevatio_deg' is not known. Did you mean 'elevation_deg'?"),
    "no pair": ("elevation_deg", "does not name a column. Give pairs"),
    "of a motion": ("time_s=thetas", "'time_s' is not known"),
}


@pytest.mark.parametrize(("names", "reason"), WRONG_NAMES.values(), ids=WRONG_NAMES.keys())
def test_a_wrong_name_is_refused(refuses: Refuses, names: str, reason: str) -> None:
    refuses(
        "solve", "--in", "-", "--columns", names, because=(reason,), stdin=b"thetas,plane_deg,psi\n30,40,1\n"
    )


def test_a_name_that_is_nearly_known_is_offered_the_option(refuses: Refuses) -> None:
    refuses(
        *("solve", "--in", "-"),
        because=("Did you mean 'plane_deg'.*give --columns plane_deg=plane",),
        stdin=b"elevation_deg,plane\n30,40\n",
    )
    refuses(
        *("solve", "--in", "-"),
        because=("'plane_deg' is missing. .*--columns plane_deg=NAME",),
        stdin=b"elevation_deg,psi\n30,40\n",
    )


def test_a_motion_has_the_names_that_are_given(girdle: Girdle, model_path: Path, tmp_path: Path) -> None:
    (tmp_path / "known.csv").write_text("time_s,elevation_deg,plane_deg\n0,30,40\n0.01,31,40\n")
    (tmp_path / "named.csv").write_text("t;theta;psi\n0;30;40\n0,01;31;40\n")
    known = girdle("simulate", model_path, "--in", "known.csv", "--out", "-")
    named = girdle(
        *("simulate", model_path, "--in", "named.csv", "--out", "-"),
        *("--columns", "time_s=t,elevation_deg=theta,plane_deg=psi"),
    )
    assert known.code == named.code == 0, named.message
    assert named.output == known.output
    assert named.message.startswith(
        "girdle: named.csv: read 't' as time_s, 'theta' as elevation_deg, 'psi' as plane_deg\n"
    )


@pytest.mark.parametrize(
    "option", [("--columns", "plane_deg=psi"), ("--gaps", "keep"), ("--bridge-gaps", "3")]
)
def test_options_of_a_table_need_one(refuses: Refuses, model_path: Path, option: tuple[str, str]) -> None:
    refuses("solve", "--elevation", "30", "--plane", "40", *option, because=(option[0], "--in FILE"))
    refuses("simulate", model_path, "--elevation", "0:30", *option, because=(option[0], "--in FILE"))


# --- Gaps -----------------------------------------------------------------------------------------

GAPPED = "elevation_deg,plane_deg\n30,40\n,40\nNaN,40\n60,55\nNA,#N/A\n"


def fields_of(text: str, *columns: str) -> list[tuple[str, ...]]:
    header, *rows = [line.split(",") for line in text.splitlines()]
    return [tuple(row[header.index(column)] for column in columns) for row in rows]


def test_a_row_with_a_gap_has_an_empty_answer(girdle: Girdle) -> None:
    finished = girdle("solve", "--in", "-", stdin=GAPPED.encode())
    whole = girdle("solve", "--in", "-", stdin=b"elevation_deg,plane_deg\n30,40\n60,55\n")
    assert finished.message == "girdle: standard input: 5 rows, 0 clamped, 0 modelled, 3 gaps\n"
    lines = finished.text.splitlines()
    assert [lines[0], lines[1], lines[4]] == whole.text.splitlines()
    empty = "," * lines[0].count(",")
    assert [lines[2], lines[3], lines[5]] == [f",40{empty[1:]}", f"NaN,40{empty[1:]}", f"NA,#N/A{empty[1:]}"]


def test_a_short_gap_is_bridged(girdle: Girdle) -> None:
    finished = girdle("solve", "--in", "-", "--bridge-gaps", "2", "--digits", "9", stdin=GAPPED.encode())
    assert finished.message == "girdle: standard input: 5 rows, 0 clamped, 0 modelled, 1 gap, 2 bridged\n"
    rows = fields_of(finished.text, "elevation_deg", "used_elevation_deg", "used_plane_deg", "bridged")
    assert [row[3] for row in rows] == ["0", "1", "1", "0", ""]
    assert [row[0] for row in rows] == ["30", "", "NaN", "60", "NA"]

    def direction(row: tuple[str, ...]) -> np.ndarray:
        elevation, plane = np.radians([float(row[1]), float(row[2])])
        return np.array(
            [np.sin(elevation) * np.sin(plane), -np.cos(elevation), np.sin(elevation) * np.cos(plane)]
        )

    # Even steps on one great circle.
    start, *between, end = (direction(row) for row in rows[:4])
    whole = np.arccos(start @ end)
    for step, found in enumerate(between, start=1):
        share = step / 3
        expected = (np.sin((1 - share) * whole) * start + np.sin(share * whole) * end) / np.sin(whole)
        assert found == pytest.approx(expected, abs=1e-9)


def test_a_long_gap_stays(girdle: Girdle) -> None:
    finished = girdle("solve", "--in", "-", "--bridge-gaps", "1", stdin=GAPPED.encode())
    assert finished.message.endswith(" 3 gaps\n")
    assert [row[0] for row in fields_of(finished.text, "bridged")] == ["0", "", "", "0", ""]


# Gaps of one to twelve rows, so that blocks begin and end in them.
MANY_GAPS = ["elevation_deg,plane_deg,row"] + [
    f"{'' if i % 97 < i // 97 % 13 else i % 150},40.5,{i}" for i in range(8000)
]


def test_gaps_are_bridged_the_same_whatever_the_number_of_threads_and_the_blocks(
    girdle: Girdle, program: Path
) -> None:
    text = "\n".join(MANY_GAPS) + "\n"
    answers = [
        girdle("solve", "--in", "-", "--bridge-gaps", "7", "--threads", threads, stdin=text.encode())
        for threads in ("1", "4")
    ]
    assert answers[0].output == answers[1].output
    assert answers[0].message == answers[1].message
    # One row at a time.
    with subprocess.Popen(
        [program, "solve", "--in", "-", "--bridge-gaps", "7"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    ) as solving:
        assert solving.stdin is not None
        assert solving.stdout is not None
        for line in MANY_GAPS[:300]:
            solving.stdin.write(f"{line}\n".encode())
            solving.stdin.flush()
        solving.stdin.close()
        lines = solving.stdout.read().splitlines()
    assert lines == answers[0].output.splitlines()[:300]
    bridged = [row[0] for row in fields_of(answers[0].text, "bridged")]
    for i, line in enumerate(MANY_GAPS[1:]):
        length = i // 97 % 13
        expected = "0" if line[0] != "," else "1" if length <= 7 else ""
        assert bridged[i] == expected, line


def test_gaps_are_refused_on_request(refuses: Refuses) -> None:
    refuses(
        *("solve", "--in", "-", "--gaps", "refuse"),
        because=("input:3: elevation_deg is empty, a gap", "--bridge-gaps ROWS", "--gaps keep"),
        stdin=GAPPED.encode(),
    )
    refuses(
        *("solve", "--in", "-", "--gaps", "refuse", "--bridge-gaps", "1"),
        because=("input:3: a gap that --bridge-gaps 1 does not bridge",),
        stdin=GAPPED.encode(),
    )


@pytest.mark.parametrize("field", ["inf", "-Infinity", "3O", "-", "n/a", "nan()"])
def test_what_is_neither_a_number_nor_a_gap_is_refused(refuses: Refuses, field: str) -> None:
    for row in (f"30,{field}", f",{field}"):
        refuses(
            *("solve", "--in", "-", "--bridge-gaps", "2"),
            because=(rf"input:3: plane_deg is '{re.escape(field)}', expected a finite number",),
            stdin=f"elevation_deg,plane_deg\n30,40\n{row}\n".encode(),
        )


@pytest.mark.parametrize("rows", ["-1", "1.5", "1001", "two", "nan"])
def test_what_is_no_number_of_rows_is_refused(refuses: Refuses, rows: str) -> None:
    refuses("solve", "--in", "-", f"--bridge-gaps={rows}", because=("--bridge-gaps", "0 to 1000"))


MOTION = "time_s,elevation_deg,plane_deg\n0,30,40\n0.004,,40\n0.008,32,40\n"


def test_a_motion_refuses_gaps_and_offers_to_bridge_them(
    refuses: Refuses, model_path: Path, tmp_path: Path
) -> None:
    (tmp_path / "motion.csv").write_text(MOTION)
    refuses(
        *("simulate", model_path, "--in", "motion.csv"),
        because=("motion.csv:3: elevation_deg is empty, a gap of 1 row. .*--bridge-gaps 1",),
    )


@pytest.mark.parametrize("option", [("--bridge-gaps", "1"), ("--gaps", "keep")])
def test_a_motion_passes_over_gaps(
    girdle: Girdle, model_path: Path, tmp_path: Path, option: tuple[str, str]
) -> None:
    (tmp_path / "motion.csv").write_text(MOTION)
    (tmp_path / "whole.csv").write_text("time_s,elevation_deg,plane_deg\n0,30,40\n0.008,32,40\n")
    passed = girdle("simulate", model_path, "--in", "motion.csv", "--out", "-", *option)
    whole = girdle("simulate", model_path, "--in", "whole.csv", "--out", "-")
    assert passed.code == whole.code == 0, passed.message
    assert passed.output == whole.output
    counted = ", 1 bridged" if option[0] == "--bridge-gaps" else ", 1 gap"
    assert passed.message == whole.message.replace("whole", "motion").removesuffix("\n") + f"{counted}\n"
    summary = json.loads(girdle("simulate", model_path, "--in", "motion.csv", "--json", *option).output)
    assert (summary["gap_rows"], summary["bridged_rows"]) == ((0, 1) if counted == ", 1 bridged" else (1, 0))
