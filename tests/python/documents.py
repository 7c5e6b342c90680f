# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The documents of the checkout: what a reader types from them, and what they show.

A document is every file *.md that git lists. Its fenced blocks mean, by their language:

  sh       lines that the reader types
  python   a program that the reader saves and runs
  cpp      a program that the reader saves under the name in its first line, "// NAME.cc"
  xml      lines of a model
  (none)   what the block of sh or python before it prints; "..." leaves lines out

A row of a table whose first cell is a command of girdle is typed as well. A reader types all of a
document from top to bottom, in one shell, in the top folder of the checkout, after scripts/run and
with the program on the PATH. A line ends with exit status 0, or with the one that its comment
gives: "# exit status 1".
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = ("sh", "python", "cpp", "xml", "")

# What scripts/run does once it has built.
AFTER_THE_BUILD = """(started_in=$PWD; eval "$(sed -n '/^build.release.girdle generate/,$p' scripts/run)")"""

# Lines that build, download or take minutes, and what a test types in their place.
STAND_INS = {
    "scripts/run": AFTER_THE_BUILD,
    "scripts/test": ":",
    "scripts/test -R faults": ":",
    "scripts/test -R solve": ":",
    "scripts/lint --fix": ":",
    "scripts/setup --python": ":",
    "scripts/engines": ":",
    "scripts/fetch_body": ":",
    "scripts/figures --quick": ":",
    "scripts/fuzz --seconds 10": ":",
    "scripts/fuzz --seconds 600 poses motion": ":",
    "python3 -m venv .venv && . .venv/bin/activate": ":",
    "pip install mujoco": ":",
    "python3 -m venv .myo && .myo/bin/pip install myo-sim==0.2.4 mujoco==3.17.0": ":",
    "build/release/tests/speed": ":",
}
# Python that needs a screen.
NOT_RUN = ("launch_passive",)
# Python that runs in the environment with the packages of other projects.
WITH_PEERS = ("myo_sim",)
PEERS = (ROOT / "build" / "peers", ROOT / "build" / "engine" / "mujoco-3.17.0")


