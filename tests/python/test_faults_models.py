# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Models that would take all memory, and those that OpenGL cannot draw, are refused in words.

Each run gets 1 GB for its data, so that a size that is not checked ends it in another way.
"""

from __future__ import annotations

import re
import resource
import struct
import zlib
from pathlib import Path

import pytest
from conftest import REFUSED
from faults import run_limited

GIGABYTE = {resource.RLIMIT_DATA: 10**9}
VERBS = {
    "render": ("--out", "picture.png"),
    "simulate": ("--elevation", "15:16", "--out", "trace.csv"),
    "verify": (),
}
LIT = "<worldbody><light/><geom size='1'/><body pos='3 0 0'><geom size='1'/></body></worldbody>"


def refuse(program: Path, folder: Path, verb: str, *because: str) -> None:
    before = set(folder.iterdir())
    result = run_limited(program, verb, "model.xml", *VERBS[verb], folder=folder, limits=GIGABYTE)
    assert result.returncode == REFUSED, result.stderr
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1, result.stderr
    for pattern in because:
        assert re.search(pattern, result.stderr), result.stderr
    assert set(folder.iterdir()) == before


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize(
    ("element", "most"),
    [
        ('<size nuser_body="2000000000"/>', "10000"),
        ('<size nkey="2000000000"/>', "10000"),
        ('<size nuserdata="2000000000"/>', "10000000"),
        ('<size memory="1P"/>', "4G"),
        ('<size memory="5000000000"/>', "4G"),
        ('<asset><texture name="t" type="2d" builtin="flat" width="30000" height="8"/></asset>', "8192"),
        ('<asset><texture name="t" type="2d" builtin="flat" width="8" height="1e9"/></asset>', "8192"),
        ('<asset><hfield name="h" nrow="1000000" ncol="2" size="1 1 1 1"/></asset>', "8192"),
        ('<worldbody><replicate count="10000000"><geom size="1"/></replicate></worldbody>', "10000"),
    ],
)
def test_a_size_that_takes_all_memory_is_named_with_its_place(
    program: Path, tmp_path: Path, verb: str, element: str, most: str
) -> None:
    (tmp_path / "model.xml").write_text(f"<mujoco>\n{element}</mujoco>")
    because = (r'^girdle: model\.xml:2: <\w+ \w+="\w+"> takes too much memory', f"Write at most {most}$")
    refuse(program, tmp_path, verb, *because)


def test_a_size_in_an_included_file_is_named_with_its_place(program: Path, tmp_path: Path) -> None:
    (tmp_path / "model.xml").write_text('<mujoco><include file="part.xml"/></mujoco>')
    (tmp_path / "part.xml").write_text('<mujoco>\n\n<size nuser_geom="2000000000"/></mujoco>')
    refuse(program, tmp_path, "render", r'part\.xml:3: <size nuser_geom="2000000000">')


def test_sizes_that_only_together_take_all_memory_are_refused(program: Path, tmp_path: Path) -> None:
    bodies = '<replicate count="400"><body><geom size="1"/></body></replicate>'
    textures = "".join(
        f'<texture name="t{i}" type="2d" builtin="flat" width="8192" height="8192"/>' for i in range(9)
    )
    (tmp_path / "model.xml").write_text(
        f"<mujoco><asset>{textures}</asset><worldbody>{bodies}</worldbody></mujoco>"
    )
    because = ("^girdle: model.xml: MuJoCo (needs|cannot)", "1 GB of memory", "Lower what makes")
    refuse(program, tmp_path, "verify", *because)


def png(side: int) -> bytes:
    """A square picture of one colour, which takes few bytes for its pixels."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        check = struct.pack(">I", zlib.crc32(kind + content))
        return struct.pack(">I", len(content)) + kind + content + check

    packer = zlib.compressobj(9)
    row = bytes(1 + 3 * side)
    pixels = b"".join(packer.compress(row) for _ in range(side)) + packer.flush()
    head = chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


@pytest.mark.parametrize(
    ("side", "because"),
    [(20_000, "needs more than 1 GB of memory to load it"), (9000, "its textures have 243 MB of pixels")],
)
def test_a_small_file_of_a_huge_picture_is_refused(
    program: Path, tmp_path: Path, side: int, because: str
) -> None:
    (tmp_path / "huge.png").write_bytes(png(side))
    (tmp_path / "model.xml").write_text(
        '<mujoco><asset><texture name="t" type="2d" file="huge.png"/></asset></mujoco>'
    )
    refuse(program, tmp_path, "render", f"^girdle: model.xml: .*{because}", "Lower|smaller")


@pytest.mark.parametrize(
    ("element", "limits"),
    [
        ('global offwidth="-1"', "1 to 100000"),
        ('global offheight="0"', "1 to 100000"),
        ('quality shadowsize="100000"', "0 to 8192"),
        ('quality shadowsize="-5"', "0 to 8192"),
        ('quality offsamples="-1"', "0 to 64"),
        ('quality numslices="100000"', "1 to 1000"),
        ('quality numstacks="0"', "1 to 1000"),
        ('quality numquads="3000"', "1 to 100"),
    ],
)
def test_a_number_that_opengl_cannot_draw_is_named(
    program: Path, tmp_path: Path, element: str, limits: str
) -> None:
    (tmp_path / "model.xml").write_text(f"<mujoco><visual><{element}/></visual>{LIT}</mujoco>")
    place = f"^girdle: model.xml: <{re.escape(element)}> of its <visual> cannot be drawn"
    refuse(program, tmp_path, "render", place, f"Write {limits}, or omit it$")


def test_the_ends_of_the_limits_are_drawn(program: Path, tmp_path: Path) -> None:
    least = '<quality shadowsize="0" offsamples="0" numslices="1" numstacks="1" numquads="1"/>'
    boxes = LIT.replace("<geom size='1'/>", "<geom type='box' size='1 1 1'/>")
    (tmp_path / "model.xml").write_text(f"<mujoco><visual>{least}</visual>{boxes}</mujoco>")
    result = run_limited(
        program, "render", "model.xml", "--out", "picture.png", folder=tmp_path, limits=GIGABYTE
    )
    assert result.returncode == 0, result.stderr


def test_more_things_than_are_drawn_are_counted_in_words(program: Path, tmp_path: Path) -> None:
    many = "<replicate count='101'><replicate count='100'><geom size='1'/></replicate></replicate>"
    (tmp_path / "model.xml").write_text(f"<mujoco><worldbody>{many}</worldbody></mujoco>")
    because = "^girdle: model.xml: has more to draw than 10000 geoms, sites and tendons. Remove some$"
    refuse(program, tmp_path, "render", because)
