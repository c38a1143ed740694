"""What the tests of our pages share."""

from __future__ import annotations

from collections.abc import Sequence

from walk import ROOT, Taken, missing

__all__ = ["ROOT", "claims_hold", "prose"]


def claims_hold(taken: Sequence[Taken]) -> None:
    """Fails where a command did not show what its page says."""
    assert taken
    for each in taken:
        lacking = missing(each.step.text, each.shown)
        assert lacking is None, (
            f"$ {each.step.words} (status {each.status}) does not show as told:\n{lacking}\n"
            f"but:\n{each.shown}{each.errors}\npython tests/packaging/walk.py brings the page up to date"
        )


def prose(page: str) -> list[str]:
    """The lines of a page outside its blocks."""
    lines, fenced = [], False
    for line in page.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            lines.append(line)
    return lines
