"""A layer of the containment is left out: the attacks that it holds alone succeed then, and no others.

So each layer is needed, and the rest are there without it.
"""

from __future__ import annotations

import json
from typing import NamedTuple

import pytest
from attackers import USERS, Attacker
from sampling import nightly
from table import ATTACKS, READING
from without import LAYERS, source_of

from judge.sandbox.inside import linux

DEEDS = [attack for attack in ATTACKS if not attack.ends]
KERNELS = {attack.name for attack in DEEDS if attack.control == "maybe"}  # only some have them switched on
LATER = {  # landlock governs it too, where it is new enough
    **dict.fromkeys(("kill_process", "kill_judge", "queue_signal", "unix_abstract"), 6),
    **dict.fromkeys(("tcp_connect", "tcp_listen"), 4),
    "truncate_file": 3,
}
STARTS = ("fork", "clone_process", "daemon", "kill_everybody", "kill_parent", "outlive_the_judge")
OF_THE_KERNEL = (
    *("memory_file", "sysv_shared_memory", "sysv_semaphore", "sysv_queue"),
    *("scheduling", "affinity", "niceness", "udp_send", "netlink"),
)
AT_HOME = ("home_file", "home_nameless_file")
MADE_AT_HOME = ("home_folders", "home_symlink", "home_pipe", "home_chmod")
READ = {name for name in READING if name not in ("readlink_answers", "change_folder")}


class Lacking(NamedTuple):
    """A level without a layer, and what a submission of the user can do then."""

    layer: str
    level: str
    opened: set[str]
    user: str = "plain"
    filters: bool = False  # whether a filter of system calls is left out


WORLDS = [
    Lacking("landlock and the last look", "strong", {*READ, "write_file", *AT_HOME, "home_fill"}),
    Lacking("landlock", "full", {*AT_HOME}),  # a page of memory; the mounts hold what else it holds
    Lacking(
        "the server's filter",
        "strong",
        {
            *OF_THE_KERNEL,
            *("readlink_answers", "change_folder", "chmod_file", "utime_file", "home_chmod"),
            *("unix_connect", "unix_datagram_pair"),
        },
        filters=True,
    ),
    Lacking("the child's filter", "strong", {*STARTS, "limit_other_process"}, filters=True),
    Lacking(
        "landlock and both filters",
        "full",
        {*OF_THE_KERNEL, *STARTS, "tcp_listen", *AT_HOME, *MADE_AT_HOME},
        filters=True,
    ),
    Lacking("the limit on threads", "limits", {"threads"}),
    Lacking("hard limits", "strong", {"raise_limits"}),
    Lacking("closed descriptors", "strong", {"inherited_descriptors"}),
    Lacking(
        "the seals of its source",
        "strong",
        {"change_own_source", "grow_own_source", "change_own_source_by_name"},
    ),
    Lacking("another user", "limits", {"threads", "be_root"}, USERS[-1]),
]
BY_DAY = ("the child's filter",)


@pytest.mark.parametrize(
    ("lacking", "user"),
    [
        (each, each.user) if each.layer in BY_DAY else nightly(each, each.user)
        for each in WORLDS
        if each.user != "plain" or each.layer != "another user"
    ],
)
def test_what_a_layer_alone_holds_is_open_without_it(attacker: Attacker, lacking: Lacking) -> None:
    attacker.require(lacking.level)
    deeds = [attack for attack in DEEDS if lacking.level not in attack.open_at]
    names = [attack.name for attack in deeds]
    found = attacker.run("without.py", lacking.layer, lacking.level, given=json.dumps(names))
    opened = {row["name"] for row in found if not row["output"].startswith("held")}
    passed_over = {name for name, version in LATER.items() if linux.abi() < version}
    if lacking.filters:
        passed_over |= KERNELS
    assert opened - passed_over == lacking.opened - passed_over


@pytest.mark.parametrize("user", [USERS[0], *map(nightly, USERS[1:])])
def test_without_landlock_nothing_is_run_at_all(attacker: Attacker) -> None:
    attacker.require("strong")
    found = attacker.run("without.py", "landlock", "strong", given=json.dumps(["read_answers"]))
    assert "isolation strong would let a submission read" in found[0]["fault"]


def test_every_layer_is_where_it_is_taken_out():
    """By day too, when few layers are."""
    for name, here, _ in {change for changes in LAYERS.values() for change in changes}:
        assert source_of(name).count(here) == 1, here
