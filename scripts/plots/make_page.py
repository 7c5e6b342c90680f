# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the paper's figures and a page that shows them beside their numbers.

Everything comes from the `girdle` program. The page begins with what came out in three sentences;
then come the plots of the rhythm, then the pictures of the skin. The page appears whole or not at
all: it is made in a folder beside the one asked for, which takes its place at the end. A folder that
an earlier run has made is replaced as a whole.
"""

from __future__ import annotations

import argparse
import html
import shutil
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import abduction
import axial_zero
import elbow_path
import outcome
import reach
import rhythm_maps
import scapular_rhythm
import scapulohumeral_rhythm
import skin_near_ac
import upper_body
import velocity_jumps
from bodies import Body, human_body, implicit_body
from figure import Figure, NumberTable
from girdle_program import Girdle, ProgramError
from style import draw_coarsely

FAILED = 1
REFUSED = 2

PAGE = "index.html"
# By which an earlier page is known as one that may be replaced.
MARK = '<meta name="generator" content="Girdle, scripts/figures">'

STYLE = """
:root { color-scheme: light dark; --line: #c8c8c8; --soft: #5a5a5a; }
@media (prefers-color-scheme: dark) { :root { --line: #4a4a4a; --soft: #a8a8a8; } }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
h2 { margin: 3.5rem 0 0.5rem; font-size: 1.25rem; }
figure { margin: 0; }
/* The figures are black on white in the dark too. */
img { width: 100%; height: auto; background: #fff; border: 1px solid var(--line); border-radius: 4px; }
figcaption { margin: 0.5rem 0 1rem; }
.files { color: var(--soft); font-size: 0.9rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.9rem; font-variant-numeric: tabular-nums; margin: 0 0 1rem; }
summary { margin: 0.3rem 0; }
th, td { text-align: right; padding: 0.15rem 0.7rem; border-bottom: 1px solid var(--line); }
th { font-weight: 600; vertical-align: bottom; }
th:first-child, td:first-child, td.words { text-align: left; }
pre { overflow-x: auto; font-size: 0.85rem; padding: 0.6rem; border: 1px solid var(--line);
      border-radius: 4px; }
.missing { border-left: 4px solid #d55e00; padding: 0.2rem 0.8rem; white-space: pre-wrap; }
"""


def is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return text in ("", "-") or text[:2] in ("> ", "≤ ")
    return True


def table_as_html(table: NumberTable) -> str:
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in table.header)
    rows = ""
    for row in table.rows:
        rows += "<tr>"
        for text in row:
            kind = "" if is_number(text) else ' class="words"'
            rows += f"<td{kind}>{html.escape(text)}</td>"
        rows += "</tr>\n"
    return (
        f"<details><summary>{html.escape(table.caption)}</summary>\n"
        f'<div class="scroll"><table>\n<thead><tr>{cells}</tr></thead>\n<tbody>\n{rows}</tbody>\n'
        "</table></div>\n</details>\n"
    )


def figure_as_html(figure: Figure) -> str:
    text = f'<section id="{figure.name}">\n<h2>{html.escape(figure.title)}</h2>\n'
    name = figure.name
    if figure.missing:
        text += f'<p class="missing">{html.escape(figure.missing)}</p>\n'
        text += f"<p>{html.escape(figure.caption)}</p>\n"
    else:
        text += (
            f'<figure>\n<a href="{name}.svg"><img src="{name}.png" '
            f'alt="{html.escape(figure.alt)}"></a>\n'
            f"<figcaption>{html.escape(figure.caption)}\n"
            f'<span class="files"><a href="{name}.svg">SVG</a> <a href="{name}.png">PNG</a></span>'
            "</figcaption>\n</figure>\n"
        )
    text += "".join(map(table_as_html, figure.tables))
    commands = "\n".join(html.escape(command) for command in figure.commands)
    count = len(figure.commands)
    title = "The command" if count == 1 else f"The {count} commands"
    return text + f"<details><summary>{title}</summary>\n<pre>{commands}</pre></details>\n</section>\n"


def page(figures: list[Figure], version: str, results: list[str], notes: list[str]) -> str:
    contents = "".join(
        f'<li><a href="#{figure.name}">{html.escape(figure.title)}</a></li>\n' for figure in figures
    )
    came_out = "".join(f"<p>{html.escape(sentence)}</p>\n" for sentence in results)
    remarks = "".join(f'<p class="missing">{html.escape(note)}</p>\n' for note in notes)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"{MARK}\n<title>Figures of Girdle</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        f"<h1>Figures of Girdle</h1>\n{came_out}"
        "<p>The pictures and numbers are the output of "
        f"<code>girdle</code> {html.escape(version)}, run in this folder by the commands below each "
        "figure. <code>scripts/figures</code> runs all of them. Figures 11 to 14 are those of Kim, "
        "Park, Jung and Han, <cite>Data-driven shoulder inverse kinematics</cite>, made anew.</p>\n"
        f"{remarks}<ol>\n{contents}</ol>\n{''.join(map(figure_as_html, figures))}</body>\n</html>\n"
    )


def body_figures(girdle: Girdle, body: Body, skin: skin_near_ac.SkinReport, quick: bool) -> list[Figure]:
    say(f"upper body, {body.title}")
    figures = [upper_body.make(girdle, body, skin, quick)]
    for camera, number in abduction.PAPERS_NUMBER.items():
        say(f"Fig. {number}, {body.title}")
        figures.append(abduction.make(girdle, body, camera, quick))
    say(f"Fig. 14, {body.title}")
    figures.append(skin_near_ac.make(girdle, body, skin, quick))
    return figures


# In the page's order.
PLOTS: list[tuple[str, Callable[[Girdle, bool], Figure]]] = [
    ("scapula and clavicle", scapular_rhythm.make),
    ("scapulohumeral rhythm", scapulohumeral_rhythm.make),
    ("maps of published rhythms", rhythm_maps.make_distances),
    ("map of upward rotation", rhythm_maps.make_rotation),
    ("reach", reach.make),
    ("axial zero", axial_zero.make),
    ("Fig. 13", elbow_path.make),
    ("jumps of velocity", velocity_jumps.make),
]


def make_all(girdle: Girdle, body_folder: Path | None, notes: list[str], quick: bool) -> None:
    if quick:
        draw_coarsely()
    version = girdle.run("--version").split()[-1]
    girdle.take_commands()
    makers = [implicit_body]
    if body_folder is not None:
        # The man comes first: he is easier to recognise than the solids.
        makers.insert(0, partial(human_body, folder=body_folder))
    # First: what is wrong with a body shows before anything is drawn.
    bodies = []
    for make_body in makers:
        body = make_body(girdle)
        generation = girdle.take_commands()
        skin = skin_near_ac.verify_skin(girdle, body)
        bodies.append((body, generation, skin, girdle.take_commands()))
    body, _, skin, _ = bodies[0]
    results = outcome.sentences(girdle, body, skin)
    girdle.take_commands()
    figures = []
    for title, make in PLOTS:
        say(title)
        figures.append(make(girdle, quick))
    for body, generation, skin, verification in bodies:
        for figure in body_figures(girdle, body, skin, quick):
            of_the_skin = figure.name.startswith(("upper_body", "figure_14"))
            figure.commands = [
                *generation, *(verification if of_the_skin else []), *figure.commands
            ]  # fmt: skip
            figures.append(figure)
    (girdle.folder / PAGE).write_text(page(figures, version, results, notes))


def say(text: str) -> None:
    print(f"figures: {text}", flush=True)


def may_be_replaced(folder: Path) -> bool:
    """Whether a folder is new, empty, or one that an earlier run has made.

    That one is known by the mark in its page, and is replaced as a whole: with it goes whatever
    somebody else has put there since.
    """
    if not folder.exists():
        return True
    if not folder.is_dir():
        return False
    earlier = folder / PAGE
    return not any(folder.iterdir()) or (earlier.is_file() and MARK in earlier.read_text())


def put_in_place(made: Path, folder: Path) -> None:
    if folder.exists():
        shutil.rmtree(folder)
    made.chmod(0o755)  # a temporary folder is its owner's alone
    made.rename(folder)


def main() -> int:
    parser = argparse.ArgumentParser(description="Makes the paper's figures and their page.")
    parser.add_argument("--program", type=Path, required=True, help="the girdle program")
    parser.add_argument("--out", type=Path, required=True, help="folder to make")
    parser.add_argument("--body", type=Path, help="what scripts/fetch_body has fetched")
    parser.add_argument("--note", action="append", default=[], help="a remark for the page")
    parser.add_argument("--quick", action="store_true", help="coarse grids and small pictures")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    if not may_be_replaced(out):
        print(
            f"figures: {arguments.out} is not a folder of figures. Give another one, or a new name",
            file=sys.stderr,
        )
        return REFUSED
    out.parent.mkdir(parents=True, exist_ok=True)
    # Beside its final place, so that relative paths are right and the last step is a renaming.
    made = Path(tempfile.mkdtemp(prefix=f".{out.name}.", dir=out.parent))
    try:
        girdle = Girdle(arguments.program.resolve(), made)
        make_all(girdle, arguments.body, arguments.note, arguments.quick)
        put_in_place(made, out)
    except ProgramError as error:
        print(f"figures: {error}", file=sys.stderr)
        return FAILED
    finally:
        shutil.rmtree(made, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
