"""Import the judge."""

import json
import sys

target = json.load(sys.stdin)
sys.path.append(target["judge_parent"])
try:
    import judge

    print("BREACH", judge.__file__)
except (ImportError, OSError) as error:
    print("held", error)
