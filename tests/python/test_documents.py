# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the documents tell a reader to type works, and prints what they show."""

from __future__ import annotations

import difflib
import os
import shutil
import sys
from pathlib import Path

import pytest
from documents import (
    ROOT,
    STAND_INS,
    Document,
    documents,
    files,
    first_difference,
    first_unknown,
    type_document,
    typed_line,
)
from shared_results import SharedResults

WITH_BLOCKS = [document for document in documents() if any(document.blocks())]


@pytest.fixture
def checkout(tmp_path: Path, program: Path, shared: SharedResults) -> Path:
    """A copy of the checkout after scripts/run, whose build is the one that is tested."""
    folder = tmp_path / "girdle"
    for name in files():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, folder / name)
    build = folder / "build"
    build.mkdir()
    (build / "release").symlink_to(program.parent)
    for other in ("body", "engine"):
        (build / other).symlink_to(ROOT / "build" / other)
    shutil.copytree(shared.generate("--skin", "implicit").folder, build / "model")
    return folder


@pytest.fixture
def environment(checkout: Path, program: Path) -> dict[str, str]:
    """The program, this Python and the build's own CMake come first on the PATH."""
    first = [program.parent, Path(sys.executable).parent, Path(os.environ["GIRDLE_CMAKE"]).parent]
    return os.environ | {"PATH": os.pathsep.join([*map(str, first), os.environ["PATH"]])}


@pytest.mark.parametrize("document", WITH_BLOCKS, ids=lambda document: document.name)
def test_a_document_can_be_typed_from_top_to_bottom(
    document: Document, checkout: Path, environment: dict[str, str]
) -> None:
    """Each line finds what the lines before it left, and prints what the document shows."""
    printed = type_document(document, checkout, environment)
    blocks = list(document.blocks())
    for number, block in enumerate(blocks):
        if block.language:
            continue
        before = blocks[number - 1]
        lines = [typed_line(line) for line in before.text.splitlines()]
        if before.language == "sh" and set(lines) == {":"}:
            continue  # held against the source, in test_documents_tables.py
        compare = first_unknown if "girdle doctor\n" in before.text else first_difference
        excerpt = {"excerpt": True} if "scripts/run" in before.text else {}
        wrong = compare(block.text, printed[number - 1], **excerpt)
        near = difflib.get_close_matches(wrong, printed[number - 1].splitlines(), n=3)
        assert not wrong, "\n".join([f"{document.name}:{block.line}: shows", wrong, "for", *near])
    for name in files():
        if name.startswith(("data/", "model/")):
            same = (checkout / name).read_bytes() == (ROOT / name).read_bytes()
            assert same, f"{document.name} changes {name}"


def test_every_block_has_a_language_that_a_test_knows() -> None:
    for document in documents():
        before = ""
        fences = sum(line.startswith("```") for line in document.text.splitlines())
        assert fences == 2 * sum(
            block.text.endswith("\n") and document.text.splitlines()[block.line - 1].startswith("```")
            for block in document.blocks()
        ), f"{document.name}: a fence that does not begin its line, or is not closed"
        for block in document.blocks():
            place = f"{document.name}:{block.line}"
            assert block.language in ("sh", "python", "cpp", "xml", ""), place
            if not block.language:
                assert before in ("sh", "python"), f"{place}: no command before this output"
            before = block.language


def test_every_stand_in_is_for_a_line_of_a_document() -> None:
    typed = {
        line.split(" # ")[0].rstrip()
        for document in documents()
        for block in document.blocks()
        if block.language == "sh"
        for line in block.text.splitlines()
    }
    assert set(STAND_INS) <= typed, sorted(set(STAND_INS) - typed)


# --- The comparison itself can fail --------------------------------------------------------------

PRINTED = """model  a.xml

item   value      unit
first  2.37       deg
second  1.2e-13   mm
third  5          mm

kind           worst  required  checked  at elevation/plane
closure  1.5e-09 deg  <= 1e-06   2        flexion 0/90
range       64.8 deg  no limit   0        grid 62.5/-95

residual  of        value  tolerance  unit  result  where
tracking  SC        0.639          3  deg   pass    flexion, elevation 116.7, plane 90
closure   plane  1.75e-09      1e-06  deg   pass    flexion, elevation 0, plane 90
"""


@pytest.mark.parametrize(
    "shown",
    [
        "model  a.xml\nitem   value      unit",
        "first  2.37   deg\n...\nthird   5   mm",
        "...\nitem   value   unit\n...",
        "first  2.37       deg\nsecond  3.4e-14   mm",
        "closure  0 deg  <= 1e-06   2        grid 1/2\nrange  64.8 deg  no limit  0  grid 62.5/-95",
        "closure   plane  0      1e-06  deg   pass    abduction, elevation 5, plane 0",
    ],
    ids=[
        *("from the start", "with a line left out", "from the middle", "with another rounding"),
        *("a summary with another rounding", "a report with another rounding"),
    ],
)
def test_an_excerpt_of_what_is_printed_is_found(shown: str) -> None:
    assert first_difference(shown, PRINTED, excerpt=True) == ""


@pytest.mark.parametrize(
    ("shown", "wrong"),
    [
        ("first  2.38       deg", "first  2.38       deg"),
        ("first  2.37       deg\nthird  5          mm", "third  5          mm"),
        ("third  5          mm\n...\nfirst  2.37       deg", "first  2.37       deg"),
        ("model  a.xml\nfourth 4          mm", "fourth 4          mm"),
        ("range  64.8 deg  no limit  0  grid 1/2", "range  64.8 deg  no limit  0  grid 1/2"),
        ("closure  1e-05 deg  <= 1e-06  2  flexion 0/90", "closure  1e-05 deg  <= 1e-06  2  flexion 0/90"),
        ("tracking  SC  0.639  3  deg  pass  abduction", "tracking  SC  0.639  3  deg  pass  abduction"),
    ],
    ids=[
        *("another value", "a line left out in silence", "another order", "a line of its own"),
        *("another place in the summary", "a value that is not rounding", "another place"),
    ],
)
def test_what_is_not_printed_so_is_named(shown: str, wrong: str) -> None:
    assert first_difference(shown, PRINTED, excerpt=True) == wrong


@pytest.mark.parametrize(
    ("shown", "wrong"),
    [
        ("a\nb\nc", ""),
        ("a\n...", ""),
        ("...\nb\n...", ""),
        ("...\nc", ""),
        ("b\nc", "a"),
        ("a\nb", "c"),
        ("a\n...\nb", "c"),
        ("b\n...", "a"),
    ],
)
def test_a_line_that_is_printed_before_or_after_is_shown_or_left_out_in_sight(shown: str, wrong: str) -> None:
    assert first_difference(shown, "a\nb\nc\n") == wrong


def test_a_document_whose_command_fails_is_named_with_the_command(
    tmp_path: Path, checkout: Path, environment: dict[str, str]
) -> None:
    failing = tmp_path / "failing.md"
    failing.write_text("```sh\necho before\ngirdle solve --elevation none # comment\n```\n", encoding="utf-8")
    with pytest.raises(AssertionError, match="stopped at: girdle solve --elevation none"):
        type_document(Document(str(failing)), checkout, environment)


def test_a_line_that_ends_otherwise_than_its_comment_says_fails(
    tmp_path: Path, checkout: Path, environment: dict[str, str]
) -> None:
    wrong = tmp_path / "wrong.md"
    wrong.write_text("```sh\ngirdle --version # exit status 1\n```\n", encoding="utf-8")
    with pytest.raises(AssertionError, match="stopped at"):
        type_document(Document(str(wrong)), checkout, environment)
