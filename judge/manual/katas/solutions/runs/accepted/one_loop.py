"""one_loop

Each run is looked for where the one before ends.
"""


def runs(s):
    parts, start = [], 0
    while start < len(s):
        end = start
        while end < len(s) and s[end] == s[start]:
            end += 1
        if end - start > 1:
            parts.append(str(end - start))
        parts.append(s[start])
        start = end
    return "".join(parts)
