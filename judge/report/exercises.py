"""The screens of what is asked: a case (try), a wrong program (hack), cards (quiz, interview), an evening."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime
from functools import partial
from itertools import chain
from typing import Any

from rich.console import Group, RenderableType
from rich.text import Text

from judge.data.parse import call_of, line_of
from judge.drawing import Picture
from judge.drawing.braille import LEAST_ROWS
from judge.practice.drill import DrillStep
from judge.practice.events import Rating
from judge.practice.questions import CardReply, Question
from judge.practice.quiz import Practise, Topic
from judge.problem import Verdict
from judge.problem.find import typed
from judge.problem.formats import input_of
from judge.problem.transcripts import typed_lines
from judge.report.entry import entry_text
from judge.report.parts import (
    BAD,
    GOOD,
    Cell,
    bad,
    blocks,
    commands,
    facts,
    faint,
    good,
    head,
    heading,
    indented,
    joined,
    label,
    paragraph,
    strong,
    table,
    text,
    under,
    verdict_head,
    warning,
)
from judge.report.picture import case_picture, drawing, has_room, picture_rows
from judge.report.published_exercises import CaseTried, Drill, HackTurn, Interviewed, PageWritten, Quizzed
from judge.report.screen import Screen, drawn
from judge.report.words import arguments, counted, day, due_words, shown_name
from judge.run.result import EntryKind, Failure
from judge.run.tried import OneCase
from judge.values import show
from judge.values.letters import texts_of

_MOST = 12  # numbers whose ends are shown
_PRINTED = 10  # lines
_ANSWERS = 3  # of several that are right, which are shown
RATE = "How well? 1 again, 2 hard, 3 good, 4 easy: "
SAVE = "Save the file. Enter judges it, q goes on: "
_OPEN = 38  # columns of the skills that are named
_NARROW = 60  # columns that the steps need
_AROUND = 2  # rows for the place of a question and the empty one below; one more for the legend of an answer


def case_tried(found: CaseTried, screen: Screen) -> RenderableType:
    """The case in both forms and its answer, the picture, and the verdict on the file's answer."""
    tried, said = found.tried, found.tried.said
    if said is None:
        return _fitted(tried, head(tried.problem.id, tried.problem.title), None, screen)
    above = verdict_head(said.verdict, said.verdict.meaning.capitalize(), said.submission)
    last = joined(label(said.verdict), f"  this case {'fails' if tried.failed else 'passes'}")
    return _fitted(tried, above, last, screen)


def page_written(found: PageWritten, _screen: Screen) -> RenderableType:
    """What was written, and of which kata."""
    return text(f"Wrote {shown_name(found.file)}: {found.problem}")


def _fitted(
    tried: OneCase, above: RenderableType | None, below: RenderableType | None, screen: Screen
) -> RenderableType:
    """The case between what is above and below it, with its picture; a low screen says less of it."""
    why, picture = drawing(partial(picture_of, tried), screen, "the case")
    full, short = (indented(facts(_facts(tried, why, brief))) for brief in (False, True))
    for middle in (full, short) if picture else ():
        rows = screen.height - drawn(blocks(above, middle, below), screen).count("\n") - 2  # empty, prompt
        if picture and rows >= LEAST_ROWS:
            return blocks(above, middle, Group(*picture(rows)), below)
    return blocks(above, full, below)


