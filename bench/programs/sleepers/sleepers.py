import asyncio

loop = asyncio.new_event_loop()
sleepers = []


def bench():
    return 0


async def go_to_bed():
    for i in range(100000):
        sleepers.append(asyncio.ensure_future(asyncio.sleep(3600)))
    await asyncio.sleep(0)


def putToBed():
    loop.run_until_complete(go_to_bed())
    return len(sleepers)
