"""Problems for the screen: the list of them, and one of them whole."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from judge.problem import Group, GrowthRule, Parameter, Problem, Tolerance
from judge.problem.model import Source
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.levels import level_name
from judge.report.values import bound, counted, size
from judge.values import Words


def list_lines(problems: Sequence[Problem], width: int | None) -> Iterator[Line]:
    """One row a problem."""
    columns = (
        Column("problem"),
        Column("tier"),
        Column("cases", right=True),
        Column("title", flexible=True),
    )
    rows: list[list[Cell]] = [
        [
            Span(problem.id, Style.STRONG),
            problem.tier.value,
            f"{cases(problem):,}",
            problem.title,
        ]
        for problem in problems
    ]
    yield from Table(columns, rows, indent=0).lines(width)


def detail_lines(problem: Problem, width: int | None) -> Iterator[Line]:
    """What follows the statement: parameters with bounds, test groups with tolerances, limits."""
    yield line(Span("Parameters", Style.STRONG))
    yield from _parameter_table(problem.parameters).lines(width)
    if smallest := _smallest(problem.parameters):
        yield from _labelled("numbers", smallest, width)
    yield line()
    yield line(Span("Answer", Style.STRONG))
    yield from hanging(Span(""), Span(str(problem.answer)), width, indent=2, column=2)
    yield line()
    tolerances = Counter(group.tolerance for group in problem.groups)
    usual = tolerances.most_common(1)[0][0]
    for name, groups in _kinds(problem):
        yield from beside(Span(name, Style.STRONG), totals(groups), width)
        yield from _group_table(groups, usual, problem.answer.words).lines(width)
        yield line()
    aside = "unless the group says otherwise" if len(tolerances) > 1 else ""
    yield from beside(Span("Tolerance", Style.STRONG), aside, width)
    yield from hanging(Span(""), Span(tolerance(usual, problem.answer.words)), width, indent=2, column=2)
    yield line()
    limits = problem.limits
    yield line(Span("Limits", Style.STRONG), Span("  for each group", Style.FAINT))
    yield from _labelled("CPU", f"{limits.cpu_seconds:g} s", width)
    yield from _labelled("wall clock", f"{limits.wall_seconds:g} s", width)
    yield from _labelled("memory", size(limits.memory_bytes), width)
    yield from _labelled("output", size(limits.output_bytes), width)
    yield from _own_limits(problem, width)
    yield from _source(problem.source, width)


def _source(source: Source, width: int | None) -> Iterator[Line]:
    """Who wrote it, on which terms and after what, where that is said."""
    said = {"authors": ", ".join(source.authors), "license": source.license, "origin": source.origin}
    if any(said.values()):
        yield line()
        yield line(Span("Source", Style.STRONG))
    for label, text in said.items():
        if text:
            yield from _labelled(label, text, width)


def _kinds(problem: Problem) -> Iterator[tuple[str, Sequence[Group]]]:
    """The groups below their headings: all together, or those of each level."""
    if not problem.levels:
        yield "Test groups", problem.groups
    for level in problem.levels:
        yield f"Test groups, {level_name(level)}", problem.of_level(level)


def totals(groups: Sequence[Group]) -> str:
    """`1,885 cases, 100 points`: what the groups hold together."""
    number = sum(group.count for group in groups)
    return f"{counted(number, 'case')}, {counted(sum(group.points for group in groups), 'point')}"


def _smallest(parameters: Sequence[Parameter]) -> str:
    """How small a real number other than 0 may be; empty where nothing is said."""
    widths = dict.fromkeys(each.smallest for each in parameters if each.smallest)
    parts = []
    for width in widths:
        names = [each.name for each in parameters if each.smallest == width]
        whose = "" if len(widths) == 1 else f" in {', '.join(names)}"
        parts.append(f"0 or at least {bound(width)} in magnitude{whose}")
    return "; ".join(parts)


def _own_limits(problem: Problem, width: int | None) -> Iterator[Line]:
    """The limits of single groups, and of growth."""
    for group in problem.groups:
        parts = [f"CPU {group.limits.cpu_seconds:g} s"] if group.limits else []
        parts += [f"wall clock {group.limits.wall_seconds:g} s"] if group.limits else []
        parts += [time_rule(group)] if group.time_limit is not None else []
        if parts:
            yield from _labelled(group.name, ", ".join(parts), width)
    if problem.growth is not None:
        yield from _labelled("growth", growth_rule(problem.growth), width)


def time_rule(group: Group) -> str:
    """`8 × the reference`: the CPU time of a group that has a limit of its own; empty where it has none."""
    return "" if group.time_limit is None else f"{group.time_limit:g} × the reference"


def growth_rule(rule: GrowthRule) -> str:
    """`at most n^0.4 faster than the reference, over …`: how CPU time may grow."""
    return f"at most n^{rule.slope:g} faster than the reference, over {', '.join(rule.groups)}"


def cases(problem: Problem) -> int:
    """How many cases all its groups hold."""
    return sum(group.count for group in problem.groups)


def tolerance(value: Tolerance, words: Words) -> str:
    """A tolerance in words, such as `1e-9 relative + 4 ulp`; what it counts in has the problem's own name."""
    unit = words.unit or "the answer's unit"
    wide = [f"{bound(value.extent)} of {unit}"] if value.extent else []
    wide += [f"{bound(value.relative)} relative"] if value.relative else []
    parts = [" or ".join(wide)] if wide else []
    parts += [f"{bound(value.ulps)} ulp"] if value.ulps else []
    said = " + ".join(parts) or "none: the exact answer"
    if not value.zero:
        return said
    return f"{said}; where the exact number is 0, {bound(value.zero)} of {unit}"


def _parameter_table(parameters: Sequence[Parameter]) -> Table:
    columns = (Column("name"), Column("type"), Column("from", right=True), Column("to", right=True))
    rows: list[list[Cell]] = [
        [
            Span(parameter.name, Style.STRONG),
            str(parameter.type).replace("-", " "),
            bound(parameter.low),
            bound(parameter.high),
            parameter.about,
        ]
        for parameter in parameters
    ]
    return Table((*columns, Column("about", flexible=True)), rows)


def _group_table(groups: Sequence[Group], usual: Tolerance, words: Words) -> Table:
    columns = (
        Column("group"),
        Column("cases", right=True),
        Column("points", right=True),
        Column("about", flexible=True),
    )
    rows: list[list[Cell]] = []
    for group in groups:
        about = group.about
        if group.tolerance != usual:
            about += f" Tolerance: {tolerance(group.tolerance, words)}."
        rows.append([Span(group.name, Style.STRONG), str(group.count), str(group.points), about])
    return Table(columns, rows)


def _labelled(label: str, text: str, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text), width, indent=2, column=14)
