"""Odd programs: what a submission may be that nobody would write, and changes of programs that somebody did.

    odd/answers.txt   expressions, a line each; most are no answer to anything
    odd/classes.txt   the classes and functions that they name
    odd/shapes.txt    submissions around an answer, which ANSWER stands for, with `---` between them
    odd/lines.txt     whole submissions of one line; more are in odd/parts.toml

ENTRY stands for the function's name, ARGS for its parameters.
"""

from __future__ import annotations

import random
from functools import cache
from pathlib import Path

from mangle import mangled_bytes, mangled_text, pool

_ODD = Path(__file__).with_name("odd")
_DEEP = "".join(f"{' ' * depth}if 1:\n" for depth in range(120)) + " " * 120 + "pass\n"
_WHOLE = (
    *(*pool("programs"), _DEEP, "(" * 500 + ")" * 500, "[" * 10_000, "-" * 50_000 + "1", "9" * 5000),
    *("x = " + "9" * 4000, "0x" + "f" * 10**5, "x = " + "1+" * 5000 + "1", "x = " + "f" * 10**5),
    *("x = '" + "a" * 10**6 + "'", "a = 1\n" * 50_000),
)


@cache
def _odd(name: str, between: str = "\n") -> tuple[str, ...]:
    """The parts of one of the files."""
    return tuple((_ODD / name).read_text(encoding="utf-8").removesuffix("\n").split(between))


def odd_program(chance: random.Random, entry: str, parameters: str) -> tuple[str, bytes]:
    """A program that nobody would write, and what it is."""
    if chance.random() < 0.3:
        text = chance.choice((*_WHOLE, *_odd("lines.txt")))
        what = repr(text[:60])
    else:
        shape, answer = chance.choice(_odd("shapes.txt", "\n---\n")), chance.choice(_odd("answers.txt"))
        text = f"{_odd('classes.txt', chr(0))[0]}\n{shape.replace('ANSWER', f'({answer})')}\n"
        what = f"{shape[:90]!r} with {answer}"
    text = text.replace("ENTRY", entry).replace("ARGS", parameters)
    return what, text.encode("utf-8", "surrogatepass")


def changed_program(chance: random.Random, source: bytes) -> tuple[str, bytes]:
    """A program changed in one to four places."""
    story = []
    for _ in range(chance.choice((1, 1, 2, 4))):
        if chance.random() < 0.3:
            what, source = mangled_bytes(chance, source)
        else:
            what, text = mangled_text(chance, source.decode("utf-8", "surrogateescape"))
            source = text.encode("utf-8", "surrogateescape")
        story.append(what)
    return ", ".join(story), source
