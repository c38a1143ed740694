"""An answer as plain JSON, made inside the containment, next to code that nobody trusts.

    None, bool, int of 64 bits, finite float   themselves
    list, tuple                                a list of encoded items
    a larger int                               {"int": "-1f…"}, hexadecimal
    fractions.Fraction                         {"fraction": ["numerator", "denominator"]}, hexadecimal
    decimal.Decimal                            {"decimal": "1.5"}
    numpy scalars and arrays, array.array      the numbers they hold
    many numbers of one type                   {"array": ["d", "000000000000f03f…"]}: the code of the type as
                                               in array.array, the bytes, little-endian, in hexadecimal
    a str of at most 1,000,000 characters      {"word": "enter"}
    a tuple of a single item                   {"tuple": [item]}
    a dict, also one of collections            {"dict": [[key, value], …]}
    anything else, a wrong type                {"type": "complex", "text": "1j"}

The mirror image is `judge.values.wire`, which believes nothing of what it reads. Standard library only,
and no import of judge: this file is handed to the contained process by itself.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:  # importing typing takes longer than starting the interpreter
    from typing import Any

MOST_ITEMS = 20_000  # where the type of the answer says nothing else
MANY = 1_000  # numbers of one type, above which they are sent as bytes
MOST_CHARACTERS = 1_000_000  # of all strs of an answer
MOST_DEPTH = 6
MOST_BITS = 4096  # of an integer, and of a fraction's two
MOST_DIGITS = 2000  # of a Decimal
MOST_TEXT = 80  # of what is sent to be shown alone

IMPORTING = ", while the module was imported"  # what the detail of such an exception ends in

_SMALL = 1 << 63


class Ready:
    """A form that is made already."""

    __slots__ = ("form",)

    def __init__(self, form: Any) -> None:
        self.form = form


class OnObject:
    """Makes an object of a class for each case, and the calls on it; each answer is encoded at once."""

    def __init__(self, made: Any, most: int) -> None:
        self._made = made
        self._most = most
        self._call: Any = None

    def __call__(self, *arguments: Any) -> Ready:
        """The answers to the calls, which are the last argument; the others are the constructor's."""
        *own, calls = arguments
        self._call = None
        one, answers = self._made(*own), []
        for number, (name, *given) in enumerate(calls, 1):
            self._call = number, name, given
            answers.append(encode(getattr(one, name)(*given), self._most))
        return Ready(answers)

    @property
    def at(self) -> str:
        """Where it has come to."""
        if self._call is None:
            return ""
        number, name, given = self._call
        return in_call(number, name, *given)


def in_call(number: int, name: str, *given: Any) -> str:
    """Which one of calls in a row it is: `, in call 3: get(1)`."""
    return f", in call {number}: {name}({', '.join(map(repr, given))[:MOST_TEXT]})"


def found(names: dict[str, Any], entry: str, most: int) -> Any:
    """What is called by that name among a module's: a function, or objects of the class of `Name()`."""
    made = names.get(entry.removesuffix("()"))
    return OnObject(made, most) if entry.endswith("()") and made is not None else made


def place_in(function: Any) -> str:
    """Where calls in a row have come to; nothing for any other function."""
    return function.at if type(function) is OnObject else ""


_CODES = {  # by kind and size
    "i1": "b", "i2": "h", "i4": "i", "i8": "q", "f4": "f", "f8": "d",
    "u1": "B", "u2": "H", "u4": "I", "u8": "Q",
}  # fmt: skip
_KINDS = {"b": "i", "h": "i", "i": "i", "l": "i", "q": "i", "f": "f", "d": "f"}  # the others are unsigned
_SEQUENCE_METHODS = ("__iter__", "__len__", "__getitem__")
_DICT_METHODS = (*_SEQUENCE_METHODS, "keys", "items")
_SHOWN = (bytes, complex)  # types whose repr is the interpreter's own


def encode(value: Any, most: int = MOST_ITEMS) -> Any:
    """The JSON form of `value`: bounded in depth, items and text; runs no method of a foreign class.

    `most` is how many items it may hold, those that are sent as bytes not counted.
    """
    kind = type(value)
    if value is None or kind is bool or (kind is float and value - value == 0.0):
        return value
    if kind is int and -_SMALL <= value < _SMALL:
        return value
    if kind is Ready:
        return value.form
    return _encode(value, 0, [most, most, MOST_CHARACTERS])


def _encode(value: Any, depth: int, budget: list[int]) -> Any:
    kind = type(value)
    if kind is float:
        return value if value - value == 0.0 else _wrong("float", repr(value))
    if kind is int:
        return value if -_SMALL <= value < _SMALL else _large(value)
    if value is None or kind is bool:
        return value
    if kind is list or kind is tuple:
        length = len(value)
        if length > MANY:
            packed = _packed(value)
            if packed:
                return packed
        found = _items(value, length, depth, budget)
        return {"tuple": found} if length == 1 and kind is tuple and type(found) is list else found
    if kind is str:
        return _text(value, budget)
    if kind is dict:
        return _entries(value, depth, budget)
    if kind in _SHOWN:
        return _wrong(kind.__name__, repr(value[:MOST_TEXT] if kind is bytes else value))
    return _unusual(value, kind, depth, budget)


