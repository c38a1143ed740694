"""Outputs on the very edge: a package's validator against the judge's own comparison in program mode."""

from __future__ import annotations

import random
import runpy
from collections.abc import Iterator
from decimal import Context, Decimal
from functools import partial
from math import inf, nextafter
from pathlib import Path
from typing import Any, NamedTuple

import judge.packs as packs
from judge.data import GroupData, ProblemData
from judge.exact import Surd
from judge.packs.schemas import accepted_form, form_of
from judge.run.program import ProgramRunner
from judge.sandbox.boundary import Limits, ProgramResult, Stop, Usage
from judge.values import show
from judge.values.check import Accepted, check_line
from judge.values.letters import TextType

WIDE = Context(prec=1200)  # of its own: every other test in this process has what it had
VALIDATOR = runpy.run_path(str(Path(packs.__file__).parent / "validators" / "output_validator.py"))
ANYWHERE = [
    *("", " ", "none", "None", "null", "none none", "0", "1", "2", "-1", "1.0", "0.5", "nan", "inf", "1_0"),
    *("0x1", "+1", "-0", "01", "1e0", "1e400", "1e5001", "1e-5001", "1e1000000", ".5", "5.", "1,5", "1 2"),
    *('"a b"', '"a  b', '"1"', '"none"', '""', '""x', '"\\u00e9"', '"\\ud800"', "true", "True", "false"),
    *(".", "+.", "-.5e1", "+5.E-1", ".e1", "5..", "1E+05", "1.0.", "5e"),
    *(
        "2 0 0 0 0",
        "1 1e400 0",
        "0 0",
        "0 none",
        "-1 0",
        "9" * 400,
        "9" * 401,
        "1." + "0" * 2001,
        "\x00",
        "é",
    ),
    *(
        "\x00",
        "é",
        "\u0661",
        "lit",
        "dark",
        "enter",
        "LIT",
        "1\r",
        "1 \t",
        "\r",
        "1\x0b",
        "1\x1c",
        "1\u00a0",
        "w" * 33,
    ),
]


class Slot(NamedTuple):
    """A number in a line: the exact ends of what is accepted."""

    low: Surd
    high: Surd


def rows(kind: Any, wanted: Any, rng: random.Random) -> list[str | Slot]:
    """The tokens of a right answer, with slots for real numbers; of several answers any."""
    if isinstance(wanted, dict):
        return rows(kind, rng.choice(wanted["any"]), rng)
    name = kind[0]
    if name == "optional":
        return ["none"] if wanted is None else rows(kind[1], wanted, rng)
    if name == "real":
        a, b, c, d, r, s = wanted if len(wanted) == 6 else (wanted[0], 0, wanted[1], 0, 0, wanted[2])
        return [Slot(Surd(a, b, r, s), Surd(c, d, r, s))]
    if name == "tuple":
        return [token for part, each in zip(kind[1], wanted, strict=True) for token in rows(part, each, rng)]
    if name == "list":
        items: list[Any] = []
        for each in wanted:
            run = list(each["run"]) if isinstance(each, dict) and "run" in each else [each]
            items += rng.sample(run, len(run)) if rng.randrange(3) else rng.choices(run, k=len(run))
        return [str(len(items)), *(token for each in items for token in rows(kind[1], each, rng))]
    if name == "dict":
        entries = rng.sample(wanted, len(wanted))
        return [
            str(len(entries)),
            *(token for pair in entries for token in rows(["tuple", kind[1:3]], pair, rng)),
        ]
    if name == "text":
        return [TextType().text_of(wanted)]
    return [str(wanted).lower() if name == "bool" else str(wanted)]


def middle(slot: Slot) -> str:
    """A number that is accepted, where there is room for a double between the ends."""
    return repr((float(slot.low) + float(slot.high)) / 2)


def edge(slot: Slot, rng: random.Random) -> str:
    """A decimal at one of the ends, next to it, or between it and the next double."""
    end = rng.choice(slot)
    digits = rng.choice((17, 25, 40, 80))
    near = rng.choice((float(end), end.round_up(), end.round_down()))
    double = rng.choice((near, nextafter(near, inf), nextafter(near, -inf)))
    exact = f"{Decimal(double):f}"
    exact = exact if "." in exact else f"{exact}."
    texts = [
        repr(double),
        f"{exact}{rng.choice(('0', '00000', '49', '0000000000000001'))}",
        end.decimal(digits),
        _moved(end.decimal(digits), rng),
        f"{double:.6f}",
        f"{double:+.17e}",
        f"{double:g}",
    ]
    if not end.q:
        texts.append(str(WIDE.divide(Decimal(end.p), Decimal(end.s))))
    return rng.choice(texts)


def _moved(text: str, rng: random.Random) -> str:
    """The decimal with another last digit."""
    mantissa, mark, power = text.partition("e")
    if not mantissa[-1:].isdigit():
        return text
    return mantissa[:-1] + str(rng.randrange(10)) + mark + power


