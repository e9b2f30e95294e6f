def bench():
    text = ""
    for i in range(400):
        text += "word" + str(i % 37) + ","
    words = text.split(",")
    lines = []
    for word in words:
        if len(word) == 6 and word[4] == "2":
            lines.append(word.upper() + "!")
        elif len(word) > 0:
            lines.append(word.replace("word", "W"))
    joined = " ".join(lines)
    vowels = 0
    for c in joined:
        if c == "O":
            vowels += 1
    return len(joined) * 1000 + vowels
