"""Make a POSIX message queue."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
name = f"/judge-{os.getpid()}".encode()
made = libc.mq_open(name, 0o102, 0o600, None)
print("BREACH" if made >= 0 else "held", os.strerror(ctypes.get_errno()))
if made >= 0:
    libc.mq_unlink(name)
