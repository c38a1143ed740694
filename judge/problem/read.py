"""What a setter wrote: problem.toml, statement.md and the rows of problem.py into one checked Problem.

The group of the statement's examples comes first. Of 100 points those that no row names are shared evenly,
and the first groups take the remainder.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from judge.errors import ProblemError, meant
from judge.files import read_ordinary
from judge.languages import described, is_described
from judge.problem.declare import Declared, group
from judge.problem.model import (
    EXAMPLES,
    FULL_SCORE,
    Group,
    GroupLimits,
    GrowthRule,
    KataLevel,
    Parameter,
    Problem,
    PythonName,
    Source,
    TimeRule,
    Titled,
    parsed_type,
)
from judge.problem.module import load_module
from judge.problem.texts import read_statement
from judge.problem.toml import TomlFile, refusal, told
from judge.values.answers import Tolerance, Words
from judge.values.atoms import NumberType, Type
from judge.values.grammar import TypeFault
from judge.values.letters import USUAL, expanded, texts_of
from judge.values.types import ArrayType, atoms, lasting

_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits
_NO_ANSWER = "the key 'answer' is missing in the file", "add answer = …"
_NOTHING = "int?"  # the type of a dialogue's answers, which are all None
_REFERENCED = "add a [time] table that names one"
_CASES = 60  # of a group, twice as many that take turns
_RUNS = 12  # of a group whose cases are a run each

Rows = Sequence[tuple[KataLevel | None, Declared]]


class Head(Titled, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A problem.toml, whole."""

    answer: Type | None = None  # there is one, unless there are methods
    parameters: dict[str, Any]  # a Parameter without its name each, in the order of the call
    methods: Mapping[PythonName, str] = {}  # of a class: what each takes and answers
    tolerance: Tolerance | None = None
    limits: GroupLimits = GroupLimits()
    time: TimeRule | None = None
    growth: Annotated[float, Meta(gt=0, le=3)] | None = None  # an exponent's excess over the reference's
    words: Words = Words()
    source: Source = Source()


def read_problem(folder: Path, solutions: Path) -> Problem:
    """The problem of that folder, for which problem.py is run. Raises ProblemError."""
    file, types = TomlFile(folder / "problem.toml", exact=True), folder.parent / "types"
    if "groups" in file.raw:
        remedy = "write GROUPS = [group(name, about, draw), …] there: judge help problem"
        raise file.fault("test groups are declared in problem.py now", remedy, "groups", 0)

    def hook(wanted: Any, value: Any) -> Any:
        return _exact(wanted, value, types)

    head = file.read(Head, hook)
    methods = _methods(file, head, types) if head.methods else None
    if methods:
        answer = methods[1]
    elif head.answer is None and head.entry:
        raise file.fault(*_NO_ANSWER)
    else:
        answer = parsed_type(head.answer.text if head.answer else _NOTHING, types, head.words)
    parameters = []
    for name, row in head.parameters.items():
        if isinstance(row, dict):
            row["name"] = name
        parameters.append(_as_its_type(file.read(Parameter, hook, "parameters", name), row, types))
    for what, remedy, *path in _faults(head, answer, parameters):
        raise file.fault(what, remedy, *path)
    parameters += [Parameter("calls", methods[0], "the calls, in their order")] if methods else []
    problem = Problem(
        id=folder.name,
        folder=folder,
        solutions=solutions,
        groups=(),
        answer=answer,
        parameters=tuple(parameters),
        methods=methods is not None,
        **{key: getattr(head, key) for key in (*Titled.__struct_fields__, "limits", "time", "source")},
    )
    module = load_module(problem)
    talks = module.format is not None and module.format.talk is not None
    if talks and problem.entry:
        raise file.fault("a dialogue calls no function", "remove entry", "entry")
    if talks and head.answer is not None:
        raise file.fault("a dialogue has no answer: talk decides", "remove answer", "answer")
    if head.answer is None and not (talks or methods):
        raise file.fault(*_NO_ANSWER)
    problem = replace(problem, formatted=module.format is not None, talks=talks)
    statement, examples = read_statement(problem, module, file.raw)
    problem = replace(problem, statement=statement, examples=examples)
    groups = _groups(problem, module.rows, head.tolerance if answer.measured else Tolerance())
    growth = None
    if head.growth is not None:
        sized = sorted((each for each in groups if each.size), key=lambda each: each.size or 0)
        if len({each.size for each in sized}) < 2:
            what = "growth needs groups of two different sizes"
            raise problem.fault(what, "add a group with size = …")
        growth = GrowthRule(tuple(each.name for each in sized), head.growth)
    return replace(problem, groups=groups, growth=growth)


