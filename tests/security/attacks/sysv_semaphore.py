"""Make a System V semaphore."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
made = libc.semget(0, 1, 0o1600)
print("BREACH" if made >= 0 else "held", os.strerror(ctypes.get_errno()))
if made >= 0:
    libc.semctl(made, 0, 0)
