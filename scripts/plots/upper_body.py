# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The upper body with one arm raised: the measured girdle beside the frozen one, bones in colour.

The program draws skin, ribs and moving bones one after the other; this module lays the bones over
the pale skin, as an X-ray does. It writes scenes of its own for that, with a plain background and
no floor, beside the body's model.
"""

from __future__ import annotations

import math
from xml.etree import ElementTree

import numpy as np
from bodies import Body
from figure import Figure, NumberTable, rounded
from girdle_program import Girdle, Numbers
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from panels import drawn
from skin_near_ac import SkinReport

ELEVATION_DEG = 120
GIRDLES = {
    "measured": ("Measured girdle", "clavicle and scapula move with the arm"),
    "frozen": ("Frozen girdle", "the arm turns in the glenohumeral joint alone"),
}

# Okabe and Ito's orange, blue and green, darkened so that labels in them can be read.
BONES = {"clavicle": (0.84, 0.47, 0.0), "scapula": (0.0, 0.40, 0.70), "humerus": (0.0, 0.55, 0.38)}
RIBCAGE = "ribcage"
RIBCAGE_COLOR = (0.62, 0.64, 0.68)
# The bones that a layer shows.
MOVING, RIBS = "moving_bones", "ribs"
# Opacity of each layer over the skin.
LAYERS = {RIBS: 0.45, MOVING: 0.96}
# The skin keeps this share of its own colour; the rest is white.
SKIN_SHARE = 0.62

# A long lens from far away: both shoulders are seen straight from behind.
CAMERA = "far_behind"
CAMERA_DISTANCE_M = 6
CAMERA_FIELD_DEG = 15
SIZE = 2400
QUICK_SIZE = 300
# Empty room around the body, as a share of the picture that the program draws.
MARGIN = 0.02
BODY_TONE = 0.985  # a darker pixel shows the body, a lighter one the background

# Where a label stands, to the right of and below the middle of its bone, in the plane through the
# spine that the camera looks at.
LABELS_M = {"clavicle": (0.12, -0.16), "scapula": (0.28, 0.18), "humerus": (0.155, 0.125)}

PANEL_WIDTH_INCHES = 3.35


def write_scene(girdle: Girdle, body: Body, layer: str, background: str) -> str:
    """A scene that shows one layer of the bones before one colour, and the file's name."""
    folder, *_ = body.scene.rpartition("/")
    scene = ElementTree.parse(girdle.folder / body.scene)
    root = scene.getroot()
    include = _first(root, "include")
    model = ElementTree.parse(girdle.folder / folder / include.get("file", ""))
    for geom in model.iter("geom"):
        bone = geom.get("name", "").rpartition("_")[0] or geom.get("name", "")
        if bone in BONES:
            geom.set("rgba", _rgba(BONES[bone], layer == MOVING))
        elif bone == RIBCAGE:
            geom.set("rgba", _rgba(RIBCAGE_COLOR, layer == RIBS))
    for ligament in model.iter("spatial"):
        ligament.set("rgba", _rgba(RIBCAGE_COLOR, False))
    include.set("file", f"{layer}.xml")
    model.write(girdle.folder / folder / f"{layer}.xml")

    for parent in root.iter():
        for child in list(parent):
            if child.get("name") == "floor":
                parent.remove(child)
    sky = next(each for each in root.iter("texture") if each.get("type") == "skybox")
    shade = {"white": "1 1 1", "black": "0 0 0"}[background]
    sky.attrib.update(builtin="flat", rgb1=shade, rgb2=shade)
    center = [float(word) for word in _first(root, "statistic").get("center", "").split()]
    place = (center[0] - CAMERA_DISTANCE_M, center[1], center[2])
    ElementTree.SubElement(
        _first(root, "worldbody"),
        "camera",
        name=CAMERA,
        pos=" ".join(map(str, place)),
        xyaxes="0 -1 0 0 0 1",
        fovy=str(CAMERA_FIELD_DEG),
    )
    name = f"{folder}/{layer}_before_{background}.xml"
    scene.write(girdle.folder / name)
    return name


