class Trouble(Exception):
    def __init__(self, code):
        self.code = code


def check(depth, n):
    if depth == 0:
        if n % 3 == 0:
            raise Trouble(n)
        return n
    else:
        return check(depth - 1, n) + 1


def bench():
    sum = 0
    tidied = 0
    for n in range(1000):
        try:
            try:
                sum += check(5, n)
            finally:
                tidied += 1
        except Trouble as e:
            sum -= e.code
    return sum + tidied
