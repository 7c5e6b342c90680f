# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""A reader finds the way: links lead somewhere, the README is short, words are those of today."""

from __future__ import annotations

import functools
import re

import pytest
from conftest import RunProgram
from documents import ROOT, Document, documents

LARGEST_README_BYTES = 10_000

ALL = documents()
# What has changed is told in the words of its day.
OF_TODAY = [document for document in ALL if not document.name.endswith("CHANGELOG.md")]


def name_of(document: Document) -> str:
    return document.name


def anchors(document: Document) -> set[str]:
    """The anchors of a document's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.+)$", document.prose, flags=re.MULTILINE)
    plain = (re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading).lower() for heading in headings)
    return {re.sub(r"[^\w\- ]", "", heading).replace(" ", "-") for heading in plain}


@pytest.mark.parametrize("document", ALL, ids=name_of)
def test_every_link_leads_to_a_file_or_a_heading(document: Document) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", document.prose):
        if re.match(r"https?://", target):
            continue
        path, _, anchor = target.partition("#")
        file = (document.path.parent / path).resolve() if path else document.path
        assert file.exists(), f"{document.name}: {target}"
        if anchor:
            assert file.suffix == ".md", f"{document.name}: {target}"
            assert anchor in anchors(Document(str(file.relative_to(ROOT)))), f"{document.name}: {target}"


def test_every_document_is_found_from_the_readme() -> None:
    found: set[str] = set()
    waiting = ["README.md"]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        found.add(name)
        document = Document(name)
        for target in re.findall(r"\]\(([^)\s#]+\.md)", document.prose):
            if not re.match(r"https?://", target):
                waiting.append(str((document.path.parent / target).resolve().relative_to(ROOT)))
    assert {document.name for document in ALL} <= found


def test_the_readme_is_short() -> None:
    assert len((ROOT / "README.md").read_bytes()) <= LARGEST_README_BYTES


def test_nothing_is_left_to_be_filled_in() -> None:
    for document in OF_TODAY:
        assert "PLACEHOLDER" not in document.text, document.name


@pytest.fixture(scope="module")
def options(run_program: RunProgram) -> dict[str, set[str]]:
    """The options of each verb, as its help has them."""

    @functools.cache
    def words(*arguments: str) -> set[str]:
        return set(
            re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]*)", run_program(*arguments, "--help"), re.MULTILINE)
        )

    verbs = re.findall(r"^  ([a-z][a-z-]*)  ", run_program("--help"), flags=re.MULTILINE)
    return {verb: words(verb) for verb in verbs}


@pytest.mark.parametrize("document", OF_TODAY, ids=name_of)
def test_a_command_in_a_sentence_has_words_that_the_program_knows(
    document: Document, options: dict[str, set[str]]
) -> None:
    for command in re.findall(r"`girdle ([a-z][^`]*)`", document.prose):
        verb = command.split()[0]
        if verb == "help":
            continue
        assert verb in options, f"{document.name}: girdle {command}"
        unknown = set(re.findall(r"--[a-z][a-z-]*", command)) - options[verb]
        assert not unknown, f"{document.name}: girdle {command}"


# Options of other programs that documents name by themselves.
OF_OTHERS = {"--fix", "--quick", "--python", "--help"}


@pytest.mark.parametrize("document", OF_TODAY, ids=name_of)
def test_an_option_in_a_sentence_is_one_of_the_program(
    document: Document, options: dict[str, set[str]]
) -> None:
    known = set().union(*options.values()) | OF_OTHERS
    named = set(re.findall(r"`(--[a-z][a-z-]*)", document.prose))
    assert named <= known, f"{document.name}: {sorted(named - known)}"


def test_the_table_of_verbs_shows_every_verb(options: dict[str, set[str]]) -> None:
    table = Document("generator/commands/README.md").prose
    shown = set(re.findall(r"^\| `girdle ([a-z-]+)", table, flags=re.MULTILINE))
    assert shown == set(options)
