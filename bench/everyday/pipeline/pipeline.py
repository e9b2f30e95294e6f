from functools import cmp_to_key, reduce

numbers = []
seed = 42
for i in range(1000):
    seed = (seed * 1309 + 13849) % 65536
    numbers.append(seed)


def bench():
    halves = list(map(lambda x: (x - x % 2) // 2, numbers))
    some = list(filter(lambda x: x % 3 != 0, halves))
    in_order = sorted(some)
    down = sorted(some, key=cmp_to_key(lambda a, b: b - a))
    total = reduce(lambda acc, x: acc + x, some, 0)
    first = 0
    for i in range(10):
        first += in_order[i] * (i + 1) + down[i]
    return first + total + len(some)
