class Point:
    def __init__(self, x, y):
        self.x = x
        self.y = y

    def add(self, other):
        self.x += other.x
        self.y += other.y


class Particle:
    def __init__(self, x, y, vx, vy):
        self.place = Point(x, y)
        self.speed = Point(vx, vy)

    def step(self):
        self.place.add(self.speed)
        if self.is_outside(self.place.x):
            self.speed.x = 0 - self.speed.x
        if self.is_outside(self.place.y):
            self.speed.y = 0 - self.speed.y

    def is_outside(self, value):
        return value < 0 or value > 100


def bench():
    particles = []
    for i in range(50):
        particles.append(Particle(i, 100 - i, i % 7 - 3, i % 5 - 2))
    for i in range(40):
        for particle in particles:
            particle.step()
    sum = 0
    for particle in particles:
        sum += particle.place.x * 3 + particle.place.y
    return sum
