# Has imported what the peers of ROS 2 import, which takes half a second of processor time, and forks each of them. What
# the middleware reads from the environment, and its threads, begin in the peer. Peers are asked for by lines of JSON:
#   {"port": where it connects what it reads and what it says, "script": …, "environment": {…}}
# and the answer is the process's number. It ends, and its peers with it, when nobody can ask it any more.
import json
import os
import runpy
import signal
import socket
import sys

import rclpy  # noqa: F401
import rclpy.action  # noqa: F401
import rclpy.executors  # noqa: F401
import rclpy.parameter_client  # noqa: F401
import std_msgs.msg  # noqa: F401
import test_msgs.action  # noqa: F401
import test_msgs.msg  # noqa: F401
import test_msgs.srv  # noqa: F401


def connect(port):
    connection = socket.create_connection(("127.0.0.1", port))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    for stream in (0, 1):
        os.dup2(connection.fileno(), stream)
    connection.close()
    sys.stdin = open(0, closefd=False)
    sys.stdout = open(1, "w", closefd=False)


# Nobody waits for those that have ended.
signal.signal(signal.SIGCHLD, signal.SIG_IGN)
for line in iter(sys.stdin.readline, ""):
    wanted = json.loads(line)
    process = os.fork()
    if process == 0:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        connect(wanted["port"])
        os.environ.update(wanted["environment"])
        runpy.run_path(wanted["script"], run_name="__main__")
        break
    print(process, flush=True)
