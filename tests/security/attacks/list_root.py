"""List a system folder that no interpreter needs."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(os.listdir("/etc")) if len(os.listdir("/etc")) > 3 else 1 // 0)
except (OSError, ZeroDivisionError) as error:
    print("held", error)
