"""Change a file's extended attributes."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.setxattr(target["victim"], "user.judge", b"x")
    print("BREACH")
except OSError as error:
    print("held", error)
