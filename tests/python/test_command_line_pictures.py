# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures and videos as a person asks for them: `girdle render`, `girdle simulate --out-picture`."""

from __future__ import annotations

import functools
import io
import json
import os
import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt
import pytest
from conftest import SCENE_FILE, Girdle, Refuses, WriteModel, contents
from PIL import Image

# Of every picture here: small, so that software draws it at once.
SMALL = ("--size", "160x120")
RAISE = ("--elevation", "0:90", "--seconds", "0.2")

# Mean difference of two pictures' colours, of 255. The arm is a small part of a picture.
SAME = 0.1  # edges of positions that differ by rounding
SAME_TO_A_RENDERER = 1  # which may round colours and edges otherwise
OTHER_POSE = 0.5


@dataclass(frozen=True)
class Png:
    width: int
    height: int
    colours: bytes  # 3 a pixel, row by row from the top

    @property
    def pixels(self) -> npt.NDArray[np.int16]:
        """Red, green and blue by row and column; signed, for differences."""
        colours = np.frombuffer(self.colours, dtype=np.uint8)
        return colours.reshape(self.height, self.width, 3).astype(np.int16)


# Where a PNG says how it is stored: bits a colour, kind of colours, interlace.
PNG_DEPTH, PNG_KIND, PNG_INTERLACE = 24, 25, 28
PNG_RGB = 2


def read_png(path: Path) -> Png:
    """A PNG of 8 bits a colour without alpha; Pillow would turn others into such."""
    content = path.read_bytes()
    stored = [content[at] for at in (PNG_DEPTH, PNG_KIND, PNG_INTERLACE)]
    assert stored == [8, PNG_RGB, 0]
    with Image.open(io.BytesIO(content), formats=["PNG"]) as image:
        return Png(image.width, image.height, image.tobytes())


def difference(a: Png, b: Png) -> float:
    """Mean difference of a colour's value."""
    assert (a.width, a.height) == (b.width, b.height)
    return float(np.abs(a.pixels - b.pixels).mean())


@pytest.fixture
def scene(generated: Path) -> Path:
    return generated / SCENE_FILE


@pytest.fixture(autouse=True)
def _no_leaks_of_drivers(monkeypatch: pytest.MonkeyPatch) -> None:
    """OSMesa 22.3 loses a few hundred bytes a context, which the address sanitizer would report,
    and its search for leaks crashes now and then while threads of Mesa end. Leaks of our own show
    in the C++ tests of pictures.
    """
    options = os.environ.get("ASAN_OPTIONS", "")
    monkeypatch.setenv("ASAN_OPTIONS", f"{options}:detect_leaks=0")


Draw = Callable[..., Png]

# What decides how a picture is drawn, beside the words.
OF_THE_RENDERER = ("GIRDLE_GL", "LD_LIBRARY_PATH")


@pytest.fixture(scope="session")
def drawn() -> dict[tuple[str | None, ...], Png]:
    """Pictures by the words and the renderer that they were drawn with."""
    return {}


@pytest.fixture
def draw(girdle_fine: Girdle, scene: Path, tmp_path: Path, drawn: dict[tuple[str | None, ...], Png]) -> Draw:
    """Renders the generated scene, small, with these arguments; each picture once."""

    def run(*arguments: str, model: Path = scene) -> Png:
        key = (str(model), *arguments, *map(os.environ.get, OF_THE_RENDERER))
        if key not in drawn:
            out = tmp_path / "drawn.png"
            girdle_fine("render", model, *SMALL, "--out", out, *arguments)
            drawn[key] = read_png(out)
        return drawn[key]

    return run


# --- Pictures of poses ----------------------------------------------------------------------------


def test_a_picture_is_640_by_480_unless_said_otherwise(
    girdle_fine: Girdle, scene: Path, tmp_path: Path
) -> None:
    finished = girdle_fine("render", scene, "--out", "arm.png")
    assert (finished.text, finished.message) == ("", "girdle: wrote arm.png\n")
    picture = read_png(tmp_path / "arm.png")
    assert (picture.width, picture.height) == (640, 480)


