"""How long after the moment until which 100,000 tasks have slept the last of them has run."""

import asyncio

loop = asyncio.new_event_loop()
awake = 0


async def sleep_until(moment):
    global awake
    await asyncio.sleep(moment - loop.time())
    awake += 1


async def all_of_them():
    global awake
    awake = 0
    moment = loop.time() + 20
    tasks = [asyncio.ensure_future(sleep_until(moment)) for i in range(100000)]
    await asyncio.sleep(15)
    assert awake == 0 and loop.time() < moment
    await asyncio.gather(*tasks)
    return loop.time() - moment


def bench():
    return loop.run_until_complete(all_of_them())
