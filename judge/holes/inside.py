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
_TOOLS = ("sqrt", "hypot", "fabs", "copysign")
SECONDS = 0.25  # of CPU that a call may take; after one that takes longer none is made

Made = tuple[str, str, int]  # a program's code, and its numbers where they are others
_functions: dict[int, Any] = {}


def ask(place: int, entry: str, made: Made | None, *case: Any) -> Any:
    """What the mutant of that place answers; `made` comes with its first case."""
    if made is not None:
        _functions[place] = None  # for the calls after an import that fails
        _functions[place] = _within(_loaded, entry, *made)
    try:
        return _within(_functions[place], *case)
    except TimeoutError:
        _functions[place] = None
        raise


def differ(
    entry: str, right: list[Made], some: list[tuple[int, Made]], cases: list[tuple[Any, ...]]
) -> list[int]:
    """Where mutants answer otherwise than the right program that each is made from, to the last bit.

    The place of a mutant times the number of cases, plus that of the case.
    """
    given = [pickle.dumps(case) for case in cases]
    usual = [_all_answers(entry, made, given) for made in right]
    found = []
    for place, (base, made) in enumerate(some):
        own = _all_answers(entry, made, given)
        found += [
            place * len(cases) + at for at, each in enumerate(own) if each is None or each != usual[base][at]
        ]
    return found


def _all_answers(entry: str, made: Made, given: list[bytes]) -> list[bytes | None]:
    try:
        function = _within(_loaded, entry, *made)
    except Exception:
        return [None] * len(given)
    found: list[bytes | None] = []
    for case in given:
        try:
            found.append(marshal.dumps(_within(function, *pickle.loads(case)), 2))
        except TimeoutError:
            break
        except Exception:
            found.append(None)
    return found + [None] * (len(given) - len(found))


def _loaded(entry: str, code: str, name: str, number: int) -> Callable[..., Any]:
    names: dict[str, Any] = {"__name__": "submission"}
    exec(marshal.loads(code.encode("latin-1")), names)
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
    """The function with other numbers; `names` are those of its module."""
    if name in TEXTS:
        return _other_texts(TEXTS[name], number, function)
    into, out = _KINDS.get(name, (None, None))
    if into is None and out is None:
        return _other_numbers(name, number, function, names)

    def call(*case: Any) -> Any:
        given = [each(value, lambda x: into(x, number)) for value in case] if into else case
        answer = function(*given)
        return each(answer, lambda x: out(x, number)) if out else answer

    return call


def _other_texts(
    change: Callable[[str], str], place: int, function: Callable[..., Any]
) -> Callable[..., Any]:
    def call(*case: Any) -> Any:
        answer = function(
            *[_each_text(each, change) if at == place else each for at, each in enumerate(case)]
        )
        return answer if place >= 0 else _each_text(answer, change)

    return call


