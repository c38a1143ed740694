"""The manual: one Markdown file a topic, read by `judge help` and on the web alike.

A page's name is its file's, its title the line `# …`, its sections the lines `## …` and what is below each.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct

_FOLDER = Path(__file__).parent
_FENCE = "```"


class Section(Struct, frozen=True):
    """A part of a page: its heading, empty for what stands above the first one, and the lines below it."""

    heading: str
    lines: tuple[str, ...]


class Page(Struct, frozen=True):
    """A topic of the manual: `name` is the word for `judge help`, `text` the whole Markdown."""

    name: str
    title: str
    text: str

    @property
    def sections(self) -> list[Section]:
        """What the page consists of, in order; what looks like a heading within a block is none."""
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
    """Where the manual speaks of something: the page, the section, and the line that says most of it."""

    page: str
    heading: str
    line: str


def topics() -> list[str]:
    """The names of all pages, in order of name."""
    return sorted(path.stem for path in _FOLDER.glob("*.md"))


def page(name: str) -> Page:
    """The page of that name. Raises KeyError if there is none."""
    if name not in topics():
        raise KeyError(name)
    text = (_FOLDER / f"{name}.md").read_text(encoding="utf-8")
    return Page(name, text.partition("\n")[0].removeprefix("# ").replace("`", ""), text)


def pages() -> list[Page]:
    """Every page."""
    return [page(name) for name in topics()]


def search(words: Sequence[str]) -> Iterator[Hit]:
    """The sections that have all the words, in any case of letters; those with all in the heading first."""
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
    """The line of a section that has most of the words, without its marks; its first where none has any."""
    lines = [text for row in section.lines if (text := _bare(row))]
    return max(lines, key=lambda text: sum(word in text.casefold() for word in words), default="")


def _bare(row: str) -> str:
    """A line without what makes it Markdown; nothing for the borders of blocks and tables."""
    if row.startswith(_FENCE) or re.fullmatch(r"[|\-: ]*", row):
        return ""
    return re.sub(r"\]\([^)]*\)|[*`\[\]]", "", row).replace("|", " ").strip()