def files() -> list[str]:
    """All files of the checkout, by their paths in it."""
    listed = subprocess.run(
        ["git", "ls-files", "-co", "-z", "--exclude-standard", "--deduplicate"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    return sorted(name for name in listed.split("\0") if name and (ROOT / name).is_file())


@dataclass(frozen=True)
class Block:
    """A fenced block, or the command in a row of a table, which counts as sh."""

    language: str
    text: str
    line: int


# A fenced block or a row of a table, from the start of its line.
ITEM = re.compile(r"^```(\w*)\n(.*?)^```$|^\| `(girdle [^`]*)` \|", re.DOTALL | re.MULTILINE)


@dataclass(frozen=True)
class Document:
    name: str

    @property
    def path(self) -> Path:
        return ROOT / self.name

    @property
    def text(self) -> str:
        return self.path.read_text(encoding="utf-8")

    @property
    def prose(self) -> str:
        """The text without its fenced blocks."""
        return re.sub(r"^```.*?^```$", "", self.text, flags=re.DOTALL | re.MULTILINE)

    def blocks(self) -> Iterator[Block]:
        text = self.text
        for found in ITEM.finditer(text):
            line = text.count("\n", 0, found.start()) + 1
            if found[3]:
                yield Block("sh", found[3].replace("\\|", "|") + "\n", line)
            else:
                yield Block(found[1], found[2], line)

    def block(self, language: str, word: str) -> str:
        """The text of the one block of this language that has this word."""
        (text,) = (each.text for each in self.blocks() if each.language == language and word in each.text)
        return text

    def after(self, start: str) -> str:
        """The text of the one block of output that begins so."""
        (text,) = (each.text for each in self.blocks() if not each.language and each.text.startswith(start))
        return text


def documents() -> list[Document]:
    return [Document(name) for name in files() if name.endswith(".md")]


# --- What is typed -------------------------------------------------------------------------------


def typed_line(line: str) -> str:
    """A line of sh as a test types it."""
    command = re.sub(r" +# .*", "", line)
    if command in STAND_INS:
        return STAND_INS[command]
    status = re.search(r" # exit status (\d)", line)
    if status:
        return f'{command} && got=0 || got=$?; [ "$got" = {status[1]} ]'
    return line


def typed_python(text: str, name: str) -> str:
    if any(word in text for word in NOT_RUN):
        compile(text, name, "exec")
        return ":"
    run = f"{shlex.quote(sys.executable)} {name}"
    if any(word in text for word in WITH_PEERS):
        run = f"PYTHONPATH={shlex.quote(':'.join(map(str, PEERS)))} {run}"
    return run


def end_of(number: int) -> str:
    return f"--- end of block {number} ---"


def type_document(document: Document, folder: Path, environment: Mapping[str, str]) -> dict[int, str]:
    """What each block of sh and python printed, by its number; fails where one fails."""
    script = ["exec 2>&1", """trap 'echo "stopped at: $BASH_COMMAND"' ERR"""]
    for number, block in enumerate(document.blocks()):
        if block.language == "sh":
            script += map(typed_line, block.text.splitlines())
        elif block.language == "python":
            name = f"block{number}.py"
            (folder / name).write_text(block.text, encoding="utf-8")
            script.append(typed_python(block.text, name))
        elif block.language == "cpp":
            (folder / block.text.split()[1]).write_text(block.text, encoding="utf-8")
        script.append(f"echo; echo '{end_of(number)}'")
    finished = subprocess.run(
        ["bash", "-ec", "\n".join(script)],
        cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=280,
    )  # fmt: skip
    assert finished.returncode == 0, f"{document.name}\n{finished.stdout[-4000:]}{finished.stderr}"
    printed: dict[int, str] = {}
    rest = finished.stdout
    for number, _ in enumerate(document.blocks()):
        printed[number], rest = rest.split(end_of(number), 1)
    return printed


# --- What is shown -------------------------------------------------------------------------------

LEFT_OUT = "..."
# What rounding makes of zero: far below every tolerance but those of exact equality.
TINY = re.compile(r"-?([0-9.]+e-(?:0[89]|1[0-9])|0|0\.0+)( \S.*)?")
SINGLE = re.compile(TINY.pattern + r"|-?0\.000\d+( \S.*)?")
RESULTS = ("pass", "FAIL", "stated", "follows")


def without_rounding(line: str) -> tuple[str, ...]:
    """Columns of a line without those that rounding makes: a tiny value, and where it is largest."""
    columns = re.split(r" {2,}", line.strip())
    # Vertices of skin have single precision.
    of_zero = SINGLE if columns[0] == "skin" else TINY
    tiny = [of_zero.fullmatch(column) is not None for column in columns]
    kept = ["tiny" if is_tiny else column for column, is_tiny in zip(columns, tiny, strict=True)]
    in_report = len(kept) in (6, 7) and kept[5:6] and kept[5] in RESULTS and tiny[2]
    in_summary = len(kept) == 5 and re.match(r"<= |> |no limit", kept[2]) and tiny[1]
    if in_report:
        return tuple(kept[:6])
    return tuple(kept[:4] if in_summary else kept)


def of_any_machine(line: str) -> tuple[str, ...]:
    """Words of a line without the paths and numbers of one machine."""
    if line.startswith("  found by "):
        return ("found", "by")
    return tuple(re.sub(r"\d+", "N", re.sub(r"[^\s\"(]*/[^\s\")]*", "PATH", line)).split())


def lines_of(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.strip()]


def first_difference(shown: str, printed: str, excerpt: bool = False) -> str:
    """The first line that was shown and not printed there, or printed and not shown; empty if none.

    The lines between two "..." stand together in what was printed; the parts are in its order. What
    does not begin or end with "..." begins or ends what was printed, unless it is an excerpt.
    """
    lines = [without_rounding(line) for line in lines_of(printed)]
    parts = [lines_of(part) for part in re.split(rf"^{re.escape(LEFT_OUT)}$", shown, flags=re.MULTILINE)]
    if not excerpt:
        for end, shown_lines in ((0, parts[0]), (-1, parts[-1])):
            if shown_lines and lines and without_rounding(shown_lines[end]) != lines[end]:
                return lines_of(printed)[end]
    start = 0
    for wanted in parts:
        if not wanted:
            continue
        keys = [without_rounding(line) for line in wanted]
        reached = 0
        for place in range(start, len(lines)):
            length = 0
            while length < len(keys) and lines[place + length : place + length + 1] == [keys[length]]:
                length += 1
            reached = max(reached, length)
            if length == len(keys):
                start = place + length
                break
        else:
            return wanted[reached]
    return ""


def first_unknown(shown: str, printed: str) -> str:
    """The first shown line that no line of this machine resembles."""
    known = {of_any_machine(line) for line in lines_of(printed)}
    for line in lines_of(shown):
        if line != LEFT_OUT and of_any_machine(line) not in known:
            return line
    return ""
