"""The table `[source]` of problem.toml: who wrote a problem, on which terms, and after what."""

from __future__ import annotations

from typing import NoReturn, Protocol

from judge.problem.lines import KeyPath
from judge.problem.model import Source
from judge.problem.schema import SourceTable


class Fault(Protocol):
    """Says what is wrong at a key, and what to do about it; raises ProblemError."""

    def __call__(self, path: KeyPath, what: str, remedy: str) -> NoReturn: ...  # noqa: D102


def source_of(table: SourceTable | None, fault: Fault) -> Source:
    """The table's values, each a line of text. Raises ProblemError."""
    if table is None:
        return Source()
    texts = {"license": table.license, "origin": table.origin}
    given = [("authors", author) for author in table.authors]
    given += [(key, text) for key, text in texts.items() if text is not None]
    for key, text in given:
        if not text.strip() or not text.isprintable():
            remedy = "write it, or leave the key out"
            fault(("source", key), f"{key} holds {text!r}, which is no line of text", remedy)
        if key == "authors" and ("," in text or "&" in text):
            fault(("source", key), f"{text!r} is more than one name", "give each author's name by itself")
    return Source(tuple(table.authors), table.license or "", table.origin or "")
