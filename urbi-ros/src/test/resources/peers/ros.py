# A node of ROS 2. Commands come by lines, answers go by lines.
#   publish TOPIC COUNT SIZE RATE, subscribe TOPIC COUNT, pair, silent NAME
import sys
import time

import guard  # noqa: F401
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String
from talk import say
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("peer")
qos = QoSProfile(depth=5000)


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


def spin_until(condition):
    while not condition():
        rclpy.spin_once(node, timeout_sec=0.05)


def graph(name, topic):
    spin_until(lambda: name in node.get_node_names() and node.get_publishers_info_by_topic(topic))
    info = node.get_publishers_info_by_topic(topic)[0]
    say(info.node_namespace, info.node_name, info.topic_type, str(info.topic_type_hash))


def serve(name):
    def answer(request, response):
        response.int32_value = request.int32_value + 1
        response.string_value = request.string_value + "!"
        return response

    kept.append(node.create_service(BasicTypes, name, answer))
    say("serving")
    spin_until(lambda: stop)


# A service that does not answer.
def silent(name):
    def hang(request, response):
        say("asked")
        time.sleep(1000)

    kept.append(node.create_service(BasicTypes, name, hang))
    say("serving")
    spin_until(lambda: stop)


# The other half of either.u. Its talker is one of those that lose messages.
def pair():
    def answer(request, response):
        response.int32_value = request.int32_value + 1
        response.string_value = request.string_value + "!"
        return response

    sensor = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    chatter = node.create_publisher(String, "chatter", sensor)
    echo = node.create_publisher(String, "echo_out", 100)
    held = node.create_publisher(String, "kept", latched)
    held.publish(String(data="kept"))
    kept.append(node.create_timer(0.02, lambda: chatter.publish(String(data="hello"))))
    kept.append(node.create_subscription(String, "echo_in", echo.publish, 100))
    kept.append(node.create_service(BasicTypes, "increment", answer))
    say("ready")
    spin_until(lambda: stop)


def call(name, number):
    client = node.create_client(BasicTypes, name)
    spin_until(client.service_is_ready)
    future = client.call_async(BasicTypes.Request(int32_value=int(number), string_value="hello"))
    spin_until(future.done)
    say(future.result().int32_value, future.result().string_value)


kept = []
stop = False
for line in sys.stdin:
    words = line.split()
    globals()[words[0]](*words[1:])
