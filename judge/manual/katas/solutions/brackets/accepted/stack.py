"""stack

What is open lies on a stack, and a closing bracket takes the last one.
"""


def balanced(s):
    opened = []
    for sign in s:
        if sign in "([{":
            opened.append(sign)
        elif not opened or opened.pop() + sign not in ("()", "[]", "{}"):
            return False
    return not opened
