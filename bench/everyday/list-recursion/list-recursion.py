class Element:
    def __init__(self, next):
        self.next = next


def make_list(length):
    if length == 0:
        return None
    else:
        return Element(make_list(length - 1))


def is_shorter(x, y):
    a = x
    b = y
    while b is not None:
        if a is None:
            return True
        a = a.next
        b = b.next
    return False


def tail(x, y, z):
    if is_shorter(y, x):
        return tail(tail(x.next, y, z), tail(y.next, z, x), tail(z.next, x, y))
    else:
        return z


def length(list):
    if list is None:
        return 0
    else:
        return 1 + length(list.next)


def bench():
    return length(tail(make_list(12), make_list(9), make_list(5)))
