"""Give up the signal that ends it with the judge."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
result = libc.prctl(1, 0, 0, 0, 0)
print("BREACH" if result == 0 else "held", os.strerror(ctypes.get_errno()))
