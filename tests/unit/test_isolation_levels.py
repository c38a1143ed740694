"""Levels of isolation: which is taken, and that it never drops in silence.

What passes is tried again, what lasts alone leads to another level.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import pytest
from sandboxed import LIMITS, children, require

from judge import sandbox
from judge.errors import JudgeError, ShortageError, UsageError
from judge.sandbox import Containment, container, launch, levels, open_box, parcels
from judge.sandbox.available import levels_here
from judge.sandbox.inside.again import PAUSES
from judge.sandbox.levels import Levels, StartError

pytestmark = pytest.mark.slow

REAL = shutil.which("bwrap")


def pretend(folder: Path, patch: pytest.MonkeyPatch, script: str) -> Path:
    """A bubblewrap that runs `script`; each of its starts is a line of the file that is returned."""
    if REAL is None:
        pytest.skip("bubblewrap is not installed")
    starts, broken = folder / "starts", folder / "bwrap"
    starts.touch()
    broken.write_text(f"#!/bin/sh\necho start >> {starts}\n{script}\n")
    broken.chmod(0o755)
    patch.setattr(launch, "bubblewrap_path", lambda: str(broken))
    return starts


def once(folder: Path, script: str) -> str:
    """A script that runs `script` the first time, and the real bubblewrap from then on."""
    mark = folder / "failed"
    return f'if [ ! -e {mark} ]; then touch {mark}; {script}; fi\nexec {REAL} "$@"'


def count(starts: Path) -> int:
    return len(starts.read_text().splitlines())


AGAIN = "Resource temporarily unavailable"
PASSING = [f"echo 'bwrap: Creating new namespace failed: {AGAIN}' >&2; exit 1", "kill -9 $$"]
LASTING = "echo 'bwrap: No permissions to create new namespace' >&2; exit 1"


@pytest.fixture(autouse=True)
def _in_no_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(levels, "PAUSES", (0.0,) * len(PAUSES))


def test_a_demanded_level_is_not_lowered(monkeypatch):
    monkeypatch.setattr(launch, "bubblewrap_path", lambda: None)
    levels.missing.cache_clear()
    try:
        with pytest.raises(UsageError, match="bubblewrap is not installed") as caught:
            open_box(b"", "f.py", level="full")
        assert "bubblewrap" in (caught.value.remedy or "")
        with open_box(b"", "f.py") as box:
            assert box.isolation in ("strong", "limits")
    finally:
        levels.missing.cache_clear()


def test_a_box_may_be_closed_while_it_boots():
    before = children()
    for seconds in (0, 0.01, 0.03):
        box = open_box(b"import decimal\ndef f(n): return n", "f.py")
        time.sleep(seconds)
        box.__exit__(None, None, None)
        assert children() == before


@pytest.mark.parametrize("script", PASSING)
def test_a_passing_refusal_is_tried_again_and_the_level_stays(script, tmp_path, monkeypatch):
    require("full")
    starts = pretend(tmp_path, monkeypatch, once(tmp_path, script))
    boxes = Containment()
    with boxes(b"def f(n): return n", "f.py") as box:
        assert box.isolation == "full"
        assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1
    assert count(starts) == 2
    assert boxes.levels.refused == {}


@pytest.mark.parametrize(("script", "level"), [(PASSING[0], None), (PASSING[1], "full")])
def test_a_passing_refusal_that_stays_costs_the_submission_and_not_the_level(
    script, level, tmp_path, monkeypatch
):
    starts = pretend(tmp_path, monkeypatch, script)
    before = children()
    boxes = Containment(level)
    with pytest.raises(ShortageError, match="no container could be started: ") as caught:
        boxes(b"", "f.py").__enter__()
    assert caught.value.remedy
    assert "\n" not in str(caught.value)
    assert count(starts) > len(PAUSES)
    assert boxes.levels.refused == {}
    assert children() == before


def test_a_lasting_refusal_leads_to_the_next_level_and_is_not_tried_again(tmp_path, monkeypatch):
    require("strong")
    starts = pretend(tmp_path, monkeypatch, f"sleep 0.2; {LASTING}")
    boxes = Containment()
    with boxes(b"def f(n): return n", "f.py") as box:
        assert box.isolation == "strong"
        for _ in range(2):
            assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1
    for _ in range(2):
        with boxes(b"", "f.py") as box:
            assert box.isolation == "strong"
    assert count(starts) == 1
    assert boxes.levels.refused == {"full": "bwrap: No permissions to create new namespace"}
    with pytest.raises(UsageError, match="No permissions"):
        Containment("full")(b"", "f.py").__enter__()


@pytest.mark.parametrize("script", [LASTING, PASSING[0]])
def test_a_level_that_was_had_is_demanded_from_then_on(script, tmp_path, monkeypatch):
    require("full")
    boxes = Containment()
    with boxes(b"", "f.py") as box:
        assert box.isolation == "full"
    with monkeypatch.context() as patch:
        pretend(tmp_path, patch, script)
        with pytest.raises(JudgeError) as caught:
            boxes(b"", "f.py").__enter__()
        assert not isinstance(caught.value, UsageError)  # it costs one submission, and the others are judged
    with boxes(b"", "f.py") as box:
        assert box.isolation == "full"


def test_a_box_that_loses_its_container_is_held_as_before(tmp_path, monkeypatch):
    require("full")
    with Containment()(b"import os\ndef f(n): os._exit(0)", "f.py") as box:
        box._drop()
        pretend(tmp_path, monkeypatch, LASTING)
        with pytest.raises(JudgeError, match="isolation full was had and is now refused: bwrap: No perm"):
            box.call("f", [(1,)], LIMITS)
        assert box.isolation == "full"


def test_resource_limits_alone_are_taken_only_where_there_is_no_sandbox(tmp_path, monkeypatch):
    require("strong")
    pretend(tmp_path, monkeypatch, LASTING)

    def refuse(self):
        self.close()
        raise StartError("landlock says no", 1, lasting=True)

    with monkeypatch.context() as patch:
        patch.setattr(container.Container, "await_ready", refuse)
        with pytest.raises(JudgeError, match="no container can be started: landlock says no"):
            Containment()(b"", "f.py").__enter__()
    monkeypatch.setattr(levels, "missing", lambda level: "" if level == "limits" else "this is no Linux")
    boxes = Containment()
    with boxes(b"", "f.py") as box:
        assert box.isolation == "limits"
    assert set(boxes.levels.refused) == {"full", "strong"}


@pytest.mark.parametrize(
    ("place", "code"),
    [
        ("container._socket.socketpair", errno.EMFILE),
        ("container.parcels.region", errno.ENOMEM),
        ("container._STARTER.start", errno.EAGAIN),
    ],
)
def test_what_the_judge_itself_is_short_of_is_tried_again_and_named(place, code, monkeypatch):
    real = _found(place)
    failed = []

    def scarce(*arguments, **settings):
        if len(failed) < most:
            failed.append(code)
            raise OSError(code, os.strerror(code))
        return real(*arguments, **settings)

    monkeypatch.setattr(f"judge.sandbox.{place}", scarce)
    before, descriptors = children(), len(list(Path("/proc/self/fd").iterdir()))
    most = 3
    with Containment()(b"def f(n): return n", "f.py") as box:
        assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1
    assert len(failed) == most
    most = 100
    with pytest.raises(ShortageError, match=r"no container could be started: .*(-j|limit)"):
        Containment()(b"", "f.py").__enter__()
    assert len(failed) < most
    assert children() == before
    assert len(list(Path("/proc/self/fd").iterdir())) == descriptors


def _found(place):
    found = sandbox
    for name in place.split("."):
        found = getattr(found, name)
    return found


@pytest.mark.parametrize(
    ("said", "status", "tries", "lasting"),
    [
        ("bwrap: No permissions to create new namespace, likely because …", 1, 1, True),
        (f"bwrap: Can't fork for pid 1: {AGAIN}", 1, len(PAUSES) + 1, False),
        ("ModuleNotFoundError: No module named 'encodings'", 1, 2, True),
        ("", 1, len(PAUSES) + 1, False),
        ("", -31, 1, True),
    ],
)
def test_what_an_end_says_of_the_next_try(said, status, tries, lasting):
    found = levels.of_end(said, status)
    assert (found.tries, found.lasting) == (tries, lasting)


@pytest.mark.parametrize(
    ("code", "tries", "lasting"),
    [
        (errno.EAGAIN, len(PAUSES) + 1, False),
        (errno.ENOMEM, len(PAUSES) + 1, False),
        (errno.ENOSPC, 1, False),
        (errno.EPERM, 2, True),
        (0, 2, True),
    ],
)
def test_what_a_server_says_is_told_by_its_errno_and_not_by_its_words(code, tries, lasting):
    found = levels.of_code(code, AGAIN)
    assert (found.tries, found.lasting) == (tries, lasting)


@pytest.mark.parametrize(
    ("fault", "kind"), [("OSError(11, 'x')", ShortageError), ("OSError(1, 'x')", UsageError)]
)
def test_a_server_that_cannot_confine_itself_sends_the_errno(fault, kind, monkeypatch):
    require("strong")
    start = "        confinement = Confinement(config)"
    with changed(monkeypatch, ".seed", start, f"        raise {fault}\n{start}"), pytest.raises(kind):
        Containment("strong")(b"", "f.py").__enter__()


@contextlib.contextmanager
def changed(patch, module, here, instead):
    """The code of a container with an edit."""

    def edited(name):
        source = Path(find_spec(name).origin).read_text()
        assert not name.endswith(module) or source.count(here) == 1
        source = source.replace(here, instead) if name.endswith(module) else source
        return compile(source, name, "exec", dont_inherit=True)

    with patch.context() as patched:
        patched.setattr(parcels, "_code_of", edited)
        parcels._module.cache_clear()
        yield
    parcels._module.cache_clear()


FILTER = "lambda: linux.load_filter(load, own_filter(child, pid_at))"


@pytest.mark.parametrize(
    ("here", "instead", "deed"),
    [
        (FILTER, "lambda: None", "start a process"),
        ("linux.load_filter(load, bytearray(server))", "pass", "open a socket"),
    ],
)
def test_a_level_at_which_a_submission_does_what_it_may_not_is_none(here, instead, deed, monkeypatch):
    require("strong")
    with changed(monkeypatch, ".confine", here, instead):
        found = {level.name: level for level in levels_here()}
    assert (found["strong"].available, found["strong"].why_not) == (False, f"a submission could {deed}")
    assert found["limits"].available


class Machine:
    """What starts but where it is refused for a reason; `starts` are the levels that were tried."""

    def __init__(self, **refusals):
        self.starts: list[str] = []
        self.refusals = refusals

    def start(self, level: str) -> str:
        self.starts.append(level)
        if level in self.refusals:
            raise self.refusals[level]
        return f"at {level}"


SHORT, NEVER = StartError("not now", 3, code=errno.EAGAIN), StartError("never", 1, lasting=True)


@pytest.fixture
def everything(monkeypatch):
    """A machine that lacks nothing, as far as can be told without trying."""
    monkeypatch.setattr(levels, "missing", lambda level: "")


@pytest.mark.usefixtures("everything")
def test_the_first_start_decides_and_later_ones_are_held_to_it():
    here, machine = Levels(), Machine(full=NEVER)
    assert [here.open(machine.start), here.open(machine.start)] == ["at strong"] * 2
    assert machine.starts == ["full", "strong", "strong"]
    assert (here.level, here.refused) == ("strong", {"full": "never"})
    machine.refusals = {"strong": NEVER}
    with pytest.raises(JudgeError, match="isolation strong was had and is now refused: never"):
        here.open(machine.start)


@pytest.mark.usefixtures("everything")
@pytest.mark.parametrize(
    ("here", "refusal", "kind", "match"),
    [
        (Levels(), SHORT, ShortageError, "no container could be started: no further process"),
        (Levels("full"), NEVER, UsageError, "isolation full cannot be had here: never"),
        (
            Levels(kept="full"),
            NEVER,
            UsageError,
            "isolation full, which 'judge doctor' found here, cannot be",
        ),
        (Levels(had="full"), NEVER, JudgeError, "isolation full was had and is now refused: never"),
    ],
)
def test_a_level_is_lowered_only_where_none_was_demanded_kept_or_had(here, refusal, kind, match):
    machine = Machine(full=refusal)
    with pytest.raises(kind, match=match):
        here.open(machine.start)
    assert machine.starts == ["full"] * refusal.tries
    assert here.refused == {}


@pytest.mark.usefixtures("everything")
def test_limits_are_never_taken_where_a_sandbox_is_refused():
    machine = Machine(full=NEVER, strong=NEVER)
    with pytest.raises(JudgeError, match="no container can be started: never"):
        Levels().open(machine.start)
    assert machine.starts == ["full", "strong"]
    assert Levels("limits").open(machine.start) == "at limits"


def test_where_no_proc_may_be_mounted_the_machines_own_is_taken(tmp_path, monkeypatch):
    refused = 'echo "bwrap: Can\'t mount proc on /newroot/proc: Operation not permitted" >&2; exit 1'
    monkeypatch.setattr(launch, "_proc", ["--proc"])
    starts = pretend(tmp_path, monkeypatch, f'case "$*" in *--proc*) {refused};; esac; exec {REAL} "$@"')
    with Containment("full")(b"def f(n):\n    return n\n", "f.py") as box:
        assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1
        assert box.isolation == "full"
    assert count(starts) == 2


@pytest.mark.skipif(sys.platform != "linux" or os.geteuid() != 0, reason="only root changes its user")
def test_a_machine_without_proc_is_told_in_one_line(monkeypatch, tmp_path):
    monkeypatch.setattr(launch, "_PROCESS", tmp_path)
    with pytest.raises(JudgeError, match=r"nothing can be judged where there is no /proc; mount it"):
        open_box(b"", "my.py")
