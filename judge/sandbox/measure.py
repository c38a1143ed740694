"""What a process uses, seen from outside: its own clocks and counters can be forged, the kernel's cannot."""

from __future__ import annotations

import re
import resource
import sys
import time

HAS_CLOCK = sys.platform == "linux"  # another process's CPU clock can be read
_PEAK = re.compile(rb"^VmHWM:\s*(\d+) kB", re.MULTILINE)


def cpu_seconds(pid: int) -> float | None:
    """CPU time of a live process with all its threads, or None where it has ended or no such clock exists."""
    if not HAS_CLOCK:
        return None
    try:
        # The kernel's encoding of "the CPU clock of process pid" (see clock_getcpuclockid in glibc).
        return time.clock_gettime((~pid << 3) | 2)
    except OSError:
        return None


def peak_bytes(pid: int) -> int | None:
    """Peak resident size of a live process since it was started, or None where it cannot be seen."""
    if not HAS_CLOCK:
        return None
    try:
        with open(f"/proc/{pid}/status", "rb") as status:  # noqa: PTH123
            found = _PEAK.search(status.read())
    except OSError:
        return None
    return int(found[1]) * 1024 if found else None


def maxrss_bytes(usage: resource.struct_rusage) -> int:
    """`ru_maxrss` in bytes: kilobytes on Linux, bytes on macOS."""
    return usage.ru_maxrss if sys.platform == "darwin" else usage.ru_maxrss * 1024
