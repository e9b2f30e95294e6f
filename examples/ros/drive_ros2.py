#!/usr/bin/env python3
"""Drives the robot of robot.u to and fro by /cmd_vel, by what it hears on /odom and /scan (ROS 2)."""
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan

heard = {}
rclpy.init()
# Nobody sets its parameters or reads its log: what is not offered costs no time.
node = Node("pilot", start_parameter_services=False, enable_rosout=False)
for topic, kind in (("/odom", Odometry), ("/scan", LaserScan)):
    node.create_subscription(
        kind, topic, lambda message, topic=topic: heard.update({topic: message}), qos_profile_sensor_data)
pilot = node.create_publisher(Twist, "/cmd_vel", 1)


def after(condition, speed=None):
    """Waits for messages, driving meanwhile."""
    while not condition():
        if speed is not None:
            command = Twist()
            command.linear.x = speed
            pilot.publish(command)
        rclpy.spin_once(node, timeout_sec=0.05)


def x():
    return heard["/odom"].pose.pose.position.x


after(lambda: len(heard) == 2)
scan = heard["/scan"]
print("a scan of %d rays, something at %.1f m" % (len(scan.ranges), min(scan.ranges)), flush=True)
began = x()
after(lambda: x() > began + 0.2, 0.3)
print("it went ahead", flush=True)
after(lambda: x() < began + 0.1, -0.3)
print("it came back", flush=True)
# What it has heard last was before.
pilot.publish(Twist())
heard.clear()
after(lambda: "/odom" in heard and heard["/odom"].twist.twist.linear.x == 0)
print("it stands", flush=True)
node.destroy_node()
rclpy.shutdown()
