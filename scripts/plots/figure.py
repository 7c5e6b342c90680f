# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What a figure is on the page: pictures, the numbers beside them, and where both come from."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class NumberTable:
    """Numbers beside a figure, as text, folded. The first column says what a row is of."""

    caption: str
    header: list[str]
    rows: list[list[str]]


@dataclass
class Figure:
    """One section of the page."""

    name: str  # of its files, NAME.svg and NAME.png
    title: str
    caption: str
    alt: str  # what the picture shows, for those who do not see it
    tables: list[NumberTable] = field(default_factory=list)
    commands: list[str] = field(default_factory=list)
    missing: str = ""  # why there is no picture, if there is none


def rounded(value: float, decimals: int) -> str:
    """A number for a table, with a minus that is one and without one before zero."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0:
        text = text.lstrip("-")
    return text


def significant(value: float, digits: int = 2) -> str:
    """A number of unknown size for a table."""
    return f"{value:.{digits}g}"
