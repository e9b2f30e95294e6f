class Tree:
    def __init__(self, left, right):
        self.left = left
        self.right = right

    def check(self):
        if self.left is None:
            return 1
        else:
            return 1 + self.left.check() + self.right.check()


def make_tree(depth):
    if depth == 0:
        return Tree(None, None)
    else:
        return Tree(make_tree(depth - 1), make_tree(depth - 1))


def bench():
    sum = 0
    for i in range(10):
        sum += make_tree(9).check()
    return sum
