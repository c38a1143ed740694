"""The manual: one Markdown file for each topic, shown by `judge help` and on the web.

A page's name is its file's name, its title the line `# …`; each `## …` begins a section.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct

_FOLDER = Path(__file__).parent
_FENCE = "```"
_FORMER = {  # a page's name in earlier versions -> the page that has its matter now
    "answers": "programs",
    "cluster": "class",
    "commands": "start",
    "containment": "sandbox",
    "explore": "failures",
    "failure": "failures",
    "hack": "interview",
    "katas": "start",
    "languages": "programs",
    "library": "testing",
    "new-type": "problem",
    "problem-py": "problem",
    "problem-toml": "problem",
    "quiz": "interview",
    "security": "sandbox",
}


class Section(Struct, frozen=True):
    """A part of a page: its heading (empty for the part above the first one) and its lines."""

    heading: str
    lines: tuple[str, ...]


class Page(Struct, frozen=True):
    """A page of the manual: `name` is the word for `judge help`, `text` the whole Markdown."""

    name: str
    title: str
    text: str

    @property
    def sections(self) -> list[Section]:
        """The parts of the page, in order; a line in a fenced block is not a heading."""
        found: list[tuple[str, list[str]]] = [("", [])]
        fenced = False
        for row in self.text.splitlines():
            fenced ^= row.startswith(_FENCE)
            if row.startswith("## ") and not fenced:
                found.append((row[3:], []))
            elif fenced or not row.startswith("# "):
                found[-1][1].append(row)
        return [Section(heading, tuple(lines)) for heading, lines in found]


class Hit(Struct, frozen=True):
    """Where words were found: the page, the section, and the line with most of them."""

    page: str
    heading: str
    line: str


def topics() -> list[str]:
    """The names of all pages, sorted."""
    return sorted(path.stem for path in _FOLDER.glob("*.md"))


def page(name: str) -> Page:
    """The page of that name, or the one that replaced it. Raises KeyError if there is none."""
    name = _FORMER.get(name, name)
    if name not in topics():
        raise KeyError(name)
    text = (_FOLDER / f"{name}.md").read_text(encoding="utf-8")
    return Page(name, text.partition("\n")[0].removeprefix("# ").replace("`", ""), text)


def pages() -> list[Page]:
    """Every page."""
    return [page(name) for name in topics()]


def search(words: Sequence[str]) -> Iterator[Hit]:
    """The sections that contain all the words, ignoring case; those with all in the heading come first."""
    wanted = [word.casefold() for word in words]
    hits: list[tuple[bool, Hit]] = []
    for each in pages():
        for section in each.sections:
            head = f"{each.title} {section.heading}".casefold()
            body = "\n".join((head, *section.lines)).casefold()
            if all(word in body for word in wanted):
                titled = all(word in head for word in wanted)
                hits.append((not titled, Hit(each.name, section.heading, _telling(section, wanted))))
    for _, hit in sorted(hits, key=lambda entry: entry[0]):
        yield hit


def _telling(section: Section, words: Sequence[str]) -> str:
    """The line with most of the words, without Markdown; the first line if none has any."""
    lines = [text for row in section.lines if (text := _bare(row))]
    return max(lines, key=lambda text: sum(word in text.casefold() for word in words), default="")


def _bare(row: str) -> str:
    """A line without its Markdown; empty for the borders of blocks and tables."""
    if row.startswith(_FENCE) or re.fullmatch(r"[|\-: ]*", row):
        return ""
    return re.sub(r"\]\([^)]*\)|[*`\[\]]", "", row).replace("|", " ").strip()