def _facts(tried: OneCase, why: str, brief: bool) -> Iterator[tuple[Cell, Cell]]:
    """What is known of the case; `why` is what it turns on, and `brief` leaves out its other forms."""
    problem, said = tried.problem, tried.said
    if tried.case:
        plain = arguments(problem.named(tried.case))
        yield from under("case", typed_lines(problem, tried.case) if problem.methods else [plain])
    if tried.case and not brief and not (problem.methods or problem.talks):
        own = tried.module.format
        given = input_of(problem, own, tried.case).rstrip() if own else line_of(problem, tried.case)
        yield from under("as program input", given.split("\n"))
    as_given = problem.methods or texts_of(problem.answer) or "{" in problem.answer.text
    shown = tried.expected if as_given else _plain(show.exact_text(tried.exact))
    if not problem.talks:
        yield "exact answer", good(shown)
    if not brief and (ends := [*_ends(show.accepted(problem.answer, tried.target))]):
        yield "in doubles", good(tried.expected)
        yield from under("accepted", [*ends[:_MOST], *["and so on"] * (len(ends) > _MOST)])
    if said is None:
        why = tried.no_case or why
        yield from [("why", why)] if why else []
        return
    if not problem.talks:
        yield "got", (bad if tried.failed else text)(said.got)
    if (hurdle := said.hurdle) is not None:
        placed = hurdle.line and hurdle.kind in (EntryKind.ARITY, EntryKind.MODULE)
        line = f"line {hurdle.line}: " if placed else ""
        yield "why", line + entry_text(hurdle, problem, said.submission, said.verdict, said.message)
    elif said.message or why:
        yield "why", said.message or why
    printed = said.printed.splitlines()
    yield from under("dialogue", printed) if problem.talks else under("printed", printed[:_PRINTED])


def _ends(accepted: Any) -> Iterator[str]:
    """The least and the greatest that is accepted of each number; of several answers those of the first."""
    if isinstance(accepted, dict):
        accepted = accepted["any"][0] if "any" in accepted else accepted["such as"]
    if isinstance(accepted, list):
        is_number = len(accepted) == 2 and all(isinstance(each, float) for each in accepted)
        yield from [" to ".join(map(repr, accepted))] if is_number else chain(*map(_ends, accepted))


def _plain(exact: Any) -> str:
    """An exact answer as it would be written in Python, its numbers in up to 40 digits."""
    if isinstance(exact, dict):
        if "such as" in exact:
            return f"such as {_plain(exact['such as'])}"
        answers = exact["any"]
        deep = isinstance(answers[0], list) and any(isinstance(each, list) for each in answers[0])
        most = 1 if deep else _ANSWERS
        return " or ".join([*map(_plain, answers[:most]), *["…"] * (len(answers) > most)])
    if isinstance(exact, list):
        listed = ", ".join(map(_plain, exact))
        is_point = 2 <= len(exact) <= 3 and all(isinstance(each, str) for each in exact)
        return f"({listed})" if is_point else f"[{listed}]"
    return str(exact)


def picture_of(tried: OneCase) -> Picture | None:
    """The case drawn with its answer and, where that is rejected, the file's; None where nothing can be."""
    got, given = (tried.failed.got, tried.failed.given) if tried.failed else (None, None)
    values = tried.problem.named(tried.case)
    case = Failure("", input=values, expected=tried.expected, got=got, given=given)
    return case_picture(tried.problem, tried.module, case, tried.group.name)


def hack_turn(found: HackTurn, screen: Screen) -> RenderableType:
    """The program and what is asked; or whether a case breaks it."""
    if found.outcome == "shown":
        return _program(found)
    ended = _ended(found)
    return _fitted(found.tried, None, ended, screen) if found.tried else ended


def _program(found: HackTurn) -> RenderableType:
    name, number = found.problem.id, found.puzzle.number
    aside = f"wrong program {number} of {len(found.puzzles)}, {found.done} broken"
    rows = map(text, found.puzzle.source.decode().splitlines())
    command = f'  judge hack {typed(found.problem)} {number} "{call_of(found.problem)}"'
    asked = Group("This program is wrong for at least one valid input. Find one:", text(command))
    more = f"All are broken. {found.more} more: judge hack {typed(found.problem)} --all"
    return blocks(head(name, aside), Group(*rows), asked, None if found.following or not found.more else more)


