"""Open a performance counter."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
attributes = (ctypes.c_uint32 * 32)(1, 128)
attributes[10] = 0b1100000
result = libc.syscall(
    298 if os.uname().machine == "x86_64" else 241, attributes, 0, -1, -1, ctypes.c_ulong(0)
)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
