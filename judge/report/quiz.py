"""Cards on a screen: a question, what an answer came to, the list; and how a round or an interview went."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime

from rich.console import Group, RenderableType
from rich.text import Text

from judge.drawing import Picture
from judge.practice.drill import DrillStep
from judge.practice.events import Rating
from judge.practice.questions import CardReply, Question
from judge.practice.quiz import Practise, Topic
from judge.report.parts import (
    BAD,
    GOOD,
    Cell,
    bad,
    blocks,
    facts,
    faint,
    good,
    head,
    heading,
    indented,
    paragraph,
    strong,
    table,
    text,
    warning,
)
from judge.report.published_quiz import Drill, Interviewed, Quizzed
from judge.report.screen import Screen, drawn
from judge.report.words import counted, due_words

RATE = "How well? 1 again, 2 hard, 3 good, 4 easy: "
SAVE = "Save the file. Enter judges it, q goes on: "
_OPEN = 38  # columns of the skills that are named
_NARROW = 60  # columns that the steps need
_AROUND = 2  # rows for the prompt and one above


def question(asked: Question, place: str, screen: Screen) -> RenderableType:
    """The card, what is known of its figure, and the figure where the terminal has room for it."""
    parts: list[RenderableType] = [faint(place), _prose(strong(asked.card.front)), *map(_prose, asked.given)]
    if asked.program:
        rows = [indented(text(row), 4) if row else Text() for row in asked.program.splitlines()]
        parts += [Text(), *rows, Text()]
    if asked.options:
        parts.append(indented(table([(strong(letter), said) for letter, said in asked.options])))
    return Group(*parts, *_figure(asked.picture, parts, screen, answered=False))


def _figure(
    picture: Picture | None, above: Sequence[RenderableType], screen: Screen, *, answered: bool
) -> Iterator[RenderableType]:
    """The figure, in the rows that are left, where the terminal has room for it."""
    from judge.drawing.braille import LEAST_ROWS
    from judge.report.picture import has_room, picture_rows

    if picture is not None and has_room(screen):
        room = screen.height - drawn(Group(*above), screen).count("\n") - _AROUND
        yield from map(indented, picture_rows(picture, screen, max(room, LEAST_ROWS), answered=answered))


def _prose(said: Cell) -> RenderableType:
    return indented(paragraph(said))


def prompt(asks: str, screen: Screen) -> str:
    """What may be typed, ready to be written: its last line is left open."""
    return drawn(indented(faint(asks.rstrip())), screen).removesuffix("\n") + " "


def reply(asked: Question, found: CardReply | None, rating: Rating, screen: Screen) -> RenderableType:
    """Whether the answer was right, the right one, why, a figure; `found` is None where none was given."""
    if asked.check is None:
        return Group(indented(faint(f"noted: {rating.name.lower()}")), Text())
    right = found is not None and found.right
    mistake = f": {found.mistake}" if found and found.mistake else ""
    verdict = good("✓ right") if right else bad(f"✗ wrong{mistake}" if found else "✗ skipped")
    because = found.why if found and not right else ""
    pairs = [("because", because), ("answer", "" if right else asked.answer), ("why", asked.why)]
    said = [pair for pair in pairs if pair[1]]
    parts = [indented(verdict), *([indented(facts(said))] if said else [])]
    return Group(*parts, *_figure(asked.drawn, parts, screen, answered=True), Text())


def model(asked: Question) -> RenderableType:
    """The model answer of a card that the person rates."""
    return indented(facts([("model", asked.answer)]))


def remark(message: str) -> RenderableType:
    """What was typed is not an answer, or the time is over."""
    return indented(warning(message))


def quizzed(found: Quizzed, _screen: Screen) -> RenderableType:
    """How the cards went, and what to practise."""
    if found.next_due is not None:
        when = f"The next card is due on {found.next_due.astimezone():%Y-%m-%d}."
        return good(f"Nothing is due today. {when}")
    if not found.asked:
        return faint("No card was answered.")
    known = strong(f"{found.known} of {counted(found.asked, 'card')} known")
    return blocks(known, _practise(found.practise))


def _practise(found: Sequence[Practise]) -> RenderableType | None:
    rows = [(each.commands[0], each.ask) for each in found]
    return heading("Practise", table(rows)) if rows else None


def opening(minutes: int, before: int, kata: str, after: int) -> RenderableType:
    """What is to come in an interview: so many cards before the kata, and after it."""
    first, last = ([counted(count, "card")] if count else [] for count in (before, after))
    parts = ", then ".join([*first, f"the kata {kata}", *last])
    return stage("Mock interview", minutes, f"{parts}. q goes on to the next part, and a second q ends it.")


def stage(title: str, minutes: int, *said: str) -> RenderableType:
    """What comes next, how long it takes, and what is said of it."""
    return Group(head(title, faint(counted(minutes, "minute"))), *map(_prose, said), Text())


def interviewed(found: Interviewed, _screen: Screen) -> RenderableType:
    """How it went, and what to practise."""
    cards = f"{found.known} of {counted(found.asked, 'card')} known" if found.asked else "none answered"
    said: list[tuple[Cell, Cell]] = [("cards", cards), ("kata", _kata(found))]
    if found.lacking:
        said.append(("not yet", ", ".join(found.lacking)))
    title = head("The interview", faint(f"{found.minutes} of {counted(found.out_of, 'minute')}"))
    nothing = good("Nothing to practise.") if found.solved and found.known == found.asked else None
    return Group(Text(), blocks(Group(title, indented(facts(said))), nothing or _practise(found.practise)))


def _kata(found: Interviewed) -> Text:
    if found.verdict is None:
        return faint(f"{found.problem}: not judged")
    mistake = f", {found.mistake}" if found.mistake else ""
    points = f"{found.verdict.value}, {found.score} of 100 points after {counted(found.runs, 'run')}"
    return text(f"{found.problem}: {points}{mistake}", GOOD if found.solved else BAD)


def drill(found: Drill, screen: Screen) -> RenderableType:
    """How the topics stand, the commands with their minutes, and what comes after them."""
    about = f"Tonight, about {found.minutes} minutes" if found.steps else "Nothing to drill tonight"
    narrow = screen.width is not None and screen.width < _NARROW
    rows: list[tuple[Cell, ...]] = []
    for at, each in enumerate(found.steps, 1):
        minutes, said = f"{each.minutes} min", _step(each, found.time)
        wide = str(at), minutes, each.command, said
        rows.append((f"{at} {each.command}", f"{minutes}, {said}") if narrow else wide)
    skills = sum(len(each.skills) for each in found.topics)
    known = "known?" if any(each.open for each in found.topics) else "are known."
    last = f"All {skills} {known} " if skills else ""
    last += "judge interview holds a mock interview at your level."
    return blocks(
        strong(about),
        indented(table(map(_topic, found.topics))) if found.topics else None,
        indented(table(rows, right=() if narrow else [1])) if rows else None,
        indented(paragraph(faint(last))),
    )


def _topic(each: Topic) -> tuple[Cell, ...]:
    known, named = len(each.skills) - len(each.open), each.open[:2]
    named = named if len(", ".join(named)) <= _OPEN else named[:1]
    more = [f"{len(each.open) - len(named)} more"] if len(named) < len(each.open) else []
    share = f"[{'#' * known:.<{len(each.skills)}}]  {known} of {len(each.skills)}"
    return each.name.capitalize(), share, f"open: {', '.join([*named, *more])}" if named else good("known")


def _step(each: DrillStep, now: datetime) -> str:
    """What the command is about."""
    if each.new or each.due:
        new = [counted(each.new, "new card")] if each.new else []
        return ", ".join([*new, *([f"{each.due} due"] if each.due else [])])
    if each.topic:
        return f"a wrong program about {each.topic}: find a case"
    if each.title:
        return f"{each.title}: {'not solved yet' if each.last else 'new'}"
    return f"solved {due_words(each.last, now)}; from memory" if each.last else ""
