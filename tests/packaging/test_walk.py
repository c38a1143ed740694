"""What counts as shown as told, and how a page is read."""

from __future__ import annotations

import pytest
from walk import Step, missing, plain, steps

SHOWN = """\
count.py  count

  smallest case found
    input   r=1
    wanted  2

True scale   a lens
⠒

o wanted  x got

WA  70 of 100 points, 1.8 ms CPU, 8 MB
"""


@pytest.mark.parametrize(
    "claimed",
    [
        SHOWN,
        "…\n",
        "count.py  count\n…\n",
        "…\n    wanted  2\n…\no wanted  x got\n…\n",
        SHOWN.replace("1.8 ms CPU, 8 MB", "12 ms CPU, 9 MB"),
        SHOWN.replace("input   r=1", "input   r=2").replace("⠒", "⠓"),  # the search ended elsewhere
    ],
)
def test_as_told(claimed):
    assert missing(claimed, SHOWN) is None


@pytest.mark.parametrize(
    ("claimed", "lacking"),
    [
        (SHOWN.replace("70", "71"), "71 of 100"),
        (SHOWN.replace("⠒", "⠓"), "⠓"),
        ("  smallest case found\n…\n", "smallest"),  # it does not begin with that
        ("count.py  count\n", "smallest"),  # it does not end with that
        ("…\n    wanted  2\n…\n    input   r=1\n…\n", "input"),  # not in that order
    ],
)
def test_not_as_told(claimed, lacking):
    assert lacking in missing(claimed, SHOWN)


def test_the_steps_of_a_page():
    page = (
        "## One\n\nInto `a/b.md`:\n\n```md\n## Two\n```\n\n"
        "```console\n$ judge run\nAC\n$ judge next\n```\n\n## Two\n"
    )
    wanted = [
        Step("a/b.md", "## Two\n", is_file=True),
        Step("judge run", "AC\n", is_file=False),
        Step("judge next", "", is_file=False),
    ]
    assert steps(page, "One") == wanted
    assert steps(page, "Two") == []


def test_colours_links_and_filling_are_left_out():
    assert plain("\x1b[32mAC\x1b[0m  \x1b]8;;file:///x\x1b\\x.py\x1b]8;;\x1b\\   \n") == "AC  x.py\n"
