#!/usr/bin/python3
"""The half of bench/ros in rospy: publish TYPE SIZE SECONDS, subscribe TYPE SECONDS, serve, call COUNT."""
import os
import sys
import time

import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String
from std_srvs.srv import SetBool, SetBoolResponse

TYPES = {"std_msgs/String": String, "sensor_msgs/Image": Image}
what, words = sys.argv[1], sys.argv[2:]
rospy.init_node("bench", anonymous=True, disable_signals=True)
if what == "publish":
    kind = TYPES[words[0]]
    publisher = rospy.Publisher("/bench", kind, queue_size=None)
    while publisher.get_num_connections() == 0:
        time.sleep(0.005)
    message = kind(data="x" * int(words[1]) if kind is String else b"x" * int(words[1]))
    end = time.monotonic() + float(words[2])
    while time.monotonic() < end:
        publisher.publish(message)
elif what == "subscribe":
    count = [0]

    def heard(message):
        count[0] += 1

    rospy.Subscriber("/bench", TYPES[words[0]], heard, buff_size=1 << 24, tcp_nodelay=True)
    print("ready", flush=True)
    while count[0] == 0:
        time.sleep(0.001)
    time.sleep(1)
    before, begun = count[0], time.monotonic()
    time.sleep(float(words[1]))
    print("%.0f" % ((count[0] - before) / (time.monotonic() - begun)), flush=True)
elif what == "serve":
    rospy.Service("/flip", SetBool, lambda request: SetBoolResponse())
    print("ready", flush=True)
    rospy.spin()
else:
    rospy.wait_for_service("/flip")
    client = rospy.ServiceProxy("/flip", SetBool, persistent=True)
    for i in range(int(words[0])):
        client(True)
    begun = time.monotonic()
    for i in range(int(words[0])):
        client(True)
    print("%.1f" % ((time.monotonic() - begun) / int(words[0]) * 1e6), flush=True)
os._exit(0)
