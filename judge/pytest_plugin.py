"""The pytest plug-in: each test group of a problem as a test of its own.

    @pytest.mark.judge_problem("count")
    def test_count(judge_group):
        judge_group.check(my_count)

It is loaded at the start of every pytest run wherever judge is installed, so nothing of judge is imported
until a test asks for it.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from judge.testing import JudgeGroup, JudgeProblem

_MARKER = "judge_problem"
_FIXTURE = "judge_group"
_USE = f"write @pytest.mark.{_MARKER}('count'), or any problem that 'judge list' shows"
stderr: int | None = None  # where pytest's own goes, whatever it captures
_PROBLEMS = pytest.StashKey[dict[Any, "JudgeProblem"]]()  # each is read and built once a session


class _Misused(Exception):  # noqa: N818
    """A marker that stands for no test groups; its text is for the person."""


def pytest_configure(config: pytest.Config) -> None:
    """Make the marker known, so that --strict-markers lets it pass."""
    global stderr
    stderr = os.dup(2)  # nothing is captured yet
    config.addinivalue_line(
        "markers",
        f"{_MARKER}(name, groups=None, problems=()): run the test once for each test group of this problem "
        f"of judge, with the fixture {_FIXTURE}; only for these groups; look in these folders first.",
    )


def pytest_unconfigure() -> None:
    """Close what is written to no more."""
    global stderr
    if stderr is not None:
        os.close(stderr)
        stderr = None


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """One test for each group, called after it."""
    if _FIXTURE not in metafunc.fixturenames:
        return
    try:
        groups: Any = _groups(metafunc.config, metafunc.definition)
        names = [group.name for group in groups]
    except _Misused as fault:  # this test fails with it when it is run, and the others are collected
        groups, names = [str(fault)], [_MARKER]
    metafunc.parametrize(_FIXTURE, groups, ids=names, indirect=True)


@pytest.fixture
def judge_group(request: pytest.FixtureRequest) -> JudgeGroup:
    """A test group of the marker judge_problem's problem; `.check(routine)` holds a routine against it."""
    group: JudgeGroup | str = request.param
    if isinstance(group, str):
        pytest.fail(group, pytrace=False)
    return group


def _groups(config: pytest.Config, item: Any) -> list[JudgeGroup]:
    """The groups that the test's nearest marker stands for. Raises _Misused with what is wrong with it."""
    marker = item.get_closest_marker(_MARKER)
    if marker is None:
        raise _Misused(f"the fixture {_FIXTURE} needs a problem: {_USE}")
    from judge.errors import JudgeError

    try:
        name, chosen, folders = _arguments(*marker.args, **marker.kwargs)
    except TypeError:
        raise _Misused(f"the marker {_MARKER} cannot be understood: {_USE}") from None
    try:
        problem = _problem(config, name, folders)
        return [problem.group(each) for each in chosen or problem.groups]
    except JudgeError as fault:
        raise _Misused(f"{_MARKER}: {fault}") from None


def _arguments(
    name: str, groups: Sequence[str] | None = None, problems: Sequence[str] = ()
) -> tuple[str, tuple[str, ...] | None, tuple[str, ...]]:
    """What the marker was given; TypeError where that is no name and no lists, or a list of no groups."""
    if not isinstance(name, str) or isinstance(groups, str) or isinstance(problems, str):
        raise TypeError
    if groups is not None and not groups:  # the test would be left out, and nobody would see it
        raise TypeError
    return name, None if groups is None else tuple(groups), tuple(map(str, problems))


def _problem(config: pytest.Config, name: str, folders: tuple[str, ...]) -> JudgeProblem:
    from judge.testing import judge_problem

    known = config.stash.setdefault(_PROBLEMS, {})
    if (name, folders) not in known:
        known[name, folders] = judge_problem(name, problems=folders)
    return known[name, folders]
