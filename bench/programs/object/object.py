class Point:
    def __init__(self, n):
        self.x = n


def bench():
    last = None
    for i in range(100000):
        last = Point(i)
    return last.x
