"""What a submission can do to others of a command, beside it and after it: `siblings.py LEVEL [LAYER]`.

Writes one JSON object for each deed. The others are a submission that has ended and left what it can, and one
that is ready for its next call. With a LAYER that is left out, see `without.py`.
"""

from __future__ import annotations

import ctypes
import json
import os
import sys
import tempfile
import textwrap

import driver
from processes import below
from table import READ_MEMORY, SCRIPTS, tried
from without import leave_out

from judge.sandbox import Containment, container, parcels
from judge.sandbox.inside import wire

KEY = 0x6A_0000 + os.getpid() % 60_000
MARK = "left by the one before"
OTHER = f"SECRET = {driver.SECRET!r}\ndef f(x):\n    return x + len(SECRET)\n"
EACH = """
failed = OSError("there is nobody")
for pid in {{*target["pids"]}} - {{os.getpid(), os.getppid()}}:
    try:
{deed}
    except OSError as error:
        failed = error
    else:
        return
raise failed
"""
TO_EACH = {
    "signal": "os.kill(pid, 0)",
    "queue_a_signal": "system_call(129, 138, pid, 0, (ctypes.c_int * 32)(0, 0, -1))",
    "signal_a_thread": "system_call(234, 131, pid, pid, 0)",
    "share_a_session": "if os.getsid(pid) != os.getsid(0): raise OSError('it has another')",
    "open_the_process": "system_call(434, 434, pid, 0)",
    "bind_to_a_core": "os.sched_setaffinity(pid, os.sched_getaffinity(pid))",
    "see_limits": "resource.prlimit(pid, resource.RLIMIT_NOFILE)",
    "trace": "libc('ptrace', 0x4206, pid, None, None)",
    "read_memory": READ_MEMORY.format(pid="pid", address="id(os)"),
    "open_memory": "open(f'/proc/{pid}/mem', 'r+b').close()",
    "read_environment": "open(f'/proc/{pid}/environ', 'rb').read()",
    "read_status": "open(f'/proc/{pid}/stat', 'rb').read()",
    "list_descriptors": "os.listdir(f'/proc/{pid}/fd')",
    "read_source": "open(f'/proc/{pid}/fd/4', 'rb').read()",
    "list_root": "os.listdir(f'/proc/{pid}/root')",
}
REGION = """
frame = sys._getframe()
while "region" not in frame.f_locals:
    frame = frame.f_back
memory = frame.f_locals["region"].memory
"""
WRITES = f"""{REGION}
memory[-64:] = memory[-1 << 20 : 64 - (1 << 20)] = {MARK!r}.encode().ljust(64)
open(os.path.join(os.environ["HOME"], {MARK!r}), "w").close()
"""
SHARES = f"system_call(29, 194, {KEY}, 4096, 0o1666)"
AFTER = {  # the last two end what they find
    "find_files": "if not os.listdir(os.environ['HOME']): raise OSError('there are none')",
    "find_memory": f"{REGION}\nif memory.find({MARK!r}.encode()) < 0: raise OSError('there is none')",
    "find_shared_memory": f"system_call(31, 195, system_call(29, 194, {KEY}, 0, 0), 0, None)",
    "find_processes": EACH.format(deed="        os.kill(pid, 9)"),
}
STAYS = """
import os, time
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        print(os.getpid(), flush=True)
        time.sleep(20)
    os._exit(0)
time.sleep(0.2)
"""
LEAVES = {
    "find_files": tried(WRITES),
    "find_memory": tried(WRITES),
    "find_shared_memory": tried(SHARES),
    "find_processes": STAYS,
}
DEEDS = {
    **{name: EACH.format(deed=textwrap.indent(deed.strip("\n"), " " * 8)) for name, deed in TO_EACH.items()},
    **AFTER,
}
SOURCES = {
    **{name: tried(textwrap.dedent(deed)) for name, deed in DEEDS.items()},
    "search_memory": SCRIPTS["search_memory"],
}


def ran(boxes: Containment, source: str, target: dict[str, object]) -> str:
    with boxes(source.encode(), "deed.py") as box:
        return box.run_program(json.dumps(target).encode(), driver.PATIENT).stdout.decode(errors="replace")


def one_home() -> None:
    home = tempfile.mkdtemp()
    os.chmod(home, 0o777)  # noqa: PTH101
    container.Container._home = lambda _self: home  # type: ignore[method-assign]


def one_memory() -> None:
    descriptor, region = parcels.region()
    parcels.region = lambda: (os.dup(descriptor), wire.Region(descriptor))
    wire.mmap.MADV_REMOVE = wire.mmap.MADV_NORMAL  # nor is anything taken out of it
    assert region.memory


OF_THE_JUDGE = {"a home of its own": one_home, "a memory of its own": one_memory}


def main(level: str) -> None:
    boxes = Containment(level).kept()
    inside = range(2, 40) if level == "full" else ()  # 1 is its own seed
    os.environ["JUDGE_TEST_SECRET"] = "1"
    for name in AFTER:
        left = ran(boxes, LEAVES[name], {})
        found = ran(boxes, SOURCES[name], {"pids": [int(left)] if left.strip().isdecimal() else []})
        print(json.dumps({"name": name, "output": found}), flush=True)
    with boxes(OTHER.encode(), "other.py") as other:
        answers = other.call("f", [(1,)], driver.PATIENT).replies
        target = {"pids": [*below(os.getpid()), *inside], "folder": tempfile.gettempdir()}
        for name in [*TO_EACH, "search_memory"]:
            print(json.dumps({"name": name, "output": ran(boxes, SOURCES[name], target)}), flush=True)
        assert other.call("f", [(1,)], driver.PATIENT).replies == answers
    boxes.close()
    libc = ctypes.CDLL(None)
    libc.shmctl(libc.shmget(KEY, 0, 0), 0, None)
    assert not below(os.getpid())


if __name__ == "__main__":
    for layer in sys.argv[2:]:
        if layer in OF_THE_JUDGE:
            OF_THE_JUDGE[layer]()
        else:
            leave_out(layer)
    main(sys.argv[1])
