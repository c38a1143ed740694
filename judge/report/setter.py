"""The screens of those who write katas and look after a machine: new, verify, export, doctor."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from shlex import quote

from rich.console import Group, RenderableType
from rich.text import Text

from judge.data.libraries import LibraryTable
from judge.holes.model import Hole, Holes
from judge.packs.begin import NewKata
from judge.packs.export import Exported
from judge.report import published_setter as published
from judge.report.parts import (
    Cell,
    bad,
    blocks,
    commands,
    facts,
    faint,
    good,
    head,
    indented,
    joined,
    strong,
    table,
    text,
    warning,
)
from judge.report.screen import Screen
from judge.report.words import counted, shown_name
from judge.verify.model import Verified


def new_kata(found: NewKata, _screen: Screen) -> RenderableType:
    """What was written, and the commands that go on with it."""
    files = [text(f"  {shown_name(str(each))}") for each in found.files]
    place = quote(str(found.problems))
    chosen = f"--problems {place} {found.problem}"
    below = [
        (f"judge verify {chosen}", "check it"),
        (f"judge verify {chosen} --pin", "pin its data, once you have changed them"),
        (f"judge show {chosen}", "see it as others will"),
    ]
    if not found.problem:
        first = f"judge new {place} my-kata", "its first kata"
        below = [first, ("pip install -e .", "once: judge list then has it"), ("pytest", "checks all katas")]
    return blocks(Group(head(found.problem or "pack", found.title), *files), commands(below))


def _sound(faults: int) -> Text:
    return bad(counted(faults, "fault")) if faults else good("sound")


def verified(found: Verified, _screen: Screen) -> RenderableType:
    """What is wrong, the verdict of each solution, and how well each mistake is found."""
    said = counted(found.cards, "card") if found.cards else ""
    if found.cases:
        said = f"{counted(found.groups, 'group')}, {counted(found.cases, 'case')}, pins {found.pins}"
    top = head(found.problem, _sound(len(found.faults)), said)
    warned = [(warning("warning"), str(each)) for each in found.warnings]
    solutions: list[tuple[Cell, ...]] = []
    for it in found.solutions:
        verdict = (good if it.ok else bad)(it.verdict.value if it.verdict else "")
        solutions.append((it.file, verdict, it.unjudged or ", ".join(it.failed)))
    mistakes = [(each.name, str(each.cases), each.group, ", ".join(each.groups)) for each in found.mistakes]
    edges = [(str(each.cases) if each.cases else warning("none"), each.what) for each in found.edges]
    tables = (
        (("solution", "verdict", "fails"), solutions, ()),
        (("mistake", "cases", "best group", "found by"), mistakes, (1,)),
        (("cases", "edge"), edges, (0,)),
    )
    below = (indented(table(rows, *titles, right=right)) for titles, rows, right in tables if rows)
    return blocks(_faulty(top, found.faults, warned), *below)


def _faulty(top: Text, faults: Iterable[object], more: Iterable[tuple[Text, str]] = ()) -> Group:
    """What stands above, with the faults right below."""
    rows = [*((bad("fault"), str(each)) for each in faults), *more]
    return Group(top, *([indented(table(rows))] if rows else []))


def library_table(found: LibraryTable, _screen: Screen) -> RenderableType:
    """What each library comes to, and what to install for those that were not judged."""
    rows: list[tuple[Cell, ...]] = []
    for each in found.libraries:
        groups, cases = "/".join(map(str, each.groups)), f"{each.cases[0] / each.cases[1]:.1%}"
        rows.append((strong(each.library), each.version, groups, cases, each.smallest))
    titles = ("library", "version", "groups", "cases", "smallest failing case")
    return blocks(
        table(rows, *titles, right=(2, 3)) if rows else head(found.problem, "no library was judged"),
        Group(*map(text, found.missing)) if found.missing else None,
    )


def holes(found: Holes, _screen: Screen) -> RenderableType:
    """The mutants in numbers; each hole as a diff, its case, and what would draw such cases."""
    said = f"{counted(found.mutants, 'mutant')} of {counted(found.programs, 'program')}: "
    said += f"{found.rejected:,} rejected, {found.accepted:,} accepted; {counted(found.cases, 'case')} tried"
    if not found.programs:
        said = "" if found.faults or found.notes else "its cases have no input"
    count = bad(counted(len(found.holes), "hole")) if found.holes else good("no hole")
    top = head(found.problem, count if found.programs or not found.notes else faint("not looked at"), said)
    left = [f"{counted(found.unknown, 'accepted mutant')} without a witness"] if found.unknown else []
    left += [f"{found.edge} wrong only at the very edge of the promise"] if found.edge else []
    left += [f"{found.marked} marked in same.toml"] if found.marked else []
    more = "--all lists them. " if found.unknown and not found.unwitnessed else ""
    more += "Again to look longer; --seed 1 looks at other cases." if found.unknown or found.edge else ""
    below = faint(". ".join(filter(None, (", ".join(left), more)))) if left else None
    listed = Group(*map(text, found.unwitnessed)) if found.unwitnessed else None
    holes = (_hole(found.problem, each) for each in found.holes)
    return blocks(_faulty(top, found.faults), *holes, below, listed)


def _hole(problem: str, hole: Hole) -> RenderableType:
    others = f", and {counted(hole.others, 'more mutant')}" if hole.others else ""
    place = f"{hole.file}:{hole.line}" if hole.line else hole.file
    change = [bad(f"  - {row}") for row in hole.was.splitlines()]
    sign = "+" if hole.was else "with"  # other numbers have no line
    change += [good(f"  {sign} {row}") for row in hole.becomes.splitlines()]
    said = [f"judge try {problem} {quote(hole.case)}", f"right {hole.right}, it gives {hole.given}"]
    said += [f"No group holds this; nearest is {hole.near}."] if hole.near else []
    said += [f"Drawn by a changed row: {hole.row}"] if hole.row else []
    remedy = "Add such a row to a group" if hole.row else "Add a group that draws it"
    remedy += f", or mark it in solutions/{problem}/same.toml and say why it is right."
    top = joined(strong(place), faint(f"  {hole.kind}{others}"))
    return Group(top, *change, *(indented(text(each)) for each in said), indented(faint(remedy)))


def verify_summary(found: published.VerifySummary, _screen: Screen) -> RenderableType:
    """What all of it comes to."""
    katas = f"  {counted(found.katas, 'kata')} checked"
    if found.holes is None:
        return joined(_sound(found.faults), katas)
    count = bad(counted(found.holes, "hole")) if found.holes else good("no hole")
    return joined(count, katas, bad(f", {counted(found.faults, 'fault')}") if found.faults else "")


def files_written(found: published.FilesWritten, _screen: Screen) -> RenderableType:
    """Where the data are."""
    what = f"{counted(found.cases, 'case')} in {counted(len(found.files), 'file')}"
    return head(shown_name(found.out), what)


def site_built(found: published.SiteBuilt, _screen: Screen) -> RenderableType:
    """Where the site is, what was made, and how to look at it."""
    done = [f"{found.bytes / 1e6:,.0f} MB", f"{counted(len(found.made), 'kata')} made"]
    done += [f"{len(found.kept)} as they were"] if found.kept else []
    done += [f"{len(found.elsewhere)} for the terminal alone"] if found.elsewhere else []
    top = head(shown_name(found.out), ", ".join(done))
    look = [(f"judge site --open --out {quote(found.out)}", "look at it on this machine")]
    return blocks(top, None if found.opened else commands(look))


def exported(found: Exported, _screen: Screen) -> RenderableType:
    """The packages of a kata, and what was left out."""
    if found.left_out:
        return head(found.problem, f"left out: {found.left_out}")
    return Group(head(found.problem, f"time limit {found.time_limit} s"), indented(facts(_packages(found))))


def _packages(found: Exported) -> Iterator[tuple[str, str]]:
    for each in found.packages:
        places = ", ".join(shown_name(str(place)) for place in (each.folder, each.archive) if place)
        yield each.version.value, f"{places}  {each.bytes / 1000:,.0f} kB"
    if found.domjudge:
        yield "DOMjudge", shown_name(str(found.domjudge))
    if kinds := Counter(each.file.partition("/")[0].replace("_", " ") for each in found.programs):
        yield "programs", ", ".join(f"{count} {kind}" for kind, count in kinds.items())
    reasons: dict[str, list[str]] = {}
    for left in found.programs_left_out:
        reasons.setdefault(left.why, []).append(left.file)
    for why, files in reasons.items():
        yield "left out", f"{', '.join(files)}: {why}"
    yield from (("note", note) for note in found.notes)


def doctor(found: published.Doctor, _screen: Screen) -> RenderableType:
    """The machine, the levels of isolation, the languages."""
    machine = [(name, str(getattr(found, name))) for name in ("judge", "python", "system", "cores", "cache")]
    best = strong(f"Isolation: {found.isolation}") if found.isolation else bad("Nothing can be run")
    return blocks(facts(machine), table(_levels(found)), table(_languages(found)), best)


def _levels(found: published.Doctor) -> Iterator[tuple[Text, Text]]:
    for level in found.levels:
        said = [text(level.meaning)]
        if level.visible is not None:
            seen = level.visible or "nothing of the judge, its problems and its solutions"
            said.append(faint(f"Tried: a submission can read {seen}."))
        if level.why_not:
            said.append(warning(f"Missing: {level.why_not}"))
        if level.remedy:
            said.append(text(f"Remedy: {level.remedy}"))
        yield (good if level.available else warning)(level.name), Text("\n").join(said)


def _languages(found: published.Doctor) -> Iterator[tuple[Text, Text]]:
    for each in found.languages:
        if each.missing:
            yield faint(each.name), faint(f"not installed: {each.remedy}")
        elif each.works is False:
            version = f"{each.version}, fails: " if each.version else ""
            yield warning(each.name), text(f"{version}{each.why_not} ({each.remedy})")
        else:
            yield (
                good(each.name),
                text(each.version + (f", works at {found.isolation}" if each.works else "")),
            )
