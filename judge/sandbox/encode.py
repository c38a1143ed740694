"""An answer as plain JSON, made inside the containment, next to code that nobody trusts.

    None, int within 64 bits, finite float     themselves
    list, tuple                                a list of encoded items
    a larger int                               {"int": "-1f…"}, hexadecimal
    fractions.Fraction                         {"fraction": ["numerator", "denominator"]}, hexadecimal
    decimal.Decimal                            {"decimal": "1.5"}
    numpy scalars and arrays                   the numbers they hold
    anything else, a wrong type                {"type": "bool", "text": "True"}

The mirror image is `judge.compare.decode`, which believes nothing of what it reads. Standard library only,
and no import of judge: this file is handed to the contained process by itself.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:  # importing typing takes longer than starting the interpreter
    from typing import Any

MOST_ITEMS = 10_000
MOST_DEPTH = 6
MOST_BITS = 4096  # of an integer, and of a fraction's two
MOST_DIGITS = 2000  # of a Decimal
MOST_TEXT = 80

_SMALL = 1 << 63
_SEQUENCE_METHODS = ("__iter__", "__len__", "__getitem__")
_SHOWN = (bool, str, bytes, complex)  # types whose repr is the interpreter's own


def encode(value: Any) -> Any:
    """The JSON form of `value`: bounded in depth, items and text; runs no method of a foreign class."""
    kind = type(value)
    if value is None or (kind is float and value - value == 0.0):
        return value
    if kind is int and -_SMALL <= value < _SMALL:
        return value
    return _encode(value, 0, [MOST_ITEMS])


def _encode(value: Any, depth: int, budget: list[int]) -> Any:
    kind = type(value)
    if kind is float:
        return value if value - value == 0.0 else _wrong("float", repr(value))
    if kind is int:
        return value if -_SMALL <= value < _SMALL else _large(value)
    if value is None:
        return None
    if kind is list or kind is tuple:
        return _items(value, len(value), depth, budget)
    if kind in _SHOWN:
        return _wrong(kind.__name__, repr(value[:MOST_TEXT] if kind in (str, bytes) else value))
    return _unusual(value, kind, depth, budget)


def _items(items: Any, length: int, depth: int, budget: list[int]) -> Any:
    if depth >= MOST_DEPTH:
        return _wrong("list", f"nested more than {MOST_DEPTH} deep")
    budget[0] -= length
    if budget[0] < 0:
        return _wrong("list", f"more than {MOST_ITEMS} items")
    return [_encode(item, depth + 1, budget) for item in items]


def _unusual(value: Any, kind: type, depth: int, budget: list[int]) -> Any:
    """Everything but the plain types: the library's numbers, numpy's, subclasses, wrong types."""
    try:
        result = _library_number(value, kind) or _numpy(value, kind, depth, budget)
        if result:
            return result[0]
    except MemoryError:
        raise
    except Exception as error:  # a forged class may raise whatever it likes: it is no number then
        return _wrong(_name(kind), f"reading it raised {_name(type(error))}")
    bases = _bases(kind)
    sequence: Any
    for sequence in (list, tuple):
        if sequence in bases:
            own = bases[: bases.index(sequence)]
            if any(method in _namespace(foreign) for foreign in own for method in _SEQUENCE_METHODS):
                return _wrong(
                    _name(kind), f"a subclass of {sequence.__name__} with its own way of reading it"
                )
            return _items(sequence.__iter__(value), sequence.__len__(value), depth, budget)
    for base in (int, float, str, complex, dict, set):
        if base in bases and base is not kind:
            return _wrong(_name(kind), f"a subclass of {base.__name__}")
    return _wrong(_name(kind), "")


def _library_number(value: Any, kind: type) -> tuple[Any] | None:
    """The form of a fractions.Fraction or decimal.Decimal, where the submission has imported them."""
    if kind is getattr(sys.modules.get("fractions"), "Fraction", None):
        return (_ratio(value.numerator, value.denominator),)
    if kind is getattr(sys.modules.get("decimal"), "Decimal", None):
        text = str(value)
        return ({"decimal": text} if len(text) <= MOST_DIGITS else _wrong("Decimal", "too long"),)
    return None


def _numpy(value: Any, kind: type, depth: int, budget: list[int]) -> tuple[Any] | None:
    """The form of numpy's own scalars and arrays, never of a class derived from them."""
    numpy: Any = sys.modules.get("numpy")
    array: Any = getattr(numpy, "ndarray", None)
    generic: Any = getattr(numpy, "generic", None)
    if generic is None or array is None:
        return None
    if kind is array:
        # Row by row, so that the bounds on depth and items hold for arrays too.
        return (
            _encode(value[()], depth, budget)
            if value.ndim == 0
            else _items(value, len(value), depth, budget),
        )
    if generic not in _bases(kind) or generic.dtype.__get__(value).type is not kind:
        return None
    code = value.dtype.kind
    if code in "iu":
        return (_encode(int(value), depth, budget),)
    if code == "f":
        plain = float(value)
        if plain - plain == 0.0 and value == plain:
            return (plain,)
        if not numpy.isfinite(value):
            return (_wrong(_name(kind), repr(plain)),)
        top, bottom = value.as_integer_ratio()
        return (_ratio(top, bottom),)
    return (_wrong(_name(kind), repr(value.item()) if code in "bc" else ""),)


def _ratio(top: Any, bottom: Any) -> dict[str, Any]:
    if type(top) is int is type(bottom) and max(top.bit_length(), bottom.bit_length()) <= MOST_BITS:
        return {"fraction": [f"{top:x}", f"{bottom:x}"]}
    return _wrong("Fraction", "too long")


def _large(value: int) -> Any:
    if value.bit_length() > MOST_BITS:
        return _wrong("int", f"{value.bit_length()} bits long")
    return {"int": f"{value:x}"}


def _wrong(name: str, text: str) -> dict[str, str]:
    return {"type": name[:MOST_TEXT], "text": text[:MOST_TEXT]}


def _bases(kind: type) -> tuple[type, ...]:
    """The classes `kind` derives from, itself first, as the interpreter knows them."""
    order: tuple[type, ...] = type.__dict__["__mro__"].__get__(kind)
    return order


def _namespace(kind: type) -> Any:
    return type.__dict__["__dict__"].__get__(kind)


def _name(kind: type) -> str:
    name: str = type.__dict__["__name__"].__get__(kind)
    return name
