"""What stands in the box: mutants by the hundred, some with other numbers.

Ints that wrap, floats of fewer bits, so many digits; rounded in and out; texts that are cut or turned. This
file is handed to the contained process by itself: standard library only, and no import of judge.
"""

from __future__ import annotations

import copy
import decimal
import marshal
import math
import operator
import pickle
import signal
from array import array
from contextlib import suppress
from fractions import Fraction

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_LADDERS = {  # what is changed, by the numbers that it may be changed to, the worst first
    "int{} that wraps": (8, 16, 32, 64, 128),
    "int{} that saturates": (8, 16, 32, 64, 128),
    "floats of {} bits": (8, 11, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 53),
    "Decimal of {} digits": (
        *(6, 9, 12, 15, 17, 20, 28, 34, 40, 50, 77, 100, 150, 200, 250),
        *(300, 350, 400, 500, 700, 1000, 1400, 2000),
    ),
    "answer rounded to {} decimals": (4, 6, 8, 9, 10, 12, 15),
    "answer of {} digits": (4, 6, 8, 9, 10, 12, 15),
    "input rounded to {} decimals": (4, 6, 8, 9, 10, 12, 15),
    "input of {} digits": (4, 6, 8, 9, 10, 12, 15),
    "input as floats of {} bits": (24,),
    "input as whole numbers": (0,),
}
# What people do to a text; the number says of which parameter, or -1 of the answer.
TEXTS: dict[str, Callable[[str], str]] = {
    "{} without blanks at the ends": str.strip,
    "{} in small letters": str.lower,
    "{} in large letters": str.upper,
    "{} backwards": lambda text: text[::-1],
    "{} without the first letter": lambda text: text[1:],
    "{} without the last letter": lambda text: text[:-1],
    "{} cut after 32 letters": lambda text: text[:32],
    "{} cut after 64 letters": lambda text: text[:64],
    "{} cut after 255 letters": lambda text: text[:255],
}
_WHOLE = tuple(_LADDERS)[:4]  # where all numbers are ints
_ALONE: dict[str, Callable[[Any], Any]] = {
    "hash": hash, "float": float, "int": int, "trunc": int, "index": operator.index, "bool": bool,
}  # fmt: skip
_OPERATORS = {  # as operator calls them, and as a context of decimal does
    "add": "add", "sub": "subtract", "mul": "multiply", "truediv": "divide", "neg": "minus",
    "floordiv": "divide_int", "mod": "remainder", "pow": "power", "abs": "abs",
}  # fmt: skip
SECONDS = 0.25  # of CPU that a call may take; after one that takes longer none is made

Made = tuple[str, str, int]  # a program's code, and its numbers where they are others


class _Asked:
    """What a process is asked about, and what the last mutant answers otherwise than its base."""

    entry: str
    given: list[bytes]
    right: list[tuple[Callable[..., Any], dict[int, bytes | None]]]  # and its answers
    answers: list[Any]


def ask(what: str, *given: Any) -> Any:
    """All that the box is asked."""
    steps: dict[str, Callable[..., Any]] = {"begin": _begin, "differ": _differ, "answer": _answer}
    return steps[what](*given)


def _begin(entry: str, right: list[Made], cases: list[list[Any]]) -> None:
    """What is called, the right programs, and cases for all of the mutants that come then.

    An array arrives as its code and its bytes.
    """
    packed = [
        [array(*x) if type(x) is tuple and bytes in map(type, x) else x for x in case] for case in cases
    ]
    _Asked.entry, _Asked.given = entry, [pickle.dumps(case) for case in packed]
    _Asked.right = [(_within(_loaded, made), {}) for made in right]


