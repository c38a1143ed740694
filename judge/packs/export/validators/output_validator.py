"""Output validator: every number must lie between two exact ends, decided in integers and never rounded.

usage: validate.py INPUT ANSWER FEEDBACK_DIR < output    42 accepted, 43 wrong, 1 the package is inconsistent

accepted.json beside this file says of what type an answer is and, by the SHA-256 of each input file, what is
accepted for each of its cases:

    ["real"]                 [a, b, s]: from a/s to b/s
                             [a, b, c, d, r, s]: from (a + b*sqrt(r))/s to (c + d*sqrt(r))/s
    ["int"], ["word"]        the int, the word
    ["tuple", [type, …]]     what is accepted for each part
    ["list", type, low, high]    the same for each item, of which there are low to high (null: no bound)
    ["optional", type]       null where the answer is none
    any of these             {"any": […]}: each of several is right

Needs Python 3.6 or newer, CPython or PyPy, and nothing else.
"""

import hashlib
import json
import os
import re
import sys
from typing import Any, List, Tuple

DECIMAL = re.compile(r"([+-]?)(?=\.?[0-9])([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?[0-9]+))?")
INTEGER = re.compile(r"[+-]?[0-9]{1,400}")
FOREIGN = re.compile(r"[^\t -~]")
MOST_DIGITS, MOST_EXPONENT = 2000, 5000
TABLE = "accepted.json"


class Wrong(Exception):  # noqa: N818
    """Why an output is wrong."""


def sign(p: int, q: int, r: int) -> int:
    """The sign of p + q*sqrt(r)."""
    if q == 0 or r == 0:
        return (p > 0) - (p < 0)
    if p == 0 or (p > 0) == (q > 0):
        return 1 if q > 0 else -1
    gap = p * p - q * q * r
    return ((gap > 0) - (gap < 0)) * (1 if p > 0 else -1)


def order(p: int, q: int, r: int, s: int, y: Tuple[int, int]) -> int:
    """The sign of (p + q*sqrt(r))/s - y."""
    return sign(p * y[1] - y[0] * s, q * y[1], r)


class Tokens:
    """The tokens of a line, taken one after the other."""

    def __init__(self, line: str) -> None:
        if line.endswith("\r"):
            line = line[:-1]
        if FOREIGN.search(line):
            raise Wrong("the output is not plain ASCII text")
        self.words = line.split()
        self.at = 0
        if not self.words:
            raise Wrong("an empty line where an answer is expected")

    def ahead(self) -> str:
        """The next token, which stays; empty at the end."""
        return self.words[self.at] if self.at < len(self.words) else ""

    def take(self) -> str:
        """The next token."""
        if self.at == len(self.words):
            raise Wrong("the line ends too early")
        self.at += 1
        return self.words[self.at - 1]

    def integer(self) -> int:
        """The next token as a plain integer."""
        token = self.take()
        if not INTEGER.fullmatch(token):
            raise Wrong("%r where a plain integer is expected" % token[:60])
        return int(token)

    def number(self) -> Tuple[int, int]:
        """The next token as a plain decimal: its numerator and denominator."""
        token = self.take()
        match = DECIMAL.fullmatch(token) if len(token) <= MOST_DIGITS else None
        if match is None:
            raise Wrong("%r where a plain decimal is expected" % token[:60])
        minus, whole, places, power = match.groups()
        if power and (len(power) > 6 or abs(int(power)) > MOST_EXPONENT):
            raise Wrong("%r has an exponent beyond %d" % (token[:60], MOST_EXPONENT))
        exponent = int(power or 0) - len(places or "")
        top = int(minus + whole + (places or ""))
        return (top * 10**exponent, 1) if exponent >= 0 else (top, 10**-exponent)


def taken(kind: Any, tokens: Tokens) -> Any:
    """The value of that type which the next tokens hold."""
    name = kind[0]
    if name == "real":
        return tokens.number()
    if name == "int":
        return tokens.integer()
    if name == "word":
        return tokens.take()
    if name == "tuple":
        return [taken(part, tokens) for part in kind[1]]
    if name == "optional":
        if tokens.ahead() == "none":
            tokens.take()
            return None
        if tokens.ahead().lower() in ("none", "null"):
            raise Wrong("write none in lower case")
        return taken(kind[1], tokens)
    if name == "list":
        return items(kind, tokens)
    raise ValueError("an unknown type %r" % name)


