# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Meshes that crash, stop or fill the library that reads them are refused in words."""

from __future__ import annotations

import json
import math
import os
import struct
from pathlib import Path
from typing import Any

import pytest
from conftest import Refuses
from reference_rhythm import DATABASE

LANDMARKS = DATABASE.parent / "example_lab_landmarks.csv"
FIX = r"\. Export it again as \.glb or \.obj$"
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
PLACES = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
CORNERS = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]


def refuse(refuses: Refuses, mesh: str, *because: str) -> str:
    words = ("generate", "--skin", mesh, "--skin-landmarks", LANDMARKS, "--out", "model")
    return refuses(*words, because=(f"^girdle: {mesh}: ", *because))


def tetrahedron() -> tuple[dict[str, Any], bytes]:
    """A glTF of one tetrahedron, and the bytes of its buffer."""
    numbers = struct.pack("<12f", *(x for place in PLACES for x in place)) + struct.pack("<12I", *CORNERS)
    gltf = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
        "buffers": [{"byteLength": 96}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 48},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5125, "count": 12, "type": "SCALAR"},
        ],
    }
    return gltf, numbers


def write_glb(path: Path, gltf: dict[str, Any], numbers: bytes) -> None:
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(numbers), b"BIN\0") + numbers
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def skinned(gltf: dict[str, Any]) -> None:
    gltf["nodes"][0]["skin"] = 0
    gltf["skins"] = [{"joints": [0]}]
    gltf["meshes"][0]["primitives"][0]["attributes"] |= {"JOINTS_0": 0, "WEIGHTS_0": 0}
    del gltf["accessors"][0]["componentType"]


def sparse(**parts: object) -> dict[str, object]:
    whole = {
        "count": 2,
        "indices": {"bufferView": 1, "componentType": 5125},
        "values": {"bufferView": 0},
    }
    return {key: value for key, value in (whole | parts).items() if value is not None}


def test_the_tetrahedron_is_read(refuses: Refuses, tmp_path: Path) -> None:
    """What is wrong with the files below is their change alone: its bones are elsewhere."""
    gltf, numbers = tetrahedron()
    write_glb(tmp_path / "whole.glb", gltf, numbers)
    words = ("generate", "--skin", "whole.glb", "--skin-landmarks", LANDMARKS, "--out", "model")
    refuses(*words, because=("outside the skin of whole.glb",))


def test_a_rig_without_its_numbers_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    gltf, numbers = tetrahedron()
    skinned(gltf)
    write_glb(tmp_path / "bad.glb", gltf, numbers)
    refuse(refuses, "bad.glb", "cannot be read as a mesh: ", FIX)


@pytest.mark.parametrize(
    "changed",
    [
        {"sparse": sparse(indices=None)},
        {"sparse": sparse(values=None)},
        {"sparse": sparse(values={}), "bufferView": None},
        {"sparse": sparse(count=None)},
    ],
    ids=["no indices", "no values", "values nowhere", "no count"],
)
def test_a_sparse_accessor_that_is_not_whole_is_refused(
    refuses: Refuses, tmp_path: Path, changed: dict[str, object]
) -> None:
    gltf, numbers = tetrahedron()
    merged = gltf["accessors"][0] | changed
    gltf["accessors"][0] = {key: value for key, value in merged.items() if value is not None}
    write_glb(tmp_path / "bad.glb", gltf, numbers)
    refuse(refuses, "bad.glb", "cannot be read as a mesh: ", FIX)


def test_a_face_of_very_many_corners_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    """Its time to be cut grows with the square of their number."""
    count = 100_000
    turns = [2 * math.pi * i / count for i in range(count)]
    lines = [f"v {math.cos(turn):g} {math.sin(turn):g} 0\n" for turn in turns]
    face = "f " + " ".join(str(i + 1) for i in range(count)) + "\n"
    (tmp_path / "fan.obj").write_text("".join(lines) + face)
    because = ("a face has 100000 corners, more than 2000", "Cut it into triangles")
    refuse(refuses, "fan.obj", *because)


NO_FILE = "it names fifo, which is not a regular file" + FIX


def test_a_material_in_a_pipe_is_not_waited_for(refuses: Refuses, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo")
    (tmp_path / "pipe.obj").write_text("mtllib fifo\n" + TETRAHEDRON)
    refuse(refuses, "pipe.obj", NO_FILE)


def test_a_buffer_in_a_pipe_is_not_waited_for(refuses: Refuses, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo")
    gltf, _ = tetrahedron()
    gltf["buffers"][0]["uri"] = "fifo"
    (tmp_path / "pipe.gltf").write_text(json.dumps(gltf))
    refuse(refuses, "pipe.gltf", NO_FILE)


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".obj"])
def test_a_mesh_in_a_pipe_is_not_waited_for(refuses: Refuses, tmp_path: Path, suffix: str) -> None:
    os.mkfifo(tmp_path / f"pipe{suffix}")
    refuse(refuses, f"pipe{suffix}", "it is not a regular file" + FIX)


def test_a_mesh_of_any_size_is_not_read(refuses: Refuses, tmp_path: Path) -> None:
    with (tmp_path / "huge.obj").open("wb") as file:
        file.truncate(1 << 40)  # takes no room on the disk
    try:
        words = ("generate", "--skin", "huge.obj", "--skin-landmarks", LANDMARKS, "--out", "model")
        with pytest.MonkeyPatch.context() as patched:
            # Its content is not compared either.
            patched.setattr("conftest.contents", lambda folder: sorted(os.listdir(folder)))
            refuses(*words, because=("it has 1099511627776 bytes, more than 100000000" + FIX,))
    finally:
        (tmp_path / "huge.obj").unlink()


def test_a_file_that_names_a_huge_one_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    """A number of bytes just above what is read, so that the test can compare them."""
    with (tmp_path / "huge.mtl").open("wb") as file:
        file.truncate(100_000_001)
    (tmp_path / "small.obj").write_text("mtllib huge.mtl\n" + TETRAHEDRON)
    refuse(refuses, "small.obj", "it names huge.mtl, which has 100000001 bytes, more than 100000000" + FIX)