@pytest.mark.numbers
def test_the_same_command_gives_the_same_bytes(girdle_fine: Girdle, scene: Path, tmp_path: Path) -> None:
    for name in ("a.png", "b.png"):
        girdle_fine("render", scene, *SMALL, "--out", name)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_egl_and_osmesa_draw_the_same_arm(draw: Draw, monkeypatch: pytest.MonkeyPatch) -> None:
    pictures = []
    for platform in ("egl", "osmesa"):
        monkeypatch.setenv("GIRDLE_GL", platform)
        pictures.append(draw("--keyframe", "abduction_90"))
    assert difference(*pictures) < SAME_TO_A_RENDERER


@pytest.mark.parametrize("words", [("--keyframe", "hanging"), ()])
def test_the_arm_rests_by_default(draw: Draw, words: tuple[str, ...]) -> None:
    assert draw(*words) == draw("--elevation", "0")


@pytest.mark.parametrize(
    ("keyframe", "elevation", "plane"),
    [
        ("abduction_90", "90", "0"),
        pytest.param("flexion_90", "90", "90", marks=pytest.mark.numbers),
        pytest.param("across_90", "90", "120", marks=pytest.mark.numbers),
    ],
)
def test_a_keyframe_is_where_the_rhythm_has_the_arm(
    draw: Draw, keyframe: str, elevation: str, plane: str
) -> None:
    posed = draw("--elevation", elevation, "--plane", plane)
    assert difference(draw("--keyframe", keyframe), posed) < SAME
    assert difference(draw("--keyframe", "hanging"), posed) > OTHER_POSE


@pytest.mark.numbers
def test_the_end_of_a_slow_raise_is_where_the_rhythm_has_the_arm(
    girdle_fine: Girdle, scene: Path, tmp_path: Path, draw: Draw
) -> None:
    girdle_fine("simulate", scene, "--elevation", "0:90", *SMALL, "--out-picture", "end.png")
    assert difference(read_png(tmp_path / "end.png"), draw("--elevation", "90")) < OTHER_POSE


@pytest.mark.numbers
def test_the_cameras_see_different_things(draw: Draw) -> None:
    pictures = [draw("--camera", word) for word in ("front", "back", "above", "oblique")]
    for i, one in enumerate(pictures):
        for other in pictures[:i]:
            assert difference(one, other) > OTHER_POSE


def test_a_frozen_girdle_stays_while_the_arm_is_raised(draw: Draw) -> None:
    """Without skin the girdle stays as at rest: at rest itself nothing changes."""
    resting = ("--elevation", "0")
    assert difference(draw(*resting, "--girdle", "frozen"), draw(*resting)) < SAME
    raised = ("--elevation", "120", "--camera", "back")
    assert difference(draw(*raised, "--girdle", "frozen"), draw(*raised)) > OTHER_POSE


def test_a_keyframe_can_be_frozen(draw: Draw) -> None:
    frozen = draw("--keyframe", "abduction_120", "--girdle", "frozen")
    assert difference(frozen, draw("--elevation", "120", "--girdle", "frozen")) < SAME


def test_the_rhythms_options_change_the_pose(draw: Draw) -> None:
    pose = ("--elevation", "60", "--plane", "90")
    assert draw(*pose, "--closure", "table") != draw(*pose)


def test_the_side_says_which_arm_is_raised(girdle_fine: Girdle, draw: Draw, tmp_path: Path) -> None:
    girdle_fine("generate", "--side", "both", "--out", "both")
    both = tmp_path / "both" / "scene_both.xml"
    view = ("--camera", "front", "--elevation", "90")
    right = draw(*view, "--side", "right", model=both)
    left = draw(*view, "--side", "left", model=both)
    all_arms = draw(*view, model=both)
    rest = draw("--camera", "front", model=both)

    def changed(picture: Png, columns: slice) -> bool:
        return bool((picture.pixels[:, columns] != rest.pixels[:, columns]).any())

    # The person's right is on the left, as far out as only a raised arm reaches.
    edges = slice(0, 40), slice(120, 160)
    assert [changed(right, edge) for edge in edges] == [True, False]
    assert [changed(left, edge) for edge in edges] == [False, True]
    assert [changed(all_arms, edge) for edge in edges] == [True, True]


def test_a_direction_out_of_reach_is_said(girdle_fine: Girdle, scene: Path) -> None:
    arm = ("--elevation", "150", "--plane=-31")
    finished = girdle_fine("render", scene, *SMALL, "--out", "a.png", *arm)
    assert re.search(r"shown instead: elevation \S+, plane -30\n", finished.text)


