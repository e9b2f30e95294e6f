# A node of ROS 2 that has parameters, and uses those of others. Commands come by lines, answers go by lines.
#   get NODE NAME…, types NODE NAME…, list NODE PREFIX…, describe NODE NAME, set NODE NAME VALUE…, atomically NODE NAME VALUE…
#   declare NAME VALUE, value NAME, events NODE, clock SECONDS NANOSECONDS
import json
import os
import sys
import threading
import time

import guard  # noqa: F401
import rclpy
from builtin_interfaces.msg import Time
from rcl_interfaces.msg import ParameterEvent
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import qos_profile_parameter_events
from rosgraph_msgs.msg import Clock
from talk import say

rclpy.init()
node = rclpy.create_node("peer")
executor = SingleThreadedExecutor()
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
kept = []


def wait(future):
    while not future.done():
        time.sleep(0.005)
    return future.result()


def client(name):
    made = AsyncParameterClient(node, name)
    kept.append(made)
    made.wait_for_services()
    return made


def parameters(words):
    return [Parameter(name, value=json.loads(value)) for name, value in zip(words[::2], words[1::2])]


def results(all):
    say(*["ok" if each.successful else each.reason for each in all])


def get(name, *names):
    say(*[parameter_value_to_python(each) for each in wait(client(name).get_parameters(list(names))).values])


def types(name, *names):
    say(*wait(client(name).get_parameter_types(list(names))).types)


def describe(name, which):
    told = wait(client(name).describe_parameters([which])).descriptors[0]
    ranges = [(each.from_value, each.to_value, each.step) for each in list(told.floating_point_range) + list(told.integer_range)]
    say(told.name, told.type, told.description, told.read_only, *ranges)


def listed(name, *prefixes):
    result = wait(client(name).list_parameters(list(prefixes) or None)).result
    say(*result.names, *result.prefixes)


def set(name, *words):
    results(wait(client(name).set_parameters(parameters(words))).results)


def atomically(name, *words):
    results([wait(client(name).set_parameters_atomically(parameters(words))).result])


def declare(name, value):
    node.declare_parameter(name, json.loads(value))
    say("declared")


def value(name):
    say(node.get_parameter(name).value)


def events(name):
    def told(event):
        if event.node == name:
            for kind in ("new", "changed", "deleted"):
                for each in getattr(event, kind + "_parameters"):
                    say(kind, each.name, parameter_value_to_python(each.value))

    kept.append(node.create_subscription(ParameterEvent, "/parameter_events", told, qos_profile_parameter_events))
    while node.count_publishers("/parameter_events") < 2:
        time.sleep(0.005)
    say("listening")


def clock(seconds, nanoseconds):
    publisher = node.create_publisher(Clock, "/clock", 1)
    message = Clock(clock=Time(sec=int(seconds), nanosec=int(nanoseconds)))
    kept.append(node.create_timer(0.02, lambda: publisher.publish(message)))
    say("ticking")


for line in sys.stdin:
    words = line.split()
    globals()[words[0]](*words[1:])
os._exit(0)