def _differ(base: int, made: Made, first: int, last: int, most: int) -> list[int]:
    """The first places where a mutant answers otherwise than its base, to the last bit; of -1 all places."""
    _Asked.answers, found = [], list[int]()
    function: Any = None
    for place in range(first, last):
        if len(found) == most:
            break
        try:
            function = function or _within(_loaded, made)
            answer = _within(function, *pickle.loads(_Asked.given[place]))
            if base >= 0 and _dumped(answer) == _usual(base, place) is not None:
                continue
            answer = copy.deepcopy(answer)  # the next call may change it
        except Exception as error:
            answer = error.with_traceback(None)
        found.append(place)
        _Asked.answers.append(answer)
        if function is None or isinstance(answer, TimeoutError):
            break
    return found


def _answer(at: int) -> Any:
    """What it answers at one of those places."""
    answer = _Asked.answers[at] if at < len(_Asked.answers) else None
    if isinstance(answer, Exception):
        raise answer
    return answer


def _usual(base: int, place: int) -> bytes | None:
    function, known = _Asked.right[base]
    if place not in known:
        known[place] = None
        with suppress(Exception):
            known[place] = _dumped(_within(function, *pickle.loads(_Asked.given[place])))
    return known[place]


def _dumped(answer: Any) -> bytes | None:
    try:
        return marshal.dumps(answer, 2)
    except ValueError:  # of other types
        return None


def _loaded(made: Made) -> Callable[..., Any]:
    code, name, number = made
    names: dict[str, Any] = {"__name__": "submission"}
    exec(marshal.loads(code.encode("latin-1")), names)
    entry = _Asked.entry
    function = _in_a_row(names[entry[:-2]]) if entry.endswith("()") else names[entry]
    return changed(name, number, function, names) if name else function


def _in_a_row(made: Callable[..., Any]) -> Callable[..., Any]:
    """What makes an object of a class, and the calls that are its last argument."""

    def call(*arguments: Any) -> list[Any]:
        *own, calls = arguments
        one = made(*own)
        return [copy.deepcopy(getattr(one, name)(*given)) for name, *given in calls]

    return call


def _within(function: Callable[..., Any], *given: Any) -> Any:
    """What it returns, unless it takes too long or leaves."""
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS, SECONDS)
    try:
        return function(*given)
    except Exception:
        raise
    except BaseException:
        raise RuntimeError("it left") from None
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)


def _late(*_: object) -> None:
    raise TimeoutError("it took too long")


signal.signal(signal.SIGVTALRM, _late)


def ladders(measured: bool) -> list[tuple[str, int]]:
    """(what is changed, to what) of programs with real numbers, or with ints alone; worse ones first."""
    chosen = _LADDERS if measured else _WHOLE
    return [(name, number) for name in chosen for number in _LADDERS[name]]


def changed(
    name: str, number: int, function: Callable[..., Any], names: dict[str, Any]
) -> Callable[..., Any]:
    """The function with other numbers or texts; `names` are those of its module."""
    if name in TEXTS:
        into = out = lambda x: TEXTS[name](x) if isinstance(x, str) else x
        return lambda *case: (
            each(function(*case), out)
            if number < 0
            else function(*[each(x, into) if at == number else x for at, x in enumerate(case)])
        )
    if name not in _KINDS:
        return _other_numbers(name, number, function, names)
    change = lambda x: x if _no_number(x) else _KINDS[name](x, number)  # noqa: E731
    if name.startswith("answer"):
        return lambda *case: each(function(*case), change)
    return lambda *case: function(*[each(x, change) for x in case])


