import asyncio

loop = asyncio.new_event_loop()
sleepers = []


def bench():
    return 0


async def spawn_all():
    for i in range(100000):
        sleepers.append(asyncio.ensure_future(asyncio.sleep(3600)))
    await asyncio.sleep(0)


def spawn():
    loop.run_until_complete(spawn_all())
    return len(sleepers)
