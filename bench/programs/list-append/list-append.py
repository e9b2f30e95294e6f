def bench():
    list = []
    for i in range(100000):
        list.append(i)
    return len(list)
