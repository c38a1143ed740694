"""The programs of every kata, and what the judge says of each."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

import edge_programs

from judge.diagnose.trial import Guard
from judge.errors import ProblemError
from judge.judging import Session, Terms
from judge.languages import find, is_program, language_of
from judge.mistakes.family import Family
from judge.problem import Problem, Verdict
from judge.problem.find import all_problems, find_problem
from judge.run.result import Result

ROOT = Path(__file__).parents[2]
_PROGRAMS = ROOT / "tests" / "fixtures" / "programs"  # by people, one folder a kind: textbook, everyday, …
_LONGEST = 400  # characters of a value that are kept


class Program(NamedTuple):
    """A submission of the record; `key` is its place, as count/wrong/x.py."""

    key: str
    name: str
    source: bytes


def katas() -> list[str]:
    """The names of all problems."""
    return [problem.id for problem in all_problems()]


def programs(kata: str) -> Iterator[Program]:
    """All programs of a kata, in order: its solutions, its mistakes as programs, those of other people."""
    problem = find_problem(kata)
    for kind in ("accepted", "wrong", "slow"):
        yield from _files(problem.solutions / kind, f"{kata}/{kind}")
    yield from _mistakes(problem)
    for folder in sorted(_PROGRAMS.iterdir()):
        yield from _files(folder / kata, f"{kata}/{folder.name}")
    yield from _edges(problem)


def record(kata: str, chosen: Iterable[Program] | None = None) -> dict[str, dict[str, Any]]:
    """What the judge says of each program of a kata, by key; those that cannot be judged here are missing."""
    found, problem = {}, find_problem(kata)
    with (
        patch.object(Guard, "over", False),  # the calls alone end a search, however busy the machine is
        Session(problem, Terms(timed=False)) as plain,
        Session(problem, Terms(diagnosed=False, named=False)) as timed,
    ):
        for program in programs(kata) if chosen is None else chosen:
            language = language_of(program.name)
            if language and find.why_not(language):
                continue
            result = (timed if "/slow/" in program.key else plain).judge(program.source, program.name)
            if "/slow/" in program.key and result.verdict is Verdict.AC:  # a close race on a busy machine
                result = timed.judge(program.source, program.name)
            found[program.key] = told(result, {group.name for group in problem.groups if group.size})
    return found


def told(result: Result, sized: Collection[str] = ()) -> dict[str, Any]:
    """What is kept of a result: nothing that another run would say otherwise.

    Whether a wrong program comes to its end in a group of a given size, or is too slow, is the machine's.
    """
    if result.verdict is Verdict.TLE:
        return {"verdict": "TLE"}
    plain = result.as_json()
    kept = {"verdict": plain["verdict"], "mode": plain["mode"]}
    if result.verdict is Verdict.AC or not sized:
        kept["score"] = plain["score"]
    if result.levels:
        kept["levels"] = [level.level.value for level in result.levels if level.passed]
    if result.verdict is Verdict.AC:
        kept["groups"] = len(result.groups)
    else:
        kept["fails"] = {
            group.name: group.cases - group.passed
            for group in result.groups
            if group.verdict is not Verdict.AC and group.name not in sized
        }
        kept["failure"] = _case(plain["failure"])
        kept["smallest"] = _case(plain["counterexample"])
        pitfall = plain["pitfall"] or {}
        kept["names"] = pitfall.get("name")
        if "perhaps" in pitfall:
            kept["perhaps"] = pitfall["perhaps"]
    kept["thresholds"] = {each.decision: _law(each.law, each.mistake) for each in result.thresholds}
    return {key: value for key, value in kept.items() if value not in (None, {}, [])}


def _case(case: dict[str, Any] | None) -> dict[str, Any] | None:
    wanted = ("group", "case", "input", "expected", "also", "got", "message")
    return case and {key: _cut(case[key]) for key in wanted if case.get(key) is not None}


def _cut(value: Any) -> Any:
    text = repr(value)
    return value if len(text) <= _LONGEST else f"{text[:_LONGEST]}… {len(text)} characters"


def _law(law: Any, mistake: str | None) -> str:
    sizes = "".join(f"·{name}^{power}" for name, power in law.powers.items())
    return f"{law.constant:.1g} + {law.factor:.1g}{sizes}" + (f" ({mistake})" if mistake else "")


def _files(folder: Path, place: str) -> Iterator[Program]:
    for path in sorted(folder.glob("*")):
        if path.is_file() and is_program(path.name):
            yield Program(f"{place}/{path.name}", path.name, path.read_bytes())


def _mistakes(problem: Problem) -> Iterator[Program]:
    """The first program that makes each mistake of mistakes.py."""
    try:
        family = Family(problem)
    except ProblemError:  # a kata without such a file
        return
    seen = set()
    for choice, name in family.named:
        if name not in seen:
            seen.add(name)
            yield Program(f"{problem.id}/mistake/{name}.py", f"{name}.py", family.program(choice).encode())


def _edges(problem: Problem) -> Iterator[Program]:
    """Programs that are right but for one small thing."""
    source = Path(edge_programs.__file__).read_text(encoding="utf-8")
    names = ", ".join(parameter.name for parameter in problem.parameters)
    for keywords in edge_programs.WRONG.get(problem.id, ()):
        ((word, value),) = keywords.items()
        called = f"{edge_programs.ENTRIES[problem.id].__name__}({names}, {word}={value})"
        entry = f"\n\ndef {problem.entry}({names}):\n    return {called}\n"
        yield Program(f"{problem.id}/edge/{word}-{value}.py", "edge.py", (source + entry).encode())
