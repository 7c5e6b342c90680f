# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""In a locale that writes 0,5 for a half, the program reads and writes the bytes of any other."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import SCENE, contents, with_scene
from reference_rhythm import DATABASE

COMMA_LOCALES = ("de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8")
WORKS = {
    "solve": ("solve", "--elevation", "0:150:2.5", "--plane", "0.5", "--out", "a.csv"),
    "a file": ("solve", "--in", "poses.csv", "--out", "a.csv"),
    "generate": ("generate", "--stature", "1.85", "--out", "model"),
    "simulate": ("simulate", SCENE, "--elevation", "15.5:16", "--seconds", "0.05", "--out", "a.csv"),
    "render": ("render", SCENE, "--elevation", "90.5", "--out", "a.png"),
    "verify": ("verify", SCENE, "--json"),
    "compare": ("compare", "--out", "a.csv"),
    "smooth-table": ("smooth-table", "--in", str(DATABASE), "--out", "a.csv"),
    "fit-thorax": ("fit-thorax", "--out", "a.csv"),
}


@pytest.fixture(scope="session")
def comma_locale(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Variables that choose such a locale: an installed one, or one that is made here."""
    listed = subprocess.run(["locale", "-a"], capture_output=True, text=True, check=False).stdout.split()
    for name in COMMA_LOCALES:
        if name in listed:
            return {"LC_ALL": name}
    folder = tmp_path_factory.mktemp("locales")
    try:
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], check=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("this machine has no locale with a comma, nor the package `locales` to make one of")
    return {"LC_ALL": "de_DE.UTF-8", "LOCPATH": str(folder)}


@pytest.mark.parametrize("work", WORKS)
def test_a_comma_of_the_locale_changes_nothing(
    program: Path, generated: Path, tmp_path: Path, comma_locale: dict[str, str], work: str
) -> None:
    seen = []
    for number, locale in enumerate(({"LC_ALL": "C"}, comma_locale)):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "poses.csv").write_text("elevation_deg,plane_deg\n30.5,0.25\n90.125,1e1\n")
        result = subprocess.run(
            [program, *with_scene(WORKS[work], generated)],
            cwd=folder,
            env={**os.environ, **locale},
            capture_output=True,
            check=False,
        )
        assert result.returncode == 0, result.stderr
        seen.append((result.stdout, result.stderr, contents(folder)))
    assert seen[0] == seen[1]
