class Counter:
    def same(self, n):
        return n


counter = Counter()


def bench():
    c = counter
    sum = 0
    for i in range(1000000):
        sum += c.same(i)
    return sum
