# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the program under test makes of given words, made once for all tests of a build.

Every file of tests runs in a process of its own, and many want the same models. They find them in
a folder of the build that is named by the bytes of what makes them: a program that changed makes
its own.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

FOLDER = "shared_results"


def digest_of(parts: Iterable[bytes]) -> str:
    """A name for these bytes; where one part ends and the next begins counts."""
    digest = hashlib.sha256()
    for part in parts:
        digest.update(hashlib.sha256(part).digest())
    return digest.hexdigest()[:16]


def bytes_of(word: str) -> Iterable[bytes]:
    """What a word of a command line says: itself, and all of the file or folder that it names."""
    yield word.encode()
    named = Path(word.partition("=")[2] if word.startswith("--") else word)
    if named.is_file():
        yield named.read_bytes()
    elif named.name and named.is_dir():
        for path in sorted(path for path in named.rglob("*") if path.is_file()):
            yield str(path.relative_to(named)).encode()
            yield path.read_bytes()


@dataclass(frozen=True)
class Made:
    """What `girdle generate` has made. No test writes to it."""

    folder: Path
    scene: Path
    model: Path


@dataclass(frozen=True)
class Verified:
    """What `girdle verify --json` has said of a model that nobody changes."""

    code: int
    message: str
    text: str

    @property
    def answer(self) -> dict[str, Any]:
        answer: dict[str, Any] = json.loads(self.text)
        return answer


class SharedResults:
    """Runs the program, unless a process of tests has done so with the same words."""

    def __init__(self, program: Path, build: Path, timeout_s: float) -> None:
        self._program = program
        self._timeout_s = timeout_s
        beside = [program.parent / name for name in ("libgirdle_rhythm.so", "libgirdle_simulation.so")]
        makers = [program, *(path for path in beside if path.is_file())]
        self._folder = build / FOLDER / digest_of(path.read_bytes() for path in makers)
        self._folder.mkdir(parents=True, exist_ok=True)
        for other in self._folder.parent.iterdir():
            if other != self._folder:
                shutil.rmtree(other, ignore_errors=True)

    def generate(self, *words: str | Path) -> Made:
        """A model by the words that it is made with."""
        command = ["generate", *map(str, words)]
        name = digest_of(part for word in command for part in bytes_of(word))

        def make(folder: Path) -> None:
            finished = self._run(*command, "--out", folder)
            assert finished.returncode == 0, finished.stderr
            assert finished.stderr == "", command

        folder = self._once(name, make)
        (scene,) = folder.glob("scene*.xml")
        (model,) = folder.glob("shoulder_*.xml")
        return Made(folder, scene, model)

    def verify(self, scene: Path, *words: str) -> Verified:
        """The report of a scene whose folder nobody changes while tests run."""
        files = sorted(path for path in scene.parent.iterdir() if path.suffix in (".xml", ".skn"))
        command = ["verify", str(scene), "--json", *words]
        parts = [part for word in command for part in bytes_of(word)]
        parts += [path.read_bytes() for path in files]

        def make(folder: Path) -> None:
            finished = self._run(*command)
            # A report was printed; a crash may not come again.
            assert finished.returncode in (0, 1), (finished.returncode, finished.stderr)
            said = [finished.returncode, finished.stderr, finished.stdout]
            (folder / "said.json").write_text(json.dumps(said))

        folder = self._once(digest_of(parts), make)
        return Verified(*json.loads((folder / "said.json").read_text()))

    def _run(self, *words: str | Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [self._program, *words],
            capture_output=True,
            text=True,
            timeout=self._timeout_s,
            check=False,
        )

    def _once(self, name: str, make: Callable[[Path], None]) -> Path:
        """The folder of this name; if it is not there, `make` fills one that becomes it.

        Another process that wants it meanwhile waits. What fails leaves nothing.
        """
        place = self._folder / name
        if place.is_dir():
            return place
        with (self._folder / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not place.is_dir():
                half = Path(tempfile.mkdtemp(prefix=f"{name}.", dir=self._folder))
                try:
                    make(half)
                    half.rename(place)
                finally:
                    shutil.rmtree(half, ignore_errors=True)
        return place
