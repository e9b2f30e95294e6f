def by_number(n):
    match n:
        case 0:
            return 3
        case 1:
            return 1
        case 2:
            return 4
        case 3:
            return 1
        case 4:
            return 5
        case 5:
            return 9
        case _:
            return 2


def by_name(name):
    match name:
        case "north":
            return 1
        case "east":
            return 2
        case "south":
            return 3
        case "west":
            return 4
        case _:
            return 0


def area(shape):
    match shape:
        case ["square", side]:
            return side * side
        case ["rectangle", a, b]:
            return a * b
        case ["triangle", a, b]:
            return a * b / 2
        case _:
            return 0


def bench():
    names = ["north", "up", "south", "west", "east"]
    shapes = [["square", 3], ["triangle", 4, 6], ["rectangle", 2, 5], ["point"]]
    sum = 0
    for i in range(1000):
        sum += by_number(i % 8)
        sum += by_name(names[i % 5])
        sum += area(shapes[i % 4])
    return sum
