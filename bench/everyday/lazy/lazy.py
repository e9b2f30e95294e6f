def unless(condition, action):
    if condition():
        return None
    else:
        return action()


def bench():
    made = 0

    def add(n):
        nonlocal made
        made += n

    for i in range(1000):
        unless(lambda: i % 4 == 0, lambda: add(i))
    return made
