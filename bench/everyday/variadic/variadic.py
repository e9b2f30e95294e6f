def sum_of(*args):
    sum = 0
    for e in args:
        sum += e
    return sum


def bench():
    sum = 0
    for i in range(500):
        sum += sum_of(i, 1)
        sum += sum_of(i, 2, 3, 4)
        sum += sum_of()
    return sum
