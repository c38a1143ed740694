"""A stack, and five mistakes beside the lines that they spoil."""


def stack(s):
    "right"
    opened, pairs = [], ("()", "[]", "{}")
    # ? one-kind@kinds: opened, pairs, s = [], ("()",), "".join(sign for sign in s if sign in "()")
    # : Only round brackets are looked at. There are three kinds.
    # + counted: return all(s.count(pair[0]) == s.count(pair[1]) for pair in pairs)
    # : Brackets are counted, and their order is not looked at: )( is not balanced.
    for sign in s:
        if sign in "([{":
            opened.append(sign)
        elif not opened:
            return False
            # ? closed-first: continue
            # : A bracket that closes nothing is passed over. It makes the text unbalanced.
        elif opened.pop() + sign not in pairs:
            return False
            # ? any-kind@kinds: continue
            # : A bracket may close one of another kind. Compare the two.
    return not opened
    # ? left-open: return True
    # : What is still open at the end is passed over. Nothing may be left.
