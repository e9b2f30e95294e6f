class State:
    def __init__(self):
        self.count = 0
        self.sum = 0


def permute(list, n, state):
    if n == 0:
        state.count += 1
        state.sum = (state.sum * 31 + list[0] * 7 + list[6]) % 65521
    else:
        permute(list, n - 1, state)
        for i in range(n - 1, -1, -1):
            exchange(list, n - 1, i)
            permute(list, n - 1, state)
            exchange(list, n - 1, i)


def exchange(list, i, j):
    old = list[i]
    list[i] = list[j]
    list[j] = old


def bench():
    list = [1, 2, 3, 4, 5, 6, 7]
    state = State()
    permute(list, 6, state)
    return state.sum + state.count
