"""The katas on a screen: the list by sets, one kata with its statement, and what its test groups test."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction

from rich.console import Group as Together
from rich.console import RenderableType
from rich.text import Text

from judge.problem import Group, GrowthRule, Parameter, Problem, Tolerance
from judge.report.parts import BAD, FAINT, GOOD, STRONG, bar, commands, facts, indented, joined, table, text
from judge.report.published import KataList, KataRow, KataShown
from judge.report.screen import Screen
from judge.report.statement import prose
from judge.report.words import counted
from judge.values.answers import Words


def kata_list(found: KataList, screen: Screen) -> RenderableType:
    """How many are solved, each set in a row, and the katas of one set; all of them where that is asked."""
    solved = {row.problem for row in found.katas if row.solved}
    stars = Counter(row.stars for row in found.katas)
    said = f"{len(solved)} of {counted(len(found.katas), 'kata')}"
    said += "".join(f"   {'★' * each} {stars[each]}" for each in (1, 2) if stars[each])
    parts: list[RenderableType] = [bar(len(solved), len(found.katas), said, screen.width), Text()]
    sets = [each for each in found.sets if each.katas]
    if found.whole and not found.shown:
        for each in sets:
            parts += [text(each.name, STRONG), *_rows(found, each.katas, None), Text()]
        return Together(*parts[:-1])
    rows = [
        (
            text(each.name, STRONG if each.name == found.shown else ""),
            f"{len(solved & {*each.katas})} of {len(each.katas)}",
        )
        for each in sets
    ]
    parts += [table(("", ""), rows, right=[1], prose=None), Text()] if len(rows) > 1 else []
    shown = next((each for each in sets if each.name == found.shown), None)
    parts += [table(("",), [(text(shown.about, FAINT),)], prose=None)] if shown else []
    room = None if screen.rows is None or found.whole else screen.rows - len(rows) - 8
    parts += _rows(found, shown.katas if shown else (), room)
    parts += [Text(), commands([("judge list SET", "another set"), ("judge list --all", "all katas")])]
    return Together(*parts)


def _rows(found: KataList, names: Sequence[str], room: int | None) -> Iterator[RenderableType]:
    """The katas of those names with their marks, as many as there is room for."""
    rows = {row.problem: row for row in found.katas}
    there = [rows[name] for name in names if name in rows and not (found.todo and rows[name].solved)]
    kept = there if room is None or len(there) <= room else there[: max(room - 1, 1)]
    if not there:
        yield text("  All katas of this set are solved." if found.todo else "  There is no kata.", GOOD)
    marked = [_row(row, current=row.problem == found.current) for row in kept]
    yield indented(table(("", "", "", ""), marked, prose=None))
    if len(kept) < len(there):
        yield text(f"  … and {len(there) - len(kept)} more: add --all", FAINT)


def _row(row: KataRow, *, current: bool) -> tuple[Text, ...]:
    mark = "★" * row.stars or ("✓" if row.solved else "")
    name = text(row.problem, STRONG if current else "")
    return text(">" if current else ""), text(mark, GOOD), name, text(row.title)


def kata_shown(found: KataShown, screen: Screen) -> RenderableType:
    """The statement, the parameters and what is allowed; or the test groups."""
    problem = found.problem
    if found.groups:
        return group_details(problem, problem.groups)
    source = problem.source
    said = (
        ("authors", ", ".join(source.authors)),
        ("license", source.license),
        ("origin", source.origin),
    )
    return Together(
        prose(problem.statement, screen),
        Text(),
        text("Parameters", STRONG),
        indented(_parameters(problem.parameters)),
        Text(),
        text("Tests", STRONG),
        indented(facts([*_allowed(problem), *((label, told) for label, told in said if told)])),
    )


def _parameters(parameters: Sequence[Parameter]) -> RenderableType:
    rows = [
        (
            text(each.name, STRONG),
            str(each.type).replace("-", " "),
            bound(each.low),
            bound(each.high),
            each.about,
        )
        for each in parameters
    ]
    return table(("name", "type", "from", "to", "about"), rows, right=[2, 3])


def _allowed(problem: Problem) -> Iterator[tuple[str, str]]:
    """What the tests are, and what they allow."""
    yield "groups", f"{totals(problem.groups)}: judge show {problem.id} --groups"
    yield "answer", f"{problem.answer}, {tolerance(_usual(problem), problem.answer.words)}"
    if smallest := _smallest(problem.parameters):
        yield "numbers", smallest
    limits = problem.limits
    allowed = f"{limits.cpu_seconds:g} s of CPU time, {limits.memory_mb:,.0f} MB for each group"
    yield "limits", allowed
    for group in problem.groups:
        own = [f"{group.limits.cpu_seconds:g} s of CPU time"] if group.limits else []
        own += [time_rule(group)] if group.time_limit is not None else []
        if own:
            yield group.name, ", ".join(own)
    if problem.growth is not None:
        yield "growth", growth_rule(problem.growth)


def _smallest(parameters: Sequence[Parameter]) -> str:
    """How small a real number other than 0 may be; empty where nothing is said."""
    widths = dict.fromkeys(each.smallest for each in parameters if each.smallest)
    parts = []
    for width in widths:
        names = [each.name for each in parameters if each.smallest == width]
        whose = "" if len(widths) == 1 else f" in {', '.join(names)}"
        parts.append(f"0 or at least {bound(width)} in size{whose}")
    return "; ".join(parts)


def group_details(problem: Problem, groups: Sequence[Group]) -> RenderableType:
    """What these groups of a problem test, and the mistakes that they find."""
    return Together(joined(text(problem.id, STRONG), "  ", problem.title), *_levels(problem, groups))


def _levels(problem: Problem, groups: Sequence[Group]) -> Iterator[RenderableType]:
    if problem.growth is not None:
        yield text(f"CPU time may grow {growth_rule(problem.growth)}.")
    for level in problem.levels or (None,):
        own = [group for group in groups if group.level is level]
        if not own:
            continue
        yield Text()
        yield joined(
            text(f"{level.value.capitalize()} level" if level else "Test groups", STRONG), f"  {totals(own)}"
        )
        rows = [
            (text(group.name, STRONG), str(group.count), str(group.points), _about(problem, group))
            for group in own
        ]
        yield indented(table(("group", "cases", "points", "tests"), rows, right=[1, 2]))


def _about(problem: Problem, group: Group) -> Text:
    """What one group tests and allows, and on a line of its own the mistakes it finds."""
    about = [group.about]
    if allowed := time_rule(group):
        about.append(f"CPU time: at most {allowed}.")
    if group.tolerance != _usual(problem):
        about.append(f"Tolerance: {tolerance(group.tolerance, problem.answer.words)}.")
    said = text(" ".join(about))
    return Text("\n").join([said, text(", ".join(group.kills), BAD)]) if group.kills else said


def _usual(problem: Problem) -> Tolerance:
    return Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]


def totals(groups: Sequence[Group]) -> str:
    """`9 groups, 1,885 cases, 100 points`: what the groups hold together."""
    cases = sum(group.count for group in groups)
    points = sum(group.points for group in groups)
    return ", ".join((counted(len(groups), "group"), counted(cases, "case"), counted(points, "point")))


def time_rule(group: Group) -> str:
    """`8 × the reference`: the CPU time of a group that has a limit of its own; empty where it has none."""
    return "" if group.time_limit is None else f"{group.time_limit:g} × the reference"


def growth_rule(rule: GrowthRule) -> str:
    """`at most n^0.4 faster than the reference, over …`: how CPU time may grow."""
    return f"at most n^{rule.slope:g} faster than the reference, over {', '.join(rule.groups)}"


def tolerance(value: Tolerance, words: Words) -> str:
    """A tolerance in words, such as `1e-9 relative + 4 ulp`; what it counts in has the problem's own name."""
    unit = words.unit or "the answer's unit"
    wide = [f"{bound(value.extent)} of {unit}"] if value.extent else []
    wide += [f"{bound(value.relative)} relative"] if value.relative else []
    parts = [" or ".join(wide)] if wide else []
    parts += [f"{bound(value.ulps)} ulp"] if value.ulps else []
    said = " + ".join(parts) or "exact"
    return f"{said}; where the exact number is 0, {bound(value.zero)} of {unit}" if value.zero else said


def bound(value: Fraction) -> str:
    """A bound or a width, shortest of its exact forms: `1000`, `2^30`, `-10^100`, `1e-12`, `1/3`."""
    if value.denominator == 1:
        return _whole(value.numerator)
    short = re.sub("e-0+", "e-", f"{float(value):g}")
    return short if Fraction(short) == value else str(value)


def _whole(value: int) -> str:
    sign, magnitude = ("-" if value < 0 else ""), abs(value)
    if magnitude < 100_000:
        return str(value)
    if magnitude & (magnitude - 1) == 0:
        return f"{sign}2^{magnitude.bit_length() - 1}"
    number = Decimal(magnitude)  # whose text, unlike an int's, may have any length
    if magnitude == 10 ** number.adjusted():
        return f"{sign}10^{number.adjusted()}"
    return f"{sign}{number:,}" if number.adjusted() < 15 else f"{sign}{number}"
