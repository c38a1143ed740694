"""What a filter says of a system call: an interpreter of the few instructions that the filters use."""

from __future__ import annotations

import struct

from judge.sandbox.linux import bpf, syscalls


def decision(rows: list[bpf.Instruction], machine: str, call: int | str, *arguments: int) -> int:
    """The action of a filter for a call, by name or number, with these arguments."""
    number = syscalls.number(call, machine) if isinstance(call, str) else call
    assert number is not None
    words = [argument & (1 << 64) - 1 for argument in (*arguments, 0, 0, 0, 0, 0, 0)][:6]
    data = struct.pack("<IIQ6Q", number, syscalls.audit_architecture(machine), 0, *words)
    place = accumulator = 0
    while True:
        code, yes, no, constant = rows[place]
        place += 1
        if code == 0x20:
            accumulator = int.from_bytes(data[constant : constant + 4], "little")
        elif code == 0x54:
            accumulator &= constant
        elif code == 0x06:
            return constant
        else:
            tests = {
                0x15: accumulator == constant,
                0x25: accumulator > constant,
                0x35: accumulator >= constant,
            }
            place += yes if tests.get(code, bool(accumulator & constant)) else no
