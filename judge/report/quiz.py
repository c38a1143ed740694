"""Quiz cards for the screen: the question, what an answer came to, and what to drill."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from typing import TYPE_CHECKING

from judge.drawing.braille import LEAST_ROWS
from judge.kata.events import Rating
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, cells, hanging, line, wrap
from judge.report.values import counted

if TYPE_CHECKING:
    from judge.kata.checklist import Row
    from judge.kata.quiz.cards import Card
    from judge.kata.quiz.questions import Question, Reply
    from judge.kata.review import Review
    from judge.report.screen import Screen

_PANEL = 31  # columns of a picture of one panel
_LABELS = 9  # the column where what follows a label begins
_AROUND = 2  # rows for the prompt and one above
RATINGS = "1 again, 2 hard, 3 good, 4 easy"


def question_lines(question: Question, place: str, screen: Screen) -> list[Line]:
    """The card, what is known of its figure, and the figure where the terminal has room for it."""
    card, width = question.card, screen.width
    head = beside(Span(place, Style.FAINT), f"{card.form}{''.join(f'  {row}' for row in card.rows)}", width)
    lines = [*head, *_prose(card.front, width, Style.STRONG)]
    lines += [each for text in question.given for each in _prose(text, width, Style.PLAIN)]
    if question.program:
        lines += [line(), *_indented(question.program), line()]
    for letter, text in question.options:
        lines += hanging(Span(letter, Style.STRONG), Span(text), width, indent=2, column=5)
    rows = _rows_left(screen, len(lines))
    return [*lines, *_picture(question, screen, rows)]


def _indented(program: str) -> list[Line]:
    return [line("    ", Span(row)) if row else line() for row in program.splitlines()]


def _prose(text: str, width: int | None, style: Style) -> list[Line]:
    return hanging(Span(""), Span(text, style), width, indent=2, column=2)


def _rows_left(screen: Screen, taken: int) -> int:
    from judge.report.terminal import height

    return height(screen) - taken - _AROUND


def _picture(question: Question, screen: Screen, rows: int) -> list[Line]:
    from judge.report.picture import has_room, picture_lines

    if question.picture is None or not has_room(screen, _PANEL):
        return []
    drawn = list(picture_lines(question.picture, max(rows, LEAST_ROWS), answered=False))
    return [line("  ", *each) for each in drawn]


def prompt_text(what: str, screen: Screen) -> str:
    """What may be typed, ready to be written; the last line is left open for it."""
    width = screen.width
    rows = wrap(what, None if width is None else max(1, width - 5))
    lines = [line("  ", Span(row, Style.FAINT)) for row in rows[:-1]]
    return screen.text([*lines, line("  ", Span(rows[-1], Style.FAINT), " > ")]).removesuffix("\n")


def reply_lines(question: Question, reply: Reply | None, width: int | None) -> Iterator[Line]:
    """Whether the answer was right, what the right one is, and why; `reply` is None where none was given."""
    if reply is not None and reply.right:
        yield line("  ", Span("✓ right", Style.GOOD))
    else:
        mistake = f": {reply.mistake}" if reply and reply.mistake else ""
        yield line("  ", Span(f"✗ wrong{mistake}" if reply else "✗ not known", Style.BAD))
        if reply and reply.why:
            yield from _labelled("because", reply.why, width)
        yield from _labelled("answer", question.answer, width)
    if question.why:
        yield from _labelled("why", question.why, width)
    yield line()


def model_lines(question: Question, width: int | None) -> Iterator[Line]:
    """The model answer of a card that the person rates."""
    yield from _labelled("model", question.answer, width)


def _labelled(label: str, text: str, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text), width, indent=2, column=2 + _LABELS)


def mistyped_lines(message: str, width: int | None) -> list[Line]:
    """What was typed is no answer."""
    return [
        line("  ", Span(row, Style.WARNING)) for row in wrap(message, None if width is None else width - 2)
    ]


def end_lines(
    asked: Sequence[tuple[Question, Rating]], drill: Sequence[tuple[Row, Sequence[str]]], width: int | None
) -> Iterator[Line]:
    """How the cards went, and the rows of the checklist to drill, each with the commands that do."""
    if not asked:
        yield line(Span("No card was answered.", Style.FAINT))
        return
    known = sum(rating is not Rating.AGAIN for _, rating in asked)
    yield line(Span(f"{known} of {counted(len(asked), 'card')} known", Style.STRONG))
    yield from drill_lines(drill, width)


def drill_lines(drill: Sequence[tuple[Row, Sequence[str]]], width: int | None) -> Iterator[Line]:
    """The rows to drill."""
    if not drill:
        return
    yield line()
    yield line(Span("To drill", Style.STRONG))
    columns = (Column("row"), Column("with"), Column("question", flexible=True))
    rows: list[list[Cell]] = [
        [Span(row.id, Style.STRONG), commands[0] if commands else "", row.ask] for row, commands in drill
    ]
    yield from Table(columns, rows).lines(width)


def list_lines(
    cards: Sequence[Card], reviews: Mapping[str, Review], now: datetime, width: int | None
) -> Iterator[Line]:
    """The cards, a row each, with when each is due; `reviews` are those that were answered, by their keys.

    A question has the one line that there is room for.
    """
    from judge.report.learned import due_words

    columns = (Column("card"), Column("form"), Column("due", spare=True), Column("question", flexible=True))
    due = {key: due_words(review.due, now) for key, review in reviews.items()}
    taken = [[cells(text) for text in (card.key, card.form, due.get(card.key, ""))] for card in cards]
    used = sum(max(column) + 2 for column in zip(*taken, strict=True)) + 2
    rows: list[list[Cell]] = [
        [
            Span(card.key, Style.STRONG),
            card.form,
            Span(due.get(card.key, ""), Style.FAINT),
            _one_line(card.front, None if width is None else width - used),
        ]
        for card in cards
    ]
    yield from Table(columns, rows).lines(width)
    new = sum(card.key not in reviews for card in cards)
    yield line()
    yield line(Span(f"{counted(len(cards), 'card')}, {new} new", Style.FAINT))


_LEAST = 20  # columns that a question has at least


def _one_line(text: str, room: int | None) -> str:
    """The question's beginning, where it is longer than a line of so many columns."""
    if room is None or room < _LEAST or cells(text) <= room:
        return text
    return wrap(text, room - 2)[0].rstrip(" ,;:") + " …"


def nothing_lines(when: str, width: int | None) -> list[Line]:
    """No card is due and none is new."""
    text = f"Nothing is due{f'; the next card is on {when}' if when else ''}. --ahead asks all the same."
    return hanging(Span(""), Span(text, Style.GOOD), width, indent=0, column=0)
