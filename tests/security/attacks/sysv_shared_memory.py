"""Make System V shared memory."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
made = libc.shmget(0, 4096, 0o1600)
print("BREACH" if made >= 0 else "held", os.strerror(ctypes.get_errno()))
if made >= 0:
    libc.shmctl(made, 0, None)
