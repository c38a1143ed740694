"""The manual on a screen: its topics, a page, where words were found, a text as it is."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from judge.report.parts import FAINT, STRONG, commands, indented, joined, table, text
from judge.report.published import Document, Mentions, PageShown, Topics
from judge.report.screen import Screen
from judge.report.statement import prose

_HITS = 8  # that are shown


def topics(found: Topics, screen: Screen) -> RenderableType:  # noqa: ARG001
    """Every topic with its title, and how to read one."""
    rows = [(text(each.topic, STRONG), each.title) for each in found.published]
    rows.append((text("options", STRONG), "Options of every command"))
    below = [("judge help TOPIC", "read one"), ("judge help WORDS", "find the pages that mention them")]
    return Group(table(("", ""), rows), Text(), commands(below))


def page(found: PageShown, screen: Screen) -> RenderableType:
    """A page, drawn for a person and as it is in a pipe."""
    return prose(found.published[0].text, screen)


def mentions(found: Mentions, screen: Screen) -> RenderableType:  # noqa: ARG001
    """The sections that have the words, each below the name of its page."""
    if not found.published:
        remedy = f"Did you mean judge help {found.near}?" if found.near else "judge help lists the topics."
        return text(f"No page mentions {found.words!r}. {remedy}")
    parts: list[RenderableType] = [text(f"Pages that mention {found.words!r}:")]
    for each in found.published[:_HITS]:
        head = joined(text(each.topic, STRONG), f"  {each.section}" if each.section else "")
        parts += [head, indented(text(each.line))]
    if len(found.published) > _HITS:
        parts.append(text(f"and {len(found.published) - _HITS} more sections", FAINT))
    return Group(*parts)


def document(found: Document, screen: Screen) -> RenderableType:  # noqa: ARG001
    """A text, line by line."""
    return Group(*(Text(row) for row in found.text.rstrip("\n").split("\n")))
