"""Output validator: every number must lie between two exact ends, decided in integers and never rounded.

usage: validate.py INPUT ANSWER FEEDBACK_DIR < output    42 accepted, 43 wrong, 1 the package is inconsistent

accepted.json beside this file says of what type an answer is and, by the SHA-256 of each input file, what is
accepted for each of its cases:

    ["real"]                 [a, b, s]: from a/s to b/s
                             [a, b, c, d, r, s]: from (a + b*sqrt(r))/s to (c + d*sqrt(r))/s
    ["int"], ["bool"], ["word", [word, …]], ["text", low, high, letters]
                             the same; ["int", low, high] and ["real", low, high] have bounds
    ["tuple", [type, …]]     what is accepted for each part
    ["list", type, low, high]    the same for each item, of which there are low to high (null: no bound)
    ["dict", key, value, low, high]    [[key, what is accepted there], …], in the order of the keys
    ["optional", type]       null where the answer is none
    ["returns", [type, …]]   of calls in a row [[place of its type, what is accepted], …]; null: anything
    any of these             {"any": […]}: each of several is right
                             {"judged": group, "case": "(…)", "at": […]}: what is in that place of what
                             `solve` of validate_problem.py gives for the case says why an answer is wrong

A case is there as Python writes it. Where `whole` is there, the whole output is one answer: of "tokens", or
what FORMAT.read of validate_problem.py makes of it; with "talk" validate_talk.py holds a dialogue about the
case. validate_declare.py stands for the judge's own module.

Needs Python 3.6 or newer, CPython or PyPy, and nothing else.
"""

import hashlib
import json
import os
import re
import sys
from ast import literal_eval
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from typing import Any, List, NamedTuple

DECIMAL = re.compile(r"(?!.{2001})[+-]?(?=\.?[0-9])[0-9]*(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?")
INTEGER = re.compile(r"[+-]?[0-9]{1,400}")
TRUTH = re.compile("true|false")
FOREIGN = re.compile(r"[^\t -~]")
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|\S+')
MOST_EXPONENT, LONGEST_TEXT = 5000, 1000000
TABLE = "accepted.json"


class Wrong(Exception):  # noqa: N818
    """Why an output is wrong."""


class Number(NamedTuple):
    """A real number, and what a checker is given for it: an int, its double, or a Fraction."""

    exact: Fraction
    plain: Any


def sign(p: int, q: int, r: int) -> int:
    """The sign of p + q*sqrt(r)."""
    if q == 0 or r == 0:
        return (p > 0) - (p < 0)
    if p == 0 or (p > 0) == (q > 0):
        return 1 if q > 0 else -1
    gap = p * p - q * q * r
    return ((gap > 0) - (gap < 0)) * (1 if p > 0 else -1)


def order(p: int, q: int, r: int, s: int, y: Fraction) -> int:
    """The sign of (p + q*sqrt(r))/s - y."""
    return sign(p * y.denominator - y.numerator * s, q * y.denominator, r)


def words_of(line: str) -> List[str]:
    """The tokens of a line; the next one is the last."""
    if line.endswith("\r"):
        line = line[:-1]
    if FOREIGN.search(line):
        raise Wrong("the output is not plain ASCII text")
    words = TOKEN.findall(line)[::-1]
    if not words:
        raise Wrong("an empty line where an answer is expected")
    return words


def like(form: Any, token: str, what: str) -> str:
    """The token, which must have that form."""
    if not form.fullmatch(token):
        raise Wrong("%r where %s is expected" % (token[:60], what))
    return token


def integer(token: str) -> int:
    """A token as a plain integer."""
    return int(like(INTEGER, token, "a plain integer"))


def text(token: str) -> str:
    """A token as a text."""
    if len(token) > LONGEST_TEXT:
        raise Wrong("a text of more than %d characters" % LONGEST_TEXT)
    try:
        found = json.loads(token) if token.startswith('"') else token
    except ValueError:
        raise Wrong("%r is not a JSON string" % token[:60]) from None
    return str(found)


def truth(token: str) -> bool:
    """A token as a bool."""
    return like(TRUTH, token, "true or false") == "true"


def number(token: str) -> Number:
    """A token as a plain decimal."""
    power = like(DECIMAL, token, "a plain decimal").lower().partition("e")[2] or "0"
    if len(power) > 6 or abs(int(power)) > MOST_EXPONENT:
        raise Wrong("%r has an exponent beyond %d" % (token[:60], MOST_EXPONENT))
    exact = Fraction(token)
    own = int(token) if token.lstrip("+-").isdigit() else float(token)  # type: Any
    return Number(exact, own if own - own == 0 else exact)


