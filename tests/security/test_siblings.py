"""Submissions of one command are forked from one seed: none reaches another, beside it or after it.

What stands between them is taken out, one thing after the other, to see that the attacks work.
"""

from __future__ import annotations

from typing import NamedTuple

import pytest
from attackers import LEVELS, USERS, Attacker
from sampling import nightly

TOLD = {"open_the_process", "read_status"}  # of any process here, at `limits`
OF_ONE_USER = {"signal", "queue_a_signal", "signal_a_thread", "bind_to_a_core", "see_limits"}
OF_ONE_ROOT = {*OF_ONE_USER, "trace", "read_memory", "open_memory", "read_environment", "list_descriptors"}
AFTER = {"find_files", "find_shared_memory", "find_processes"}


class World(NamedTuple):
    """A level, a user, what is taken out and what a submission can do then."""

    level: str
    user: str
    lacking: str
    opened: set[str]


HELD = [
    World(level, user, "", set() if level != "limits" else TOLD if user == "root" else PLAIN)
    for PLAIN in [{*TOLD, *OF_ONE_USER, "find_shared_memory"}]
    for user in USERS
    for level in LEVELS
]
LACKING = [
    World("limits", "plain", "a session of its own", {"share_a_session"}),
    World("limits", "plain", "a home of its own", {"find_files"}),
    World("limits", "plain", "a memory of its own", {"find_memory"}),
    World("limits", "plain", "the sweep", {"find_processes"}),
    World("limits", "root", "another user", {*OF_ONE_ROOT, "read_source", "list_root", "find_shared_memory"}),
    World("strong", "plain", "landlock and both filters", {*TOLD, *OF_ONE_USER, "find_shared_memory"}),
    World("full", "plain", "landlock and both filters", set()),  # its own namespaces, and nothing is left
    World("full", "plain", "landlock, both filters and the sweep", set()),
    World("full", "plain", "landlock, both filters, the sweep and the count", AFTER),
]
BY_DAY = (("full", "plain"), ("strong", "root"))


@pytest.mark.parametrize(
    ("world", "user"),
    [
        (each, each.user) if each[:2] in BY_DAY and not each.lacking else nightly(each, each.user)
        for each in [*HELD, *LACKING]
        if each.user in USERS
    ],
)
def test_what_reaches_another_submission_of_the_command(attacker: Attacker, world: World) -> None:
    attacker.require(world.level)
    layers = [world.lacking] if world.lacking else []
    found = attacker.run("siblings.py", world.level, *layers)
    opened = {row["name"] for row in found if not row["output"].startswith("held")}
    known = next(each.opened for each in HELD if each[:2] == world[:2])
    # Where root's interpreter lies in a private home, what may pass closed folders passes these too.
    passed_over = {"list_descriptors"} if world[:2] == ("limits", "root") else set()
    if "the count" in world.lacking:  # then the server before is seen while it ends
        passed_over |= {*TOLD, *OF_ONE_USER}
    assert opened - passed_over == (known | world.opened) - passed_over
