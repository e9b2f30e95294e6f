class Board:
    def __init__(self, n):
        self.n = n
        self.rows = [True] * n
        self.up = [True] * (2 * n)
        self.down = [True] * (2 * n)
        self.found = 0

    def place(self, column):
        if column == self.n:
            self.found += 1
        else:
            for row in range(self.n):
                if self.rows[row] and self.up[column + row] and self.down[column - row + self.n]:
                    self.set(row, column, False)
                    self.place(column + 1)
                    self.set(row, column, True)

    def set(self, row, column, free):
        self.rows[row] = free
        self.up[column + row] = free
        self.down[column - row + self.n] = free


def bench():
    board = Board(7)
    board.place(0)
    return board.found