def items(kind: Any, tokens: Tokens) -> List[Any]:
    """The length of a list, and so many items."""
    low, high = kind[2:]
    count = tokens.integer()
    if count < low or (high is not None and count > high) or count > len(tokens.words) - tokens.at:
        raise Wrong(
            "a list of %s items, with %d tokens left" % (str(count)[:20], len(tokens.words) - tokens.at)
        )
    return [taken(kind[1], tokens) for _ in range(count)]


def held(kind: Any, value: Any, wanted: Any, where: str) -> None:
    """Raises Wrong unless the value is what is wanted."""
    if isinstance(wanted, dict) and "any" in wanted:
        for each in wanted["any"]:
            if fits(kind, value, each):
                return
        raise Wrong("%s is none of the right ones" % where)
    name = kind[0]
    if name == "optional":
        if value is None or wanted is None:
            if value is not wanted:
                raise Wrong(
                    "%s: %s" % (where, "none given, but there is one" if value is None else "none wanted")
                )
            return
        held(kind[1], value, wanted, where)
    elif name == "real":
        low, high = (wanted[:2], wanted[2:4]) if len(wanted) == 6 else ((wanted[0], 0), (wanted[1], 0))
        r, s = wanted[-2] if len(wanted) == 6 else 0, wanted[-1]
        if order(low[0], low[1], r, s, value) > 0 or order(high[0], high[1], r, s, value) < 0:
            raise Wrong("%s is off" % where)
    elif name == "tuple":
        for at, part in enumerate(kind[1]):
            held(part, value[at], wanted[at], "part %d of %s" % (at + 1, where))
    elif name == "list":
        if len(value) != len(wanted):
            raise Wrong("%s has %d items, %d wanted" % (where, len(value), len(wanted)))
        for at, each in enumerate(wanted):
            held(kind[1], value[at], each, "item %d of %s" % (at + 1, where))
    elif value != wanted:  # an int, a word
        raise Wrong("%s is %s, %s wanted" % (where, str(value)[:60], str(wanted)[:60]))


def fits(kind: Any, value: Any, wanted: Any) -> bool:
    """Whether the value is what is wanted."""
    try:
        held(kind, value, wanted, "")
    except Wrong:
        return False
    return True


def check(kind: Any, line: str, wanted: Any) -> None:
    """Raises Wrong unless a line of output is the answer that is wanted."""
    tokens = Tokens(line)
    value = taken(kind, tokens)
    if tokens.ahead():
        raise Wrong("%r after the answer" % tokens.ahead()[:60])
    held(kind, value, wanted, "the answer")


def lines_of(output: bytes) -> List[str]:
    """The lines of an output, without blank ones at its end."""
    lines = output.decode("latin-1").replace("\r\n", "\n").split("\n")
    while lines and not lines[-1].strip(" \t"):
        lines.pop()
    return lines


def decide(kind: Any, wanted: Any, output: bytes) -> None:
    """Raises Wrong unless an output is right: a line for each case."""
    lines = lines_of(output)
    for case, target in enumerate(wanted):
        if case >= len(lines):
            raise Wrong("the output ends after %d of %d lines" % (len(lines), len(wanted)))
        try:
            check(kind, lines[case], target)
        except Wrong as why:
            raise Wrong("case %d: %s" % (case + 1, why)) from None
    if len(lines) > len(wanted):
        raise Wrong("%d lines printed, %d wanted" % (len(lines), len(wanted)))


def main() -> int:
    """The exit status."""
    with open(sys.argv[1], "rb") as file:
        key = hashlib.sha256(file.read()).hexdigest()
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), TABLE)) as file:
        table = json.load(file)
    if key not in table["files"]:
        sys.stderr.write("%s is not an input of this package: export the package again\n" % sys.argv[1])
        return 1
    try:
        decide(table["answer"], table["files"][key], sys.stdin.buffer.read())
    except Wrong as why:
        with open(os.path.join(sys.argv[3], "judgemessage.txt"), "a") as file:
            file.write("%s\n" % why)
        return 43
    return 42


if __name__ == "__main__":
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # the ends are long, and our own
    sys.exit(main())
