class Counter:
    def same(self, n):
        return n


counter = Counter()


def bench():
    c = counter
    last = 0
    for i in range(1000000):
        last = c.same(i)
    return last
