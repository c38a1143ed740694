"""A small assembler for seccomp's classic BPF: programs as rows, rules as blocks that fall through.

A filter sees struct seccomp_data: the call's number at 0, the architecture at 4, argument i as two 32-bit
words at 16 + 8i (low, then high: both machines here are little-endian). Every block starts and ends with
the call's number in the accumulator, or returns.
"""

from __future__ import annotations

import struct

TYPE_CHECKING = False  # collections take longer to import than all of this
if TYPE_CHECKING:
    from collections.abc import Sequence

Instruction = tuple[int, int, int, int]  # code, jump if true, jump if false, constant

_LOAD, _EQUAL, _GREATER, _AT_LEAST, _ANY_BIT, _RETURN = 0x20, 0x15, 0x25, 0x35, 0x45, 0x06
_AND = 0x54  # of the accumulator and a constant
_NUMBER, _ARCHITECTURE, _ARGUMENTS = 0, 4, 16

KILL = 0x80000000
ALLOW = 0x7FFF0000
_ERRNO = 0x00050000

ROW = struct.Struct("=HBBI")


def errno_action(code: int) -> int:
    """The action that makes a call fail with this errno."""
    return _ERRNO | code


def check_architecture(word: int, x32_bit: int | None, refuse: int) -> list[Instruction]:
    """Kill a process of another architecture; refuse numbers of a second table; leave the number loaded."""
    rows = [(_LOAD, 0, 0, _ARCHITECTURE), (_EQUAL, 1, 0, word), (_RETURN, 0, 0, KILL), (_LOAD, 0, 0, _NUMBER)]
    if x32_bit is not None:
        rows += [(_AT_LEAST, 0, 1, x32_bit), (_RETURN, 0, 0, refuse)]
    return rows


def load_number() -> list[Instruction]:
    """Load the call's number."""
    return [(_LOAD, 0, 0, _NUMBER)]


def decide(number: int, action: int) -> list[Instruction]:
    """This call ends with this action."""
    return [(_EQUAL, 0, 1, number), (_RETURN, 0, 0, action)]


def decide_range(first: int, last: int, action: int) -> list[Instruction]:
    """The calls numbered first to last end with this action."""
    if first == last:
        return decide(first, action)
    return [(_AT_LEAST, 0, 2, first), (_GREATER, 1, 0, last), (_RETURN, 0, 0, action)]


def one_of(number: int, argument: int, values: Sequence[int], refuse: int) -> list[Instruction]:
    """Allow this call if the low word of its argument is one of `values` (an int there), else refuse."""
    tests: list[Instruction] = [
        (_EQUAL, len(values) - place, 0, value & 0xFFFFFFFF) for place, value in enumerate(values)
    ]
    return _guarded(number, argument, 0, [*tests, (_RETURN, 0, 0, refuse), (_RETURN, 0, 0, ALLOW)])


def null_pointer(number: int, argument: int, refuse: int) -> list[Instruction]:
    """Allow this call if its argument, all 64 bits of it, is zero, else refuse."""
    rest: list[Instruction] = [
        (_EQUAL, 0, 2, 0),
        (_LOAD, 0, 0, _ARGUMENTS + 8 * argument + 4),
        (_EQUAL, 1, 0, 0),
        (_RETURN, 0, 0, refuse),
        (_RETURN, 0, 0, ALLOW),
    ]
    return _guarded(number, argument, 0, rest)


def with_bits(number: int, argument: int, bits: int, refuse: int) -> list[Instruction]:
    """Allow this call if the low word of its argument has any of `bits`, else refuse."""
    rest: list[Instruction] = [(_ANY_BIT, 1, 0, bits), (_RETURN, 0, 0, refuse), (_RETURN, 0, 0, ALLOW)]
    return _guarded(number, argument, 0, rest)


def without_bits(number: int, argument: int, bits: int, refuse: int) -> list[Instruction]:
    """Allow this call if the low word of its argument has none of `bits`, else refuse."""
    rest: list[Instruction] = [(_ANY_BIT, 0, 1, bits), (_RETURN, 0, 0, refuse), (_RETURN, 0, 0, ALLOW)]
    return _guarded(number, argument, 0, rest)


def without_both(number: int, argument: int, bits: int, refuse: int) -> list[Instruction]:
    """Allow this call unless the low word of its argument has all of `bits`, else refuse."""
    rest: list[Instruction] = [
        (_AND, 0, 0, bits),
        (_EQUAL, 0, 1, bits),
        (_RETURN, 0, 0, refuse),
        (_RETURN, 0, 0, ALLOW),
    ]
    return _guarded(number, argument, 0, rest)


def otherwise(action: int) -> list[Instruction]:
    """Every call that came this far ends with this action."""
    return [(_RETURN, 0, 0, action)]


def assemble(rows: Sequence[Instruction]) -> bytearray:
    """The program in the kernel's form."""
    return bytearray(b"".join(ROW.pack(*row) for row in rows))


def _guarded(number: int, argument: int, word: int, rest: Sequence[Instruction]) -> list[Instruction]:
    load = (_LOAD, 0, 0, _ARGUMENTS + 8 * argument + 4 * word)
    return [(_EQUAL, 0, 1 + len(rest), number), load, *rest]
