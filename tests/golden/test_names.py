"""Wrong programs written from the statements alone, in fixtures/programs/statements: how well they are named.

The first line of each says what is wrong and where; names.toml the names that are right for it, and under
`also` those that nobody had thought of before, but that are true.
"""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import NamedTuple

import pytest

from judge import RunOptions, Session
from judge.problem import Verdict
from judge.problem.find import find_problem

pytestmark = [pytest.mark.slow, pytest.mark.nightly, pytest.mark.timeout(3600)]  # a minute for ten programs

PROGRAMS = Path(__file__).parents[1] / "fixtures" / "programs" / "statements"
NAMES = tomllib.loads((PROGRAMS / "names.toml").read_text("utf-8"))
KATAS = sorted(path.name for path in PROGRAMS.iterdir() if path.is_dir())
_NEAR = 5  # lines from the one that is wrong to where what it spoils is used
_TOLD = 0.86  # of the programs get a right name or the line: 0.9 when this was written
# Named falsely: their answers are like those of a mistake that they do not make.
_FALSELY = {"circle-circle/13", "on-circle/14", "polygon/12"}


class Said(NamedTuple):
    program: str
    false: frozenset[str]
    told: bool


def said(kata):
    with Session(find_problem(kata), RunOptions(timed=False, diagnosed=False)) as session:
        for path in sorted(PROGRAMS.glob(f"{kata}/*.py")):
            result = session.judge(path.read_bytes(), path.name)
            assert result.verdict is not Verdict.AC, path
            program, pitfall = f"{kata}/{path.stem}", result.pitfall
            first = path.read_text("utf-8").partition("\n")[0]
            wrong = [int(line) for line in re.findall(r"\d+", first.rpartition("; line ")[2])]
            right = {*NAMES[kata][path.stem], *NAMES["also"].get(program, ())}
            lines = [step.line for step in pitfall.steps] if pitfall else []
            near = any(line and abs(line - at) <= _NEAR for line in lines for at in wrong)
            names = frozenset(pitfall.names if pitfall else ())
            yield Said(program, names - right, bool(names & right) or near)


@pytest.fixture(scope="module")
def everything(built):
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("JUDGE_CACHE", str(built))
        return [each for kata in KATAS for each in said(kata)]


def test_most_get_a_right_name_or_the_line(everything):
    assert sum(each.told for each in everything) >= _TOLD * len(everything)


def test_no_other_program_is_named_falsely(everything):
    assert {each.program for each in everything if each.false} == _FALSELY
