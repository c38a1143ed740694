"""`judge progress`: what your runs have shown, what is due, what comes next.

`judge history`: the runs so far, one of them in full, a source again.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import check_place, writing
from judge.cli.options import Common, command, opt
from judge.cli.resolve import KATAS, history_at, seen_cards, shown, this_folder
from judge.errors import UsageError
from judge.files import new_file
from judge.languages import is_program
from judge.practice import events, syllabus
from judge.practice import progress as learned
from judge.practice.cards import read_decks
from judge.practice.events import Hack, Run
from judge.practice.history import History
from judge.practice.progress import State
from judge.practice.review import Due, Learner, read_learner
from judge.practice.stub import write_over
from judge.practice.syllabus import USUAL, PracticeSet, Skill
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report import published_progress as published
from judge.report.screen import note

_ON_SCREEN = 18  # runs, unless it is said how many
_DIGITS = 18  # of the number of a run; what is longer is the name of a kata


class ProgressAsk(Struct, frozen=True):
    """What to show of the progress."""

    due: bool = opt("--due", "What to repeat today, and when the rest comes again.")
    question: str | None = opt("--question ID", "One interview question, and what ticks it.")


@command("progress", published.ProgressShown, Due, published.QuestionShown, ask=ProgressAsk)
@click.argument("name", metavar="[SET]", default=USUAL)
def progress(name: str, ask: ProgressAsk, common: Common) -> Struct:
    """Show what you can do, what is due, and what comes next.

    A skill is ticked when one run passes all its test groups in one kata. The tick goes if your latest run
    fails one of them. A question of an interview is ticked by its katas, its skills, its cards (judge quiz)
    or a wrong program that you broke (judge hack).

    A kata that you solve at once comes again after 1, 3, 8, 21, 60, then 180 days, a step sooner if you
    needed failed runs or hints. Running an accepted file again changes nothing.
    """
    if ask.due and ask.question is not None:
        raise UsageError("--due and --question exclude each other; give one of them")
    folders = common.problems
    with history_at(common.db, reading=True) as history:
        mine, hacks = read_learner(history, folders), history.events(Hack)
    due = mine.due(events.now().astimezone(), seen_cards(mine))
    if ask.due:
        return due
    chosen = syllabus.find_set(name, mine.problems, folders)
    checklist = syllabus.read_checklist(folders)
    cards, faults = read_decks(folders)
    for fault in (*mine.faults, *syllabus.unknown_names(mine.problems, folders), *faults):
        note(str(fault), bad=True)
    every = learned.skills(mine.problems, mine.own, checklist.skills)
    asked = learned.questions(mine.problems, mine.solved, every, checklist, cards, mine.answers, hacks)
    if ask.question is not None:
        row = syllabus.find_row(ask.question, checklist.rows).id
        return published.QuestionShown(next(each for each in asked if each.row == row))
    parts = {each.title for each in checklist.sections if name in (USUAL, *each.sets)}
    sets = [each for each in mine.sets if each.problems and name == USUAL != each.name]
    runs = [run for each in chosen.problems for run in mine.own.get(each.id, ())]
    if name == USUAL:  # as judge start goes on
        following = mine.next(mine.runs[-1].problem if mine.runs else "")
    else:
        following = next((each for each in chosen.problems if each.id not in mine.own), None)
    told = published.ProgressShown(
        set=_share(chosen, mine, checklist.skills),
        sets=tuple(_share(each, mine, checklist.skills) for each in sets),
        skills=tuple(learned.skills(chosen.problems, mine.own, checklist.skills)),
        mistakes=dict(learned.mistakes(runs).most_common()),
        rows=tuple([each for each in asked if each.section in parts] or asked),
        next=following.id if following else None,
    )
    return published.ProgressPage((told,), due, following)


def _share(part: PracticeSet[Problem], mine: Learner, named: Sequence[Skill]) -> published.SetShare:
    counted, shown = mine.counted(part), learned.skills(part.problems, mine.own, named)
    names = [each.id for each in counted]
    return published.SetShare(
        name=part.name,
        title=part.title,
        katas=tuple(names),
        solved=tuple(each for each in names if each in mine.solved),
        stars=mine.stars(counted) if any(each.levels for each in counted) else (),
        skills=len(shown),
        shown=sum(skill.state is State.SHOWN for skill in shown),
    )


class HistoryAsk(Struct, frozen=True):
    """What to show of the runs."""

    limit: int | None = opt("--limit N", "Only the last N runs.", type=click.IntRange(1))
    restore: bool = opt("--restore", "Write the source of that RUN to its file again.")
    out: Path | None = opt("--out FILE", "Restore it to this file instead.")


@command("history", published.RunRow, published.Restored, ask=HistoryAsk)
@click.argument("words", metavar="[KATA|RUN]", nargs=-1)
def history(words: tuple[str, ...], ask: HistoryAsk, common: Common) -> Struct:
    """Show your runs, or one run.

    The latest run is last. The screen shows the last 18, JSON all of them. RUN is the number in the
    first column.

    With --restore, the source that a run judged is written to its file again. If that file has changed since,
    it is kept as FILE.bak. A damaged run is left out, and a note says so.
    """
    numbers = [int(word) for word in words if word.isdecimal() and len(word) <= _DIGITS]
    for broken, said in (
        (len(words) > 1, "Give one kata or one run; such as judge history 3"),
        (ask.restore and not numbers, "Which run? --restore takes one; such as judge history 3 --restore"),
        (ask.out and not ask.restore, "--out goes with --restore: judge history 3 --restore --out old.py"),
        (numbers and ask.limit, "--limit is for the list of runs; leave it out"),
    ):
        if broken:
            raise UsageError(said)
    with history_at(common.db, reading=True) as found:
        if not numbers:
            return _listed(words[0] if words else "", ask, common, found)
        run, source = found.run(numbers[0]), found.source(numbers[0])
    return _restored(run, source, ask.out) if ask.restore else published.row_of(run)


def _listed(name: str, ask: HistoryAsk, common: Common, history: History) -> published.RunList:
    """The last runs, of that kata if one is named, which may be gone since. Raises UsageError."""
    most = ask.limit or (None if common.json else _ON_SCREEN)
    runs = history.runs(name or None, most and most + 1)
    if not runs and name:
        find_problem(name, common.problems)
    kept = runs[-most:] if most else runs
    more = ask.limit is None and len(kept) < len(runs)
    return published.RunList(history.with_results(kept) if common.json else kept, name, more)


def _restored(run: Run, source: bytes, target: Path | None) -> published.Restored:
    """Write the source of that run to `target`, or to where it was; what is there is kept beside it."""
    if target is None and not run.path:
        raise UsageError(f"run {run.id} judged no ordinary file", remedy="name one with --out FILE")
    here = this_folder()
    if target is None and not (is_program(run.path) and Path(run.path).parent in (here, here / KATAS)):
        what = f"run {run.id} judged {run.path}, which is no program of this folder"
        raise UsageError(what, remedy="go to its folder, or name a file with --out FILE")
    target = target or Path(run.path)
    check_place(target, "--out")
    there, kept = target.exists(), None
    with writing(target, "name another file with --out"):
        if there:
            kept = write_over(target, source)
        else:
            new_file(target, source)
    written, kept_as = not there or kept is not None, shown(kept) if kept else None
    return published.Restored(run.id, run.when, run.problem, shown(target), written, kept_as)
