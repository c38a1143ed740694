"""Make a user namespace."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
result = libc.unshare(0x10000000)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
