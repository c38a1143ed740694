"""`judge progress`: what your runs have shown, what is due, what comes next; on the screen or as a page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import click
from msgspec import Struct

from judge.cli.drilling import known_cards
from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.cli.resolve import shown
from judge.cli.target import OutFile, moment
from judge.errors import ProblemError, UsageError
from judge.practice import events
from judge.practice.checklist import find_row, read_checklist, unknown_skills
from judge.practice.events import Answer, Hack, Help
from judge.practice.hacks import hack_shares
from judge.practice.history import History
from judge.practice.progress import Progress, State, read_progress, standings
from judge.practice.review import card_reviews, reviews
from judge.practice.sets import USUAL, PracticeSet, find_set, sound_sets
from judge.problem import Problem
from judge.problem.find import problem_folders, sound_problems
from judge.report.published_progress import (
    CardsDue,
    DueShown,
    NextKata,
    ProgressPage,
    ProgressShown,
    ProgressWritten,
    QuestionShown,
    SetShare,
    Unfinished,
)
from judge.report.screen import note

_PAGE = Path("judge-report.html")


class ProgressAsk(Struct, frozen=True):
    """What to show of the progress."""

    whole: Annotated[bool, opt("--all", help="List each skill, kata and question.")] = False
    due: Annotated[bool, opt("--due", help="What to repeat today, and when the rest comes again.")] = False
    question: Annotated[
        str | None, opt("--question", metavar="ID", help="One interview question, and what ticks it.")
    ] = None
    html: Annotated[bool, opt("--html", help="Write a page that you can send and print.")] = False
    out: Annotated[Path, opt("--out", metavar="FILE", help=f"Write that page here, not to {_PAGE}.")] = _PAGE
    person: Annotated[str, opt("--name", metavar="NAME", help="Whose page it is, for its heading.")] = ""
    opened: Annotated[bool, opt("--open", help="Open the page in the browser.")] = False


@command("progress", ProgressShown, DueShown, QuestionShown, ProgressWritten)
@click.argument("name", metavar="[SET]", default=USUAL)
@takes(ProgressAsk, "ask")
def progress(name: str, ask: ProgressAsk, common: Common) -> Struct:
    """Show what you can do, what is due, and what comes next.

    A skill is ticked when one run passes all its test groups in one kata. The tick goes if your latest run
    fails one of them. A question of an interview is ticked by its katas, its skills, its cards (judge quiz)
    or a wrong program that you broke (judge hack).

    A kata that you solve at once comes again after 1, 3, 8, 21, 60, then 180 days, a step sooner if you
    needed failed runs or hints. Running an accepted file again changes nothing.
    """
    if ask.whole + ask.due + ask.html + (ask.question is not None) > 1:
        raise UsageError("--all, --due, --question and --html exclude each other", remedy="give one of them")
    if not ask.html and (ask.out != _PAGE or ask.person or ask.opened):
        raise UsageError("--out, --name and --open go with --html", remedy="add --html")
    if ask.html:
        return _page(ask, common)
    with history_at(common.db, reading=True) as history:
        if ask.due:
            return _due(history, common.problems)
        chosen = find_set(name, common.problems)
        for fault in chosen.faults:
            note(str(fault), bad=True)
        problems, _ = sound_problems(common.problems)
        found, faults = read_progress(history, problems, common.problems)
        for fault in (*unknown_skills(chosen.problems, common.problems), *faults):
            note(str(fault), bad=True)
        if ask.question is not None:
            row = find_row(ask.question, read_checklist(common.problems).rows).id
            (one,) = (each for _, rows in found.sections for each in rows if each.row == row)
            return QuestionShown(question=one)
        shares = tuple(hack_shares(chosen.problems, history.events(Hack)))
        due = _due(history, common.problems)
    sets = sound_sets(problems, common.problems)[0] if chosen.name == USUAL else []
    own = found.within([problem.id for problem in chosen.problems])
    parts = [each for each in own.sections if chosen.name in (USUAL, *each[0].sets)] or own.sections
    stars = Counter(found.stars(problem.id) for problem in chosen.problems)
    told = ProgressShown(
        set=chosen.name,
        title=chosen.title,
        katas=tuple(problem.id for problem in chosen.problems),
        solved=tuple(problem.id for problem in chosen.problems if found.solved(problem.id)),
        one_star=stars[1],
        two_stars=stars[2],
        sets=tuple(_share(each, found) for each in sets if each.problems and each.name != USUAL),
        skills=own.skills,
        levels=own.levels,
        mistakes=dict(sum(own.mistakes.values(), Counter[str]()).most_common()),
        rows=tuple(row for _, rows in parts for row in rows),
        hacks=shares,
        next=_next(chosen.problems, found),
    )
    return ProgressPage(told, due, ask.whole)


def _share(part: PracticeSet[Problem], progress: Progress) -> SetShare:
    own = progress.within([problem.id for problem in part.problems])
    stars = Counter(own.stars(problem.id) for problem in part.problems)
    return SetShare(
        name=part.name,
        katas=len(part.problems),
        solved=sum(own.solved(problem.id) for problem in part.problems),
        levelled=len({level.problem for level in own.levels}),
        one_star=stars[1],
        two_stars=stars[2],
        skills=len(own.skills),
        shown=sum(skill.state is State.SHOWN for skill in own.skills),
    )


def _next(problems: Sequence[Problem], progress: Progress) -> NextKata | None:
    """The first that was not tried; None where all were."""
    for problem in problems:
        if problem.id not in progress.standings:
            skills = (
                skill.name
                for skill in progress.skills
                if skill.state is not State.SHOWN and problem.id in {need.problem for need in skill.needs}
            )
            return NextKata(problem=problem.id, title=problem.title, skill=next(skills, ""))
    return None


def _due(history: History, folders: Sequence[Path]) -> DueShown:
    """What is unfinished, and what comes again when; a kata that is unfinished is not repeated yet."""
    today, runs = events.now().astimezone(), history.runs()
    here = {folder.name for folder in problem_folders(folders)}
    found = reviews(runs, history.events(Help))
    tried = {name: each for name, each in standings(runs).items() if each.passed is None and name in here}
    known = [each for each in found if each.name in here and each.name not in tried]
    cards = card_reviews(history.events(Answer))
    if cards:  # whoever has answered none waits for no deck
        cards = known_cards(cards, folders)
    return DueShown(
        time=today,
        now=tuple(Unfinished(problem=name, best=each.best, last=each.last) for name, each in tried.items()),
        due=tuple(each for each in known if each.is_due(today)),
        later=tuple(each for each in known if not each.is_due(today)),
        elsewhere=tuple(sorted({each.name for each in found} - here)),
        cards=CardsDue(
            tuple(each for each in cards if each.is_due(today)),
            tuple(each for each in cards if not each.is_due(today)),
        ),
    )


def _page(ask: ProgressAsk, common: Common) -> ProgressWritten:
    """Write the page. Raises UsageError where there is nothing to write, or something else is there."""
    from judge.report.html import is_page
    from judge.report.html.learner import MARK, learner_page

    target = OutFile(ask.out, "--out", "page of judge progress", lambda start: is_page(start, MARK))
    target.check()
    with history_at(common.db, reading=True) as history:
        runs = [run for run in history.runs() if run.counts]
        if not runs:
            raise UsageError("You have no runs yet", remedy="judge a file first: judge run FILE")
        solved = {run.problem: run.id for run in runs if run.solved}
        sources = {name: history.source(number) for name, number in solved.items()}
        problems, faults = sound_problems(common.problems)
        for fault in faults:  # its runs are shown all the same
            note(f"a kata is left out: {fault}")
        try:
            skills = read_progress(history, problems, common.problems)[0].skills
        except ProblemError as fault:
            note(f"the skills are left out: {fault}")
            skills = ()
    generated = moment().astimezone()
    page = learner_page(runs, problems, skills, sources, person=ask.person, generated=generated)
    target.write(page)
    if ask.opened:
        click.launch(str(ask.out))
    tried = tuple(sorted({run.problem for run in runs}))
    return ProgressWritten(out=shown(ask.out), bytes=len(page), runs=len(runs), problems=tried)
