def bench():
    texts = ["12.5", "7", "-3.25", "1e3", "0.125"]
    sum = 0
    size = 0
    for i in range(200):
        x = float(texts[i % 5])
        assert isinstance(x, float)
        sum += x
        size += len("%.2f" % x)
        size += len(str(i * 7))
    return sum * 8 + size
