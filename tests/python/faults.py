# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Runs of the program in which something fails on purpose."""

from __future__ import annotations

import resource
import subprocess
from collections.abc import Mapping
from pathlib import Path

from conftest import PROGRAM_TIMEOUT_S

MEBIBYTE = 1 << 20


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
