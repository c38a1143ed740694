"""A submission that does something bad in one of its calls, and can write its own replies."""

from __future__ import annotations

import textwrap

_SOURCE = """
import os, signal, sys, threading, time
class Mute(Exception):
    def __str__(self):
        raise self
def replies():
    frame = sys._getframe()
    while 'memory' not in frame.f_locals:
        frame = frame.f_back
    return frame.f_locals
def forge(data, at=None):
    found = replies()
    at = found['at'] if at is None else at
    found['memory'][at : at + len(data)] = data
    found['words'][0] = max(found['words'][0], at + len(data))
    return at
def stop():
    os.kill(os.getpid(), signal.SIGSTOP)
def spin(seconds):
    end = time.thread_time() + seconds
    while time.thread_time() < end:
        pass
def f(x, *more):
    if x == {at}:
{deed}
    return x
"""


def source(deed: str, at: int) -> bytes:
    """The module whose function `f` returns its argument, and does the deed where that is `at`."""
    return _SOURCE.format(deed=textwrap.indent(deed, " " * 8), at=at).encode()
