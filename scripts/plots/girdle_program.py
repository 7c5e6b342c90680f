# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The `girdle` program as the figures use it: all their numbers and pictures come from it."""

from __future__ import annotations

import csv
import io
import json
import os
import shlex
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]

# The status of `girdle verify` when a residual is above its tolerance; its report is whole.
ABOVE_TOLERANCE = 1


class ProgramError(Exception):
    """The program failed. The text is its message, with the command that it was given."""


class NoPictures(ProgramError):
    """The program cannot draw on this machine; everything else of it works."""


class Rows:
    """A CSV of the program, by columns."""

    def __init__(self, text: str) -> None:
        self._rows = list(csv.DictReader(io.StringIO(text)))

    def words(self, column: str) -> list[str]:
        return [row[column] for row in self._rows]

    def numbers(self, column: str) -> Numbers:
        """A column; where the program says nothing it is not a number."""
        return np.array([float(row[column] or "nan") for row in self._rows])

    def only(self, column: str, word: str) -> Rows:
        """The rows that have this word in this column."""
        kept = Rows("")
        kept._rows = [row for row in self._rows if row[column] == word]
        return kept

    def map(self, column: str) -> tuple[Numbers, Numbers, Numbers]:
        """Planes, elevations, and the column at [elevation, plane], not a number where no row is."""
        planes_deg, plane_index = np.unique(self.numbers("plane_deg"), return_inverse=True)
        elevations_deg, elevation_index = np.unique(self.numbers("elevation_deg"), return_inverse=True)
        values = np.full((len(elevations_deg), len(planes_deg)), np.nan)
        values[elevation_index, plane_index] = self.numbers(column)
        return planes_deg, elevations_deg, values


class Girdle:
    """Runs the program in the folder of the figures and remembers every command.

    The folder of the program is none of the reader's business: commands are remembered as they
    would be typed in the folder of the figures, with the program on the PATH.
    """

    def __init__(self, program: Path, folder: Path) -> None:
        self.program = program
        self.folder = folder
        self._commands: list[str] = []

    def take_commands(self) -> list[str]:
        """The commands since the last call."""
        commands, self._commands = self._commands, []
        return commands

    def run(self, *words: str, may_exceed: bool = False) -> str:
        """What the program prints. With `may_exceed`, residuals above their tolerances are fine."""
        command = shlex.join(["girdle", *words])
        self._commands.append(command)
        try:
            finished = subprocess.run(
                [str(self.program), *words],
                cwd=self.folder,
                # Progress is for terminals, numbers are without a locale.
                env={**os.environ, "LC_ALL": "C"},
                capture_output=True,
                text=True,
                check=False,
            )
        except OSError as error:
            raise ProgramError(f"{self.program}: {error.strerror}. Build it first") from error
        if finished.returncode == 0 or (may_exceed and finished.returncode == ABOVE_TOLERANCE):
            return finished.stdout
        message = finished.stderr.strip() or f"exit status {finished.returncode}, no message"
        kind = NoPictures if "girdle: cannot draw pictures: " in message else ProgramError
        raise kind(f"{message}\n  from: {command}")

    def rows(self, *words: str) -> Rows:
        return Rows(self.run(*words))

    def answer(self, *words: str, may_exceed: bool = False) -> Any:
        """What the program prints as JSON."""
        return json.loads(self.run(*words, "--json", may_exceed=may_exceed))
