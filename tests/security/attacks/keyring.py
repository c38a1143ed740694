"""Put a key on a keyring."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
result = libc.syscall(
    248 if os.uname().machine == "x86_64" else 217, b"user", b"judge", b"x", ctypes.c_size_t(1), -2
)
print("BREACH" if result >= 0 else "held", result, os.strerror(ctypes.get_errno()))
