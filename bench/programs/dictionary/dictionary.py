keys = ["key" + str(i) for i in range(100)]


def bench():
    counts = {}
    for key in keys:
        counts[key] = 0
    for i in range(1000):
        for key in keys:
            counts[key] = counts[key] + 1
    return counts["key42"]
