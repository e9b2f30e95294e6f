position = 0
speed = 1
goal = 100
turns = 0


def move():
    global position, speed, turns
    position += speed
    if position >= goal or position <= 0:
        speed = 0 - speed
        turns += 1


def bench():
    global position, speed, turns
    position = 0
    speed = 1
    turns = 0
    for i in range(3000):
        move()
    return turns * 1000 + position
