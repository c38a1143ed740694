"""Send a signal by another call."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
information = (ctypes.c_int * 32)(10, 0, -1)
result = libc.syscall(129 if os.uname().machine == "x86_64" else 138, target["victim_pid"], 0, information)
print("BREACH" if result == 0 else "held", os.strerror(ctypes.get_errno()))