def _text(value: str, budget: list[int]) -> dict[str, str]:
    budget[2] -= len(value)
    if budget[2] >= 0:
        return {"word": value}
    if len(value) > MOST_CHARACTERS:
        return _wrong("str", f"a text of {len(value):,} characters, more than {MOST_CHARACTERS:,}")
    return _wrong("str", f"a text of more than {MOST_CHARACTERS:,} characters in all its parts")


def _items(items: Any, length: int, depth: int, budget: list[int]) -> Any:
    if depth >= MOST_DEPTH:
        return _wrong("list", f"nested more than {MOST_DEPTH} deep")
    budget[0] -= length
    if budget[0] < 0:
        return _wrong("list", f"of more than {budget[1]} items")
    return [_encode(item, depth + 1, budget) for item in items]


def _entries(value: dict[Any, Any], depth: int, budget: list[int]) -> Any:
    """What the dict itself holds, whatever a class that derives from dict says of it."""
    found = _items(dict.items(value), dict.__len__(value), depth, budget)
    return {"dict": found} if type(found) is list else found


def _packed(numbers: Any) -> dict[str, Any] | None:
    """A list of ints, or one of floats, as bytes; None for any other."""
    first = type(numbers[0])
    if first is not int and first is not float:
        return None
    for number in numbers:
        if type(number) is not first:
            return None
    return _bytes("d", numbers) if first is float else _narrow(numbers)


def _narrow(numbers: Any) -> dict[str, Any] | None:
    """Ints as bytes, each in as few as all of them fit into: there is room for so many only."""
    for code in "bhiq":
        try:
            return _bytes(code, numbers)
        except OverflowError:
            continue
    return None


def _bytes(code: str, numbers: Any) -> dict[str, Any]:
    from array import array  # late: it imports all of collections

    packed = array(code, numbers)
    if sys.byteorder == "big":
        packed.byteswap()
    return {"array": [code, packed.tobytes().hex()]}


def _unusual(value: Any, kind: type, depth: int, budget: list[int]) -> Any:
    """Everything but the plain types: the library's numbers, numpy's, subclasses, wrong types."""
    try:
        if result := _library_number(value, kind) or _numpy(value, kind, depth, budget):
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
    if dict in bases:
        ordered = _imported("collections", "OrderedDict")
        foreign = [each for each in bases[: bases.index(dict)] if each is not ordered]
        if any(method in _namespace(each) for each in foreign for method in _DICT_METHODS):
            return _wrong(_name(kind), "a subclass of dict with its own way of reading it")
        return _entries(value, depth, budget)
    for base in (int, float, str, complex, set):
        if base in bases and base is not kind:
            return _wrong(_name(kind), f"a subclass of {base.__name__}")
    return _wrong(_name(kind), "")


def _imported(module: str, name: str) -> Any:
    """What a module that the submission has imported calls so, or None."""
    return getattr(sys.modules.get(module), name, None)


def _library_number(value: Any, kind: type) -> tuple[Any] | None:
    """The form of a fractions.Fraction, a decimal.Decimal or an array.array."""
    if kind is _imported("fractions", "Fraction"):
        return (_ratio(value.numerator, value.denominator),)
    if kind is _imported("array", "array"):
        return (_array(value),)
    if kind is _imported("decimal", "Decimal"):
        text = str(value)
        return ({"decimal": text} if len(text) <= MOST_DIGITS else _wrong("Decimal", "too long"),)
    return None


def _array(value: Any) -> Any:
    """An array of Python's own: its items, or all of them as bytes."""
    code = value.typecode
    if code in ("u", "w"):  # of characters
        return _wrong("array", "of characters")
    if len(value) <= MANY:
        return value.tolist()
    return (code not in "fd" and _narrow(value)) or _bytes(
        _CODES[f"{_KINDS.get(code, 'u')}{value.itemsize}"], value
    )


def _numpy(value: Any, kind: type, depth: int, budget: list[int]) -> tuple[Any] | None:
    """The form of numpy's own scalars and arrays, never of a class derived from them."""
    numpy: Any = sys.modules.get("numpy")
    ndarray, generic = (_imported("numpy", each) for each in ("ndarray", "generic"))
    if generic is None or ndarray is None:
        return None
    if kind is ndarray:
        if value.ndim == 1 and len(value) > MANY and value.dtype.kind in "iuf":
            return (_vector(value),)
        # Row by row, so that the bounds on depth and items hold for arrays too.
        return (
            _encode(value[()], depth, budget)
            if value.ndim == 0
            else _items(value, len(value), depth, budget),
        )
    if generic not in _bases(kind) or generic.dtype.__get__(value).type is not kind:
        return None
    code = value.dtype.kind
    if code == "b":
        return (bool(value),)
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
    return (_wrong(_name(kind), repr(value.item()) if code == "c" else ""),)


def _vector(value: Any) -> Any:
    """An array of numpy's as bytes."""
    if value.dtype.kind in "iu":
        low, high = int(value.min()), int(value.max())
        bits = max(max(high, 0).bit_length(), max(-low - 1, 0).bit_length()) + 1
        fitting = next((size for size in (1, 2, 4, 8) if bits <= 8 * size), None)
        value = value.astype(f"i{fitting}") if fitting else value
    dtype = value.dtype
    code = _CODES.get(f"{dtype.kind}{dtype.itemsize}")
    if code is None:
        return _wrong("array", f"of {dtype.name}")
    return {"array": [code, value.astype(dtype.newbyteorder("<"), copy=False).tobytes().hex()]}


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
