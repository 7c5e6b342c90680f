# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Solved poses have the committed bits in the build that is tested: optimised, or for debugging with
sanitizers."""

from __future__ import annotations

import hashlib
import os
import subprocess
from pathlib import Path

import pytest

COMMITTED = Path(__file__).resolve().parents[1] / "fingerprint.txt"


@pytest.mark.parametrize(("line", "which"), [("poses", "random"), ("sweep", "sweep")])
def test_the_bits_are_the_committed_ones(line: str, which: str) -> None:
    program = Path(os.environ["GIRDLE_BUILD_DIR"]) / "tests" / "pose_bits"
    bits = subprocess.run([program, which, "0"], stdout=subprocess.PIPE, check=True, timeout=300).stdout
    committed = dict(text.split() for text in COMMITTED.read_text().splitlines())
    assert hashlib.sha256(bits).hexdigest() == committed[line]