def add_skin(root: ElementTree.Element) -> None:
    """A red square before the chest, bound where the model stands in the world's axes."""
    deformable = ElementTree.SubElement(root, "deformable")
    skin = ElementTree.SubElement(
        deformable,
        "skin",
        name="skin",
        rgba="1 0 0 1",
        vertex=".3 -.3 1 .3 .3 1 .3 .3 1.6 .3 -.3 1.6",
        face="0 1 2 0 2 3",
    )
    for body in ("thorax", "clavicle_r", "scapula_r", "humerus_r"):
        weights = "1 1 1 1" if body == "thorax" else "0 0 0 0"
        ElementTree.SubElement(
            skin,
            "bone",
            body=body,
            bindpos="0 0 1.4",
            bindquat="0.70710678 0.70710678 0 0",
            vertid="0 1 2 3",
            vertweight=weights,
        )


def red_pixels(picture: Png) -> int:
    red, green, blue = np.moveaxis(picture.pixels, 2, 0)
    return int(((red > 60) & (red > 2 * np.maximum(green, blue))).sum())


def test_skin_and_bones_are_shown_as_asked(draw: Draw, write_model: WriteModel) -> None:
    model = write_model(add_skin)
    view = ("--camera", "front")
    words = ("skin", "bones", "both")
    skin, bones, both = (draw(*view, "--show", word, model=model) for word in words)
    assert skin == draw(*view, model=model)
    assert red_pixels(skin) > 1000
    assert red_pixels(bones) == 0
    assert difference(bones, draw(*view)) == 0
    assert both not in (skin, bones)


def test_a_girdle_is_frozen_where_its_skin_was_bound(draw: Draw, write_model: WriteModel) -> None:
    model = write_model(add_skin)
    view = ("--camera", "back", "--show", "bones", "--girdle", "frozen", "--elevation", "90")
    # Bound with all bones in one orientation, which no shoulder at rest has.
    assert difference(draw(*view, model=model), draw(*view)) > OTHER_POSE


def test_any_model_can_be_drawn(draw: Draw, tmp_path: Path) -> None:
    model = tmp_path / "ball.xml"
    model.write_text(
        "<mujoco><worldbody><body><freejoint/><geom size='1' rgba='1 0 0 1'/></body></worldbody></mujoco>"
    )
    assert red_pixels(draw(model=model)) > 1000


# --- Videos ---------------------------------------------------------------------------------------


def probe(video: Path) -> dict[str, Any]:
    words = ("-v", "error", "-count_frames", "-show_streams", "-of", "json")
    output = subprocess.run(["ffprobe", *words, video], capture_output=True, check=True).stdout
    (stream,) = json.loads(output)["streams"]
    return stream


@pytest.mark.parametrize(
    ("words", "rate"), [pytest.param((), 30, marks=pytest.mark.numbers), (("--fps", "10"), 10)]
)
def test_a_video_shows_the_motion_in_real_time(
    girdle_fine: Girdle, scene: Path, tmp_path: Path, words: tuple[str, ...], rate: int
) -> None:
    finished = girdle_fine(
        "simulate", scene, "--elevation", "0:90", "--seconds", "1", *SMALL, *words, "--out-video", "arm.mp4"
    )
    frames = rate + 1  # from the first instant to the last
    assert f"girdle: wrote arm.mp4: {frames} frames\n" in finished.message
    stream = probe(tmp_path / "arm.mp4")
    assert stream["codec_name"] == "h264"
    assert stream["pix_fmt"] == "yuv420p"
    assert (stream["width"], stream["height"]) == (160, 120)
    assert stream["r_frame_rate"] == f"{rate}/1"
    assert int(stream["nb_read_frames"]) == frames


