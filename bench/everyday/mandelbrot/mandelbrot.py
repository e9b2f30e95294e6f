def bench():
    sum = 0
    for row in range(60):
        ci = row / 30 - 1
        for column in range(60):
            cr = column / 30 - 1.5
            zr = 0
            zi = 0
            n = 0
            while n < 50 and zr * zr + zi * zi < 4:
                next = zr * zr - zi * zi + cr
                zi = 2 * zr * zi + ci
                zr = next
                n += 1
            sum += n
    return sum