LEAVES = {"real": number, "int": integer, "word": str, "text": text, "bool": truth}  # type: Any
PLAIN = {"int": int, "word": str, "text": str, "bool": bool}


def taken(kind: Any, words: List[str]) -> Any:
    """The value of that type which the next tokens hold."""
    if not words:
        raise Wrong("the line ends too early")
    name = kind[0]
    if name == "tuple":
        return tuple([taken(part, words) for part in kind[1]])
    if name == "list":
        return items(kind, words)
    if name == "dict":
        return keyed(items, kind, words)
    if name != "optional":
        return LEAVES[name](words.pop())
    if words[-1] == "none":
        words.pop()
        return None
    if words[-1].lower() in ("none", "null") and kind[1][0] != "text":
        raise Wrong("write none in lower case")
    return taken(kind[1], words)


def items(kind: Any, words: List[str]) -> List[Any]:
    """The length of a list, and so many items."""
    low, high = kind[2:]
    count, left = integer(words.pop()), len(words)
    if count < low or (high is not None and count > high) or count > left:
        raise Wrong("a list of %s items, with %d tokens left" % (str(count)[:20], left))
    return [taken(kind[1], words) for _ in range(count)]


def keyed(way: Any, kind: Any, entries: Any) -> Any:
    """The dict of the entries, taken that way as a list, in the order of the keys."""
    found = way(["list", ["tuple", kind[1:3]], *kind[3:]], entries)
    if len(dict(found)) < len(found):
        raise Wrong("a key is there twice")
    return dict(sorted(found, key=lambda each: each[0]))


def given(kind: Any, value: Any) -> Any:
    """The same out of what FORMAT.read returns."""
    name, own = kind[0], type(value)
    if name == "optional":
        return None if value is None else given(kind[1], value)
    if name == "real" and own is Decimal:
        return number(str(value))
    if name == "real" and own in (int, float, Fraction) and value - value == 0:
        return Number(Fraction(value), value)
    if name == "dict" and isinstance(value, dict):
        return keyed(given, kind, list(value.items()))
    if name in ("tuple", "list") and own in (tuple, list):
        low, high = kind[2:] if name == "list" else [len(kind[1])] * 2
        if low <= len(value) and (high is None or len(value) <= high):
            return (tuple if name == "tuple" else list)([given(*each) for each in pairs(kind, value)])
    elif own is PLAIN.get(name) or (name == "returns" and own in (tuple, list)):
        return value
    raise Wrong("%s where another answer is expected" % ascii(value)[:60])


def pairs(kind: Any, value: Any) -> Any:
    """The parts of a tuple or the items of a list, each after its type."""
    return zip(kind[1] if kind[0] == "tuple" else [kind[1]] * len(value), value)


def plain(kind: Any, value: Any) -> Any:
    """A value as a checker is given it, which is not asked about what is beyond the bounds. Raises Wrong."""
    name = kind[0]
    if value is None:
        return None
    if name == "optional":
        return plain(kind[1], value)
    if name == "dict":
        return {plain(kind[1], key): plain(kind[2], each) for key, each in value.items()}
    if name in ("tuple", "list"):
        return type(value)([plain(*each) for each in pairs(kind, value)])
    if name == "text":
        within = kind[1] <= len(value) <= kind[2] and not set(value) - set(kind[3])
    elif name == "word":
        within = value in kind[1]
    else:
        within = not kind[1:] or kind[1] <= (value.exact if name == "real" else value) <= kind[2]
    if not within:
        raise Wrong("out of bounds")
    return value.plain if name == "real" else value


def brought() -> Any:
    """The problem's own problem.py."""
    sys.modules["judge.problem.declare"] = import_module("validate_declare")
    return import_module("validate_problem")


def why_not(kind: Any, value: Any, wanted: Any) -> Any:
    """What the problem's own checker says of a value; None where it is right."""
    try:
        value = plain(kind, value)
    except Wrong as why:
        return why
    found = brought().solve(*literal_eval(wanted["case"]))
    for step in wanted["at"]:
        found = sorted(found.items()) if isinstance(found, dict) else getattr(found, "answers", found)
        found = found[step]
    return found.why_not(value, wanted["judged"])


