"""The screens of those who write katas and look after a machine: new, verify, export, doctor."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from shlex import quote

from rich.console import Group, RenderableType
from rich.text import Text

from judge.report.parts import (
    BAD,
    FAINT,
    GOOD,
    STRONG,
    WARNING,
    commands,
    facts,
    indented,
    joined,
    table,
    text,
)
from judge.report.published_setter import (
    DecksVerified,
    Doctor,
    Exported,
    FilesWritten,
    NewKata,
    Verified,
    VerifySummary,
)
from judge.report.screen import Screen
from judge.report.words import counted, shown_name

_NAMED = 3  # files that are named beside a reason


def new_kata(found: NewKata, _screen: Screen) -> RenderableType:
    """What was written, and the commands that go on with it."""
    chosen = f"--problems {quote(found.problems)} {found.problem}"
    below = [
        (f"judge verify {chosen}", "check it"),
        (f"judge verify {chosen} --pin", "pin its data, once you have changed them"),
        (f"judge show {chosen}", "see it as others will"),
    ]
    files = [text(f"  {shown_name(each)}") for each in found.files]
    return Group(joined(text(found.problem, STRONG), f"  {found.title}"), *files, Text(), commands(below))


def verified(found: Verified, _screen: Screen) -> RenderableType:
    """What is wrong, the verdict of each solution, and how well each mistake is found."""
    verdict = text("sound", GOOD) if found.ok else text(counted(len(found.faults), "fault"), BAD)
    said = f"  {counted(found.groups, 'group')}, {counted(found.cases, 'case')}, pins {found.pins}"
    parts: list[RenderableType] = [
        joined(text(found.problem, STRONG), "  ", verdict, said if found.cases else "")
    ]
    wrong = [(text("fault", BAD), str(each)) for each in found.faults]
    wrong += [(text("warning", WARNING), str(each)) for each in found.warnings]
    if wrong:
        parts.append(indented(table(("", ""), wrong)))
    if found.solutions:
        rows = [
            (
                each.file,
                text(each.verdict or "", GOOD if each.ok else BAD),
                each.unjudged or ", ".join(each.failed),
            )
            for each in found.solutions
        ]
        parts += [Text(), indented(table(("solution", "verdict", "fails"), rows))]
    if found.mistakes:
        mistakes = [
            (each.name, str(each.cases), each.group, ", ".join(each.groups)) for each in found.mistakes
        ]
        titles = ("mistake", "cases", "best group", "found by")
        parts += [Text(), indented(table(titles, mistakes, right=[1]))]
    if found.edges:
        edges = [
            (str(each.cases) if each.cases else text("none", WARNING), each.what) for each in found.edges
        ]
        parts += [Text(), indented(table(("cases", "edge"), edges, right=[0]))]
    return Group(*parts)


def decks_verified(found: DecksVerified, _screen: Screen) -> RenderableType:
    """What is wrong with the cards."""
    verdict = text(counted(len(found.faults), "fault"), BAD) if found.faults else text("sound", GOOD)
    rows = [(text("fault", BAD), str(each)) for each in found.faults]
    return Group(
        joined(text("quiz", STRONG), "  ", verdict, f"  {counted(found.cards, 'card')}"),
        *([indented(table(("", ""), rows))] if rows else []),
    )


def verify_summary(found: VerifySummary, _screen: Screen) -> RenderableType:
    """What all of it comes to."""
    verdict = text(counted(found.faults, "fault"), BAD) if found.faults else text("sound", GOOD)
    return joined(verdict, f"  {counted(found.katas, 'kata')} checked")


def files_written(found: FilesWritten, _screen: Screen) -> RenderableType:
    """Where the data are."""
    what = f"  {counted(found.cases, 'case')} in {counted(len(found.files), 'file')}"
    return joined(text(shown_name(found.out), STRONG), what)


def exported(found: Exported, _screen: Screen) -> RenderableType:
    """The packages of a kata, and what was left out."""
    if found.left_out:
        return joined(text(found.problem, STRONG), f"  left out: {found.left_out}")
    return Group(
        joined(text(found.problem, STRONG), f"  time limit {found.time_limit} s"),
        indented(facts(_packages(found))),
    )


def _packages(found: Exported) -> Iterator[tuple[str, str]]:
    for each in found.packages:
        places = ", ".join(shown_name(str(place)) for place in (each.folder, each.archive) if place)
        yield each.version.value, f"{places}  {each.bytes / 1000:,.0f} kB"
    if found.domjudge:
        yield "DOMjudge", shown_name(found.domjudge)
    kinds = Counter(each.file.partition("/")[0].replace("_", " ") for each in found.programs)
    if kinds:
        yield "programs", ", ".join(f"{count} {kind}" for kind, count in kinds.items())
    reasons: dict[str, list[str]] = {}
    for left in found.programs_left_out:
        reasons.setdefault(left.why, []).append(left.file)
    for why, files in reasons.items():
        more = f" and {len(files) - _NAMED} more" if len(files) > _NAMED else ""
        yield "left out", f"{', '.join(files[:_NAMED])}{more}: {why}"
    for note in found.notes:
        yield "note", note


def doctor(found: Doctor, _screen: Screen) -> RenderableType:
    """The machine, the levels of isolation, the languages; or what came of the attacks."""
    if found.attacks is not None:
        return _attacked(found)
    machine = [(name, str(getattr(found, name))) for name in ("judge", "python", "system", "cores", "cache")]
    used = f"Isolation: {found.isolation}" if found.isolation else "Nothing can be run"
    return Group(
        facts(machine),
        Text(),
        table(("", ""), [*_levels(found)]),
        Text(),
        table(("", ""), [*_languages(found)]),
        Text(),
        text(used, STRONG if found.isolation else BAD),
    )


def _levels(found: Doctor) -> Iterator[tuple[Text, Text]]:
    for level in found.levels:
        said = [text(level.meaning)]
        if level.visible is not None:
            seen = level.visible or "nothing of the judge, its problems and its solutions"
            said.append(text(f"Tried: a submission can read {seen}.", FAINT))
        if level.why_not:
            said.append(text(f"Missing: {level.why_not}", WARNING))
        if level.remedy:
            said.append(text(f"Remedy: {level.remedy}"))
        yield text(level.name, GOOD if level.available else WARNING), Text("\n").join(said)


def _languages(found: Doctor) -> Iterator[tuple[Text, Text]]:
    for each in found.languages:
        if not each.version:
            yield text(each.name, FAINT), text(f"not installed: {each.remedy}", FAINT)
        elif each.works is False:
            yield text(each.name, WARNING), text(f"{each.version}, fails: {each.why_not} ({each.remedy})")
        else:
            tried = f", works at {found.isolation}" if each.works else ""
            yield text(each.name, GOOD), text(each.version + tried)


def _attacked(found: Doctor) -> RenderableType:
    assert found.attacks is not None
    attacks = found.attacks.attacks
    rows = [
        (
            text(each.name, STRONG),
            text("held", GOOD) if each.held else text("NOT HELD", BAD),
            each.tries if each.held else f"{each.tries}: {each.how}",
        )
        for each in attacks
    ]
    held = sum(each.held for each in attacks)
    said = f"{held} of {counted(len(attacks), 'attack')} held at isolation {found.attacks.isolation}"
    return Group(
        table(("attack", "result", "a submission tries to"), rows),
        Text(),
        text(said, GOOD if held == len(attacks) else BAD),
    )
