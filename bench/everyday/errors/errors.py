class Empty:
    pass


def bench():
    list = [1, 2, 3]
    object = Empty()
    object.there = 1
    sum = 0
    for n in range(500):
        try:
            sum += list[n % 6]
        except IndexError:
            sum += 10
        try:
            sum += object.there
            sum += object.nowhere
        except AttributeError:
            sum += 100
    return sum
