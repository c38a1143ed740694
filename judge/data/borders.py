"""The topic's borders as they are kept with the data: probes whose two sides `solve` has confirmed.

They are plain values in the data's own file, so that a warm start measures thresholds without the topic.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.problem.border import Border, Probe
from judge.problem.model import tupled

if TYPE_CHECKING:
    from judge.data.module import ProblemModule
    from judge.data.validate import Validator
    from judge.problem import Problem

KEY = "#borders"  # beside the groups' names, none of which begins so; it is there if there are any


def borders_of(problem: Problem, module: ProblemModule) -> tuple[Border, ...]:
    """The borders of the problem's topic, each probe with the forms of its two answers.

    Raises ProblemError for a probe whose answers do not differ, or that is no case of the problem.
    """
    if module.topic.borders is None:
        return ()
    from judge.data.module import blaming
    from judge.data.validate import Validator

    with blaming(problem, "the topic's borders cannot be made"):
        found = module.topic.borders(problem)
    validator = Validator(problem, module.solve)
    return tuple(
        replace(each, probes=tuple(_proved(validator, each, one, problem) for one in each.probes))
        for each in found
    )


def as_plain(borders: tuple[Border, ...]) -> Any:
    """JSON's values for them."""
    return msgspec.to_builtins(borders)


def from_plain(plain: Any) -> tuple[Border, ...]:
    """What `as_plain` wrote. Raises ValueError (msgspec's own) for anything else."""
    return tuple(
        replace(each, probes=tuple(replace(probe, case=tupled(probe.case)) for probe in each.probes))
        for each in msgspec.convert(plain, tuple[Border, ...])
    )


def _proved(validator: Validator, border: Border, probe: Probe, problem: Problem) -> Probe:
    from judge.data.build import target_of

    forms = []
    for share in (probe.least, probe.widest):
        case, gap = probe.at(share * probe.size)
        proof = validator.proof(case)
        if proof.fault:
            raise ProblemError(
                f"a probe of {border.about!r} is invalid: {proof.fault}",
                where=f"{problem.id}/problem.py",
                remedy="correct the topic's borders",
            )
        target = target_of(problem, proof.answer, problem.groups[0].tolerance)
        forms.append(probe.form(problem.answer.right(target), gap))
    near, far = forms
    if border.mistaken:
        if near != far:
            raise ProblemError(
                f"a probe of {border.about!r} is answered {near!r} and then {far!r}: {probe.case}",
                where=f"{problem.id}/problem.py",
                remedy="correct the topic's borders",
            )
        near = border.mistaken
    if near == far:
        raise ProblemError(
            f"a probe of {border.about!r} is answered {near!r} on both sides: {probe.case}",
            where=f"{problem.id}/problem.py",
            remedy="correct the topic's borders",
        )
    return replace(probe, near=near, far=far)
