class Shape:
    def __init__(self, size):
        self.size = size

    def area(self):
        return 0

    def weight(self):
        return self.area() * 2 + 1


class Square(Shape):
    def area(self):
        return self.size * self.size


class Circle(Shape):
    def area(self):
        return self.size * self.size * 3


class Triangle(Shape):
    def area(self):
        return self.size * self.size / 2


class Line(Shape):
    def weight(self):
        return self.size


class Cube(Square):
    def area(self):
        return 6 * self.size * self.size


shapes = []
for i in range(20):
    shapes += [Square(i), Circle(i), Triangle(i), Line(i), Cube(i), Shape(i)]


def bench():
    sum = 0
    for i in range(20):
        for shape in shapes:
            sum += shape.weight()
    return sum
