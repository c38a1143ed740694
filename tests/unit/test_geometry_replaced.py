"""Points, directions and lengths of a case: told with their roles, and replaced where they stand."""

from __future__ import annotations

import pytest

from judge.geometry.replaced import replaced
from judge.problem.find import find_problem, problem_folders

POINTLESS = {"stable-roots", "test-writer"}


def told(problem, case):
    found = []

    def note(role, name, numbers):
        found.append((role, name, numbers))
        return numbers

    return replaced(problem, case, note), found


@pytest.mark.parametrize("name", sorted(each.name for each in problem_folders(installed=False)))
def test_what_is_not_changed_stays(name):
    problem = find_problem(name, [])
    for example in problem.examples[:3]:
        same, found = told(problem, example.case)
        assert same == (None if name in POINTLESS else example.case)
        assert bool(found) is (name not in POINTLESS)


@pytest.mark.parametrize(
    ("name", "case", "roles"),
    [
        (
            "segment",
            (1, 2, 3, (4, 5), (6, 7)),
            [
                ("point", "(cx, cy)", (1, 2)),
                ("length", "r", (3,)),
                ("end", "A", (4, 5)),
                ("end", "B", (6, 7)),
            ],
        ),
        (
            "ray-nearest",
            (1, 2, 3, (4, 5), (6, 7)),
            [
                ("point", "(cx, cy)", (1, 2)),
                ("length", "r", (3,)),
                ("point", "O", (4, 5)),
                ("way", "D", (6, 7)),
            ],
        ),
        (
            "shadow",
            (((1, 2, 3),), (4, 5), (6, 7), (8, 9)),
            [
                ("point", "circles[0]", (1, 2)),
                ("length", "circles[0]", (3,)),
                ("point", "O", (4, 5)),
                ("way", "D", (6, 7)),
                ("point", "L", (8, 9)),
            ],
        ),
    ],
)
def test_roles_follow_from_types_and_names(name, case, roles):
    problem = find_problem(name, [])
    assert told(problem, case) == (case, roles)
    doubled = replaced(problem, case, lambda _role, _name, numbers: tuple(2 * x for x in numbers))
    assert repr(told(problem, doubled)[1]) == repr(
        [(*each[:2], tuple(2 * x for x in each[2])) for each in roles]
    )
