"""A wrong program as a person writes it: what gets shorter, and what must stay as it is."""

from __future__ import annotations

import pytest

from judge.mistakes.plain import as_written

SHORTER = {
    "a name for a name": ("near = x\n    return near + near", "return x + x"),
    "a name for one use": ("k = 2 * x\n    d = abs(k) / 3\n    return d", "return abs(2 * x) / 3"),
    "one of two": ("a, b = x + 1, x + 2\n    return a * b * b", "b = x + 2\n    return (x + 1) * b * b"),
    "never read": ("a, b = x, max(x, 1)\n    return a", "return x"),
    "a comment and more": ('"doc"\n    pass  # why\n    return x\n    return 2', "return x"),
    "a chain": (
        "w = 1 if x > 2 else 0 if x else -1\n    if w == 1:\n        return 7\n    if w == 0:\n        x()",
        "if x > 2:\n        return 7\n    if x:\n        x()",
    ),
    "what never is": (
        "w = 1 if x > 2 else -1\n    if w == 1:\n        return 7\n    if w == 0:\n        x()\n    return 9",
        "if x > 2:\n        return 7\n    return 9",
    ),
}  # fmt: skip

SAME = {
    "what may fail is not worked out later": "d = 1 / x\n    if x > 1:\n        return 0\n    return d",
    "nor in another order": "d = 1 / x\n    return 2 / x, d",
    "nor only sometimes": "d = 1 / x\n    return d if x > 1 else 0",
    "nor often": "d = 2 * x\n    return [d + each for each in x]",
    "nor in a loop": "d = 2 * x\n    for each in x:\n        each.add(d)\n    return x",
    "a name that changes": "d = x\n    d += 1\n    return d",
    "what it is made of changes": "d = x + 1\n    x = 2\n    return d + x",
    "two values": "if x:\n        d = 1\n    else:\n        d = x\n    return d",
    "a name for all functions": "global kept\n    kept = x\n    return 2 * x",
    "a call": "d = input(x)\n    return 2",
    "a chain that is read": "w = 1 if x > 2 else -1\n    if w == 1:\n        return w\n    return 9",
    "a chain with more": "w = 1 if x > 2 else -1\n    if w == 1 and x > 3:\n        return 5\n    return 9",
}


@pytest.mark.parametrize(("long", "short"), SHORTER.values(), ids=SHORTER)
def test_it_gets_shorter(long, short):
    assert as_written(f"def f(x):\n    {long}\n", "f") == f"def f(x):\n    {short}\n"


@pytest.mark.parametrize("body", SAME.values(), ids=SAME)
def test_it_stays_as_it_is(body):
    source = f"def f(x):\n    {body}\n"
    assert as_written(source, "f") == source


WRAPPED = """
from math import hypot, sqrt
def inner(x, y):
    if x > y:
        return sqrt(x)
    return y
def f(x, y):
    x = x[::-1]
    answer = inner(x, y)
    answer = round(answer, 2)
    return answer
"""


def test_what_a_wrapper_does_moves_into_the_function():
    assert as_written(WRAPPED, "f") == (
        "from math import sqrt\n\n\n"
        "def f(x, y):\n    x = x[::-1]\n"
        "    if x > y:\n        return round(sqrt(x), 2)\n    return round(y, 2)\n"
    )
    twice = WRAPPED.replace("round(answer, 2)", "answer if answer is None else answer[::-1]")
    assert "def inner" in as_written(twice, "f")


def test_a_call_with_all_arguments_is_no_wrapper():
    source = WRAPPED.partition("def f")[0] + "def f(x, y):\n    answer = inner(x, y)\n    return answer + 1\n"
    assert "return inner(x, y) + 1" in as_written(source, "f")