def each(value: Any, change: Callable[[Any], Any]) -> Any:
    """The value with every part of it changed."""
    if isinstance(value, dict):
        return {each(key, change): each(item, change) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(each(item, change) for item in value)
    return change(value)


def _no_number(x: Any) -> bool:
    """Words and truth values are none."""
    return x is None or isinstance(x, bool | str)


def _of_digits(x: Any, digits: int) -> Any:
    return type(x)(float(f"{x:.{digits}g}"))


def _of_bits(x: Any, bits: int) -> Any:
    if not isinstance(x, float) or x == 0 or not math.isfinite(x):
        return x
    mantissa, exponent = math.frexp(x)
    return math.ldexp(round(math.ldexp(mantissa, bits)), exponent - bits)


_KINDS: dict[str, Callable[[Any, int], Any]] = {  # what becomes of a number of the input, or of the answer
    "answer rounded to {} decimals": lambda x, digits: round(x, digits) if isinstance(x, float) else x,
    "answer of {} digits": lambda x, digits: _of_digits(x, digits) if isinstance(x, float) else x,
    "input rounded to {} decimals": lambda x, digits: round(x, digits) if isinstance(x, float) else x,
    "input of {} digits": _of_digits,
    "input as floats of {} bits": lambda x, bits: _of_bits(float(x), bits),
    "input as whole numbers": lambda x, _: round(x),
}


def _decimal(x: Any) -> decimal.Decimal:
    return decimal.Decimal(x.numerator) / x.denominator if isinstance(x, Fraction) else decimal.Decimal(x)


def _other_numbers(
    name: str, number: int, function: Callable[..., Any], names: dict[str, Any]
) -> Callable[..., Any]:
    """The function where every number is of one class, and so is what is made of numbers."""
    own: Any = operator  # what knows add, sub and the others
    load: Any = lambda x: x  # noqa: E731
    fit: Any
    root: Any = math.sqrt
    half = 1 << number - 1
    if name == "int{} that wraps":
        fit = lambda x: (x + half) % (2 * half) - half if isinstance(x, int) else x  # noqa: E731
    elif name == "int{} that saturates":
        fit = lambda x: max(-half, min(half - 1, x)) if isinstance(x, int) else x  # noqa: E731
    elif name == "floats of {} bits":
        load, fit = float, lambda x: _of_bits(x, number)
    else:
        traps = [decimal.InvalidOperation, decimal.DivisionByZero]
        own = decimal.Context(prec=number, Emax=10**8, Emin=-(10**8), traps=traps)
        load, fit, root = _decimal, own.plus, own.sqrt

    class Number:
        __slots__ = ("v",)

        def __init__(self, v: Any) -> None:
            self.v = v

        def __round__(self, digits: int | None = None) -> Any:
            return round(self.v, digits)

    def raw(x: Any) -> Any:
        return x.v if isinstance(x, Number) else load(x)

    for word, alone in _ALONE.items():
        setattr(Number, f"__{word}__", lambda a, do=alone: do(a.v))
    for word, other in _OPERATORS.items():
        do = getattr(own, word if own is operator else other)
        if word in ("neg", "abs"):
            setattr(Number, f"__{word}__", lambda a, do=do: Number(fit(do(a.v))))
            continue
        setattr(Number, f"__{word}__", lambda a, b, do=do: Number(fit(do(a.v, raw(b)))))
        setattr(Number, f"__r{word}__", lambda a, b, do=do: Number(fit(do(raw(b), a.v))))
    for word in ("lt", "le", "gt", "ge", "eq", "ne"):
        do = getattr(operator, word)
        setattr(Number, f"__{word}__", lambda a, b, do=do: b is not None and do(a.v, raw(b)))

    def hypot(*parts: Any) -> Any:
        total: Any = Number(fit(load(0)))
        for part in parts:
            square: Any = Number(raw(part))
            total = total + square * square
        return Number(fit(root(total.v)))

    tools: dict[str, Any] = {
        "sqrt": lambda x: Number(fit(root(raw(x)))),
        "hypot": hypot,
        "fabs": abs,
        "copysign": lambda a, b: abs(a) if raw(b) >= 0 else -abs(a),
    }
    names.update((word, tool) for word, tool in tools.items() if word in names)
    if "math" in names:
        own = {word: staticmethod(tool) if callable(tool) else tool for word, tool in vars(math).items()}
        names["math"] = type("math", (), own | {word: staticmethod(tool) for word, tool in tools.items()})

    def plain(x: Any) -> Any:
        found = x.v if isinstance(x, Number) else x
        if isinstance(found, decimal.Decimal):
            return int(found) if found == int(found) else float(found)
        return found

    def made(x: Any) -> Any:
        return x if _no_number(x) else Number(fit(load(x)))

    return lambda *case: each(function(*[each(value, made) for value in case]), plain)
