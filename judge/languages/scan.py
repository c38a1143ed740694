"""Looking through a stranger's text: in time that grows with its length, and never for long.

A description says how comments and strings begin and end, and by patterns what a head looks like. A comment
or a string without an end goes to the end of the text, so that none is read twice. A pattern is tried on a
few thousand characters at once; a test counts how many steps each of ours may take at one place. Whatever
still takes long costs that text alone: the clock is looked at all the while.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache

from judge.errors import JudgeError

SECONDS = 2.0  # of CPU time, for all that is to be found in one text
WINDOW = 2_000  # characters that a match may have; a comment or a string has any number
AT_ONCE = 6_000  # characters that are looked through between two looks at the clock

Tokens = tuple[tuple[str, ...], ...]
"""Patterns of what begins a comment or a string, what ends it, what is passed over before. A beginning alone
is all of it. An end with `{mark}` in it is no pattern: that stands for the beginning's group `mark`."""
MARK = "{mark}"

_STRINGS: Tokens = (
    ('"""', '"""', r"\\."),
    ("'''", "'''", r"\\."),
    ('"', r'"|\n', r"\\."),
    ("'", r"'|\n", r"\\."),
)
_C_LIKE: Tokens = (
    ("//", r"\n"),
    (r"/\*", r"\*/"),
    ('"', r'"|\n', r"\\."),
    (r"'(?:\\.|[^'\\\n])'",),  # a character
    ("`", "`"),
)
_INNER = r"\((?>(?:[^;{}()]{1,50}+|\([^;{}()]{0,50}+\)){0,5})\)"
PARAMETERS = rf"\((?>(?:[^;{{}}()]{{1,200}}+|{_INNER}){{0,30}})\)"
"""The pattern of a function's parameters in their brackets, three deep."""

_end: ContextVar[float] = ContextVar("_end", default=float("inf"))
_Closing = Mapping[str, re.Pattern[str] | str]


class _TooLongError(JudgeError):
    """A text that takes too long."""


@contextmanager
def reading(name: str | None = None) -> Iterator[None]:
    """What is looked for in one text meanwhile takes no more than `SECONDS`; it is the file of that name.

    Raises JudgeError where it would.
    """
    before = _end.set(time.thread_time() + SECONDS)
    try:
        yield
    except _TooLongError as fault:
        fault.where = name
        raise
    finally:
        _end.reset(before)


def _check_time() -> None:
    if time.thread_time() > _end.get():
        what = f"it takes more than {SECONDS:g} s to look through this text"
        raise _TooLongError(what, remedy="take out what no person would write")


def usual_tokens(comment: str) -> Tokens:
    """The comments and strings of a language of which nothing but the beginning of a comment is known."""
    return _C_LIKE if comment == "//" else ((re.escape(comment), r"\n"), *_STRINGS)


def met(pattern: re.Pattern[str], text: str, end: int | None = None) -> Iterator[re.Match[str]]:
    """As `pattern.finditer` up to `end`, for what is no longer than `WINDOW`. Raises as `reading` says."""
    at, end = 0, len(text) if end is None else end
    while at <= end:
        _check_time()
        stop = at + AT_ONCE
        for found in pattern.finditer(text, at, min(end, stop + WINDOW)):
            if found.start() >= stop:
                break
            yield found
            stop = max(stop, found.end())
        at = stop


def unsaid(text: str, tokens: Tokens) -> Iterator[tuple[int, int]]:
    """Where the comments and strings of a text begin and end. Raises as `reading` says."""
    for found, end in _outside(re.compile(beginning(tokens)), text, tokens):
        yield found.start(), end


def stripped(source: bytes, tokens: Tokens) -> str:
    """The source without comments and strings; its lines where they were. Raises as `reading` says."""
    text = source.decode(errors="replace")
    parts, kept = [], 0
    for start, end in unsaid(text, tokens):
        parts += [text[kept:start], " ", "\n" * text.count("\n", start, end)]
        kept = end
    return "".join([*parts, text[kept:]])


def changed(source: bytes, pattern: str, change: Callable[[re.Match[str]], str], tokens: Tokens) -> bytes:
    """The source, changed wherever it meets the pattern, but not within comments and strings.

    A character stands for each byte, and `^` is the beginning of a line. Raises as `reading` says.
    """
    text = source.decode("latin-1")
    both = re.compile(f"{pattern}|{beginning(tokens)}", re.DOTALL | re.MULTILINE | re.ASCII)
    parts, kept = [], 0
    for found, end in _outside(both, text, tokens):
        if found.lastgroup not in _closing(tokens):
            parts += [text[kept : found.start()], change(found)]
            kept = end
    return "".join([*parts, text[kept:]]).encode("latin-1")


def _outside(pattern: re.Pattern[str], text: str, tokens: Tokens) -> Iterator[tuple[re.Match[str], int]]:
    """What is met outside of comments and strings, and the beginnings of these; each with its end."""
    closing = _closing(tokens)
    at = 0
    while at < len(text):
        _check_time()
        stop = at + AT_ONCE
        found = pattern.search(text, at, stop + WINDOW)
        if found is None or found.start() >= stop:
            at = stop
            continue
        end = _end_of(found, text, closing)
        yield found, end
        at = max(end, at + 1)


def _end_of(found: re.Match[str], text: str, closing: _Closing) -> int:
    closes = closing.get(found.lastgroup or "", "")
    if isinstance(closes, str):
        sign = closes.replace(MARK, found["mark"]) if closes else ""
        place = text.find(sign, found.end())
        return place + len(sign) if place >= 0 else len(text)
    ends = (each.end() for each in closes.finditer(text, found.end()) if each["end"] is not None)
    return next(ends, len(text))


@cache
def beginning(tokens: Tokens) -> str:
    """The pattern of what begins a comment or a string, each with a name."""
    return "|".join(f"(?P<token{place}>{begin})" for place, (begin, *_) in enumerate(tokens))


@cache
def _closing(tokens: Tokens) -> _Closing:
    """By that name the pattern of what ends it or is passed over, or the sign itself; empty for neither."""
    return {f"token{place}": _closes(*others) for place, (_, *others) in enumerate(tokens)}


def _closes(end: str = "", over: str = "") -> re.Pattern[str] | str:
    if not end or MARK in end:
        return end
    return re.compile(f"{over}|(?P<end>{end})" if over else f"(?P<end>{end})", re.DOTALL)
