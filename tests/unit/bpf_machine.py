"""What a filter says of a system call: an interpreter of the few instructions that the filters use."""

from __future__ import annotations

import os
import struct

from judge.sandbox.filters import MACHINES, ROW, filters, table
from judge.sandbox.inside.confine import own_filter


def number_of(call: str, machine: str) -> int | None:
    """A call's number on a machine."""
    return table(machine).get(call, (None,))[0]


def named() -> set[str]:
    """The calls of the table, whichever machine has them."""
    return set().union(*map(table, MACHINES))


def of_server(machine: str, profile: str = "python") -> bytes:
    """What a container's server loads."""
    return filters(machine, profile).server


def of_child(machine: str, profile: str = "python") -> bytes:
    """What a child loads besides that has the pid of this process."""
    found = filters(machine, profile)
    return bytes(own_filter(found.child, found.pid_at))


PID = os.getpid()


def decision(program: bytes, machine: str, call: int | str, *arguments: int) -> int:
    """The action of a filter, as it is sent, for a call, by name or number, with these arguments."""
    rows = list(ROW.iter_unpack(program))
    number = number_of(call, machine) if isinstance(call, str) else call
    assert number is not None
    words = [argument & (1 << 64) - 1 for argument in (*arguments, 0, 0, 0, 0, 0, 0)][:6]
    data = struct.pack("<IIQ6Q", number, MACHINES[machine], 0, *words)
    place = accumulator = 0
    while True:
        code, yes, no, constant = rows[place]
        place += 1
        if code == 0x20:
            accumulator = int.from_bytes(data[constant : constant + 4], "little")
        elif code == 0x54:
            accumulator &= constant
        elif code == 0x06:
            return int(constant)
        else:
            tests = {
                0x15: accumulator == constant,
                0x25: accumulator > constant,
                0x35: accumulator >= constant,
            }
            place += yes if tests.get(code, bool(accumulator & constant)) else no