def _first(root: ElementTree.Element, tag: str) -> ElementTree.Element:
    return next(root.iter(tag))


def _rgba(color: tuple[float, float, float], visible: bool) -> str:
    return " ".join(map(str, (*color, int(visible))))


def draw(girdle: Girdle, body: Body, scene: str, show: str, motion: str, size: int) -> Numbers:
    """What the program draws of a scene, as [row, column, colour]."""
    (girdle.folder / "panels").mkdir(exist_ok=True)
    stem = scene.rpartition("/")[2].removesuffix(".xml")
    file = f"panels/{body.name}_{stem}_{show}_{motion}.png"
    girdle.run(
        "render", scene, "--elevation", str(ELEVATION_DEG), "--plane", "0", "--side", "right",
        "--girdle", motion, "--camera", CAMERA, "--size", f"{size}x{size}", "--show", show,
        "--out", file,
    )  # fmt: skip
    picture: Numbers = plt.imread(girdle.folder / file)[..., :3].astype(float)
    return picture


def girdle_picture(
    girdle: Girdle, body: Body, scenes: dict[tuple[str, str], str], motion: str, size: int
) -> tuple[Numbers, Numbers, Numbers]:
    """The bones over the skin; the skin alone; and how much each pixel shows of each moving bone."""
    skin = draw(girdle, body, scenes[MOVING, "white"], "skin", motion, size)
    picture = 1 - SKIN_SHARE * (1 - skin)
    for layer, share in LAYERS.items():
        before_white, before_black = (
            draw(girdle, body, scenes[layer, background], "bones", motion, size)
            for background in ("white", "black")
        )
        # Where both are alike a bone covers the background.
        covered = 1 - np.clip((before_white - before_black).mean(axis=2, keepdims=True), 0, 1)
        picture = picture * (1 - share * covered) + share * before_black
        if layer == MOVING:
            moving = bones_shown(before_black, covered[..., 0])
    return np.clip(picture, 0, 1), skin, moving


def bones_shown(picture: Numbers, covered: Numbers) -> Numbers:
    """For each bone where it is seen: 1 or 0 at [bone, row, column]."""
    tones = np.array(list(BONES.values()))
    tones /= np.linalg.norm(tones, axis=1, keepdims=True)
    likeness = picture @ tones.T  # light changes a colour's length alone
    nearest = likeness.argmax(axis=2)
    seen = covered > 0.5
    return np.array([(nearest == bone) & seen for bone in range(len(BONES))], dtype=float)


def window_around(skins: list[Numbers]) -> tuple[int, int, int, int]:
    """Upper, lower, left and right edge of what holds all bodies, with a margin."""
    body = np.any([skin.min(axis=2) < BODY_TONE for skin in skins], axis=0)
    rows, columns = np.flatnonzero(body.any(axis=1)), np.flatnonzero(body.any(axis=0))
    margin = round(MARGIN * body.shape[0])
    return (
        max(rows[0] - margin, 0),
        min(rows[-1] + 1 + margin, body.shape[0]),
        max(columns[0] - margin, 0),
        min(columns[-1] + 1 + margin, body.shape[1]),
    )


def label_bones(panel: Axes, moving: Numbers, spine: int, pixels_per_m: float) -> None:
    """Writes the name of each bone of the raised arm, with a line to it.

    That arm is on the right of the column `spine`.
    """
    right_half = np.arange(moving.shape[2]) > spine
    for name, color, shown in zip(BONES, BONES.values(), moving, strict=True):
        rows, columns = np.nonzero(shown * right_half)
        if len(rows) == 0:
            continue  # a picture too small to show it
        middle = (rows.mean(), columns.mean())
        nearest = np.argmin((rows - middle[0]) ** 2 + (columns - middle[1]) ** 2)
        place = np.array([columns[nearest], rows[nearest]])
        panel.annotate(
            name,
            place,
            xytext=place + pixels_per_m * np.array(LABELS_M[name]),
            color=color,
            fontsize=12,
            fontweight="bold",
            ha="center",
            va="center",
            arrowprops={
                "arrowstyle": "-",
                "color": "#333333",
                "linewidth": 1.1,
                "shrinkA": 1,
                "shrinkB": 0,
            },
        )
        panel.plot(*place, marker="o", markersize=4.5, color="#333333")


