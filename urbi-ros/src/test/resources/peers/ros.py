# A node of ROS 2. Commands come by lines, answers go by lines.
#   publish TOPIC COUNT SIZE RATE, subscribe TOPIC COUNT
import sys
import time

import rclpy
from rclpy.qos import QoSProfile
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("peer")
qos = QoSProfile(depth=5000)


def say(*words):
    print(*words, flush=True)


def publish(topic, count, size, rate):
    publisher = node.create_publisher(String, topic, qos)
    while publisher.get_subscription_count() == 0:
        time.sleep(0.005)
    say("matched")
    text = "x" * int(size)
    due = time.time()
    for i in range(int(count)):
        publisher.publish(String(data="%d:%s" % (i, text)))
        due += 1 / float(rate)
        time.sleep(max(0, due - time.time()))
    say("published")


def subscribe(topic, count):
    got = []
    node.create_subscription(String, topic, lambda m: got.append(int(m.data.split(":")[0])), qos)
    say("subscribed")
    while len(got) < int(count):
        rclpy.spin_once(node, timeout_sec=0.1)
    say("got", len(got), "in order" if got == list(range(int(count))) else "in disorder")


for line in sys.stdin:
    words = line.split()
    globals()[words[0]](*words[1:])
