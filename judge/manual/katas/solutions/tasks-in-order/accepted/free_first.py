"""free first

It counts what each task still needs; who needs nothing comes next.
"""


def tasks_in_order(count, needs):
    missing = [0] * count
    for _, second in needs:
        missing[second] += 1
    order = [task for task in range(count) if not missing[task]]
    for task in order:
        for first, second in needs:
            if first == task:
                missing[second] -= 1
                if not missing[second]:
                    order.append(second)
    return order if len(order) == count else None
