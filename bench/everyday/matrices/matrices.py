def make_matrix(n, seed):
    rows = []
    for i in range(n):
        row = []
        for j in range(n):
            row.append((seed * i + 3 * j) % 17)
        rows.append(row)
    return rows


def multiply(a, b):
    n = len(a)
    rows = []
    for i in range(n):
        row = []
        for j in range(n):
            sum = 0
            for k in range(n):
                sum += a[i][k] * b[k][j]
            row.append(sum)
        rows.append(row)
    return rows


def bench():
    c = multiply(make_matrix(25, 5), make_matrix(25, 7))
    trace = 0
    for i in range(25):
        trace += c[i][i] * (i + 1) - c[0][i]
    return trace
