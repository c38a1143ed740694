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


def mangled_bytes(chance: random.Random, data: bytes) -> tuple[str, bytes]:
    """The bytes with one change, and what was done to them."""
    return _one(chance, _BYTES, data)


def mangled_text(chance: random.Random, text: str) -> tuple[str, str]:
    """The text with one change, and what was done to it."""
    return _one(chance, _TEXTS, text)


def _one(
    chance: random.Random, changes: tuple[Callable[[random.Random, T], T], ...], value: T
) -> tuple[str, T]:
    change = chance.choice(changes)
    return change.__name__.strip("_").replace("_", " "), change(chance, value)


def _place(chance: random.Random, data: bytes | str) -> int:
    return chance.randint(0, len(data))


def _truncated(chance: random.Random, data: bytes) -> bytes:
    return data[: _place(chance, data)]


def _bad_byte(chance: random.Random, data: bytes) -> bytes:
    at = _place(chance, data)
    return data[:at] + chance.choice(_BAD_BYTES) + data[at:]


def _flipped(chance: random.Random, data: bytes) -> bytes:
    at = _place(chance, data[:-1])
    return data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1 :] if data else b"\0"


def _block_twice(chance: random.Random, data: bytes) -> bytes:
    start, end = sorted((_place(chance, data), _place(chance, data)))
    return data[:end] + data[start:end] * chance.choice((1, 2, 50)) + data[end:]


def _block_gone(chance: random.Random, data: bytes) -> bytes:
    start, end = sorted((_place(chance, data), _place(chance, data)))
    return data[:start] + data[end:]


def _marked(chance: random.Random, data: bytes) -> bytes:
    return chance.choice(_MARKS) + data


def _other_line_ends(chance: random.Random, data: bytes) -> bytes:
    return data.replace(b"\n", chance.choice((b"\r\n", b"\r", b"\n\n", b"\x0c", b"\xe2\x80\xa8", b"")))


def _other_encoding(chance: random.Random, data: bytes) -> bytes:
    text = data.decode("utf-8", "replace")
    return text.encode(chance.choice(("utf-16", "utf-32-be", "latin-1", "cp037", "utf-7")), "replace")


def _emptied(chance: random.Random, _data: bytes) -> bytes:
    return chance.choice((b"", b"\n", b" ", b"\0" * 100, b"\xff" * 100))


def _random_bytes(chance: random.Random, _data: bytes) -> bytes:
    return chance.randbytes(chance.choice((1, 40, 4000)))


def _odd_character(chance: random.Random, text: str) -> str:
    at = _place(chance, text)
    return text[:at] + chance.choice(ODD_CHARACTERS) + text[at:]


def _line_gone(chance: random.Random, text: str) -> str:
    lines = text.splitlines(keepends=True)
    if lines:
        del lines[chance.randrange(len(lines))]
    return "".join(lines)


def _line_twice(chance: random.Random, text: str) -> str:
    lines = text.splitlines(keepends=True) or ["\n"]
    at = chance.randrange(len(lines))
    return "".join([*lines[:at], *lines[at : at + 1] * chance.choice((2, 3, 30)), *lines[at + 1 :]])


def _lines_swapped(chance: random.Random, text: str) -> str:
    lines = text.splitlines(keepends=True) or ["\n"]
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[one], lines[other] = lines[other], lines[one]
    return "".join(lines)


def _indented(chance: random.Random, text: str) -> str:
    lines = text.splitlines(keepends=True) or ["\n"]
    at = chance.randrange(len(lines))
    lines[at] = chance.choice((" ", "    ", "\t", " " * 200)) + lines[at]
    return "".join(lines)


def _word_swapped(chance: random.Random, text: str) -> str:
    """One word of the text is replaced by another one of it."""
    words = list(re.finditer(r"\w+|[^\w\s]", text))
    if not words:
        return text
    one, other = chance.choice(words), chance.choice(words)
    return text[: one.start()] + other[0] + text[one.end() :]


def _word_gone(chance: random.Random, text: str) -> str:
    words = list(re.finditer(r"\w+|[^\w\s]", text))
    if not words:
        return text
    one = chance.choice(words)
    return text[: one.start()] + text[one.end() :]


def _number_changed(chance: random.Random, text: str) -> str:
    numbers = list(re.finditer(r"\d+(\.\d+)?(e-?\d+)?", text))
    if not numbers:
        return text
    one = chance.choice(numbers)
    odd = ("0", "-1", "1e400", "1e-400", "9" * 30, "9" * 5000, "nan", "inf", "0x10", "1_0", "01", "1j", "''")
    return text[: one.start()] + chance.choice(odd) + text[one.end() :]


def _long_line(chance: random.Random, text: str) -> str:
    at = _place(chance, text)
    return text[:at] + chance.choice(("x", " ", "x ", "é", "\t", "(", "[", "-")) * 20_000 + text[at:]


_BYTES = (
    *(_truncated, _bad_byte, _flipped, _block_twice, _block_gone, _marked, _other_line_ends),
    *(_other_encoding, _emptied, _random_bytes),
)
_TEXTS = (
    *(_odd_character, _line_gone, _line_twice, _lines_swapped, _indented, _word_swapped, _word_gone),
    *(_number_changed, _long_line),
)
