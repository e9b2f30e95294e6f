class Holder:
    pass


holder = Holder()


def bench():
    o = holder
    o.x = 0
    for i in range(1000000):
        o.x = o.x + 1
    return o.x
