# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The program on a terminal, as a person sees it."""

from __future__ import annotations

import fcntl
import os
import pty
import struct
import subprocess
import termios
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

from conftest import PROGRAM_TIMEOUT_S

ROWS = 50


@dataclass(frozen=True)
class Seen:
    """One run on a terminal, and all that came there."""

    code: int
    written: str

    @property
    def lines(self) -> list[str]:
        """What stands on the screen in the end: a carriage return goes back to overwrite."""
        lines = []
        for line in self.written.replace("\r\n", "\n").split("\n"):
            screen = ""
            for part in line.split("\r"):
                screen = part + screen[len(part) :]
            lines.append(screen.rstrip())
        return lines


def run_on_terminal(
    command: list[str],
    folder: Path,
    *,
    output: Path | None = None,
    columns: int | None = None,
    variables: dict[str, str] | None = None,
    messages: bool = True,
) -> Seen:
    """Runs a command with its standard output, or else its standard error, on a terminal.

    Standard output goes to `output` where that is given. Standard error goes to the terminal, or
    with `messages` false nowhere. A terminal without `columns` does not say how wide it is.
    """
    terminal, program_side = pty.openpty()
    if columns:
        fcntl.ioctl(program_side, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, columns, 0, 0))
    # What whoever runs the tests has set is none of theirs.
    environment = {name: os.environ[name] for name in os.environ if name not in ("NO_COLOR", "TERM")}
    with output.open("wb") if output else nullcontext(program_side) as standard_output:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=standard_output,
            stderr=program_side if messages else subprocess.DEVNULL,
            cwd=folder,
            env={**environment, **(variables or {})},
        )
    os.close(program_side)
    parts = []
    while True:
        try:
            part = os.read(terminal, 1 << 16)
        except OSError:  # how a terminal ends when nobody is left on the other side
            break
        if not part:
            break
        parts.append(part)
    os.close(terminal)
    return Seen(process.wait(PROGRAM_TIMEOUT_S), b"".join(parts).decode())
