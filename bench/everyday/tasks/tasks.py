class Packet:
    def __init__(self, kind, datum):
        self.kind = kind
        self.datum = datum
        self.next = None


class Task:
    def __init__(self, system, priority):
        self.system = system
        self.priority = priority
        self.first = None
        self.last = None
        self.runs = 0

    def put(self, packet):
        packet.next = None
        if self.first is None:
            self.first = packet
        else:
            self.last.next = packet
        self.last = packet

    def take(self):
        packet = self.first
        self.first = packet.next
        return packet

    def is_ready(self):
        return self.first is not None


class Source(Task):
    def __init__(self, system, priority, left):
        Task.__init__(self, system, priority)
        self.left = left

    def is_ready(self):
        return self.left > 0

    def run(self):
        self.left -= 1
        kind = "disc" if self.left % 3 == 0 else "line"
        self.system.send("worker", Packet(kind, self.left))


class Worker(Task):
    def run(self):
        packet = self.take()
        packet.datum = (packet.datum * 7 + 13) % 1009
        self.system.send(packet.kind, packet)


class Device(Task):
    def __init__(self, system, priority):
        Task.__init__(self, system, priority)
        self.sum = 0

    def run(self):
        packet = self.take()
        self.sum = (self.sum + packet.datum) % 65521


class System:
    def __init__(self, packets):
        self.names = ["disc", "line", "worker", "source"]
        self.tasks = [Device(self, 4), Device(self, 3), Worker(self, 2), Source(self, 1, packets)]

    def send(self, name, packet):
        for i in range(len(self.names)):
            if self.names[i] == name:
                self.tasks[i].put(packet)
                return
        raise ValueError("no such task: " + name)

    def next(self):
        best = None
        for task in self.tasks:
            if task.is_ready() and (best is None or task.priority > best.priority):
                best = task
        return best

    def schedule(self):
        task = self.next()
        while task is not None:
            task.runs += 1
            task.run()
            task = self.next()


def bench():
    system = System(500)
    system.schedule()
    sum = 0
    for task in system.tasks:
        sum = sum * 7 + task.runs
    return sum + system.tasks[0].sum + system.tasks[1].sum
