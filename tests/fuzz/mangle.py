"""Changing a text or its bytes in small bad ways, drawn from a seeded random.Random."""

from __future__ import annotations

import random
import re
import tomllib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TypeVar

T = TypeVar("T", bytes, str)

ODD_CHARACTERS = (
    *("\0", "\x1b[31m", "\x1b]0;title\x07", "\r", "\x0b", "\x0c", "\x7f", "\x85", "\u2028", "\u202e"),
    *("\ufeff", "\u200b", "\ufffd", "\U0001f600", "e\u0301", "\u0645\u0631\u062d\u0628\u0627", "\uff08"),
    *("\u00e9", "\U0010ffff", "\ue000", "%", "%s", "{}", "{{", "}}", "{{a}}", "$HOME", "::error::", "\\"),
    *('"', "'", '"""', "`", "```", "<!--", "&amp;", "]]>", "#", "\n", "\n\n", "\t", " ", ">>> ", "... "),
)
_BAD_BYTES = (b"\xff", b"\xc3", b"\xed\xa0\x80", b"\xf5\x80\x80\x80", b"\xc0\x80", b"\x80", b"\x00")
_MARKS = (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff", b"\x00\x00\xfe\xff", b"\x1f\x8b", b"#!", b"PK\x03\x04")


@cache
def _parts() -> dict[str, list[str]]:
    return tomllib.loads((Path(__file__).parent / "odd" / "parts.toml").read_text(encoding="utf-8"))


def pool(name: str) -> list[str]:
    """A list of odd/parts.toml."""
    return _parts()[name]


Change = Callable[[random.Random, T], T]


def mangled_bytes(chance: random.Random, data: bytes) -> tuple[str, bytes]:
    """The bytes with one change, and what was done to them."""
    return _one(chance, _BYTES, data)


def mangled_text(chance: random.Random, text: str) -> tuple[str, str]:
    """The text with one change, and what was done to it."""
    return _one(chance, _TEXTS, text)


def _one(chance: random.Random, changes: dict[str, Change[T]], value: T) -> tuple[str, T]:
    what = chance.choice([*changes])
    return what, changes[what](chance, value)


def _ends(chance: random.Random, data: bytes | str) -> tuple[int, int]:
    """Two places in it, in order."""
    start, end = sorted((chance.randint(0, len(data)), chance.randint(0, len(data))))
    return start, end


def _put(chance: random.Random, value: T, new: T) -> T:
    """Something in between."""
    at = chance.randint(0, len(value))
    return value[:at] + new + value[at:]


def _flipped(chance: random.Random, data: bytes) -> bytes:
    at = chance.randint(0, len(data[:-1]))
    return data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1 :] if data else b"\0"


def _block(times: tuple[int, ...]) -> Change[bytes]:
    def change(chance: random.Random, data: bytes) -> bytes:
        start, end = _ends(chance, data)
        return data[:start] + data[start:end] * chance.choice(times) + data[end:]

    return change


def _other_encoding(chance: random.Random, data: bytes) -> bytes:
    text = data.decode("utf-8", "replace")
    return text.encode(chance.choice(("utf-16", "utf-32-be", "latin-1", "cp037", "utf-7")), "replace")


def _lines(change: Callable[[random.Random, list[str], int], object]) -> Change[str]:
    def changed(chance: random.Random, text: str) -> str:
        lines = text.splitlines(keepends=True) or ["\n"]
        change(chance, lines, chance.randrange(len(lines)))
        return "".join(lines)

    return changed


def _swapped(chance: random.Random, lines: list[str], at: int) -> None:
    other = chance.randrange(len(lines))
    lines[at], lines[other] = lines[other], lines[at]


def _replaced(pattern: str, other: Callable[[random.Random, list[str]], str]) -> Change[str]:
    """One part of the text is replaced; `other` is given all of them."""

    def change(chance: random.Random, text: str) -> str:
        found = list(re.finditer(pattern, text))
        if not found:
            return text
        one = chance.choice(found)
        return text[: one.start()] + other(chance, [each[0] for each in found]) + text[one.end() :]

    return change


_NUMBERS = ("0", "-1", "1e400", "1e-400", "9" * 30, "9" * 5000, "nan", "inf", "0x10", "1_0", "01", "1j", "''")
_ENDS = (b"\r\n", b"\r", b"\n\n", b"\x0c", b"\xe2\x80\xa8", b"")
_LONG = ("x", " ", "x ", "é", "\t", "(", "[", "-")
_WORD = r"\w+|[^\w\s]"
_BYTES: dict[str, Change[bytes]] = {
    "truncated": lambda chance, data: data[: chance.randint(0, len(data))],
    "a bad byte": lambda chance, data: _put(chance, data, chance.choice(_BAD_BYTES)),
    "flipped": _flipped,
    "a block again": _block((2, 3, 51)),
    "a block gone": _block((0,)),
    "marked": lambda chance, data: chance.choice(_MARKS) + data,
    "other line ends": lambda chance, data: data.replace(b"\n", chance.choice(_ENDS)),
    "other encoding": _other_encoding,
    "emptied": lambda chance, data: chance.choice((b"", b"\n", b" ", b"\0" * 100, b"\xff" * 100)),
    "random bytes": lambda chance, data: chance.randbytes(chance.choice((1, 40, 4000))),
}
_TEXTS: dict[str, Change[str]] = {
    "odd character": lambda chance, text: _put(chance, text, chance.choice(ODD_CHARACTERS)),
    "line gone": _lines(lambda chance, lines, at: lines.pop(at)),
    "line twice": _lines(lambda chance, lines, at: lines.insert(at, lines[at] * chance.choice((1, 2, 29)))),
    "lines swapped": _lines(_swapped),
    "indented": _lines(lambda chance, lines, at: lines.insert(at, chance.choice((" ", "\t", " " * 200)))),
    "word swapped": _replaced(_WORD, lambda chance, words: chance.choice(words)),
    "word gone": _replaced(_WORD, lambda chance, words: ""),
    "number changed": _replaced(r"\d+(\.\d+)?(e-?\d+)?", lambda chance, _: chance.choice(_NUMBERS)),
    "long line": lambda chance, text: _put(chance, text, chance.choice(_LONG) * 20_000),
}
