"""Make a System V message queue."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
made = libc.msgget(0, 0o1600)
print("BREACH" if made >= 0 else "held", os.strerror(ctypes.get_errno()))
if made >= 0:
    libc.msgctl(made, 0, None)
