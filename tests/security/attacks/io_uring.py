"""Set up an io_uring."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
parameters = (ctypes.c_char * 120)()
result = libc.syscall(425, 1, parameters)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
