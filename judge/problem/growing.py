"""The keys of problem.toml that speak of growth and of big cases, and their checks.

[limits]
input_mb = 16           the cases of one group, as a function receives them; 64 where it is not said

[time]                  as ever: the reference solutions, and the limit as a multiple of their CPU time
limit = 8
function = "grid.py"

[growth]                how a submission's CPU time may grow, beside the reference's
groups = ["n-2000", "n-8000", "n-32000"]
slope = 0.4             by how much its exponent of n may exceed the reference's

[[groups]]
name = "n-8000"
size = 8000             n. The cases of such a group are big: they are not kept but built again from their
                        seed, a failing one is not shown, and `judge stress` leaves the group out

[groups.time]           of this group, which is then raced by itself
limit = 4

[groups.limits]         of this group; the wall clock follows the CPU time where it is not said
cpu_seconds = 20
wall_seconds = 60
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import NoReturn

from msgspec.structs import replace

from judge.errors import nearest
from judge.problem import schema
from judge.problem.lines import KeyPath
from judge.problem.model import EXAMPLES, Group, GroupLimits, GrowthRule

MOST_INPUT_MB = 72  # what a container's memory has room for beside the answers
_MOST_SIZE = 10**9

Fault = Callable[[KeyPath, str, str], NoReturn]
Exactly = Callable[[schema.TomlNumber, KeyPath], Fraction]


def slope(value: Fraction, path: KeyPath, fault: Fault) -> float:
    """By how much an exponent may exceed the reference's; `fault` refuses what is none."""
    if not 0 < value <= 3:
        fault(path, "the slope is no difference of exponents", "give 0.1 to 3")
    return float(value)


class GrowingKeys:
    """The checks; `fault` refuses what stands at a key, `exact` reads its number."""

    def __init__(self, table: schema.ProblemTable, limits: GroupLimits, fault: Fault, exact: Exactly) -> None:
        self._table = table
        self._limits = limits
        self._fault = fault
        self._exact = exact

    def growth(self, groups: tuple[Group, ...]) -> GrowthRule | None:
        """The rule of growth, if there is one."""
        table = self._table.growth
        if table is None:
            return None
        self._need_reference(("growth",))
        named = {group.name: group for group in groups}
        for at, name in enumerate(table.groups):
            if name not in named:
                meant = nearest(name, named)
                remedy = f"did you mean {meant!r}?" if meant else f"the groups are {', '.join(named)}"
                self._fault(("growth", "groups"), f"there is no group {name!r}", remedy)
            if name in table.groups[:at]:
                self._fault(("growth", "groups"), f"group {name!r} is there twice", "remove one")
        chosen = [named[name] for name in table.groups]
        for group in chosen:
            if group.size is None:
                path = ("groups", groups.index(group))
                self._fault(path, f"group {group.name!r} grows and has no size", "add size = …")
        if len({group.size for group in chosen}) < 2:
            what = "growth needs groups of two different sizes"
            self._fault(("growth", "groups"), what, "name more of them")
        place = ("growth", "slope")
        ordered = sorted(chosen, key=lambda group: group.size or 0)
        return GrowthRule(
            tuple(group.name for group in ordered), slope(self._exact(table.slope, place), place, self._fault)
        )

    def group(self, group: Group, table: schema.GroupTable, path: KeyPath) -> Group:
        """The group with its own size and limits."""
        return replace(
            group,
            size=self._size(table, path),
            time_limit=self._time_limit(table, path),
            limits=self._own_limits(table, path),
        )

    def _size(self, table: schema.GroupTable, path: KeyPath) -> int | None:
        if table.size is None:
            return None
        if table.builder == EXAMPLES:
            self._fault((*path, "size"), "the examples take no size", "remove size")
        if not 1 <= table.size <= _MOST_SIZE:
            what = f"group {table.name!r} has the size {table.size}"
            self._fault((*path, "size"), what, f"give 1 to {_MOST_SIZE}")
        return table.size

    def _time_limit(self, table: schema.GroupTable, path: KeyPath) -> float | None:
        if table.time is None:
            return None
        self._need_reference((*path, "time"))
        limit = self._exact(table.time.limit, (*path, "time", "limit"))
        if limit < 1:
            what = "the reference itself would be too slow"
            self._fault((*path, "time", "limit"), what, "give a multiple above 1")
        return float(limit)

    def _own_limits(self, table: schema.GroupTable, path: KeyPath) -> GroupLimits | None:
        if table.limits is None:
            return None
        place = (*path, "limits")
        cpu = self._seconds(table.limits.cpu_seconds, (*place, "cpu_seconds"))
        usual = self._limits
        wall = usual.wall_seconds * cpu / usual.cpu_seconds
        if table.limits.wall_seconds is not None:
            wall = self._seconds(table.limits.wall_seconds, (*place, "wall_seconds"))
        return replace(usual, cpu_seconds=cpu, wall_seconds=wall)

    def _seconds(self, value: schema.TomlNumber, path: KeyPath) -> float:
        seconds = self._exact(value, path)
        if seconds <= 0:
            self._fault(path, f"{path[-1]} allows nothing", "give a number above 0")
        return float(seconds)

    def _need_reference(self, path: KeyPath) -> None:
        if self._table.time is None:
            what = f"{path[-1]} is measured beside a reference solution, and there is none"
            self._fault(path, what, "add a [time] table that names one")
