"""The keys of problem.toml that declare test groups, their skills and the bands, and their checks.

Only of katas whose groups do not stand in problem.py yet.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from judge.problem import schema
from judge.problem.growing import GrowingKeys
from judge.problem.level import level_fault
from judge.problem.lines import KeyPath
from judge.problem.model import EXAMPLES, Group, Problem, ShownSkill
from judge.problem.names import is_name
from judge.problem.tomlfile import meant
from judge.problem.verdict import FULL_SCORE
from judge.values import Tolerance

if TYPE_CHECKING:
    from judge.problem.load import Reader

_MOST_CASES = 1_000_000
_DEEPEST = 10  # lists in lists of a builder's parameter


class TomlGroups:
    """The checks, by the reader of the file's other keys; `problem` is all that these say."""

    def __init__(self, reader: Reader, problem: Problem) -> None:
        self._reader = reader
        self._fault = reader.fault
        self._problem = problem

    def filled(self, table: schema.ProblemTable) -> Problem:
        """The problem with its groups, skills and bands. Raises ProblemError."""
        bands = self._bands(table)
        growing = GrowingKeys(table, self._problem.limits, self._fault, self._reader.exact)
        groups = tuple(
            growing.group(group, table.groups[at], ("groups", at))
            for at, group in enumerate(self._groups(table))
        )
        return replace(
            self._problem,
            in_toml=True,
            bands=bands,
            groups=groups,
            skills=self._skills(table),
            growth=growing.growth(groups),
        )

    def _tolerance(self, group: schema.GroupTable, table: schema.ProblemTable, path: KeyPath) -> Tolerance:
        own = group.tolerance is not None
        place: KeyPath = (*path, "tolerance") if own else ("tolerance",)
        tolerance = self._reader.tolerance(group.tolerance or table.tolerance, place)
        if tolerance is None:
            self._fault(path, f"group {group.name!r} has no tolerance", "add a [tolerance] table")
        return tolerance

    def _bands(self, table: schema.ProblemTable) -> dict[str, Fraction]:
        """The named widths, each above 0."""
        widths = {name: self._reader.exact(value, ("bands", name)) for name, value in table.bands.items()}
        for name, width in widths.items():
            if width <= 0:
                self._fault(("bands", name), f"the band {name!r} has no width", "give a number above 0")
        return widths

    def _groups(self, table: schema.ProblemTable) -> tuple[Group, ...]:
        if not table.groups:
            self._fault(("groups",), "there are no test groups", "add a [[groups]] table")
        self._reader.unique("groups", [group.name for group in table.groups])
        total = sum(group.points for group in table.groups)
        if total != FULL_SCORE:
            what = f"the groups' points sum to {total}"
            self._fault(("groups", 0, "points"), what, f"make them sum to {FULL_SCORE}")
        if mixed := level_fault([(group.name, group.level) for group in table.groups]):
            self._fault(("groups", mixed[0]), *mixed[1:])
        return tuple(self._group(each, table, ("groups", at)) for at, each in enumerate(table.groups))

    def _group(self, group: schema.GroupTable, table: schema.ProblemTable, path: KeyPath) -> Group:
        if not is_name(group.name):
            remedy = "use small letters, digits and single hyphens"
            self._fault((*path, "name"), f"{group.name!r} is no name for a group", remedy)
        if group.points < 0:
            self._fault((*path, "points"), f"group {group.name!r} has negative points", "give 0 to 100")
        if len(set(group.kills)) < len(group.kills):
            self._fault((*path, "kills"), f"group {group.name!r} names a mistake twice", "remove one")
        seed, count = self._seed_and_count(group, path)
        return Group(
            name=group.name,
            about=group.about,
            builder=group.builder,
            parameters={
                name: self._argument(value, (*path, "parameters", name))
                for name, value in group.parameters.items()
            },
            seed=seed,
            count=count,
            points=group.points,
            tolerance=self._tolerance(group, table, path),
            kills=tuple(group.kills),
            neighbours=self._neighbours(group, path),
            level=group.level,
        )

    def _neighbours(self, group: schema.GroupTable, path: KeyPath) -> bool:
        if group.neighbours and (group.builder == EXAMPLES or group.size is not None):
            what = "examples and big cases are no neighbours of one another"
            self._fault((*path, "neighbours"), what, "remove neighbours")
        return group.neighbours

    def _seed_and_count(self, group: schema.GroupTable, path: KeyPath) -> tuple[int, int]:
        """A group's seed and number of cases; both 0 for the examples, whose number the statement says."""
        if group.builder == EXAMPLES:
            for key in ("seed", "count", "parameters"):
                if getattr(group, key):
                    self._fault((*path, key), f"the examples take no {key}", f"remove {key}")
            return 0, 0
        if group.seed is None or group.count is None:
            missing = "seed" if group.seed is None else "count"
            self._fault(path, f"group {group.name!r} has no {missing}", f"add {missing} = …")
        if group.seed < 0:
            self._fault((*path, "seed"), f"the seed of group {group.name!r} is negative", "give 0 or more")
        if not 1 <= group.count <= _MOST_CASES:
            self._fault(
                (*path, "count"), f"group {group.name!r} has {group.count} cases", f"give 1 to {_MOST_CASES}"
            )
        return group.seed, group.count

    def _skills(self, table: schema.ProblemTable) -> tuple[ShownSkill, ...]:
        names = [group.name for group in table.groups]
        return tuple(self._skill(skill, entry, names) for skill, entry in table.skills.items())

    def _skill(self, skill: str, entry: Any, names: list[str]) -> ShownSkill:
        path: KeyPath = ("skills", skill)
        if isinstance(entry, dict):
            own = self._reader.file.shaped(entry, schema.SkillTable, path)
            groups, about, path = own.groups, own.about, (*path, "groups")
        else:
            groups, about = self._reader.file.shaped(entry, list[str], path), None
        if not skill.strip():
            self._fault(path, "a skill has no name", "write what the groups show in a few words")
        if about is not None and not about.strip():
            self._fault(("skills", skill, "about"), f"{skill!r} is not explained", "write one sentence")
        if not groups:
            self._fault(path, f"no group shows {skill!r}", "name at least one")
        for at, group in enumerate(groups):
            if group not in names:
                self._fault(path, f"there is no group {group!r} to show {skill!r}", meant(group, names))
            if group in groups[:at]:
                self._fault(path, f"{skill!r} names the group {group!r} twice", "remove one")
        return ShownSkill(skill, tuple(groups), about)

    def _argument(self, value: Any, path: KeyPath, depth: int = 0) -> Any:
        """A builder's parameter: exact (a Fraction where the file has a decimal point) and unchangeable."""
        if isinstance(value, Decimal):
            return self._reader.exact(value, path)
        if isinstance(value, list) and depth < _DEEPEST:
            return tuple(self._argument(each, path, depth + 1) for each in value)
        if isinstance(value, bool | int | str):
            return value
        return self._fault(
            path, f"a builder cannot take {value!r}", "give a number, text, true or false, or a list"
        )
