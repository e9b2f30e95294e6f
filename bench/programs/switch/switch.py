import asyncio

loop = asyncio.new_event_loop()
done = 0


async def job():
    global done
    i = 0
    while i < 1000:
        i += 1
        await asyncio.sleep(0)
    done += i


async def jobs():
    await asyncio.gather(*(job() for j in range(100)))


def bench():
    global done
    done = 0
    loop.run_until_complete(jobs())
    return done


def base():
    total = 0
    for j in range(100):
        i = 0
        while i < 1000:
            i += 1
        total += i
    return total
