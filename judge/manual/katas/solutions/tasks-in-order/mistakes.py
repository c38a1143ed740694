"""A count of what is missing, and five mistakes beside the lines that they spoil."""


def free_first(count, needs):
    "right"
    missing = [0] * count
    for _, second in needs:
        missing[second] += 1
        # ? needs-once: missing[second] = 1
        # : A task comes as soon as one of those that it needs is there. It waits for all of them.
    order = [task for task in range(count) if not missing[task]]
    for task in order:
        for first, second in needs:
            if first == task:
                missing[second] -= 1
                if not missing[second]:
                    order.append(second)
    # ? reversed-order: order.reverse()
    # : The order is turned around. Who is needed comes first.
    return order if len(order) == count else None
    # ? part-of-it: return order
    # : Some tasks are missing where there is no order. Return None then.
    # ? empty-for-none: return order if len(order) == count else []
    # : No order is an empty list. Return None where there is none.
    # ? as-numbered: return [*range(count)] if len(order) == count else None
    # : The tasks come as they are numbered, whatever they need.
