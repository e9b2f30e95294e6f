def make_counter(step):
    count = 0

    def counter():
        nonlocal count
        count += step
        return count

    return counter


def compose(f, g):
    def composed(x):
        return f(g(x))

    return composed


def bench():
    counters = []
    for i in range(20):
        counters.append(make_counter(i))
    sum = 0
    for i in range(100):
        for counter in counters:
            sum += counter()
    add_one = lambda x: x + 1
    twice = lambda x: x * 2
    both = compose(add_one, compose(twice, add_one))
    for i in range(2000):
        sum = (sum + both(i)) % 65521
    return sum
