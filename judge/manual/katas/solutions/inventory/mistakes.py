"""Each move in its order, and five mistakes beside the lines that they spoil."""


def in_order(stock, moves):
    "right"
    left = dict(stock)
    for thing, count in moves:
        known = left.get(thing, 0)
        # ? new-things-ignored: known = left.get(thing, -100)
        # : A thing that is not in stock at first is never added. Begin with 0 for it.
        total = known + count
        # ? replaced: total = count
        # : The count of a move replaces what was there. Add it.
        # ? takes-what-there-is: total = max(0, known + count)
        # : A move that takes too many takes all there are. Leave it out.
        # @ takes more than there are
        if total < 0:
            continue
            # ? stops-there: break
            # : A move that takes too many ends the loop. Go on with the next one.
        left[thing] = total
    return {thing: total for thing, total in left.items() if total > 0}
    # ? none-left-stays: return left
    # : A thing of which none are left stays with 0. Leave it out.
    # @ none are left
