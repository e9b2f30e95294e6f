def bench():
    text = ""
    for i in range(10000):
        text += "x"
    return len(text)
