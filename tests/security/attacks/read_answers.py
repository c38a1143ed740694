"""Read the file of expected answers."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", open(target["secret"]).read())
except OSError as error:
    print("held", error)
