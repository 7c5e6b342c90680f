# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The committed models are what the program emits today, byte for byte."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

COMMITTED = Path(__file__).resolve().parents[2] / "model" / "shoulder_right"


@pytest.mark.parametrize("name", sorted(path.name for path in COMMITTED.glob("*.xml")))
def test_a_committed_model_is_regenerated_byte_for_byte(
    name: str, program: Path, tmp_path: Path
) -> None:
    subprocess.run([program, "generate", "--out", tmp_path], check=True, capture_output=True)
    assert (tmp_path / name).read_bytes() == (COMMITTED / name).read_bytes()


def test_every_emitted_file_is_committed(program: Path, tmp_path: Path) -> None:
    subprocess.run([program, "generate", "--out", tmp_path], check=True, capture_output=True)
    emitted = {path.name for path in tmp_path.iterdir()}
    assert emitted
    assert emitted == {path.name for path in COMMITTED.glob("*.xml")}
