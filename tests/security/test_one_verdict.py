"""A right program is right at every level: what it may use of the machine is the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.sandbox import Containment, Limits, Stop
from judge.sandbox.available import levels_here

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)
DEEDS = {  # an expression, and what it comes to
    "threading.Lock().acquire()": True,
    "[*concurrent.futures.ThreadPoolExecutor(4).map(abs, [-1, 2])]": [1, 2],
    "asyncio.run(asyncio.sleep(0, 7))": 7,
    "len(tempfile.SpooledTemporaryFile().read())": 0,
    "zoneinfo.ZoneInfo('Europe/Berlin').utcoffset(datetime.datetime(2026, 7, 1)).seconds": 7200,
    "sqlite3.connect(':memory:').execute('select 6 * 7').fetchone()[0]": 42,
    "len(secrets.token_bytes(4)) + len(os.urandom(4))": 8,
    "str(decimal.Decimal(1) / 4)": {"word": "0.25"},
    "len(mmap.mmap(-1, 10))": 10,
    "inspect.getsource(answer).count('def answer(place)')": 2,  # and here
    "sys.stdin.read()": {"word": ""},
    "open('/dev/null').read()": {"word": ""},
    "locale.getlocale() is not None and time.tzname[0]": {"word": "UTC"},
    "os.environ['ONLINE_JUDGE']": {"word": "1"},
    "subprocess.PIPE": -1,  # no process is started
}
SOURCE = """
import asyncio, concurrent.futures, datetime, decimal, inspect, locale, mmap, os, secrets, sqlite3, subprocess
import sys, tempfile, threading, time, zoneinfo

def answer(place):
    return [DEEDS][place]()
"""


@pytest.mark.parametrize("level", ["full", "strong", "limits"])
def test_a_right_program_is_right_at_every_level(level):
    if level not in {each.name for each in levels_here() if each.available}:
        pytest.skip(f"no {level} here")
    if not Path("/usr/share/zoneinfo").is_dir():
        pytest.skip("no time zones here")
    source = SOURCE.replace("DEEDS", ", ".join(f"lambda: {deed}" for deed in DEEDS))
    with Containment(level)(source.encode(), "right.py") as box:
        replies = box.call("answer", [(place,) for place in range(len(DEEDS))], LIMITS).replies
    came = dict(zip(DEEDS, ((reply.stop, reply.answer or reply.detail) for reply in replies), strict=True))
    assert came == {deed: (Stop.ANSWERED, wanted or "") for deed, wanted in DEEDS.items()}
