"""The walks through the judge that our pages offer, gone step by step from their own text.

A walk is a section of a page. Its steps are the fenced blocks, in order:

    … `name/of/file` …      a paragraph; the block below it is written into the first file it names
    ```diff                 or changes that file: the lines after - and a blank are found, and replaced
    ```console              lines `$ command` to be run, and below each what it shows, in parts or whole:
    $ judge start           a line … stands for lines left out

Run as a script it goes all walks and writes what the commands show now into the pages.
"""

from __future__ import annotations

import difflib
import os
import re
import shlex
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pseudoterminal import run

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = "…"
WALKS = (
    ("README.md", "A tour of two minutes"),
    (".github/CONTRIBUTING.md", "Add a kata in 15 minutes"),
    ("judge/manual/programs.md", "A program"),
    (".github/CONTRIBUTING.md", "Add a language in 15 minutes"),
    ("judge/manual/start.md", "Solve one"),
)

_BLOCK = re.compile(
    r"(?:^(?P<about>(?:[^\n`][^\n]*\n|`[^`\n][^\n]*\n)+)\n)?^```(?P<kind>\w+)\n(?P<text>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
_MASKS = (
    (r"judge try \S+", "judge try …"),
    (r"(?s)[\d.]+ m?s CPU, \d+ MB.*?(?=\n\n|\Z)", "…"),  # time, memory, the ratio
    (r"\d{4}-\d\d-\d\d( \d\d:\d\d)?", "…"),
)


@dataclass(frozen=True)
class Step:
    """A file to write, or a command with what the page says it shows."""

    words: str  # the file's name, or the command
    text: str
    is_file: bool
    is_change: bool = False


@dataclass(frozen=True)
class Taken:
    """A command of a walk as it went: its exit status, what it showed and what it wrote to standard error."""

    step: Step
    status: int
    shown: str
    errors: str


def steps(page: str, title: str) -> list[Step]:
    """The steps of the section of that title."""
    found: list[Step] = []
    for block in _BLOCK.finditer(_section(page, title)):
        if block["kind"] == "console":
            for part in re.split(r"^\$ ", block["text"], flags=re.MULTILINE)[1:]:
                command, _, shown = part.partition("\n")
                found.append(Step(command, shown, is_file=False))
        elif name := re.search(r"`([\w./-]+\.\w+)`", block["about"] or ""):
            found.append(Step(name[1], block["text"], is_file=True, is_change=block["kind"] == "diff"))
    return found


def go(walk: list[Step], folder: Path) -> list[Taken]:
    """Take every step in `folder`, which is empty, as someone new who has nothing but the judge."""
    settings = {"JUDGE_CACHE": f"{folder}/.cache", "JUDGE_DB": f"{folder}/.history.sqlite3"}
    settings |= {"PYTHONPATH": str(ROOT), "PATH": f"{_commands(folder)}:{os.environ['PATH']}"}
    taken = []
    for step in walk:
        if step.is_file:
            path = folder / step.words
            path.parent.mkdir(parents=True, exist_ok=True)
            text = changed(path.read_text(encoding="utf-8"), step.text) if step.is_change else step.text
            path.write_text(text, encoding="utf-8")
        else:
            status, shown, errors = run(["sh", "-c", step.words], folder, settings)
            taken.append(Taken(step, status, plain(shown), errors))
    return taken


def changed(text: str, diff: str) -> str:
    """The text after the change; each part of a diff, between lines @@, must be there once."""
    for part in re.split(r"^@@.*\n", diff, flags=re.MULTILINE):
        lines = part.splitlines(keepends=True)
        old = "".join(line[1:] for line in lines if line[0] in " -")
        new = "".join(line[1:] for line in lines if line[0] in " +")
        if part:
            assert text.count(old or "\0") == 1, f"the diff does not fit:\n{part}"
            text = text.replace(old, new)
    return text


def plain(shown: str) -> str:
    """What was written to a terminal, without colours, links and the filling of lines."""
    bare = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\]8;;[^\x1b]*\x1b\\", "", shown)
    return "".join(f"{line.rstrip()}\n" for line in bare.splitlines()).strip("\n") + "\n"


def _masked(text: str) -> str:
    """The text without what differs from run to run."""
    for pattern, instead in _MASKS:
        text = re.sub(pattern, instead, text)
    return text


def missing(claimed: str, shown: str) -> str | None:
    """The first part of what a page claims that was not shown in its place; None if all was."""
    left_open = claimed.rstrip().endswith(LEFT_OUT)
    claimed, shown = _masked(claimed), _masked(shown)
    rest, whole = _lines(shown), True
    for part in _parts(claimed):
        size = len(part)
        places = range(len(rest) - size + 1) if not whole else range(1)
        at = next((i for i in places if rest[i : i + size] == part), None)
        if at is None:
            return "\n".join(part)
        rest, whole = rest[at + size :], False
    return "\n".join(rest) if rest and not left_open else None


def claims_hold(taken: Sequence[Taken]) -> None:
    """Fails where a command did not show what its page says."""
    assert taken
    for each in taken:
        lacking = missing(each.step.text, each.shown)
        assert lacking is None, (
            f"$ {each.step.words} (status {each.status}) does not show as told:\n{lacking}\n"
            f"but:\n{each.shown}{each.errors}\npython tests/packaging/walk.py brings the page up to date"
        )


def _section(page: str, title: str) -> str:
    """What is below that title, up to the next one; what looks like a title within a block is none."""
    found: list[str] = []
    inside = fenced = False
    for line in page.splitlines(keepends=True):
        fenced ^= line.startswith("```")
        if line.startswith("## ") and not fenced:
            inside = line.strip() == f"## {title}"
        elif inside:
            found.append(line)
    return "".join(found)


def _lines(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.strip()]


def _parts(claimed: str) -> list[list[str]]:
    """The runs of lines between those left out."""
    parts: list[list[str]] = [[]]
    for line in _lines(claimed):
        if line.strip() == LEFT_OUT:
            parts.append([])
        else:
            parts[-1].append(line)
    return parts


def _commands(folder: Path) -> Path:
    """A folder that holds the command `judge`, this checkout's."""
    place = folder / ".bin"
    place.mkdir()
    (place / "judge").write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m judge "$@"\n')
    (place / "judge").chmod(0o755)
    return place


def _renewed(claimed: str, shown: str) -> str:
    """What a page claims, its paragraphs replaced by those that were shown and are most like them."""
    paragraphs, fresh = shown.strip("\n").split("\n\n"), []
    for paragraph in claimed.strip("\n").split("\n\n"):
        lines = paragraph.splitlines()
        if LEFT_OUT in (line.strip() for line in lines):
            options = _lines(shown)
            lines = [line if line.strip() == LEFT_OUT else _nearest(line, options) for line in lines]
            fresh.append("\n".join(lines))
        else:
            fresh.append(_nearest(paragraph, paragraphs))
    return "\n\n".join(fresh) + "\n" if claimed.strip() else claimed


def _nearest(text: str, options: list[str]) -> str:
    return max(
        options, key=lambda option: difflib.SequenceMatcher(None, _masked(text), _masked(option)).ratio()
    )


def main() -> None:
    """Bring the pages up to date."""
    for name, title in WALKS:
        path = ROOT / name
        page = path.read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            for taken in go(steps(page, title), Path(folder)):
                if missing(taken.step.text, taken.shown):
                    before = f"$ {taken.step.words}\n{taken.step.text}"
                    after = f"$ {taken.step.words}\n{_renewed(taken.step.text, taken.shown)}"
                    page = page.replace(before, after, 1)
        path.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
