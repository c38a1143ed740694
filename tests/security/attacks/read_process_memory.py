"""Read another process's memory."""

import ctypes
import json
import os
import sys

target = json.load(sys.stdin)
libc = ctypes.CDLL(None, use_errno=True)
buffer = ctypes.create_string_buffer(8)
local = (ctypes.c_size_t * 2)(ctypes.addressof(buffer), 8)
remote = (ctypes.c_size_t * 2)(int(target["victim_address"]), 8)
result = libc.process_vm_readv(target["victim_pid"], local, 1, remote, 1, ctypes.c_ulong(0))
print("BREACH" if result > 0 else "held", os.strerror(ctypes.get_errno()))
