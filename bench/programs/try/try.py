def bench():
    caught = 0
    for i in range(10000):
        try:
            raise ValueError("ball")
        except ValueError as e:
            caught += 1
    return caught
