"""Input validator: 42 for an input of this problem, 43 for any other.

It checks the form of every line, that each number is written as Python writes it, and its bounds:

    ["real", low, high, smallest]    each bound [n, m] for n/m; other than 0 at least smallest
    ["int", low, high, smallest]     the same for integers
    ["word", [word, …]]              one of these
    ["text", low, high, letters]     so many of these characters: as it is if it is one word, else as JSON
    ["bool"]                         true or false
    ["tuple", [type, …]]             its parts
    ["list", type, low, high]        the length, low to high (None: no bound), and the items
    ["dict", key, value, low, high]  the same: of each entry its key, then its value, in the order of the keys
    ["optional", type]               none, or the type

It does not prove what else the statement promises of a case, such as how near a miss may be. Inputs of a
format of the problem's own are known by their SHA-256.
Needs Python 3.6 or newer, CPython or PyPy, and nothing else.
"""

import hashlib
import json
import re
import sys
from fractions import Fraction
from typing import Any, List

PARAMETERS = []  # type: Any  # the problem's, in order
INPUTS = []  # type: List[str]  # in their place, where the format is the problem's own
INTEGER = re.compile(r"0|-?[1-9][0-9]*")
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[^ ]+')
BARE = re.compile(r'(?!")(?!none\Z)[!-~]+')
FLOAT = re.compile(r"-?(0|[1-9][0-9]*)(\.[0-9]+)?(e[+-]?[0-9]+)?")
LONGEST = 400  # of a number
MOST_CASES = 7  # digits of their number


class Invalid(Exception):  # noqa: N818
    """Why an input is invalid."""


def number(kind: Any, token: str) -> None:
    """Raises Invalid unless the token is such a number."""
    name, low, high, smallest = kind
    if len(token) > LONGEST:
        raise Invalid("a number of %d characters" % len(token))
    if INTEGER.fullmatch(token):
        value = Fraction(int(token))
    elif name == "real" and FLOAT.fullmatch(token) and repr(float(token)) == token:
        value = Fraction(float(token))
    else:
        raise Invalid("%r is not a number as Python writes it" % token[:60])
    if not Fraction(*low) <= value <= Fraction(*high):
        raise Invalid("%s is out of bounds" % token)
    if value and abs(value) < Fraction(*smallest):
        raise Invalid("%s is too small" % token)


def text(kind: Any, token: str) -> None:
    """Raises Invalid unless the token is such a text."""
    try:
        value = json.loads(token) if token.startswith('"') else token
    except ValueError:
        raise Invalid("%r is not a JSON string" % token[:60]) from None
    if token != (value if BARE.fullmatch(value) else json.dumps(value)):
        raise Invalid("%r is not a text as the format has it" % token[:60])
    if not kind[1] <= len(value) <= kind[2] or set(value) - set(kind[3]):
        raise Invalid("%r is too short, too long or has another letter" % token[:60])


def parameter(kind: Any, tokens: List[str]) -> None:
    """Takes a value of that type from the tokens, of which the next is last. Raises Invalid, IndexError."""
    name = kind[0]
    if name == "tuple":
        for part in kind[1]:
            parameter(part, tokens)
    elif name in ("list", "dict"):
        count = tokens.pop()
        if not INTEGER.fullmatch(count) or len(count) > MOST_CASES or not kind[-2] <= int(count):
            raise Invalid("%r is not a length" % count[:60])
        if kind[-1] is not None and int(count) > kind[-1]:
            raise Invalid("%s items are too many" % count)
        keys = []
        for _ in range(int(count)):
            keys.append(tokens[-1])
            for part in kind[1:-2]:
                parameter(part, tokens)
        if name == "dict":
            keys = [json.loads(each) if each[0] == '"' or kind[1][0] == "int" else each for each in keys]
            if keys != sorted(set(keys)):
                raise Invalid("the keys are not in order, or one is there twice")
    elif name == "optional":
        if tokens[-1] != "none":
            parameter(kind[1], tokens)
        else:
            tokens.pop()
    elif name == "text":
        text(kind, tokens.pop())
    elif name in ("word", "bool"):
        word = tokens.pop()
        if word not in (kind[1] if name == "word" else ("true", "false")):
            raise Invalid("%r is none of the words" % word[:60])
    else:
        number(kind, tokens.pop())


def validate(data: bytes) -> None:
    """Raises Invalid unless these are the bytes of an input."""
    if INPUTS:
        if hashlib.sha256(data).hexdigest() not in INPUTS:
            raise Invalid("not an input of this package: export the package again")
        return
    try:
        lines = data.decode("ascii").split("\n")
    except UnicodeDecodeError:
        raise Invalid("a byte that is not ASCII") from None
    first = lines[0]
    if not re.fullmatch("[1-9][0-9]*", first) or len(first) > MOST_CASES:
        raise Invalid("the first line is not a number of cases")
    if len(lines) != int(first) + 2 or lines[-1]:
        raise Invalid("%s cases, then each on a line of its own, are expected" % first)
    for at, line in enumerate(lines[1:-1]):
        tokens = TOKEN.findall(line)[::-1]
        try:
            if " ".join(tokens[::-1]) != line:
                raise Invalid("tokens are separated by one blank each")
            for kind in PARAMETERS:
                parameter(kind, tokens)
        except IndexError:
            raise Invalid("case %d: the line ends too early" % (at + 1)) from None
        except Invalid as why:
            raise Invalid("case %d: %s" % (at + 1, why)) from None
        if tokens:
            raise Invalid("case %d: the line holds more than the case" % (at + 1))


def main() -> int:
    """The exit status."""
    try:
        validate(sys.stdin.buffer.read())
    except Invalid as why:
        sys.stderr.write("%s\n" % why)
        return 43
    return 42


if __name__ == "__main__":
    sys.exit(main())
