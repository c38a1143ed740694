"""The mock interview for the screen: what comes, the kata, and the page of what to drill."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from judge.kata.checklist import Row
from judge.kata.events import Rating
from judge.kata.quiz.questions import Question
from judge.problem import Problem, Verdict
from judge.report.layout import Line, Span, Style, hanging, line
from judge.report.names import shown_name
from judge.report.quiz import drill_lines, prompt_text
from judge.report.screen import Screen
from judge.report.values import counted, score_text
from judge.run.result import Result

_COLUMN = 11  # where what follows a label begins


class Outcome(Struct, frozen=True):
    """What became of the kata: how often its file was judged, and the last result."""

    problem: Problem
    file: str
    runs: int = 0
    last: Result | None = None

    def after(self, result: Result) -> Outcome:
        """The outcome once that result is there."""
        return Outcome(self.problem, self.file, self.runs + 1, result)

    @property
    def solved(self) -> bool:
        """Whether the last run was accepted with no group left out."""
        return self.last is not None and self.last.verdict is Verdict.AC

    @property
    def lacking(self) -> tuple[str, ...]:
        """The skills that the last run did not show; none where nothing was judged."""
        if self.last is None:
            return ()
        passed = {group.name for group in self.last.groups if group.verdict is Verdict.AC}
        return tuple(skill.name for skill in self.problem.skills if not passed.issuperset(skill.groups))


def interview_lines(
    minutes: int, before: int, after: int, problem: Problem, width: int | None
) -> Iterator[Line]:
    """What is to come."""
    yield line(Span("Mock interview", Style.STRONG), Span(f"  {counted(minutes, 'minute')}", Style.FAINT))
    parts = f"{counted(before, 'card')}, the kata {problem.id}, {counted(after, 'card')}"
    text = f"{parts}. q leaves; what was done is kept."
    yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0)
    yield line()


def kata_lines(problem: Problem, file: str, minutes: int, width: int | None) -> Iterator[Line]:
    """The kata, its file, and the time for it."""
    yield line(Span(problem.title, Style.STRONG), Span(f"  {counted(minutes, 'minute')}", Style.FAINT))
    yield from hanging(Span(""), Span(problem.summary), width, indent=2, column=2)
    text = f"Write it in {shown_name(file)}: the statement is in there. It is judged on every save."
    yield from hanging(Span(""), Span(text), width, indent=2, column=2)
    yield line()


def kata_prompt(screen: Screen) -> str:
    """What may be typed while the kata is solved."""
    return prompt_text("save the file, or Enter to judge it, q to go on", screen)


def over_lines() -> list[Line]:
    """The time for the kata is over."""
    return [line(), line(Span("The time for the kata is over.", Style.WARNING)), line()]


def page_lines(
    asked: Sequence[tuple[Question, Rating]],
    outcome: Outcome,
    drill: Sequence[tuple[Row, Sequence[str]]],
    minutes: tuple[int, int],
    width: int | None,
) -> Iterator[Line]:
    """How it went, and what to drill."""
    taken, of = minutes
    yield line()
    yield line(
        Span("The interview", Style.STRONG), Span(f"  {taken} of {counted(of, 'minute')}", Style.FAINT)
    )
    known = sum(rating is not Rating.AGAIN for _, rating in asked)
    cards = f"{known} of {counted(len(asked), 'card')} known" if asked else "none answered"
    yield from hanging(Span("cards", Style.FAINT), Span(cards), width, indent=2, column=_COLUMN)
    yield from hanging(Span("kata", Style.FAINT), _kata(outcome), width, indent=2, column=_COLUMN)
    if outcome.lacking and not outcome.solved:
        text = ", ".join(outcome.lacking)
        yield from hanging(Span("not yet", Style.FAINT), Span(text), width, indent=2, column=_COLUMN)
    yield from drill_lines(drill, width)
    if not drill and asked:
        yield line()
        yield line(Span("Nothing to drill.", Style.GOOD))


def _kata(outcome: Outcome) -> Span:
    last, name = outcome.last, outcome.problem.id
    if last is None:
        return Span(f"{name}: not judged", Style.FAINT)
    pitfall = f", {last.pitfall.name}" if last.pitfall else ""
    score = score_text(last.score, accepted=last.verdict is Verdict.AC)
    points = f"{score} of 100 points" if score == str(last.score) else "all points, but an extra group fails,"
    points += f" after {counted(outcome.runs, 'run')}"
    text = f"{name}: {last.verdict.value}, {points}{pitfall}"
    return Span(text, Style.GOOD if outcome.solved else Style.BAD)