def pictures(girdle: Girdle, body: Body, quick: bool) -> plt.Figure:
    size = QUICK_SIZE if quick else SIZE
    scenes = {
        (layer, background): write_scene(girdle, body, layer, background)
        for layer in LAYERS
        for background in ("white", "black")
    }
    made = [girdle_picture(girdle, body, scenes, motion, size) for motion in GIRDLES]
    pixels_per_m = size / (2 * CAMERA_DISTANCE_M * math.tan(math.radians(CAMERA_FIELD_DEG / 2)))
    upper, lower, left, right = window_around([skin for _, skin, _ in made])
    panel_height = PANEL_WIDTH_INCHES * (lower - upper) / (right - left)
    canvas, panels = plt.subplots(1, 2, figsize=(2 * PANEL_WIDTH_INCHES + 0.3, panel_height + 0.72))
    canvas.get_layout_engine().set(w_pad=0.04, h_pad=0.04, wspace=0.02, hspace=0)
    for panel, (title, words), (picture, _, moving) in zip(panels, GIRDLES.values(), made, strict=True):
        panel.imshow(picture[upper:lower, left:right], interpolation="antialiased")
        # The camera looks at the spine.
        label_bones(panel, moving[:, upper:lower, left:right], size // 2 - left, pixels_per_m)
        panel.set_xticks([])
        panel.set_yticks([])
        for spine in panel.spines.values():
            spine.set_visible(True)
            spine.set_color("#b0b0b0")
        panel.set_title(title, fontsize=14, fontweight="bold", pad=23)
        panel.text(0.5, 1.018, words, transform=panel.transAxes, ha="center", va="bottom", fontsize=10.5)
    canvas.supxlabel(
        f"right arm raised to {ELEVATION_DEG}° in the frontal plane, left arm hanging; seen from behind",
        fontsize=10.5,
    )
    return canvas


def rises(skin: SkinReport) -> NumberTable:
    """How much the raised shoulder rises with either girdle."""
    items = ("acromion's skin rises", "acromion's bone rises", "AC joint rises")
    rows = [
        [item, *(rounded(skin.value(motion, f"{item}, plane 0, right"), 1) for motion in GIRDLES)]
        for item in items
    ]
    return NumberTable(
        "Between elevations 30 and 120 in the frontal plane, right side (mm), as girdle verify has it",
        ["of", *(title.lower() for title, _ in GIRDLES.values())],
        rows,
    )


def make(girdle: Girdle, body: Body, skin: SkinReport, quick: bool) -> Figure:
    figure = Figure(
        f"upper_body_{body.name}",
        f"The girdle that moves and the frozen one: {body.title}",
        f"The right arm is raised to {ELEVATION_DEG} degrees in the frontal plane, the left one "
        "hangs. On the left, clavicle and scapula move as measured. On the right, they stay where "
        "the skin was bound and the arm turns in the glenohumeral joint alone, to where it points on "
        "the left. The bones are drawn over the skin. The scene is the body's own without floor; "
        "the script that makes this page writes it and colours the bones.",
        "Two views of an upper body from behind, with clavicles, scapulae and humeri in colour. On "
        "the left the scapula of the raised arm is turned upward and the clavicle is raised; on the "
        "right both are about as on the side of the hanging arm, and the raised shoulder is lower.",
        [rises(skin)],
    )
    return drawn(girdle, figure, lambda: pictures(girdle, body, quick))
