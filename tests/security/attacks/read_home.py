"""Read a file of the user's home."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(open(target["home_file"]).read()))
except OSError as error:
    print("held", error)