def _ended(found: HackTurn) -> RenderableType:
    """The mistake, once it may be named, and what came of the case."""
    puzzle, kata = found.puzzle, f"judge hack {typed(found.problem)}"
    if found.outcome == "lost":
        lost, again = facts([(label(Verdict.WA, "LOST"), found.why)]), f"{kata} {puzzle.number}"
        more = [(again, "shows the program again"), (f"{again} --give-up", "names the mistake")]
        return lost if found.goes_on else blocks(lost, indented(commands(more)))
    mistake = Group(indented(bad(puzzle.mistake)), indented(text(puzzle.advice), 4))
    if found.outcome == "given-up":
        return mistake
    said = f"broken, {found.done} of {counted(len(found.puzzles), 'program')} of {found.problem.id}"
    if found.following:
        said += f"; next: {kata} {found.following.number}"
    elif found.more:
        said += f"; {found.more} more: {kata} --all"
    return blocks(mistake, facts([(label(Verdict.AC, "WON"), said)]))


# -- cards, and an evening of them --------------------------------------------------------------------------


def question(asked: Question, place: str, screen: Screen) -> RenderableType:
    """The card, what is known of its figure, and the figure where the terminal has room for it."""
    parts = [faint(place), *_asked(asked)]
    return Group(*parts, *_figure(asked, asked.picture, screen, answered=False))


def _asked(asked: Question) -> Iterator[RenderableType]:
    yield _prose(strong(asked.card.front))
    yield from map(_prose, asked.given)
    if asked.options:
        yield indented(table([(strong(letter), said) for letter, said in asked.options]))


def _figure(
    asked: Question, picture: Picture | None, screen: Screen, *, answered: bool
) -> Iterator[RenderableType]:
    """The figure, in the rows that the question and its longest reply leave.

    Where those are too few, one with the reply is left out, and one with the question is as high as if there
    was no reply.
    """
    if picture is None or not has_room(screen):
        return
    words = [*_asked(asked), indented(expected(asked))]
    for more in (_said(asked, None), ()):
        room = screen.height - drawn(Group(*words, *more), screen).count("\n") - _AROUND - answered
        if room >= LEAST_ROWS:
            break
        if answered:
            return
    yield from map(indented, picture_rows(picture, screen, room, answered=answered))


def expected(asked: Question) -> str:
    """What the prompt of a card asks for, which the judge rates."""
    return f"Answer ({asked.expects}): "


def _prose(said: Cell) -> RenderableType:
    return indented(paragraph(said))


def prompt(asks: str, screen: Screen) -> str:
    """What may be typed, ready to be written: its last line is left open."""
    return drawn(indented(faint(asks.rstrip())), screen).removesuffix("\n") + " "


def reply(asked: Question, found: CardReply | None, rating: Rating, screen: Screen) -> RenderableType:
    """Whether the answer was right, the right one, why, a figure; `found` is None where none was given."""
    if asked.check is None:
        return Group(indented(faint(f"noted: {rating.name.lower()}")), Text())
    return Group(*_said(asked, found), *_figure(asked, asked.drawn, screen, answered=True), Text())


def _said(asked: Question, found: CardReply | None) -> Iterator[RenderableType]:
    right = found is not None and found.right
    mistake = f": {found.mistake}" if found and found.mistake else ""
    yield indented(good("✓ right") if right else bad(f"✗ wrong{mistake}" if found else "✗ skipped"))
    pairs = [("because", found.why if found else ""), ("answer", asked.answer)] if not right else []
    if said := [pair for pair in (*pairs, ("why", asked.why)) if pair[1]]:
        yield indented(facts(said))


def model(asked: Question) -> RenderableType:
    """The model answer of a card that the person rates."""
    return indented(facts([("model", asked.answer)]))


def remark(message: str) -> RenderableType:
    """What was typed is not an answer, or the time is over."""
    return indented(warning(message))


def quizzed(found: Quizzed, _screen: Screen) -> RenderableType:
    """How the cards went, and what to practise."""
    if found.next_due is not None:
        return good(f"Nothing is due today. The next card is due on {day(found.next_due)}.")
    if not found.asked:
        return faint("No card was answered.")
    return blocks(strong(f"{found.known} of {counted(found.asked, 'card')} known"), _practise(found.practise))


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
    lacking = [("not yet", ", ".join(found.lacking))] if found.lacking else []
    said: list[tuple[Cell, Cell]] = [("cards", cards), ("kata", _kata(found)), *lacking]
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
