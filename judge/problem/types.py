"""The types of a kata's answer and parameters, from their text and the pack's own types."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from judge.values.answers import Words
from judge.values.atoms import Type


@cache
def parsed_type(text: str, folder: Path, words: Words = Words(), letters: str = "") -> Type:  # noqa: B008
    """The type of that text; `folder` has the pack's own types, if it is there. Raises TypeFault."""
    from judge.values.grammar import parse  # not for who lists problems

    return parse(text, folder if folder.is_dir() else None, words, letters)
