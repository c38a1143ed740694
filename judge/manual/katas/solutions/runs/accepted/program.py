"""program

A line for each text, which is a JSON string where it does not stand for itself.
"""

import json
import sys
from itertools import groupby

for line in sys.stdin.read().split("\n")[1:-1]:
    s = json.loads(line) if line.startswith('"') else line
    found = [(len(list(run)), letter) for letter, run in groupby(s)]
    print(json.dumps("".join((str(length) if length > 1 else "") + letter for length, letter in found)))
