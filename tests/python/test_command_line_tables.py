# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of poses and motions as spreadsheets, MATLAB and motion capture write them."""

from __future__ import annotations

from pathlib import Path

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
