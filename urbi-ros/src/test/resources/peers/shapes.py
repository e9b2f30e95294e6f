# A node of ROS 2 that is told types of test_msgs, one a line. It publishes three messages of each on /there/TYPE, and says
# whether the same come back on /back/TYPE.
import os
import random
import sys

import guard  # noqa: F401
import rclpy
import test_msgs.msg
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.serialization import deserialize_message, serialize_message
from talk import say

sys.path.append(os.path.join(os.path.dirname(__file__), "../../oracles"))
from ros2 import message  # noqa: E402

rclpy.init()
node = rclpy.create_node("shapes")
qos = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
dice = random.Random(2)


def publish(name):
    kind = getattr(test_msgs.msg, name)
    # As they are once they have been on the way: some numbers are rounded.
    sent = [deserialize_message(serialize_message(m), kind) for m in (kind(), message(dice, kind), message(dice, kind))]
    back = []

    def hear(m):
        back.append(m)
        if len(back) == len(sent):
            say(name, "same" if back == sent else "sent %s, back came %s" % (sent, back))

    node.create_subscription(kind, "/back/" + name, hear, qos)
    publisher = node.create_publisher(kind, "/there/" + name, qos)
    for m in sent:
        publisher.publish(m)


for name in sys.stdin.readline().split():
    publish(name)
while rclpy.ok():
    rclpy.spin_once(node)
