#!/usr/bin/python3
"""The talker of ROS's tutorials."""
import rospy
from std_msgs.msg import String

rospy.init_node('talker', disable_signals=True)
chatter = rospy.Publisher('/chatter', String, queue_size=10)
rate = rospy.Rate(20)
count = 0
while not rospy.is_shutdown():
    chatter.publish(String('Hello there! This is message [%d]' % count))
    count += 1
    rate.sleep()
