def quick_sort(list):
    if len(list) <= 1:
        return list
    pivot = list[0]
    less = []
    more = []
    for e in list[1:]:
        if e < pivot:
            less.append(e)
        else:
            more.append(e)
    return quick_sort(less) + [pivot] + quick_sort(more)


numbers = []
seed = 42
for i in range(400):
    seed = (seed * 1309 + 13849) % 65536
    numbers.append(seed)


def bench():
    sum = 0
    for e in quick_sort(numbers):
        sum = (sum * 31 + e) % 65521
    return sum
