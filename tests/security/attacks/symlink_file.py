"""Make a symbolic link."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.symlink("/etc/passwd", os.path.join(target["folder"], "made-link"))
    print("BREACH")
except OSError as error:
    print("held", error)
