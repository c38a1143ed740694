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
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[^ ]+')
BARE = re.compile(r'(?!")(?!none\Z)[!-~]+')
JSON = re.compile(r'"[^\n]*"|-?[0-9][0-9.e+-]{,399}|true|false')
MOST = 7  # digits of the number of cases, or of items
TYPES = {"int": (int,), "real": (int, float), "bool": (bool,), "word": (str,), "text": (str,)}


class Invalid(Exception):  # noqa: N818
    """Why an input is invalid."""


def leaf(kind: Any, token: str) -> Any:
    """The value of that type which is written so, and can be in no other way. Raises Invalid."""
    name = kind[0]
    if name in ("word", "text") and BARE.fullmatch(token):
        value = token  # type: Any
    else:
        try:
            value = json.loads(token) if JSON.fullmatch(token) else None
        except ValueError:
            value = None
    bare = isinstance(value, str) and BARE.fullmatch(value)
    if type(value) not in TYPES[name] or token != (value if bare else json.dumps(value)):
        raise Invalid("%r is not as Python writes a value of this type" % token[:60])
    if name == "word" and value not in kind[1]:
        raise Invalid("%r is none of the words" % token[:60])
    if name == "text" and (not kind[1] <= len(value) <= kind[2] or set(value) - set(kind[3])):
        raise Invalid("%r is too short, too long or has another letter" % token[:60])
    if name in ("int", "real"):
        low, high, smallest = [Fraction(*bound) for bound in kind[1:]]
        if not low <= value <= high or 0 < abs(value) < smallest:
            raise Invalid("%s is out of bounds" % token)
    return value


def parameter(kind: Any, tokens: List[str]) -> Any:
    """A value of that type from the tokens, of which the next is last. Raises Invalid, IndexError."""
    name = kind[0]
    if name == "tuple":
        return [parameter(part, tokens) for part in kind[1]]
    if name in ("list", "dict"):
        count = tokens.pop()
        if not re.fullmatch("0|[1-9][0-9]*", count) or len(count) > MOST or not kind[-2] <= int(count):
            raise Invalid("%r is not a length" % count[:60])
        if kind[-1] is not None and int(count) > kind[-1]:
            raise Invalid("%s items are too many" % count)
        items = [[parameter(part, tokens) for part in kind[1:-2]] for _ in range(int(count))]
        keys = [item[0] for item in items]
        if name == "dict" and keys != sorted(set(keys)):
            raise Invalid("the keys are not in order, or one is there twice")
        return items
    if name == "optional":
        return parameter(kind[1], tokens) if tokens[-1] != "none" else tokens.pop()
    return leaf(kind, tokens.pop())


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
    if not re.fullmatch("[1-9][0-9]*", first) or len(first) > MOST:
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
