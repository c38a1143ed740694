"""Breaking a known wrong program with a case of one's own: what it answers, and a smallest case."""

from __future__ import annotations

from judge.data.load import load_data
from judge.errors import JudgeError, UsageError
from judge.judging.job import RunOptions
from judge.judging.naming import Bars
from judge.judging.session import Session, silent
from judge.judging.trying import ask, try_case
from judge.languages import file_name
from judge.mistakes.puzzles import Puzzle
from judge.problem import Case, Problem, Verdict
from judge.problem.model import case_of
from judge.problem.solutions import accepted_source
from judge.run.tried import Hacked, Said, Tried

NAME = file_name("program")  # what the wrong program is called in a message


def hack(problem: Problem, puzzle: Puzzle, case: Case, isolation: str | None = None) -> Hacked:
    """Run the puzzle's program on the case, contained; the case breaks it if the answer is rejected.

    Raises:
        UsageError: the isolation that is asked for cannot be had.
        JudgeError: the problem is broken, or nothing can be run here.
    """
    try:
        tried = try_case(problem, case, puzzle.group.name)
    except UsageError as fault:
        return Hacked(fault.what)
    with Session(problem, RunOptions(isolation=isolation)) as session:
        said = _asked(session, tried, puzzle.source)
        notes = tuple(session.containment.notes(said.isolation))
        if said.verdict is Verdict.AC:
            return Hacked("the program answers this case correctly", tried, said, notes)
        model = accepted_source(problem, problem.time.function) if puzzle.special and problem.time else None
        if model is not None and _asked(session, tried, model).verdict is not Verdict.AC:
            why = f"with the tolerance of {puzzle.group.name}, a right program fails this case too"
            return Hacked(why, tried, said, notes)
        return Hacked("", tried, said, notes)


def smallest(
    problem: Problem, puzzle: Puzzle, isolation: str | None = None, bars: Bars = silent
) -> tuple[Tried, Said] | None:
    """A smallest case that breaks the program, and what it answers; None where none of its group does.

    Raises as `hack`.
    """
    options = RunOptions(groups=(puzzle.group.name,), isolation=isolation, timed=False, named=False)
    with Session(problem, options, bars=bars) as session:
        result = session.judge(puzzle.source, NAME)
        found, failure = result.counterexample, result.failure
        if found is not None and found.replay and found.input is not None:
            case = case_of(found.input)
        elif failure is not None and failure.group and failure.case:
            data = next(each for each in load_data(problem).groups if each.group.name == failure.group)
            case = data.cases[failure.case - 1]
        else:
            return None
        tried = try_case(problem, case, puzzle.group.name)
        return tried, _asked(session, tried, puzzle.source)


def _asked(session: Session, tried: Tried, source: bytes) -> Said:
    said = ask(session, tried, source, NAME)
    if said.verdict is Verdict.JE:
        raise JudgeError(said.message)
    return said
