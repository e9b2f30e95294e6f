class Disc:
    def __init__(self, size):
        self.size = size
        self.next = None


class Towers:
    def __init__(self):
        self.piles = [None, None, None]
        self.moves = 0

    def push(self, disc, pile):
        top = self.piles[pile]
        if top is not None and disc.size >= top.size:
            raise ValueError("a disc on a smaller one")
        disc.next = top
        self.piles[pile] = disc

    def pop(self, pile):
        top = self.piles[pile]
        self.piles[pile] = top.next
        top.next = None
        return top

    def move(self, n, start, to):
        if n == 1:
            self.push(self.pop(start), to)
            self.moves += 1
        else:
            other = 3 - start - to
            self.move(n - 1, start, other)
            self.move(1, start, to)
            self.move(n - 1, other, to)


def bench():
    towers = Towers()
    for size in range(12, 0, -1):
        towers.push(Disc(size), 0)
    towers.move(12, 0, 2)
    return towers.moves
