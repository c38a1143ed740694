"""What test groups may take, as the published objects of several commands have it."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from judge.problem import Group, GrowthRule
from judge.problem.model import GroupLimits


def limits_object(limits: GroupLimits) -> dict[str, Any]:
    """Bounds in seconds and bytes."""
    return {
        "cpu_seconds": limits.cpu_seconds,
        "wall_seconds": limits.wall_seconds,
        "memory_bytes": limits.memory_bytes,
        "output_bytes": limits.output_bytes,
    }


def own_rules(group: Group) -> dict[str, Any]:
    """What only some groups have: n, bounds, and a time limit in CPU time of the reference."""
    return {
        **({"size": group.size} if group.size is not None else {}),
        **({"limits": limits_object(group.limits)} if group.limits is not None else {}),
        **({"time_limit": group.time_limit} if group.time_limit is not None else {}),
    }


def growth_rule(rule: GrowthRule | None, groups: Collection[Group]) -> dict[str, Any]:
    """`growth`, how CPU time may grow, where one of these groups counts for it; else nothing."""
    if rule is None or not any(group.name in rule.groups for group in groups):
        return {}
    return {"growth": {"slope": rule.slope, "groups": list(rule.groups)}}
