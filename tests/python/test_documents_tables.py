# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of the documents that no command prints: verdicts, skin, speed, lines of XML, steps."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import Girdle, RunProgram
from documents import ROOT, Document, documents
from shared_results import SharedResults

MODELS = Document("model/README.md")
SKIN = Document("generator/skin/README.md")
SPEED = Document("tests/benchmarks/README.md")
FUZZERS = Document("tests/fuzz/README.md")

# How the lines of the report that the table of verdicts shows begin, by its columns.
CHIEF_LINES = (
    ("joint constraint", {"AC", "AC at rest"}),
    ("joint constraint", {"AC", "AC at 1 Hz"}),
    ("emergent AC", {"measured AC, rms"}),
    ("tracking moving", {"SC", "AC", "ST", "GH"}),
)
DECIMALS = (3, 3, 2, 2)


def verified_models() -> dict[str, list[str]]:
    rows = re.findall(r"^\| `(shoulder_\w+/scene\w*\.xml)` \| (.*) \|$", MODELS.text, flags=re.MULTILINE)
    return {model: cells.split(" | ") for model, cells in rows}


def test_the_table_of_verdicts_has_every_committed_model() -> None:
    committed = {f"{path.parent.name}/{path.name}" for path in (ROOT / "model").glob("*/scene*")}
    assert verified_models().keys() == committed


@pytest.mark.parametrize("model", verified_models())
def test_a_verdict_is_that_of_the_program(model: str, shared: SharedResults) -> None:
    report = shared.verify(ROOT / "model" / model).answer
    shown = []
    for (group, items), decimals in zip(CHIEF_LINES, DECIMALS, strict=True):
        values = [
            line["value"]
            for line in report["residuals"]
            if line["group"] == group and re.sub(", (right|left)$", "", line["item"]) in items
        ]
        shown.append(f"{max(values):.{decimals}f}" if values else "-")
    assert [*shown, "pass" if report["passed"] else "fail"] == verified_models()[model]


SKIN_LINES = (
    "acromion's skin rises, plane 0",
    "acromion's bone rises, plane 0",
    "area below half, plane 0",
    "area below half, plane 90",
)


def test_the_table_of_the_skin_is_that_of_the_program(shared: SharedResults, girdle: Girdle) -> None:
    shown = re.search(r"\| measured \| `--girdle frozen` .*?\n\|[-|]+\|\n(.*?)\n\n", SKIN.text, re.DOTALL)
    assert shown
    rows = [line.strip("| ").split(" | ")[1:3] for line in shown[1].splitlines()]
    scene = shared.generate("--skin", "implicit").scene
    columns = []
    for word, status in (("measured", 0), ("frozen", 1)):
        finished = girdle("verify", scene, "--json", "--girdle", word)
        assert finished.code == status, finished.message
        lines = json.loads(finished.text)["residuals"]
        values = {line["item"]: line["value"] for line in lines if line["group"] == "skin"}
        columns.append([f"{values[item]:.1f}" for item in SKIN_LINES])
    assert rows == [list(row) for row in zip(*columns, strict=True)]


def test_the_table_of_speed_has_the_rows_of_the_benchmark() -> None:
    """Timings are no test; that the document shows what the benchmark prints is."""
    source = (ROOT / "tests" / "benchmarks" / "speed.cc").read_text(encoding="utf-8")
    shown = SPEED.after("one pose, all three joints")
    rows = [re.split(r"  +", line)[0] for line in shown.splitlines() if line]
    assert len(rows) > 15
    for row in rows:
        # A row may be made of a place, "inside", and what is done there, ", one by one".
        place, comma, done = row.partition(", ")
        in_parts = f'"{place}"' in source and f'"{comma}{done}"' in source
        assert f'"{row}' in source or in_parts, row


def test_the_table_of_fuzzers_has_every_fuzzer() -> None:
    shown = re.findall(r"^\| `(\w+)` \|", FUZZERS.text, flags=re.MULTILINE)
    folder = ROOT / "tests" / "fuzz"
    assert shown == sorted(file.stem.removeprefix("fuzz_") for file in folder.glob("fuzz_*.cc"))


def parts_of(root: ElementTree.Element) -> set[tuple[str, tuple[tuple[str, str], ...]]]:
    """Every element as its name and attributes, numbers rounded as a document shows them."""

    def rounded(value: str) -> str:
        try:
            return " ".join(f"{float(word):.4g}" for word in value.split())
        except ValueError:
            return value

    return {
        (each.tag, tuple(sorted((name, rounded(value)) for name, value in each.items())))
        for each in root.iter()
    }


def blocks_of_xml() -> list[tuple[Document, str]]:
    return [
        (document, block.text)
        for document in documents()
        for block in document.blocks()
        if block.language == "xml"
    ]


@pytest.mark.parametrize(
    ("document", "text"), blocks_of_xml(), ids=[document.name for document, _ in blocks_of_xml()]
)
def test_lines_of_xml_are_those_of_the_model_that_is_generated(
    document: Document, text: str, shared: SharedResults
) -> None:
    model = parts_of(ElementTree.parse(shared.generate().model).getroot())
    shown = parts_of(ElementTree.fromstring(f"<mujoco>{text}</mujoco>"))
    for tag, attributes in shown:
        if attributes:
            alike = any(tag == name and set(attributes) <= set(values) for name, values in model)
            assert alike, f"{document.name}: <{tag} {attributes}>"


# --- Numbers in sentences ------------------------------------------------------------------------


def test_steps_of_the_table_are_those_that_smooth_table_prints(
    run_program: RunProgram, tmp_path: Path
) -> None:
    """The largest second difference before and after, and how far a row has moved."""
    text = Document("data/README.md").text
    table = ROOT / "data" / "ludewig2009.csv"
    printed = run_program("smooth-table", "--in", table, "--out", tmp_path / "smooth.csv")
    values = dict(re.findall(r"^(\S.*? {2,}(?:SC|AC|GH)) +([0-9.]+)", printed, flags=re.MULTILINE))
    by_words = {" ".join(words.split()): float(value) for words, value in values.items()}
    for when, name in (("before", "ludewig2009.csv"), ("after", "ludewig2009_smoothed.csv")):
        row = re.search(rf"^\| `{name}` \| ([0-9.]+) \| ([0-9.]+) \| ([0-9.]+) \|$", text, re.MULTILINE)
        assert row, name
        for joint, shown in zip(("SC", "AC", "GH"), row.groups(), strict=True):
            assert shown == f"{by_words[f'second difference {when} {joint}']:.2f}", (name, joint)
    moved = max(by_words[f"move {joint}"] for joint in ("SC", "AC", "GH"))
    stated = re.search(r"moves no row by more than ([0-9.]+) degrees", text)
    assert stated
    assert moved <= float(stated[1]) < moved + 0.01


FAULTS = Document("tests/README.md")


def test_the_table_of_faults_has_every_file_with_its_cases() -> None:
    shown = dict(re.findall(r"^\| `(\w+)` \| .* \| (\d+) \| .* \|$", FAULTS.text, flags=re.MULTILINE))
    folder = ROOT / "tests" / "python"
    command = [sys.executable, "-m", "pytest", "--collect-only", "-qq", "-p", "no:cacheprovider"]
    files = sorted(str(path) for path in folder.glob("test_faults_*.py"))
    listed = subprocess.run([*command, *files], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    counted = dict(re.findall(r"test_faults_(\w+)\.py: (\d+)$", listed, flags=re.MULTILINE))
    assert shown == counted
