text = []
seed = 42
for i in range(2000):
    seed = (seed * 1309 + 13849) % 65536
    text.append("k" + str(seed % 500))


def bench():
    counts = {}
    for word in text:
        if word in counts:
            counts[word] += 1
        else:
            counts[word] = 1
    by_length = {}
    for word in counts.keys():
        length = len(word)
        if length not in by_length:
            by_length[length] = 0
        by_length[length] += counts[word]
    sum = 0
    for length in by_length.keys():
        sum += length * by_length[length]
    return sum * 1000 + len(counts)