def test_a_video_begins_and_ends_with_the_motion(
    girdle_fine: Girdle, scene: Path, tmp_path: Path, draw: Draw
) -> None:
    pictures = ("--out-video", "arm.mp4", "--fps", "5", "--out-picture", "end.png")
    girdle_fine("simulate", scene, "--elevation", "0:90", "--seconds", "2", *SMALL, *pictures)
    video, frames = tmp_path / "arm.mp4", tmp_path / "frame_%d.png"
    command: list[str | Path] = ["ffmpeg", "-v", "error", "-i", video, frames]
    subprocess.run(command, check=True, stdin=subprocess.DEVNULL)
    compressed = 6  # mean of what the encoder changes, and colours at half the resolution
    first = read_png(tmp_path / "frame_1.png")
    last = read_png(tmp_path / "frame_11.png")
    end = read_png(tmp_path / "end.png")
    assert difference(first, draw("--elevation", "0")) < compressed
    assert difference(last, end) < compressed
    assert difference(first, end) > difference(last, end) + OTHER_POSE


@dataclass(frozen=True)
class Film:
    """What a simulation with a trace, a video and a picture leaves in a folder, and says."""

    folder: Path
    summary: dict[str, Any]


@pytest.fixture(scope="session")
def films() -> list[Film]:
    """The one film that several tests look at, once it is made."""
    return []


EARLIER = b"x" * 1_000_000


@pytest.fixture
def film(
    girdle_fine: Girdle, scene: Path, films: list[Film], tmp_path_factory: pytest.TempPathFactory
) -> Film:
    """In the place of an earlier video, which was longer."""
    if not films:
        folder = tmp_path_factory.mktemp("film")
        (folder / "a.mp4").write_bytes(EARLIER)
        videos = ("--out-video", folder / "a.mp4", "--out-picture", folder / "a.png")
        results = ("--out", folder / "seen.csv", *videos)
        said = girdle_fine("simulate", scene, *RAISE, *SMALL, *results, "--json").text
        films.append(Film(folder, json.loads(said)))
    return films[0]


def test_the_index_of_a_video_stands_in_front(film: Film) -> None:
    content = (film.folder / "a.mp4").read_bytes()
    assert 0 < content.index(b"moov") < content.index(b"mdat")


def test_a_video_has_the_same_bytes_on_one_processor_and_on_all(
    program: Path, generated: Path, tmp_path: Path
) -> None:
    processors = os.sched_getaffinity(0)
    if len(processors) == 1:
        pytest.skip("this machine has one processor")
    scene = generated / SCENE_FILE
    words = ("simulate", scene, "--elevation", "0:90", "--seconds", "0.3", *SMALL, "--out-video")
    for name, allowed in (("one.mp4", {min(processors)}), ("all.mp4", processors)):
        subprocess.run(
            [program, *words, name],
            cwd=tmp_path,
            preexec_fn=functools.partial(os.sched_setaffinity, 0, allowed),
            capture_output=True,
            check=True,
        )
    assert (tmp_path / "one.mp4").read_bytes() == (tmp_path / "all.mp4").read_bytes()


def test_a_video_is_written_in_place_of_the_one_before(film: Film) -> None:
    assert EARLIER[:100] not in (film.folder / "a.mp4").read_bytes()
    assert int(probe(film.folder / "a.mp4")["nb_read_frames"]) == 7
    assert {path.name for path in film.folder.iterdir()} == {"seen.csv", "a.mp4", "a.png"}


def test_pictures_leave_the_motion_as_it_is(
    girdle_fine: Girdle, scene: Path, film: Film, tmp_path: Path
) -> None:
    girdle_fine("simulate", scene, *RAISE, "--out", "plain.csv")
    assert (tmp_path / "plain.csv").read_bytes() == (film.folder / "seen.csv").read_bytes()


def test_the_summary_as_json_names_the_pictures(film: Film) -> None:
    named = [film.summary["out_picture"], film.summary["out_video"], film.summary["frames"]]
    assert named == [str(film.folder / "a.png"), str(film.folder / "a.mp4"), 7]


# --- What is refused ------------------------------------------------------------------------------


def literal(text: str) -> str:
    return "".join(f"[{c}]" if c in ".*+?()|" else c for c in text)


