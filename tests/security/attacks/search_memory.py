"""Look for the expected answers in every object and frame of the process."""

import gc
import json
import re
import sys

target = json.load(sys.stdin)

PATTERN = re.compile("EXPECTED" + "-[0-9a-f]{8}")
seen, waiting, found = set(), [*gc.get_objects(), sys._getframe()], []
frame = sys._getframe()
while frame:
    waiting += [frame.f_locals, frame.f_globals]
    frame = frame.f_back
while waiting and len(seen) < 400_000:
    item = waiting.pop()
    if id(item) in seen:
        continue
    seen.add(id(item))
    if isinstance(item, bytes):
        item = item.decode("latin-1")
    if isinstance(item, str):
        found += PATTERN.findall(item)
    else:
        waiting += gc.get_referents(item)
print("BREACH" if found else "held", found)
