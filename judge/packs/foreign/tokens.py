r"""The default output validator: two texts compared token by token, as the C++ program of Kattis does it.

It is the C library that says what is a space and what is a number there, and it is followed to the letter:

    spaces     the six of `isspace`; a token ends at its first NUL where it is compared
    letters    only A to Z have another case
    numbers    what `%lf` takes whole: `.5`, `1.`, `0x1p-3`, also `1e` and `0x1p+`, whose exponent is missing;
               `1e400`, `inf` and `nan` are words
    near       not (|a−b| ≤ absolute) and not (|a−b| ≤ relative·|a|) is wrong, in doubles; a is the answer's
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from msgspec import Struct

_DECIMAL = re.compile(rb"([+-]?(?=\.?[0-9])[0-9]*(?:\.[0-9]*)?)(?:[eE]([+-]?[0-9]*))?")
_HEX = re.compile(rb"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?[0-9]*))?")
_PARTED = re.compile(rb"([ \t\n\v\f\r]*)([^ \t\n\v\f\r]*)")
_SHOWN = 40  # bytes of a token
_UNSET = -1.0


class BadFlagsError(Exception):
    """Arguments that the validator does not take."""


class Rules(Struct, frozen=True):
    """How tokens are compared; a tolerance below 0 is none."""

    case_sensitive: bool = False
    space_change_sensitive: bool = False
    absolute: float = _UNSET
    relative: float = _UNSET

    @property
    def near(self) -> bool:
        """Whether numbers are compared as numbers."""
        return self.absolute >= 0 or self.relative >= 0


def rules_of(flags: Sequence[str]) -> Rules:
    """The rules that arguments come to, later ones over earlier ones. Raises BadFlagsError."""
    case = space = False
    absolute = relative = _UNSET
    rest = iter(flags)
    for flag in rest:
        match flag:
            case "case_sensitive":
                case = True
            case "space_change_sensitive":
                space = True
            case "float_absolute_tolerance":
                absolute = _tolerance(flag, rest)
            case "float_relative_tolerance":
                relative = _tolerance(flag, rest)
            case "float_tolerance":
                absolute = relative = _tolerance(flag, rest)
            case _:
                raise BadFlagsError(f"the default output validator takes no {flag[:40]!r}")
    return Rules(case, space, absolute, relative)


def _tolerance(flag: str, rest: Iterator[str]) -> float:
    word = next(rest, None)
    found = None if word is None else as_number(word.encode(errors="surrogateescape"))
    if found is None:
        raise BadFlagsError(f"{flag} wants a number" + ("" if word is None else f", not {word[:40]!r}"))
    return found


def as_number(token: bytes) -> float | None:
    """The double that `%lf` reads where it reads the whole token and finds it finite; None otherwise."""
    found = _DECIMAL.fullmatch(token)
    if found:
        mantissa, exponent = found[1], found[2] or b""
        text = mantissa + (b"e" + exponent if exponent.lstrip(b"+-") else b"")
        value = float(text)
        return value if math.isfinite(value) else None
    return _hexadecimal(token)


def _hexadecimal(token: bytes) -> float | None:
    found = _HEX.fullmatch(token)
    if not found:
        return None
    sign, whole, part, exponent = found.groups()
    if not whole and not part:
        return None if part is None or exponent is not None else math.copysign(0.0, -1 if sign == b"-" else 1)
    power = exponent.decode() if exponent and exponent.lstrip(b"+-") else "0"
    try:
        value = float.fromhex(f"{sign.decode()}0x{whole.decode()}.{(part or b'').decode()}p{power}")
    except (OverflowError, ValueError):
        return None
    return value if math.isfinite(value) else None


def difference(answer: bytes, output: bytes, rules: Rules) -> str:
    """Why an output is wrong, in one line; "" where it is right."""
    if rules.space_change_sensitive:
        found = _spaced(answer, output, rules)
    else:
        found = _compared(answer.split(), output.split(), rules)
    return found


def _compared(wanted: Sequence[bytes], given: Sequence[bytes], rules: Rules) -> str:
    if rules.case_sensitive and not rules.near and wanted == given:
        return ""
    for place, (want, got) in enumerate(zip(wanted, given, strict=False), 1):
        why = _token(want, got, rules)
        if why:
            return f"token {place}: {why}"
    if len(given) < len(wanted):
        return f"it ends after {len(given):,} of {len(wanted):,} tokens, before {_quoted(wanted[len(given)])}"
    if len(given) > len(wanted):
        return f"there is more after the last of {len(wanted):,} tokens: {_quoted(given[len(wanted)])}"
    return ""


def _spaced(answer: bytes, output: bytes, rules: Rules) -> str:
    """As `_compared`, and the spaces between the tokens byte by byte."""
    wanted, given = _PARTED.findall(answer), _PARTED.findall(output)
    for place in range(max(len(wanted), len(given))):
        space, want = wanted[place] if place < len(wanted) else (b"", b"")
        own, got = given[place] if place < len(given) else (b"", b"")
        if space != own:
            return f"the space before token {place + 1} is {_quoted(own)}, not {_quoted(space)}"
        if want and not got:
            return f"it ends before token {place + 1}, {_quoted(want)}"
        if got and not want:
            return f"there is more after the last token: {_quoted(got)}"
        why = _token(want, got, rules) if want else ""
        if why:
            return f"token {place + 1}: {why}"
    return ""


def _token(want: bytes, got: bytes, rules: Rules) -> str:
    if want == got:
        return ""
    want, got = want.partition(b"\0")[0], got.partition(b"\0")[0]
    judged = as_number(want) if rules.near else None
    if judged is not None:
        return _number(judged, want, got, rules)
    same = want == got if rules.case_sensitive else want.lower() == got.lower()
    return "" if same else f"{_quoted(got)}, not {_quoted(want)}"


def _number(judged: float, want: bytes, got: bytes, rules: Rules) -> str:
    given = as_number(got)
    if given is None:
        return f"{_quoted(got)} is no number; {_quoted(want)} is wanted"
    off = abs(judged - given)
    if off <= rules.absolute or off <= rules.relative * abs(judged):
        return ""
    return f"{_quoted(got)}, not {_quoted(want)}: {off:.3g} off"


def _quoted(token: bytes) -> str:
    text = repr(token[:_SHOWN])[1:]
    return text if len(token) <= _SHOWN else f"{text}…"
