#!/usr/bin/python3
"""Drives the robot of robot.u to and fro by /cmd_vel, and tells what it hears from it (ROS 1)."""
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image, LaserScan

heard = {}
rospy.init_node("pilot", disable_signals=True)
for topic, kind in (("/odom", Odometry), ("/camera/image_raw", Image), ("/scan", LaserScan), ("/clock", Clock)):
    rospy.Subscriber(topic, kind, lambda message, topic=topic: heard.update({topic: message}), queue_size=1)
pilot = rospy.Publisher("/cmd_vel", Twist, queue_size=1)


def after(condition, speed=None):
    """Waits, driving meanwhile."""
    while not condition():
        if speed is not None:
            command = Twist()
            command.linear.x = speed
            pilot.publish(command)
        rospy.rostime.wallsleep(0.05)


def x():
    return heard["/odom"].pose.pose.position.x


after(lambda: len(heard) == 4)
image, scan = heard["/camera/image_raw"], heard["/scan"]
print("an image of %d x %d, %s, %d bytes" % (image.width, image.height, image.encoding, len(image.data)), flush=True)
print("a scan of %d rays, something at %.1f m" % (len(scan.ranges), min(scan.ranges)), flush=True)
began, time = x(), heard["/clock"].clock.to_sec()
after(lambda: x() > began + 0.2, 0.3)
print("it went ahead", flush=True)
after(lambda: x() < began + 0.1, -0.3)
print("it came back", flush=True)
# Without a pilot it stops by itself.
after(lambda: heard["/odom"].twist.twist.linear.x == 0)
print("it stands", flush=True)
assert heard["/clock"].clock.to_sec() > time
