"""What to do again today, for the screen."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from datetime import datetime

from judge.kata.events import Rating
from judge.kata.review import Review
from judge.languages import file_name
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, hanging, line
from judge.report.values import counted

_STYLES = {Rating.AGAIN: Style.BAD, Rating.HARD: Style.WARNING}


def due_lines(
    found: Sequence[Review], elsewhere: Collection[str], now: datetime, width: int | None
) -> Iterator[Line]:
    """The katas that are due, the longest overdue first, then those that come later.

    `elsewhere` are problems of the history that are not to be found from here.
    """
    due = [review for review in found if review.is_due(now)]
    later = [review for review in found if not review.is_due(now)]
    if due:
        yield line(Span("Today", Style.STRONG), Span(f"  {counted(len(due), 'kata')}", Style.FAINT))
        yield from _table(due, now).lines(width)
        yield line()
        text = "Write it again from an empty file: a file that was accepted before counts for nothing."
        yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=2, column=2)
        first = due[0].name
        yield line("  next  ", Span(f"judge init {first} {_fresh(first, now)}", Style.STRONG))
    else:
        yield line(Span("Nothing is due today.", Style.GOOD))
    if later:
        yield line()
        yield line(Span("Later" if due else "Next", Style.STRONG))
        yield from _table(later, now).lines(width)
    if elsewhere:
        yield line()
        text = f"Not to be found from here: {', '.join(sorted(elsewhere))}; see --problems."
        yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0)


def card_lines(found: Sequence[Review], now: datetime, width: int | None) -> Iterator[Line]:
    """How many cards are due, and when the next one is; nothing where none was ever answered."""
    if not found:
        return
    due = sum(review.is_due(now) for review in found)
    yield line()
    yield line(Span("Cards", Style.STRONG), Span(f"  {due} due of {len(found)} answered", Style.FAINT))
    if due:
        yield line("  next  ", Span("judge quiz", Style.STRONG))
    else:
        text = f"The next one is due {due_words(min(found, key=lambda review: review.due), now)}."
        yield from hanging(Span(""), Span(text), width, indent=2, column=2)


def waiting_lines(due: int, width: int | None) -> Iterator[Line]:
    """That cards are due, beside a kata."""
    if due:
        yield line()
        text = f"{counted(due, 'card')} {'is' if due == 1 else 'are'} due: judge quiz"
        yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0)


def nothing_lines(width: int | None, *, tried: bool) -> Iterator[Line]:
    """No kata is kept in mind yet; runs of a problem's own solutions are no tries."""
    none = "No run of yours has passed a test group yet" if tried else "You have tried no kata yet"
    yield from hanging(Span(""), Span(f"{none}, so nothing is due."), width, indent=0, column=0)
    yield line("  next  ", Span("judge next", Style.STRONG))


def _table(found: Sequence[Review], now: datetime) -> Table:
    columns = (
        Column("kata"),
        Column("due"),
        Column("last time", flexible=True),
    )
    return Table(columns, [_row(review, now) for review in found])


def _row(review: Review, now: datetime) -> list[Cell]:
    return [
        Span(review.name, Style.STRONG),
        due_words(review, now),
        Span(f"{day(review.last)}: {_why(review)}", _STYLES.get(review.rating, Style.PLAIN)),
    ]


def due_words(review: Review, now: datetime) -> str:
    """When it is due, in days from now: `in 3 days`, `today`, `1 day ago`."""
    days = (review.due.astimezone(now.tzinfo).date() - now.date()).days
    if days < 0:
        return f"{counted(-days, 'day')} ago"
    return "today" if days == 0 else f"in {counted(days, 'day')}"


def _why(review: Review) -> str:
    """What happened, and after how many days it therefore comes again."""
    if review.rating is Rating.AGAIN:
        how = "not solved"
    elif review.rating is Rating.HARD:
        how = "solved, but not at once"
    else:
        times = {1: "", 2: " twice in a row"}.get(review.in_a_row, f" {review.in_a_row} times in a row")
        how = f"solved at once{times}"
    return f"{how}, so again after {counted(review.days, 'day')}"


def _fresh(problem: str, now: datetime) -> str:
    """A name for a file that is not there yet."""
    return file_name(f"{problem.replace('-', '_')}_{now:%m%d}")
