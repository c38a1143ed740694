"""The manual: one Markdown file for each topic, shown by `judge help` and on the web.

A page's name is its file's name, its title the line `# …`; each `## …` begins a section.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from judge.published import Published

_FOLDER = Path(__file__).parent
_FENCE = "```"
_FORMER = {  # a page -> the names of those of earlier versions whose matter it has now
    "class": ("cluster",),
    "failures": ("explore", "failure"),
    "interview": ("hack", "quiz"),
    "problem": ("new-type", "problem-py", "problem-toml"),
    "programs": ("answers", "languages"),
    "sandbox": ("containment", "security"),
    "start": ("commands", "katas"),
    "testing": ("library",),
}


class Page(Published, frozen=True):
    """A page of the manual: `topic` is the word for `judge help`, `text` the whole Markdown."""

    topic: str
    title: str
    text: str


class SearchHit(Published, frozen=True):
    """Where words were found: the page, the section, and the line with most of them."""

    topic: str
    section: str
    line: str


def topics() -> list[str]:
    """The names of all pages, sorted."""
    return sorted(path.stem for path in _FOLDER.glob("*.md"))


def page(name: str) -> Page:
    """The page of that name, or the one that replaced it. Raises KeyError if there is none."""
    name = next((now for now, former in _FORMER.items() if name in former), name)
    if name not in topics():
        raise KeyError(name)
    text = (_FOLDER / f"{name}.md").read_text(encoding="utf-8")
    title = text.partition("\n")[0].removeprefix("# ").replace("`", "")
    return Page(topic=name, title=title, text=text)


def pages() -> list[Page]:
    """Every page."""
    return [page(name) for name in topics()]


def search(words: Sequence[str]) -> list[SearchHit]:
    """The sections that contain all the words, ignoring case; those with all in the heading come first."""
    wanted = [word.casefold() for word in words]
    titled, others = list[SearchHit](), list[SearchHit]()
    for each in pages():
        for heading, lines in _sections(each.text):
            head = f"{each.title} {heading}".casefold()
            body = "\n".join((head, *lines)).casefold()
            if all(word in body for word in wanted):
                found = titled if all(word in head for word in wanted) else others
                found.append(SearchHit(topic=each.topic, section=heading, line=_telling(lines, wanted)))
    return titled + others


def _sections(text: str) -> list[tuple[str, list[str]]]:
    """The heading and the lines of each part, the first without one; no line of a fenced block is one."""
    found: list[tuple[str, list[str]]] = [("", [])]
    fenced = False
    for row in text.splitlines():
        fenced ^= row.startswith(_FENCE)
        if row.startswith("## ") and not fenced:
            found.append((row[3:], []))
        elif fenced or not row.startswith("# "):
            found[-1][1].append(row)
    return found


def _telling(lines: Sequence[str], words: Sequence[str]) -> str:
    """The line with most of the words, without Markdown; the first line if none has any."""
    bare = filter(None, map(_bare, lines))
    return max(bare, key=lambda text: sum(word in text.casefold() for word in words), default="")


def _bare(row: str) -> str:
    """A line without its Markdown; empty for the borders of blocks and tables."""
    if row.startswith(_FENCE) or re.fullmatch(r"[|\-: ]*", row):
        return ""
    return re.sub(r"\]\([^)]*\)|[*`\[\]]", "", row).replace("|", " ").strip()