@pytest.mark.parametrize(
    ("words", "because"),
    [
        (("--size", "0x0"), "--size 0x0: expected WIDTHxHEIGHT in pixels, each 16 to 4096"),
        (("--size", "100000x100000"), "--size 100000x100000: expected WIDTHxHEIGHT"),
        (("--size", "640"), "--size 640: expected WIDTHxHEIGHT"),
        (("--size", "640x48O"), "--size 640x48O: expected WIDTHxHEIGHT"),
        (("--size", "640x480x2"), "--size 640x480x2: expected WIDTHxHEIGHT"),
        (("--size", "-640x480"), "--size -640x480: expected WIDTHxHEIGHT"),
        (("--camera", "bakc"), "no camera \"bakc\". Did you mean 'back'? Choose one of: "),
        (("--camera", "below"), 'no camera "below". Choose one of: front, back, above, oblique'),
        (("--keyframe", "abduction"), 'no keyframe "abduction". Choose one of: hanging, relaxed, '),
        (("--show", "muscles"), "--show muscles: not known. Choose one of: skin, bones, both"),
        (("--show", "skin"), "has no skin to show"),
        (("--girdle", "stiff"), "--girdle stiff: not known. Choose one of: measured, frozen"),
        (("--elevation", "up"), "--elevation 'up': not a finite number"),
        (("--elevation", "181"), "--elevation 181: expected 0 to 180 degrees"),
        (("--convention", "isb"), "--convention isb: no elevation is given. Add --elevation DEG"),
        (("--plane", "40"), "--plane 40: no elevation is given"),
        (
            ("--interpolation", "slerp"),
            "--interpolation slerp: the picture shows a keyframe. Omit this option",
        ),
        (("--keyframe", "hanging", "--closure", "table"), "--closure table: a keyframe has its own pose"),
        (("--elevation", "9", "--keyframe", "hanging"), "Give either --keyframe, or --elevation"),
        (("--side", "right"), "--side right: a keyframe is one of the whole model"),
        (("--elevation", "9", "--side", "left"), "has no left shoulder"),
        (("--elevation", "9", "--interpolation", "x"), "--interpolation x: not known"),
        (("--out", "arm.jpg"), "--out arm.jpg: the name does not end in .png"),
        (("--out", "-"), "--out -: the name does not end in .png"),
        (("--out", "no/such/arm.png"), "arm.png: cannot be written"),
    ],
)
def test_render_refuses(refuses: Refuses, scene: Path, words: tuple[str, ...], because: str) -> None:
    out = () if "--out" in words else ("--out", "arm.png")
    refuses("render", scene, *out, *words, because=(literal(because),))


@pytest.mark.parametrize(
    ("words", "because"),
    [
        (("--out-picture", "arm.jpg"), "--out-picture arm.jpg: the name does not end in .png"),
        (("--out-video", "arm.avi"), "--out-video arm.avi: the name does not end in .mp4"),
        (("--out-video", "-"), "--out-video -: the name does not end in .mp4"),
        (("--camera", "front"), "--camera, --size and --show belong to a picture"),
        (("--fps", "30"), "--fps 30: there is no video. Give --out-video"),
        (("--out-video", "a.mp4", "--fps", "0"), "--fps 0: expected a whole number, 1 to 240"),
        (("--out-video", "a.mp4", "--fps", "29.97"), "--fps 29.97: expected a whole number"),
        (("--out-video", "a.mp4", "--fps", "fast"), "--fps 'fast': not a finite number"),
        (("--out-video", "a.mp4", "--size", "161x120"), "width and height have to be even"),
        (("--out-picture", "a.png", "--size", "1x1"), "--size 1x1: expected WIDTHxHEIGHT"),
        (("--out-picture", "a.png", "--camera", "x"), 'no camera "x"'),
        (("--out-picture", "no/such/a.png"), "a.png: cannot be written"),
    ],
)
def test_simulate_refuses(refuses: Refuses, scene: Path, words: tuple[str, ...], because: str) -> None:
    refuses("simulate", scene, *RAISE, "--out", "t.csv", *words, because=(literal(because),))


def test_two_results_in_one_file_are_refused(refuses: Refuses, scene: Path) -> None:
    because = (literal("--out and --out-video both want ./a.mp4"),)
    refuses("simulate", scene, *RAISE, "--out", "a.mp4", "--out-video", "./a.mp4", because=because)