def bent(tokens: list[str], rng: random.Random) -> list[str]:
    """The tokens with one fault of form or order."""
    tokens = list(tokens)
    at = rng.randrange(len(tokens))
    way = rng.randrange(8)
    if way == 0:
        del tokens[at]
    elif way == 1:
        tokens.insert(at, rng.choice(tokens))
    elif way == 2:
        other = rng.randrange(len(tokens))
        tokens[at], tokens[other] = tokens[other], tokens[at]
    elif way == 3:
        tokens[at] = rng.choice(ANYWHERE)
    elif way == 4:
        tokens = tokens[: at + 1]
    elif way == 5:
        tokens[at] = tokens[at].upper()
    elif way == 6:
        tokens[at] = rng.choice(("+", "-", "0", "00")) + tokens[at]
    else:
        tokens.append(rng.choice(("0", "none", tokens[at])))
    return tokens


def lines(kind: Any, wanted: Any, right: str, rng: random.Random, count: int) -> Iterator[str]:
    """So many lines of output for one case."""
    yield right
    for _ in range(count - 1):
        way = rng.randrange(10)
        if way == 0:
            yield rng.choice(ANYWHERE)
            continue
        row = rows(kind, wanted, rng)
        slots = [at for at, token in enumerate(row) if isinstance(token, Slot)]
        edgy = set(slots if way == 1 else rng.sample(slots, min(len(slots), 1)))
        tokens = [
            token if isinstance(token, str) else edge(token, rng) if at in edgy else middle(token)
            for at, token in enumerate(row)
        ]
        if way in (2, 3, 4) or not slots:
            tokens = bent(tokens, rng)
        yield rng.choice((" ", " ", "  ", "\t")).join(tokens) + rng.choice(("", "", "", " ", "\r"))


def disagreements(
    data: ProblemData, rng: random.Random, cases: int, each: int
) -> tuple[int, int, list[tuple[str, str]]]:
    """How many lines were decided and accepted, and those that the validator decides otherwise: group, line.

    `cases` is how many of each group are looked at, `each` how many lines there are for one.
    """
    kind = form_of(data.problem.answer)
    decided = accepted = 0
    differ: list[tuple[str, str]] = []
    for group in data.groups:
        for at in rng.sample(range(len(group.cases)), min(cases, len(group.cases))):
            case, target = group.cases[at], group.targets[at]
            exact = data.exact(case, group.group)
            wanted = accepted_form(data.problem.answer, *exact)
            right = show.line(data.problem.answer, target)
            for line in lines(kind, wanted, right, rng, each):
                outcome = check_line(data.problem.answer, line, target, lambda exact=exact: exact)
                ours = isinstance(outcome, Accepted)
                decided, accepted = decided + 1, accepted + ours
                if ours != theirs(kind, line, wanted):
                    differ.append((group.group.name, line))
    return decided, accepted, differ


def theirs(kind: Any, line: str, wanted: Any) -> bool:
    """Whether the validator accepts a line."""
    try:
        VALIDATOR["check"](kind, line, wanted)
    except VALIDATOR["Wrong"]:
        return False
    return True


class _Printed:
    """A box in which whatever runs prints the same."""

    def __init__(self, output: bytes) -> None:
        self._output = output

    def run_program(self, _stdin: bytes, _limits: Limits) -> ProgramResult:
        return ProgramResult(Stop.ANSWERED, self._output, b"", "", Usage())


def judged(data: ProblemData, group: GroupData, output: bytes) -> bool:
    """Whether the judge accepts what a program prints for a whole group."""
    runner = ProgramRunner(data.problem)
    replies = runner.ask(_Printed(output), group.cases, Limits(1, 1, 1, 1))  # type: ignore[arg-type]
    return replies.breakdown is None and all(
        isinstance(runner.decide(reply.answer, target, partial(data.exact, case, group.group)), Accepted)
        for reply, case, target in zip(replies.replies, group.cases, group.targets, strict=True)
    )


def validated(data: ProblemData, group: GroupData, output: bytes) -> bool:
    """Whether the validator does."""
    answer = data.problem.answer
    wanted = [accepted_form(answer, *data.exact(case, group.group)) for case in group.cases]
    try:
        VALIDATOR["decide"](form_of(answer), wanted, output)
    except VALIDATOR["Wrong"]:
        return False
    return True


def outputs(data: ProblemData, group: GroupData) -> list[bytes]:
    """Outputs for a whole group: the right one, and such whose lines or their ends are odd."""
    right = [show.line(data.problem.answer, target) for target in group.targets]
    plain = "".join(f"{line}\n" for line in right).encode()
    return [
        plain,
        plain[:-1],
        plain + b"\n \t\n\n",
        plain.replace(b"\n", b"\r\n"),
        plain.replace(b"\n", b"\r\r\n"),
        plain.replace(b"\n", b"\n\n", 1),
        plain + b"\r",
        plain + b"\r\n",
        plain + b"\x0b\n",
        plain + b"0\n",
        plain + b"\x00",
        plain + b"\xff\xfe",
        plain + b"\xc2\xa0\n",
        b"\n" + plain,
        plain.split(b"\n", 1)[1],
        plain.rsplit(b"\n", 2)[0] + b"\n",
        plain.replace(b"\n", b"\r"),
        plain.replace(b"\n", b"\x85"),
        b"",
        b"\n",
    ]
