# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Runs of the program in which something fails on purpose."""

from __future__ import annotations

import resource
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest
from conftest import PROGRAM_TIMEOUT_S, SCENE, with_scene
from reference_rhythm import DATABASE

MEBIBYTE = 1 << 20

# Each verb that writes a file, up to the file's name.
WRITERS = {
    "solve": ("solve", "--elevation", "0:150:1", "--plane", "0", "--out"),
    "simulate": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out"),
    "simulate controls": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-controls"),
    "simulate picture": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-picture"),
    "simulate video": ("simulate", SCENE, "--elevation", "15:16", "--seconds", "0.1", "--out-video"),
    "render": ("render", SCENE, "--out"),
    "compare": ("compare", "--out"),
    "smooth-table": ("smooth-table", "--in", str(DATABASE), "--out"),
    "fit-thorax": ("fit-thorax", "--out"),
}
SUFFIXES = {"simulate picture": ".png", "simulate video": ".mp4", "render": ".png"}
every_writer = pytest.mark.parametrize("writer", WRITERS)


def named(writer: str, stem: str = "out") -> str:
    """The name of a file that the verb writes, with the suffix that it asks for."""
    return stem + SUFFIXES.get(writer, ".csv")


def command(writer: str, name: str, generated: Path) -> list[str]:
    """The words after `girdle`."""
    words = with_scene(WRITERS[writer], generated)
    # A name that begins with a dash belongs to its option by the sign between them.
    return [*words[:-1], f"{words[-1]}={name}"]


def run_limited(
    program: Path, *words: str | Path, folder: Path, limits: Mapping[int, int]
) -> subprocess.CompletedProcess[str]:
    """Runs the program in a folder with limits of the system, such as {resource.RLIMIT_DATA: 2**30}."""

    def limit() -> None:
        for kind, most in limits.items():
            resource.setrlimit(kind, (most, most))

    return subprocess.run(
        [program, *words],
        cwd=folder,
        preexec_fn=limit,
        capture_output=True,
        text=True,
        timeout=PROGRAM_TIMEOUT_S,
        check=False,
    )


def names_below(folder: Path) -> set[str]:
    """The names of all files and folders below a folder."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}
