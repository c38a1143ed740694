"""Make a file in memory."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
result = libc.memfd_create(b"x", 0)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
