"""Open a userfaultfd."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
result = libc.syscall(323 if os.uname().machine == "x86_64" else 282, 1)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
