"""`judge quiz`: cards, asked again before they are forgotten; and the mock interview."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from datetime import datetime
from pathlib import Path

import click

from judge.cli.asking import SCHEMA, AsEvents, OnScreen, Round, StoppedError, Voice
from judge.cli.drilling import to_drill
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option
from judge.errors import ExitCode, UsageError, nearest
from judge.kata import events
from judge.kata.quiz.cards import Card, all_cards, cards_of
from judge.kata.quiz.choose import next_cards, next_due
from judge.kata.quiz.questions import Sources
from judge.kata.review import Review, card_reviews
from judge.kata.sets import USUAL
from judge.report.progress import progress
from judge.report.screen import note, out

_COUNT = 10
_MINUTES = 30
_SEED_BYTES = 4


@click.command("quiz")
@click.argument("name", metavar="[SET]", default=USUAL)
@click.option(
    "--cards", "count", type=click.IntRange(0, 1000), metavar="N", help=f"How many cards; {_COUNT}."
)
@click.option("--row", metavar="ROW", help="Only cards of this question of the checklist, due or not.")
@click.option("--form", metavar="FORM", help="Only cards of this form, due or not.")
@click.option("--card", "key", metavar="CARD", help="Only this card, as deck/id, due or not.")
@click.option("--ahead", is_flag=True, help="Also ask cards that are not due yet.")
@click.option("--seed", type=click.IntRange(0), metavar="N", help="Repeat the figures of this seed.")
@click.option("--list", "listing", is_flag=True, help="List the cards instead of asking them.")
@click.option("--check", "checking", is_flag=True, help="Check every deck and every card.")
@click.option("--interview", is_flag=True, help="A mock interview: cards and a kata, then what to practise.")
@click.option("--minutes", type=click.IntRange(1, 600), metavar="N", help=f"Of the interview; {_MINUTES}.")
@click.option("--kata", metavar="PROBLEM", help="The kata of the interview.")
@click.option(
    "--file", metavar="FILE", type=click.Path(dir_okay=False), help="Your file for it, instead of a new one."
)
@json_option
@db_option
@problems_option
def command(
    name: str,
    count: int | None,
    row: str | None,
    form: str | None,
    key: str | None,
    ahead: bool,
    seed: int | None,
    listing: bool,
    checking: bool,
    interview: bool,
    minutes: int | None,
    kata: str | None,
    file: str | None,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Ask cards, or hold a mock interview.

    Cards are short questions that need no code: first the cards of SET that are due, then new ones. You type
    one line. What you say in your own words you compare with a model answer, and rate. `?` means "I do not
    know". `q`, Ctrl-D and Ctrl-C stop; your answers are kept, and decide when a card comes again.

    --interview is a mock interview: some cards, a kata whose file is judged on every save, more cards, and a
    page of what to practise. Without a terminal the answers are read from a pipe, one a line.
    """
    asked = {"--interview": interview, "--list": listing, "--check": checking}
    modes = [name for name, on in asked.items() if on]
    if modes[1:]:
        raise UsageError(f"{modes[0]} and {modes[1]} do not go together", remedy="leave one of them out")
    if not interview and (minutes or kata or file):
        option = "--minutes" if minutes else "--kata" if kata else "--file"
        raise UsageError(f"{option} belongs to --interview", remedy="add that, or leave it out")
    if not interview and count == 0:
        raise UsageError("--cards 0 asks nothing", remedy="write 1 or more; 0 is for --interview")
    every = all_cards(folders)
    cards = cards_of(name, every, folders)
    cards, narrowed = _narrowed(cards, every, row, form, key, folders)
    cards = _here(cards, folders, told=checking)
    seed = int.from_bytes(os.urandom(_SEED_BYTES), "big") if seed is None else seed
    sources = Sources(folders, seed, progress)
    if listing:
        return _list(cards, db, as_json=as_json)
    if checking:
        return _check(cards, sources, as_json=as_json)
    voice: Voice = AsEvents(seed) if as_json else OnScreen()
    with history_at(db) as history:
        asking = Round(sources, voice, history)
        if interview:
            from judge.cli.interview import Interview, hold  # who quizzes alone does without judging

            wanted = Interview(name, minutes or _MINUTES, kata, file, count, db)
            return hold(wanted, cards, asking)
        reviews = card_reviews(history.events(events.Answer))
        chosen = next_cards(cards, reviews, _now(), count or _COUNT, ahead=ahead or narrowed)
        if not chosen:
            _tell_nothing(cards, reviews, voice, as_json=as_json)
            return ExitCode.ACCEPTED
        try:
            with suppress(StoppedError):
                for place, card in enumerate(chosen, 1):
                    asking.ask(card, place, len(chosen))
        finally:  # after Ctrl-C too
            voice.end(asking.asked, to_drill(asking.missed, folders))
    return ExitCode.ACCEPTED


