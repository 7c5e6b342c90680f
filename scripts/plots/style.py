# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""How all figures look, and the files that they become."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("agg")

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

# Okabe and Ito's colours, which all kinds of colour vision tell apart.
BLACK = "#000000"
WHITE = "#ffffff"
ORANGE = "#e69f00"
SKY = "#56b4e9"
GREEN = "#009e73"
BLUE = "#0072b2"
VERMILION = "#d55e00"
PURPLE = "#cc79a7"
GREY = "#777777"
BROWN = "#8a5a00"  # their orange, darker

# Of one kind of line everywhere: colour, dashes and marker differ, so that a copy in grey can be
# read too.
INTERPOLATIONS: dict[str, dict[str, Any]] = {
    "slerp": {"color": VERMILION, "linestyle": (0, (5, 2)), "marker": "s"},
    "squad": {"color": BLUE, "linestyle": "-", "marker": "o"},
    "smooth": {"color": GREEN, "linestyle": (0, (1, 1.2)), "marker": "^"},
}
RHYTHMS: dict[str, dict[str, Any]] = {
    "Girdle": {"color": BLACK, "linestyle": "-"},
    "Inman": {"color": BLUE, "linestyle": (0, (6, 2))},
    "Braman": {"color": VERMILION, "linestyle": (0, (1, 1.2))},
    "de Groot and Brand": {"color": GREEN, "linestyle": (0, (5, 1.5, 1, 1.5))},
    "MoBL-ARMS": {"color": PURPLE, "linestyle": (0, (3, 1, 1, 1, 1, 1))},
    "frozen girdle": {"color": GREY, "linestyle": (0, (2, 4))},
}

# Perceptually uniform, and readable without colour.
SEQUENTIAL = "cividis"
# Its middle, where two rhythms agree, is white.
DIVERGING = "PuOr"

plt.rcParams.update(
    {
        "font.family": "sans-serif",
        "font.sans-serif": ["DejaVu Sans"],
        "font.size": 11,
        "axes.titlesize": 11,
        "axes.labelsize": 11,
        "xtick.labelsize": 10,
        "ytick.labelsize": 10,
        "legend.fontsize": 10,
        "legend.frameon": False,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": False,
        "lines.linewidth": 1.8,
        "figure.facecolor": "white",
        "figure.constrained_layout.use": True,
        # The page shows a PNG at half of that.
        "savefig.dpi": 200,
        # Text stays text, and the same input gives the same bytes.
        "svg.fonttype": "none",
        "svg.hashsalt": "girdle",
    }
)


def draw_coarsely() -> None:
    """Makes PNGs small from here on."""
    plt.rcParams["savefig.dpi"] = 50


def save(canvas: Canvas, folder: Path, name: str) -> None:
    """Writes NAME.svg and NAME.png, the same bytes for the same figure, and closes it."""
    # Tight: the layout leaves no room for a legend beside the panels, this makes it.
    tight = {"bbox_inches": "tight", "pad_inches": 0.08}
    canvas.savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": None}, **tight)
    canvas.savefig(folder / f"{name}.png", metadata={"Software": None}, **tight)
    plt.close(canvas)


def name_panel(axes: Axes, text: str) -> None:
    """Puts the panel's title at its left end."""
    axes.set_title(text, loc="left")
