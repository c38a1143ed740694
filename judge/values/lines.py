"""An answer as a line of a program's output: decided, and read strictly."""

from __future__ import annotations

from math import inf

from judge.values.answers import NO_WORDS, Words
from judge.values.base import Atom, Target, Type
from judge.values.check import Accepted, ExactOf, Outcome, Rejection, check
from judge.values.show import line
from judge.values.types import Composite, ListType, OptionalType, TupleType
from judge.values.wire import Raw, Tokens, Unreadable, quoted


def check_line(type_: Type, text: str, target: Target, exact: ExactOf) -> Outcome:
    """Decide one line of a program's output (without its newline, whatever it holds); see `check`."""
    answer = read_line(type_, text)
    got = quoted(text)[1:-1]
    if isinstance(answer, str):
        return Rejection(answer, line(type_, target), got)
    outcome = check(type_, answer[0], target, exact)
    if isinstance(outcome, Accepted):
        return outcome
    # The answers are shown as programs write them.
    message = outcome.message.replace("None", "none")
    errors = outcome.where, outcome.absolute, outcome.relative, outcome.ulps
    return Rejection(message, line(type_, target), got, *errors)


def read_line(type_: Type, text: str) -> tuple[Raw] | str:
    """The answer that a line holds, in a tuple of one, or why it holds none."""
    try:
        words = Tokens(text, meant(type_))
        if type_.width == 1 and words.left > 1:
            words.next()
            raise Unreadable(f"{quoted(words.ahead)} after the answer: one line holds {words.meant}")
        raw = _take(type_, words, whole=True)
        if words.left:
            raise Unreadable(f"{quoted(words.ahead)} after the answer: one line holds {words.meant}")
    except Unreadable as why:
        return str(why)
    return (raw,)


def meant(type_: Type) -> str:
    """What a line holds, in words."""
    return type_.words.meant or hint(type_, type_.words)


def _take(type_: Type, words: Tokens, *, whole: bool = False) -> Raw:
    """The answer that the next tokens hold; raises Unreadable. `whole` says that it is all of the line."""
    if isinstance(type_, OptionalType):
        ahead = words.ahead
        if ahead == "none":
            words.next()
            return None
        if ahead.lower() in {"none", "null"}:
            what = words.meant if whole and type_.width == 1 else hint(type_)
            raise Unreadable(f"{quoted(ahead)} where {what} is meant: write none in lower case")
        return _take(type_.inner, words, whole=whole)
    if isinstance(type_, Atom):
        return type_.take(words, words.meant if whole else type_.noun)
    assert isinstance(type_, Composite)
    count = _count(type_, words, whole=whole) if isinstance(type_, ListType) else 0
    return [_take(part, words) for part in type_.parts(count)]


def _count(type_: ListType, words: Tokens, *, whole: bool) -> int:
    """The length of the list that follows."""
    if words.ahead.lower() == "none":
        raise Unreadable(f'"{words.ahead}" where {hint(type_)} is meant: no {type_.several} are 0')
    count = words.integer(f"the number of {type_.several} k")
    if not type_.low <= count <= (inf if type_.high is None else type_.high):
        given = str(count) if len(str(count)) <= 20 else f"{str(count)[:20]}…"
        bounds = f"{type_.low} or more" if type_.high is None else f"{type_.low} to {type_.high}"
        bounds = str(type_.low) if type_.low == type_.high else bounds
        raise Unreadable(f"k = {given} where {bounds} {type_.several} are meant")
    width = type_.item.width
    if width is not None and whole and words.left != count * width:
        noun = "coordinates" if type_.one == "point" else "more"
        raise Unreadable(f"k = {count} needs {count * width} {noun}, {words.left} given")
    if count > words.left:
        raise Unreadable(f"the line ends too early: it holds {words.meant}")
    return count


def hint(type_: Type, words: Words = NO_WORDS) -> str:
    """What a line holds, in words, as far as the type says it."""
    if isinstance(type_, OptionalType):
        return f"{hint(type_.inner, words)} or none"
    if isinstance(type_, TupleType):
        return " ".join(type_.names) if type_.is_vector else ", ".join(map(hint, type_.fixed))
    if isinstance(type_, ListType):
        if isinstance(type_.item, TupleType) and type_.item.is_vector:
            return f"k {' '.join(f'{name}1' for name in type_.item.names)} …"
        item = hint(type_.item)
        return f"k and then k times ({item})" if type_.item.depth else f"k and then k times {item}"
    return words.answer or type_.noun