def held(kind: Any, value: Any, wanted: Any, where: str) -> None:
    """Raises Wrong unless the value is what is wanted."""
    if isinstance(wanted, dict) and "any" in wanted:
        if not any(fits(kind, value, each) for each in wanted["any"]):
            raise Wrong("%s is none of the right ones" % where)
        return
    if isinstance(wanted, dict):
        why = why_not(kind, value, wanted)
        if why is not None:
            raise Wrong("%s: %s" % (where, why))
        return
    name = kind[0]
    if name == "optional":
        if (value is None) != (wanted is None):
            why = "none given, but there is one" if value is None else "none wanted"
            raise Wrong("%s: %s" % (where, why))
        if value is not None:
            held(kind[1], value, wanted, where)
    elif name == "real":
        a, b, c, d, r, s = wanted if len(wanted) == 6 else (wanted[0], 0, wanted[1], 0, 0, wanted[2])
        if order(a, b, r, s, value.exact) > 0 or order(c, d, r, s, value.exact) < 0:
            raise Wrong("%s is off" % where)
    elif name in ("tuple", "list"):
        if len(value) != len(wanted):  # of a list
            raise Wrong("%s has %d items, %d wanted" % (where, len(value), len(wanted)))
        what = "part" if name == "tuple" else "item"
        for at, (own, each) in enumerate(zip(pairs(kind, value), wanted), 1):
            held(own[0], own[1], each, "%s %d of %s" % (what, at, where))
    elif name == "dict":
        own = dict(wanted)
        for key in sorted({*own, *value}):
            told = ascii(key)[:60]
            if key not in value or key not in own:
                fault = "%s has no entry %s" if key in own else "%s has an entry %s too many"
                raise Wrong(fault % (where, told))
            held(kind[2], value[key], own[key], "entry %s of %s" % (told, where))
    elif name == "returns":
        if len(value) != len(wanted):
            raise Wrong("%d answers, %d wanted" % (len(value), len(wanted)))
        for at, (place, each) in enumerate(wanted):
            if kind[1][place] is not None:
                own = kind[1][place]
                held(own, given(own, value[at]), each, "answer %d" % (at + 1))
    elif value != wanted:  # an int, a bool, a word, a text
        raise Wrong("%s is %s, %s wanted" % (where, ascii(value)[:60], ascii(wanted)[:60]))


def fits(kind: Any, value: Any, wanted: Any) -> bool:
    """Whether the value is what is wanted."""
    try:
        held(kind, value, wanted, "")
    except Wrong:
        return False
    return True


def check(kind: Any, line: str, wanted: Any) -> None:
    """Raises Wrong unless a line of output is the answer that is wanted."""
    words = words_of(line)
    value = taken(kind, words)
    if words:
        raise Wrong("%r after the answer" % words[-1][:60])
    held(kind, value, wanted, "the answer")


def text_of(output: bytes) -> str:
    """An output as text, in which what is not UTF-8 stays."""
    return output.decode("utf-8", "backslashreplace").replace("\r\n", "\n")


def decide_whole(kind: Any, wanted: Any, how: str) -> None:
    """Raises Wrong unless a program is right whose whole output is one answer, or is talked with."""
    if how == "talk":
        why = import_module("validate_talk").why_not(brought().FORMAT.talk, literal_eval(wanted))
        if why is not None:
            raise Wrong(why)
        return
    output = sys.stdin.buffer.read()
    if how == "tokens":
        check(kind, " ".join(text_of(output).splitlines()), wanted)
        return
    read = brought().FORMAT.read
    try:
        value = given(kind, read(text_of(output)))
    except (Wrong, ValueError) as why:
        raise Wrong(str(why) or "the output cannot be read") from None
    except Exception as fault:  # of an output that the setter did not think of
        raise Wrong("the output cannot be read: %s" % type(fault).__name__) from None
    held(kind, value, wanted, "the answer")


def decide(kind: Any, wanted: Any, output: bytes) -> None:
    """Raises Wrong unless an output is right: a line for each case, and blank ones at its end."""
    lines = text_of(output).split("\n")
    while lines and not lines[-1].strip(" \t"):
        lines.pop()
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
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), TABLE), encoding="utf-8") as file:
        table = json.load(file)
    if key not in table["files"]:
        sys.stderr.write("%s is not an input of this package: export the package again\n" % sys.argv[1])
        return 1
    try:
        kind, wanted = table.get("answer"), table["files"][key]
        if "whole" in table:
            decide_whole(kind, wanted[0], table["whole"])
        else:
            decide(kind, wanted, sys.stdin.buffer.read())
    except Wrong as why:
        path = os.path.join(sys.argv[3], "judgemessage.txt")
        with open(path, "a", encoding="utf-8", errors="backslashreplace") as file:
            file.write("%s\n" % why)
        return 43
    return 42


if __name__ == "__main__":
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # the ends are long, and our own
    sys.exit(main())
