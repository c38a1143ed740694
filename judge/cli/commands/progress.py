"""`judge progress`: what your runs have shown, what is due, what comes next; on the screen or as a page.

`judge history`: the runs so far, one of them in full, what changed between two, a source again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import unified_diff
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import OutFile, check_place, moment
from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at, shown
from judge.errors import ProblemError, UsageError, unwritable
from judge.files import new_file
from judge.practice import events, syllabus
from judge.practice import progress as learned
from judge.practice.cards import known_cards, read_decks
from judge.practice.events import Answer, Hack, Help, Run
from judge.practice.history import History
from judge.practice.progress import State, Tried
from judge.practice.review import reviews
from judge.practice.stub import write_over
from judge.practice.syllabus import USUAL, Checklist, PracticeSet
from judge.problem import Problem
from judge.problem.find import find_problem, problem_folders, sound_problems
from judge.report import published_progress as published
from judge.report.published_look import Next
from judge.report.screen import note
from judge.report.views import copied

_ON_SCREEN = 18  # runs, unless it is said how many
_PAGE = Path("judge-report.html")


class ProgressAsk(Struct, frozen=True):
    """What to show of the progress."""

    whole: bool = opt("--all", "List each skill and question.")
    due: bool = opt("--due", "What to repeat today, and when the rest comes again.")
    question: str | None = opt("--question ID", "One interview question, and what ticks it.")
    html: bool = opt("--html", "Write a page that you can send and print.")
    out: Path = opt("--out FILE", f"Write that page here, not to {_PAGE}.", default=_PAGE)
    person: str = opt("--name NAME", "Whose page it is, for its heading.", default="")
    opened: bool = opt("--open", "Open the page in the browser.")


@command(
    "progress",
    published.ProgressShown,
    published.DueShown,
    published.QuestionShown,
    published.ProgressWritten,
    ask=ProgressAsk,
)
@click.argument("name", metavar="[SET]", default=USUAL)
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
    folders = common.problems
    with history_at(common.db, reading=True) as history:
        runs, helps = history.runs(), history.events(Help)
        answers, hacks = history.events(Answer), history.events(Hack)
    due = _due(runs, helps, answers, folders)
    if ask.due:
        return due
    problems, broken = sound_problems(folders)
    chosen = syllabus.find_set(name, problems, folders)
    checklist = syllabus.read_checklist(folders)
    cards, faults = read_decks(folders)
    for fault in (*broken, *syllabus.unknown_names(problems, folders), *faults):
        note(str(fault), bad=True)
    own, done = learned.tried(runs), learned.solved(runs)
    every = learned.skills(problems, own, checklist.skills)
    asked = learned.questions(problems, done, every, checklist, cards, answers, hacks)
    if ask.question is not None:
        row = syllabus.find_row(ask.question, checklist.rows).id
        return published.QuestionShown(question=next(each for each in asked if each.row == row))
    sets = syllabus.sound_sets(problems, folders)[0] if name == USUAL else []
    parts = {each.title for each in checklist.sections if name in (USUAL, *each.sets)}
    won = _stars(chosen.problems, own)
    ids = tuple(problem.id for problem in chosen.problems)
    following = next((each for each in chosen.problems if each.id not in own), None)
    told = published.ProgressShown(
        set=name,
        title=chosen.title,
        katas=ids,
        solved=tuple(each for each in ids if each in done),
        one_star=won.count(1),
        two_stars=won.count(2),
        sets=tuple(_share(each, own, checklist) for each in sets if each.problems and each.name != USUAL),
        skills=tuple(learned.skills(chosen.problems, own, checklist.skills)),
        mistakes=dict(
            learned.mistakes(run for name in own if name in ids for run in own[name]).most_common()
        ),
        rows=tuple([each for each in asked if each.section in parts] or asked),
        next=Next(following.id, following.title, following.summary) if following else None,
    )
    return published.ProgressPage(told, due, ask.whole)


def _share(part: PracticeSet[Problem], own: Tried, checklist: Checklist) -> published.SetShare:
    won, shown = _stars(part.problems, own), learned.skills(part.problems, own, checklist.skills)
    return published.SetShare(
        name=part.name,
        katas=len(part.problems),
        solved=sum(any(run.solved for run in own.get(each.id, ())) for each in part.problems),
        levelled=sum(bool(each.levels) for each in part.problems),
        one_star=won.count(1),
        two_stars=won.count(2),
        skills=len(shown),
        shown=sum(skill.state is State.SHOWN for skill in shown),
    )


def _stars(problems: Iterable[Problem], own: Tried) -> list[int]:
    """How many levels of each of these katas were passed."""
    return [len(learned.levels_passed(each, own.get(each.id, ()))) for each in problems]


def _due(
    runs: Sequence[Run], helps: Sequence[Help], answers: Sequence[Answer], folders: Sequence[Path]
) -> published.DueShown:
    """What is unfinished, and what comes again when; a kata that is unfinished is not repeated yet."""
    today, here = events.now().astimezone(), {folder.name for folder in problem_folders(folders)}
    own, done = learned.tried(runs), learned.solved(runs)
    unsolved = {name: tries for name, tries in own.items() if name in here and name not in done}
    known = [each for each in reviews(runs, helps) if each.name in here and each.name not in unsolved]
    return published.DueShown(
        time=today,
        now=tuple(
            published.Unfinished(problem=name, best=max(run.score for run in tries), last=tries[-1].when)
            for name, tries in unsolved.items()
        ),
        due=tuple(each for each in known if each.is_due(today)),
        later=tuple(each for each in known if not each.is_due(today)),
        cards=tuple(known_cards(answers, folders)),
    )


def _page(ask: ProgressAsk, common: Common) -> published.ProgressWritten:
    """Write the page. Raises UsageError where there is nothing to write, or something else is there."""
    from judge.report.html import is_page
    from judge.report.html.learner import MARK, learner_page

    target = OutFile(ask.out, "--out", "a page of judge progress", lambda start: is_page(start, MARK))
    with history_at(common.db, reading=True) as history:
        runs = [run for run in history.runs() if run.counts]
        if not runs:
            raise UsageError("You have no runs yet", remedy="judge a file first: judge run FILE")
        last = {run.problem: run.id for run in runs if run.solved}
        sources = {name: history.source(number) for name, number in last.items()}
        problems, faults = sound_problems(common.problems)
        for fault in faults:  # its runs are shown all the same
            note(f"a kata is left out: {fault}")
        try:
            shown_skills = learned.skills(
                problems, learned.tried(runs), syllabus.read_checklist(common.problems).skills
            )
        except ProblemError as fault:
            note(f"the skills are left out: {fault}")
            shown_skills = []
    generated = moment().astimezone()
    page = learner_page(runs, problems, shown_skills, sources, person=ask.person, generated=generated)
    target.write(page)
    if ask.opened:
        click.launch(str(ask.out))
    names = tuple(sorted({run.problem for run in runs}))
    return published.ProgressWritten(out=shown(ask.out), bytes=len(page), runs=len(runs), problems=names)


class HistoryAsk(Struct, frozen=True):
    """What to show of the runs."""

    limit: int | None = opt("--limit N", "Only the last N runs.", type=click.IntRange(1))
    csv: bool = opt("--csv", "Write CSV, one run on each line.")
    restore: bool = opt("--restore", "Write the source of that RUN to its file again.")
    out: Path | None = opt("--out FILE", "Restore it to this file instead.")


@command("history", published.RunRow, published.RunsCompared, published.Restored, ask=HistoryAsk)
@click.argument("words", metavar="[KATA|RUN [RUN]]", nargs=-1)
def history(words: tuple[str, ...], ask: HistoryAsk, common: Common) -> Struct:
    """Show your runs, one run, or what changed between two.

    The latest run is last. The screen shows the last 18, JSON and CSV all of them. RUN is the number in the
    first column.

    With --restore, the source that a run judged is written to its file again. If that file has changed since,
    it is kept as FILE.bak. A damaged run is left out, and a note says so.
    """
    if ask.csv and common.json:
        raise UsageError("--json and --csv exclude each other", remedy="give one of them")
    numbers = [int(word) for word in words if word.isdecimal()]
    if len(words) > max(len(numbers), 1) or len(words) > 2:
        raise UsageError("Give one kata, one run or two runs", remedy="such as judge history 3 5")
    if ask.restore != (len(numbers) == 1 and ask.restore):
        raise UsageError("Which run? --restore takes one", remedy="such as judge history 3 --restore")
    if ask.out is not None and not ask.restore:
        raise UsageError("--out goes with --restore", remedy="such as judge history 3 --restore --out old.py")
    if numbers and (ask.csv or ask.limit is not None):
        raise UsageError("--csv and --limit are for the list of runs", remedy="leave them out")
    with history_at(common.db, reading=True) as found:
        if not numbers:
            return _listed(words[0] if words else "", ask, common, found)
        runs = [(found.run(number), found.source(number)) for number in numbers]
    if ask.restore:
        return _restored(*runs[0], ask.out)
    return _compared(*runs) if len(runs) == 2 else copied(published.RunRow, runs[0][0])


def _listed(name: str, ask: HistoryAsk, common: Common, history: History) -> published.RunList:
    """The last runs, of that kata if one is named, which may be gone since. Raises UsageError."""
    on_screen = not (common.json or ask.csv)
    short = on_screen and ask.limit is None
    runs = history.runs(name or None, _ON_SCREEN + 1 if short else ask.limit)
    if not on_screen:
        runs = history.with_results(runs)
    if not runs and name:
        find_problem(name, common.problems)
    kept = runs[-_ON_SCREEN:] if short else runs
    return published.RunList(tuple(kept), name, more=len(kept) < len(runs), csv=ask.csv)


def _compared(first: tuple[Run, bytes], second: tuple[Run, bytes]) -> published.RunsCompared:
    """What changed between two runs of one kata. Raises UsageError."""
    (before, old), (after, new) = first, second
    if before.problem != after.problem:
        what = f"run {before.id} is of {before.problem}, run {after.id} of {after.problem}"
        raise UsageError(what, remedy="name two runs of one kata")
    ended, now = (
        dict.fromkeys(run.passed, "passed") | dict.fromkeys(run.failed, "failed") for run in (before, after)
    )
    old_lines, new_lines = (text.decode("utf-8", "backslashreplace").splitlines() for text in (old, new))
    diff = unified_diff(old_lines, new_lines, f"run {before.id}", f"run {after.id}", lineterm="")
    return published.RunsCompared(
        problem=before.problem,
        before=before.id,
        after=after.id,
        verdicts=(before.verdict, after.verdict),
        scores=(before.score, after.score),
        groups=tuple(
            published.GroupChange(name, ended.get(name), now.get(name))
            for name in ended | now
            if ended.get(name) != now.get(name)
        ),
        diff=tuple(diff),
    )


def _restored(run: Run, source: bytes, target: Path | None) -> published.Restored:
    """Write the source of that run to `target`, or to where it was; what is there is kept beside it."""
    if target is None and not run.path:
        raise UsageError(f"run {run.id} judged no ordinary file", remedy="name one with --out FILE")
    target = target or Path(run.path)
    check_place(target, "--out")
    there, kept = target.exists(), None
    try:
        if there:
            kept = write_over(target, source)
        else:
            new_file(target, source)
    except OSError as fault:
        raise unwritable(target, fault, "name another file with --out") from fault
    return published.Restored(
        run=run.id,
        time=run.when,
        problem=run.problem,
        source=run.source_hash,
        file=shown(target),
        written=kept is not None or not there,
        kept_as=shown(kept) if kept else None,
    )
