class Thing:
    pass


def bench():
    o = Thing()
    for i in range(49152):
        setattr(o, "s" + str(i), i)
    return len(o.__dict__)
