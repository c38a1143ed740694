"""Read a system file."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(open("/etc/passwd").read()))
except OSError as error:
    print("held", error)
