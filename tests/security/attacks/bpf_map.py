"""Make a BPF map."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
attributes = (ctypes.c_uint32 * 32)(2, 4, 4, 1)
result = libc.syscall(321 if os.uname().machine == "x86_64" else 280, 0, attributes, 128)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
