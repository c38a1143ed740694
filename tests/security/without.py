"""`driver.py` with one layer of the containment left out: `without.py LAYER LEVEL < names`.

A layer is left out in the code that is sent into the container, so that nothing of the judge's has a switch
for it.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

import driver

from judge.sandbox import parcels

INSIDE = "judge.sandbox.inside."
_RULES = (
    f"{INSIDE}confine",
    'linux.restrict(config["readable"], config["writable"], runnable, filled)',
    "pass",
)
_LOOK = (f"{INSIDE}seed", '        _look_around(region, line, config["unseen"])\n', "")
_SERVERS = (f"{INSIDE}confine", "linux.load_filter(load, bytearray(server))", "pass")
_CHILDS = (f"{INSIDE}confine", "lambda: linux.load_filter(load, own_filter(child, pid_at))", "lambda: None")
_SWEEP = (
    f"{INSIDE}server",
    '_kill_all([-1] if self._level == "full" else [-pid, *_children()])',
    "return spent",
)
_COUNT = (f"{INSIDE}seed", '_left(config.get("home"))', "False")
LAYERS = {
    "landlock": (_RULES,),
    "landlock and the last look": (_RULES, _LOOK),
    "the server's filter": (_SERVERS,),
    "the child's filter": (_CHILDS,),
    "landlock and both filters": (_RULES, _LOOK, _SERVERS, _CHILDS),
    "another user": ((f"{INSIDE}confine", 'if config["uid"] is not None:', "if False:"),),
    "the limit on threads": ((f"{INSIDE}server", 'limits["RLIMIT_NPROC"] = self._threads', "pass"),),
    "hard limits": (
        (f"{INSIDE}confine", "setrlimit(which, (value, value))", "setrlimit(which, (value, hard))"),
    ),
    "closed descriptors": ((f"{INSIDE}child", "os.closerange(len(kept), wire.MOST_DESCRIPTORS)", "pass"),),
    "a session of its own": ((f"{INSIDE}seed", "    os.setsid()\n", ""),),
    "the sweep": (_SWEEP,),
    "landlock, both filters and the sweep": (_RULES, _LOOK, _SERVERS, _CHILDS, _SWEEP),
    "landlock, both filters, the sweep and the count": (_RULES, _LOOK, _SERVERS, _CHILDS, _SWEEP, _COUNT),
    "the seals of its source": (
        (f"{INSIDE}source", "fcntl.fcntl(number, fcntl.F_ADD_SEALS, seals)", "pass"),
    ),
}


def source_of(name: str) -> str:
    """The text of a module of the container."""
    return Path(str(find_spec(name).origin)).read_text()


def leave_out(layer: str) -> None:
    """Send the container code that lacks the layer."""
    whole = parcels._code_of

    def lacking(name: str) -> object:
        changes = [change for change in LAYERS[layer] if change[0] == name]
        if not changes:
            return whole(name)
        source = source_of(name)
        for _, here, instead in changes:
            assert source.count(here) == 1, here
            source = source.replace(here, instead)
        return compile(source, name, "exec", dont_inherit=True)

    parcels._code_of = lacking  # type: ignore[assignment]


if __name__ == "__main__":
    leave_out(sys.argv[1])
    driver.main(sys.argv[2])
