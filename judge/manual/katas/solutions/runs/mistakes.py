"""A loop that counts, and five mistakes beside the lines that they spoil."""


def counted(s):
    "right"
    parts, count = [], 0
    # ? stripped: parts, count, s = [], 0, s.strip()
    # : Blanks at the ends are removed, but a blank is a letter too. Leave out strip().
    for at, letter in enumerate(s):
        count += 1
        # ? nine-at-most: count = min(count + 1, 9)
        # : A run is counted up to 9 and no further. Its length may have two digits.
        ends = at + 1 == len(s) or s[at + 1] != letter
        # ? last-run-lost: ends = at + 1 < len(s) and s[at + 1] != letter
        # : The last run is missing, since no other letter comes after it. It ends with the text.
        if ends:
            parts.append(str(count) if count > 1 else "")
            # ? one-written@length: parts.append(str(count))
            # : A letter alone gets a 1 before it. It stays as it is.
            # ? one-digit@length: parts.append(str(count)[-1] if count > 1 else "")
            # : Only the last digit of a length is written. Write all of them.
            parts.append(letter)
            count = 0
    return "".join(parts)
