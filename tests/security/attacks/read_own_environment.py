"""Look for what the judge keeps in its environment."""

import json
import os
import sys

target = json.load(sys.stdin)
print("BREACH" if "JUDGE_TEST_SECRET" in os.environ else "held")
