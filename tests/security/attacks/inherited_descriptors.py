"""Look for descriptors that somebody left open."""

import fcntl
import json
import sys

target = json.load(sys.stdin)

found = []
for number in range(3, 1024):
    try:
        fcntl.fcntl(number, fcntl.F_GETFD)
    except OSError:
        continue
    found.append(number)
print("BREACH" if found else "held", found)
