"""Make a process by the raw call."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)

NUMBER, SIGNAL = (56, 17) if os.uname().machine == "x86_64" else (220, 17)
child = libc.syscall(NUMBER, ctypes.c_ulong(SIGNAL), None, None, None, ctypes.c_ulong(0))
if child == 0:
    os._exit(0)
if child > 0:
    os.waitpid(child, 0)
print("BREACH" if child > 0 else "held", os.strerror(ctypes.get_errno()))
