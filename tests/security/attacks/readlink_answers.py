"""Read where a symbolic link points."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", os.readlink(target["link"]))
except OSError as error:
    print("held", error)
