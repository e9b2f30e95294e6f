import asyncio

loop = asyncio.new_event_loop()
done = 0


async def job():
    global done
    done += 1


async def jobs():
    await asyncio.gather(*(job() for i in range(10000)))


def bench():
    global done
    done = 0
    loop.run_until_complete(jobs())
    return done
