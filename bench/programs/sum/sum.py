def bench():
    sum = 0
    for i in range(1000000):
        sum += i
    return sum
