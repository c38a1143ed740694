"""Mount something, in namespaces of its own so that nobody else would see it."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
NEW_USER, NEW_NAMESPACE, PRIVATE = 0x10000000, 0x20000, 0x44000
alone = libc.unshare(NEW_USER | NEW_NAMESPACE) == 0 or libc.unshare(NEW_NAMESPACE) == 0
separate = alone and libc.mount(b"none", b"/", None, ctypes.c_ulong(PRIVATE), None) == 0
result = libc.mount(b"none", target["folder"].encode(), b"tmpfs", ctypes.c_ulong(0), None) if separate else -1
print("BREACH" if result == 0 else "held", os.strerror(ctypes.get_errno()))
