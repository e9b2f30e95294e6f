list = []
for i in range(100000):
    list.append(i)


def bench():
    sum = 0
    for e in list:
        sum += e
    return sum