def _methods(file: TomlFile, head: Head, types: Path) -> tuple[Type, Type]:
    """The type of the calls, and of what they return. Raises ProblemError."""
    if head.answer is not None:
        raise file.fault("a class has no answer of its own: each method has one", "remove answer", "answer")
    if not head.entry:
        raise file.fault("[methods] needs entry, the class's name", 'add entry = "…"', "methods")
    texts = []
    for name, written in head.methods.items():
        texts.append(name + written.strip())
        try:
            parsed_type(f"calls{{{texts[-1]}}}", types)
        except TypeFault as fault:
            told = fault.what.rpartition(": ")[2]
            what, remedy = f"methods.{name} = {written!r}: {told}", 'write "(name: type, …) -> type"'
            raise file.fault(what, remedy, "methods", name) from None
    calls, returns = (parsed_type(f"{kind}{{{'; '.join(texts)}}}", types) for kind in ("calls", "returns"))
    return calls, returns


def _as_its_type(parameter: Parameter, row: Mapping[str, Any], types: Path) -> Parameter:
    """The parameter with its letters in its type, and with the bounds of that where its `row` has none."""
    if texts_of(parameter.type):
        letters = parameter.letters or USUAL
        parameter = replace(parameter, type=parsed_type(parameter.type.text, types, letters=letters))
    if not parameter.type.measured:  # ints are as small as they like
        parameter = replace(parameter, smallest=Fraction(0))
    numbers = [each for each in atoms(parameter.type) if isinstance(each, NumberType)]
    for key, widest in (("low", min), ("high", max)):
        own = [bound for each in numbers if (bound := getattr(each, key)) is not None]
        if own and key not in row:
            usual = [getattr(parameter, key)] if len(own) < len(numbers) else []
            parameter = replace(parameter, **{key: Fraction(widest(own + usual))})
    return parameter