def _each_text(value: Any, change: Callable[[str], str]) -> Any:
    """The value with every text in it changed."""
    if isinstance(value, dict):
        return {_each_text(key, change): _each_text(item, change) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(_each_text(item, change) for item in value)
    return change(value) if isinstance(value, str) else value


def _rounded(x: Any, decimals: int) -> Any:
    return round(x, decimals) if isinstance(x, float) else x


def _of_digits(x: Any, digits: int) -> Any:
    return float(f"{x:.{digits}g}") if isinstance(x, float) else x


def _all_of_digits(x: Any, digits: int) -> Any:
    return type(x)(float(f"{x:.{digits}g}"))


def _of_bits(x: Any, bits: int) -> Any:
    if not isinstance(x, float) or x == 0 or not math.isfinite(x):
        return x
    mantissa, exponent = math.frexp(x)
    return math.ldexp(round(math.ldexp(mantissa, bits)), exponent - bits)


_KINDS: dict[str, tuple[Any, Any]] = {  # what becomes of the input, and of the answer
    "answer rounded to {} decimals": (None, _rounded),
    "answer of {} digits": (None, _of_digits),
    "input rounded to {} decimals": (_rounded, None),
    "input of {} digits": (_all_of_digits, None),
    "input as floats of {} bits": (lambda x, bits: _of_bits(float(x), bits), None),
    "input as whole numbers": (lambda x, _: round(x), None),
}


def each(value: Any, change: Callable[[Any], Any]) -> Any:
    """The value with every number in it changed; words and truth values are none."""
    if isinstance(value, dict):
        return {key: each(item, change) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(each(item, change) for item in value)
    return value if value is None or isinstance(value, bool | str) else change(value)


def _other_numbers(
    name: str, number: int, function: Callable[..., Any], names: dict[str, Any]
) -> Callable[..., Any]:
    """The function where every number is of one class, and so is what is made of numbers."""
    context = None
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
        context = decimal.Context(prec=number, Emax=10**8, Emin=-(10**8), traps=traps)
        load, fit, root = _decimal, context.plus, context.sqrt
    kind = _class(load, fit, root, context)
    names.update((tool, kind.tools[tool]) for tool in _TOOLS if tool in names)
    if "math" in names:
        own = {word: staticmethod(tool) if callable(tool) else tool for word, tool in vars(math).items()}
        names["math"] = type("math", (), own | {word: staticmethod(kind.tools[word]) for word in _TOOLS})

    def plain(x: Any) -> Any:
        found = x.v if isinstance(x, kind) else x
        if isinstance(found, decimal.Decimal):
            return int(found) if found == int(found) else float(found)
        return found

    return lambda *case: each(function(*[each(value, lambda x: kind(fit(load(x)))) for value in case]), plain)


def _decimal(x: Any) -> decimal.Decimal:
    return decimal.Decimal(x.numerator) / x.denominator if isinstance(x, Fraction) else decimal.Decimal(x)


def _class(load: Any, fit: Any, root: Any, context: decimal.Context | None) -> Any:
    class Number:
        __slots__ = ("v",)
        tools: dict[str, Any]

        def __init__(self, v: Any) -> None:
            self.v = v

        def __hash__(self) -> int:
            return hash(self.v)

        def __float__(self) -> float:
            return float(self.v)

        def __int__(self) -> int:
            return int(self.v)

        __trunc__ = __int__

        def __index__(self) -> int:
            return operator.index(self.v)

        def __bool__(self) -> bool:
            return bool(self.v)

        def __neg__(self) -> Any:
            return Number(fit(-self.v if context is None else context.minus(self.v)))

        def __abs__(self) -> Any:
            return Number(fit(abs(self.v) if context is None else context.abs(self.v)))

        def __round__(self, digits: int | None = None) -> Any:
            return round(self.v, digits)

    def raw(x: Any) -> Any:
        return x.v if isinstance(x, Number) else load(x)

    own: dict[str, str] = {
        "add": "add", "sub": "subtract", "mul": "multiply", "truediv": "divide",
        "floordiv": "divide_int", "mod": "remainder", "pow": "power",
    }  # fmt: skip
    for name, word in own.items():
        plain = getattr(operator, name) if context is None else getattr(context, word)
        setattr(Number, f"__{name}__", lambda a, b, do=plain: Number(fit(do(a.v, raw(b)))))
        setattr(Number, f"__r{name}__", lambda a, b, do=plain: Number(fit(do(raw(b), a.v))))
    for name in ("lt", "le", "gt", "ge", "eq", "ne"):
        plain = getattr(operator, name)
        setattr(Number, f"__{name}__", lambda a, b, do=plain: b is not None and do(a.v, raw(b)))

    def hypot(*parts: Any) -> Any:
        total: Any = Number(fit(load(0)))
        for part in parts:
            square: Any = Number(raw(part))
            total = total + square * square
        return Number(fit(root(total.v)))

    Number.tools = {
        "sqrt": lambda x: Number(fit(root(raw(x)))),
        "hypot": hypot,
        "fabs": abs,
        "copysign": lambda a, b: abs(a) if raw(b) >= 0 else -abs(a),
    }
    return Number