def _narrowed(
    cards: Sequence[Card],
    every: Sequence[Card],
    row: str | None,
    form: str | None,
    key: str | None,
    folders: Sequence[Path],
) -> tuple[list[Card], bool]:
    """The cards of the set that the options ask for, and whether they ask for some; `every` card is known."""
    found = list(cards)
    if row is not None:
        from judge.kata.checklist import find_row, read_checklist

        wanted = find_row(row, read_checklist(folders).rows).id
        found = [card for card in found if wanted in card.rows]
        if not found:
            raise UsageError(
                f"no card drills the row {wanted!r}", remedy=f"see 'judge progress --question {wanted}'"
            )
    if key is not None:
        meant = nearest(key, [card.key for card in found])
        found = [card for card in found if key in (card.key, card.id)]
        if not found and any(key in (card.key, card.id) for card in every):
            raise UsageError(f"the card {key!r} is not among those", remedy="name it alone")
        if not found:
            remedy = f"did you mean {meant!r}?" if meant else "'judge quiz --list' lists them"
            raise UsageError(f"there is no card {key!r}", remedy=remedy)
    if form is not None:
        found = _of_form(form, found)
    return found, not row is form is key is None


def _of_form(form: str, cards: Sequence[Card]) -> list[Card]:
    from judge.kata.quiz.cards import FORMS

    if form not in FORMS:
        meant = nearest(form, FORMS)
        remedy = f"did you mean {meant!r}?" if meant else f"the forms are {', '.join(FORMS)}"
        raise UsageError(f"no form of cards is called {form!r}", remedy=remedy)
    found = [card for card in cards if card.form == form]
    if not found:
        raise UsageError(
            f"none of those cards has the form {form!r}",
            remedy="leave out --form, or see 'judge quiz --list'",
        )
    return found


def _here(cards: Sequence[Card], folders: Sequence[Path], *, told: bool) -> list[Card]:
    """The cards whose problem can be found; `told` says which are not."""
    from judge.kata.quiz.cards import unknown_parts

    missing = unknown_parts(cards, folders)
    if told:
        for problem, card in missing.items():
            note(f"{card} is left out: no problem is called {problem!r}")
    return [card for card in cards if card.problem not in missing]


def _tell_nothing(cards: Sequence[Card], reviews: Sequence[Review], voice: Voice, *, as_json: bool) -> None:
    if as_json:
        voice.end([], [])
        return
    from judge.report.history import day
    from judge.report.quiz import nothing_lines

    when, screen = next_due(cards, reviews), out()
    screen.show(nothing_lines(day(when) if when else "", screen.width))


def _list(cards: Sequence[Card], db: Path | None, *, as_json: bool) -> ExitCode:
    from judge.cli.options import write_json
    from judge.report.quiz import list_lines

    now = _now()
    with history_at(db, reading=True) as history:
        reviews = {review.name: review for review in card_reviews(history.events(events.Answer))}
    if as_json:
        for card in cards:
            write_json({"schema": SCHEMA, "event": "card", **_as_object(card, reviews.get(card.key))})
    else:
        screen = out()
        screen.show(list_lines(cards, reviews, now, screen.width))
    return ExitCode.ACCEPTED


def _as_object(card: Card, review: Review | None) -> dict[str, object]:
    """The published object of a card, without its answer; what is kept of it is null where there is none."""
    return {
        "card": card.key,
        "form": card.form,
        "rows": list(card.rows),
        "sets": list(card.sets),
        "front": card.front,
        "last": review.last.isoformat() if review else None,
        "rating": review.rating.name.lower() if review else None,
        "due": review.due.isoformat() if review else None,
    }


def _check(cards: Sequence[Card], sources: Sources, *, as_json: bool) -> ExitCode:
    """Make a question of each card. Raises ProblemError with the first fault."""
    from judge.cli.options import write_json
    from judge.kata.quiz.questions import ask
    from judge.report.layout import Span, Style, line
    from judge.report.values import counted

    for card in cards:
        ask(card, sources, "check")
    if as_json:
        write_json({"schema": SCHEMA, "event": "sound", "cards": len(cards)})
    else:
        out().show([line(Span("sound", Style.GOOD), f"  {counted(len(cards), 'card')} checked")])
    return ExitCode.ACCEPTED


def _now() -> datetime:
    return events.now().astimezone()
