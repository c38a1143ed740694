"""program

Reads the number of texts, then a line each; an empty text is a JSON string.
"""

import sys


def balanced(s):
    before = None
    while s != before:
        before, s = s, s.replace("()", "").replace("[]", "").replace("{}", "")
    return not s


for line in sys.stdin.read().split()[1:]:
    print("true" if balanced(line.strip('"')) else "false")