def test_a_machine_that_cannot_draw_is_told_what_to_install(
    refuses: Refuses, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GIRDLE_GL", "none")
    because = ("GIRDLE_GL=none", "libegl1 libgl1-mesa-dri", "libosmesa6")
    refuses("render", scene, "--out", "arm.png", because=because)
    refuses("simulate", scene, *RAISE, "--out-picture", "arm.png", because=because)
    refuses("simulate", scene, *RAISE, "--out-video", "arm.mp4", because=because)


@pytest.mark.parametrize(("platform", "library"), [("egl", "libEGL.so.1"), ("osmesa", "libOSMesa.so.8")])
def test_a_library_that_is_broken_is_named(
    refuses: Refuses,
    scene: Path,
    tmp_path_factory: pytest.TempPathFactory,
    monkeypatch: pytest.MonkeyPatch,
    platform: str,
    library: str,
) -> None:
    folder = tmp_path_factory.mktemp("broken")
    for name in (library, library[:-1] + "6"):
        (folder / name).write_text("not a library\n" * 100)
    monkeypatch.setenv("LD_LIBRARY_PATH", f"{folder}:{os.environ.get('LD_LIBRARY_PATH', '')}")
    monkeypatch.setenv("GIRDLE_GL", platform)
    refuses("render", scene, "--out", "arm.png", because=(library, "apt-get install libegl1"))


def test_osmesa_draws_where_egl_does_not(
    girdle: Girdle,
    draw: Draw,
    tmp_path_factory: pytest.TempPathFactory,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    expected = draw()
    folder = tmp_path_factory.mktemp("broken")
    (folder / "libEGL.so.1").write_text("not a library\n" * 100)
    monkeypatch.setenv("LD_LIBRARY_PATH", f"{folder}:{os.environ.get('LD_LIBRARY_PATH', '')}")
    assert difference(draw(), expected) < SAME_TO_A_RENDERER
    assert diagnosis(girdle)["pictures"]["found"].startswith("OSMesa")


def test_an_unknown_platform_is_refused(
    refuses: Refuses, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GIRDLE_GL", "vulkan")
    refuses("render", scene, "--out", "arm.png", because=("GIRDLE_GL=vulkan: not known",))


def test_a_machine_without_ffmpeg_is_told_what_to_install(
    refuses: Refuses, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    because = ("no ffmpeg in PATH", "apt-get install ffmpeg")
    refuses("simulate", scene, *RAISE, "--out-video", "arm.mp4", because=because)


def test_what_cannot_be_drawn_leaves_the_earlier_file(girdle: Girdle, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "arm.png").write_text("earlier")
    before = contents(tmp_path)
    assert girdle("render", scene, "--camera", "below", "--out", "arm.png").code == 2
    assert contents(tmp_path) == before


def test_all_else_works_where_nothing_draws(
    girdle_fine: Girdle, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GIRDLE_GL", "none")
    girdle_fine("simulate", scene, *RAISE, "--out", "t.csv")


# --- What doctor says -----------------------------------------------------------------------------


def diagnosis(girdle: Girdle) -> dict[str, Any]:
    finished = girdle("doctor", "--json")
    assert (finished.code, finished.message) == (0, "")
    return json.loads(finished.text)


@pytest.mark.parametrize(("platform", "name"), [("egl", "EGL"), ("osmesa", "OSMesa")])
def test_doctor_says_what_draws(
    girdle: Girdle, monkeypatch: pytest.MonkeyPatch, platform: str, name: str
) -> None:
    monkeypatch.setenv("GIRDLE_GL", platform)
    pictures = diagnosis(girdle)["pictures"]
    assert pictures["found"].startswith(name)
    assert pictures["problem"] == pictures["fix"] == ""


def test_doctor_is_fine_where_nothing_draws(girdle: Girdle, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIRDLE_GL", "none")
    pictures = diagnosis(girdle)["pictures"]
    assert pictures["found"] == ""
    assert "GIRDLE_GL=none" in pictures["problem"]
    assert pictures["fix"] == "unset GIRDLE_GL"


def test_doctor_says_where_ffmpeg_is_or_how_to_get_it(
    girdle: Girdle, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert diagnosis(girdle)["videos"]["found"].endswith("/ffmpeg")
    monkeypatch.setenv("PATH", "/nowhere")
    videos = diagnosis(girdle)["videos"]
    assert videos == {"found": "", "problem": "no ffmpeg in PATH", "fix": "apt-get install ffmpeg"}


def test_the_diagnosis_for_people_says_the_same(girdle: Girdle) -> None:
    lines = girdle("doctor").text.splitlines()
    report = diagnosis(girdle)
    assert f"pictures  {report['pictures']['found']}" in lines
    assert f"videos  {report['videos']['found']}" in lines
