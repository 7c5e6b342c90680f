# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Every package that a script fetches is pinned, and checked against a hash."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
REQUIREMENTS = SOURCE / "scripts" / "requirements"
VERSIONS = "tested_engines.txt"  # versions of engines.txt, which has their hashes
PINNED = re.compile(r"[A-Za-z0-9_.-]+==[0-9][0-9A-Za-z.]*( --hash=sha256:[0-9a-f]{64})+")
# The scripts that run pip, each with the times that it does.
RUNS = {"setup": 4, "fetch_engine": 1, "fetch_body": 1}


@pytest.mark.parametrize("path", sorted(REQUIREMENTS.glob("*.txt")), ids=lambda path: path.name)
def test_every_package_is_pinned_with_hashes(path: Path) -> None:
    joined = re.sub(r" *\\\n *", " ", path.read_text())
    lines = [line for line in joined.splitlines() if line and not line.startswith("#")]
    assert lines
    if path.name == VERSIONS:
        pinned = re.sub(r"\\\n", "", (REQUIREMENTS / "engines.txt").read_text())
        assert all(f"=={version} " in pinned for version in lines)
        return
    for line in lines:
        assert PINNED.fullmatch(line), line


def test_every_package_of_node_is_pinned_with_a_hash() -> None:
    lock = json.loads((REQUIREMENTS / "node" / "package-lock.json").read_text())
    packages = {name: package for name, package in lock["packages"].items() if name}
    assert packages
    for name, package in packages.items():
        assert package["integrity"].startswith("sha512-"), name


def test_every_run_of_pip_requires_hashes() -> None:
    seen = {}
    for path in [*SOURCE.glob("scripts/*"), *SOURCE.glob(".ci/*")]:
        if not path.is_file():
            continue
        text = re.sub(r" *\\\n *", " ", path.read_text())
        runs = re.findall(r"-m pip (?:install|download) --quiet.*", text)
        for run in runs:
            assert "--require-hashes" in run, f"{path.name}: {run}"
        if runs:
            seen[path.name] = len(runs)
    assert seen == RUNS
