# Imported by peers: ends them with the test that has started them, which may have been killed.
import os
import threading
import time


def watch(parent):
    while os.getppid() == parent:
        time.sleep(1)
    os._exit(1)


threading.Thread(target=watch, args=(os.getppid(),), daemon=True).start()
