heard = 0


def handler():
    global heard
    heard += 1


ring = [handler]


def bench():
    global heard
    heard = 0
    i = 0
    while i < 10000:
        for handler in ring:
            handler()
        i += 1
    return heard