def _exact(wanted: Any, value: Any, types: Path) -> Any:
    """A Fraction or a Type of what a setter writes, for `msgspec.convert`; a pack's types are in `types`."""
    if wanted is Type:
        if not isinstance(value, str):
            raise refusal("{key} is not text", 'give a type in quotes, such as "integer"')
        try:
            return parsed_type(value, types)
        except TypeFault as fault:
            raise refusal(f"{{key}} = {fault.what}", fault.remedy) from None
    if isinstance(value, bool) or not isinstance(value, int | float | Decimal | Fraction):
        raise refusal("{key} is not a number", "give a number")
    number = Decimal(str(value)) if isinstance(value, float) else value
    if isinstance(number, Decimal) and not number.is_finite():
        raise refusal(f"{{key}} is {number}", "give a finite number")
    if isinstance(number, Decimal) and abs(number.adjusted()) > _MOST_DIGITS:
        raise refusal("{key} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
    return Fraction(number)


def _faults(head: Head, answer: Type, parameters: Sequence[Parameter]) -> Iterator[Sequence[str]]:
    """What the shape alone does not say: what is wrong, what to do about it, and the keys of the place."""
    if isinstance(lasting(answer), ArrayType):
        what = f"no answer can be of the type {answer}"
        yield what, "an array is a parameter's; write a list, which may be one too", "answer"
    if head.growth is not None and head.time is None:
        yield "growth is measured beside a reference solution, and there is none", _REFERENCED, "growth"
    if head.time is not None and not head.entry and (head.time.function or not head.time.program):
        what = "a kata without entry has programs alone"
        yield what, 'write program = "a file of solutions/accepted" in [time], and no function', "time"
    if head.time is not None and head.entry and not head.time.function:
        yield "[time] names no function", 'add function = "a file of solutions/accepted"', "time"
    for name in head.sets:
        if head.sets.count(name) > 1:
            yield f"{name!r} is there twice in sets", "remove one", "sets"
    if head.tolerance is not None:
        yield from _tolerance_faults(head.tolerance, answer)
    for language in head.time.references if head.time else ():
        if not is_described(language):
            what = f"there is no language {language!r}"
            yield what, meant(language, described()), "time", "references", language
    for each in parameters:
        path = "parameters", each.name
        if each.low > each.high:
            yield f"the bounds of {each.name!r} leave nothing: low is above high", "swap them", *path, "low"
        if not each.type.is_parameter:
            what = f"no parameter can be of the type {each.type}"
            yield what, "an array is a whole parameter", *path, "type"
        if each.letters is not None and not texts_of(each.type):
            yield f"{each.name} has letters, and no text", "remove them", *path, "letters"
        elif each.letters == "":
            yield "letters is empty", "name at least one, or leave the key out", *path, "letters"
        try:
            expanded(each.letters or "")
        except ValueError as why:
            remedy = 'write single ones and ranges, such as "a-z "'
            yield f"letters = {each.letters!r}: {why}", remedy, *path, "letters"
        if not 0 <= each.smallest <= 1:
            what = f"the smallest number of {each.name!r} other than 0 is not from 0 to 1"
            yield what, "an int other than 0 is never smaller than 1", *path, "smallest"


def _tolerance_faults(tolerance: Tolerance, answer: Type) -> Iterator[Sequence[str]]:
    """The same of a tolerance for such answers."""
    if not answer.measured:
        what = "an answer without real numbers is right or wrong and has no tolerance"
        yield what, "remove it", "tolerance"
    for key in tolerance.__struct_fields__:
        if getattr(tolerance, key) < 0:
            yield f"the tolerance {key} is negative", "give 0 or more", "tolerance", key
    if not (tolerance.extent or tolerance.relative or tolerance.ulps):
        what = "the tolerance is 0, which no double can meet"
        yield what, "give relative, extent or ulps", "tolerance"


# -- groups ------------------------------------------------------------------------------------------------


def _groups(problem: Problem, rows: Rows, usual: Tolerance | None) -> tuple[Group, ...]:
    """The groups of the rows; `usual` is the tolerance of one without its own. Raises ProblemError."""
    levels = list(dict.fromkeys(level for level, _ in rows)) or [None]
    if len(levels) == 1 and levels[0] is not None:
        remedy = "declare groups of both, or all of them in GROUPS"
        raise problem.fault(f"every group is in {levels[0].name}", remedy, rows[0][1].line)
    if not problem.examples and problem.entry:
        remedy = f"add a line >>> {problem.entry}(…) and the answer below it"
        raise problem.fault("there are no worked examples", remedy, file="statement.md")
    about = "The worked examples of the statement."
    examples = replace(group(EXAMPLES, about, tuple, cases=len(problem.examples)), line=0)
    first = usual or next((row.row["tolerance"] for _, row in rows), None) or Tolerance()
    groups = {EXAMPLES: _group(problem, examples, levels[0], first)}
    for level, row in rows:
        made = _group(problem, row, level, usual)
        if made.name in groups:
            remedy = "the examples come by themselves" if made.name == EXAMPLES else "rename or remove one"
            raise problem.fault(f"there are two groups {made.name!r}", remedy, made.line)
        groups[made.name] = made
    left = FULL_SCORE - sum(each.points for each in groups.values())
    if left < 0:
        remedy = f"make them sum to {FULL_SCORE} at most: what is left is shared"
        raise problem.fault(f"the groups' points sum to {FULL_SCORE - left}", remedy)
    free = [EXAMPLES, *(row.row["name"] for _, row in rows if row.row["points"] is None)]
    share, rest = divmod(left, len(free))
    for at, name in enumerate(free):
        groups[name] = replace(groups[name], points=share + (at < rest))
    kills = _pinned_kills(problem)
    return tuple(replace(each, kills=kills.get(each.name, ())) for each in groups.values())


def _group(problem: Problem, declared: Declared, level: KataLevel | None, usual: Any) -> Group:
    """The group of a row, without its share of the points; `usual` is the tolerance where it has none."""
    own = {key: value for key, value in declared.row.items() if value is not None}
    cases = _RUNS if problem.formatted else 2 * _CASES if own["turns"] else _CASES
    usually = {"points": 0, "cases": cases, "tolerance": usual or Tolerance()}
    raw = {**usually, **own, "seed": problem.id, "line": declared.line}
    if isinstance(limits := raw.get("limits"), Mapping):
        bounds, wall = problem.limits, {}
        if isinstance(cpu := limits.get("cpu_seconds"), int | float):
            wall = {"wall_seconds": bounds.wall_seconds * cpu / bounds.cpu_seconds}
        raw["limits"] = {**msgspec.to_builtins(bounds), **wall, **limits}
    what = f"group {raw['name']!r}"

    def fault(what: str, remedy: str) -> ProblemError:
        return problem.fault(what, remedy, declared.line)

    try:
        made = msgspec.convert(raw, Group, dec_hook=lambda kind, value: _exact(kind, value, problem.folder))
    except msgspec.ValidationError as why:
        said, remedy, _ = told(why, raw, Group)
        raise fault(f"{what}: {said}", remedy) from None
    if not callable(declared.draw):
        raise fault(f"{what} draws from {declared.draw!r}", "give a function that takes a draw")
    if made.size is not None and made.neighbours:
        raise fault(f"the cases of {what} are big and cannot take turns", "remove turns")
    if made.time_limit is not None and problem.time is None:
        raise fault(f"{what} is timed beside a reference solution", _REFERENCED)
    for wrong in _tolerance_faults(made.tolerance, problem.answer) if "tolerance" in own else ():
        raise fault(*wrong[:2])
    if "tolerance" not in own and usual is None:
        raise fault(f"{what} has no tolerance", "add tolerance = { … } to problem.toml")
    return replace(made, level=level)


class _Pin(Struct):
    kills: tuple[str, ...]


def _pinned_kills(problem: Problem) -> dict[str, tuple[str, ...]]:
    """The mistakes that each group catches, by pins.json; a file that is none is verify's to tell."""
    try:
        pins = msgspec.json.decode(read_ordinary(problem.folder / "pins.json"), type=dict[str, _Pin])
    except (OSError, ValueError, RecursionError):
        return {}
    return {name: pin.kills for name, pin in pins.items()}
