#!/usr/bin/python3
"""A node of rospy for tests: it talks, echoes and serves. Says "ready" when all is there."""
import sys
import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String, UInt32
from std_srvs.srv import SetBool, SetBoolResponse, Trigger, TriggerResponse

rospy.init_node('peer', disable_signals=True)
chatter = rospy.Publisher('/chatter', String, queue_size=10)
# Latched, so that who subscribes knows from the first message when it is in the list of those who are sent the next.
echo = rospy.Publisher('/echo_out', String, queue_size=100, latch=True)
echo.publish(String('ready'))
sizes = rospy.Publisher('/image_size', UInt32, queue_size=100, latch=True)
sizes.publish(UInt32(0))
latched = rospy.Publisher('/latched', String, queue_size=1, latch=True)
latched.publish(String('kept'))
rospy.Subscriber('/echo_in', String, echo.publish)
numbers = rospy.Publisher('/image_number', UInt32, queue_size=100, latch=True)
numbers.publish(UInt32(0))
rospy.Subscriber('/image_in', Image, lambda image: numbers.publish(UInt32(image.header.seq)))
rospy.Subscriber('/image_in', Image, lambda image: sizes.publish(UInt32(sum(image.data) + len(image.data))))
rospy.Service('/set_bool', SetBool, lambda r: SetBoolResponse(r.data, 'got %s' % r.data))


def failing(request):
    raise rospy.ServiceException('no luck')


rospy.Service('/failing', Trigger, failing)
print('ready', flush=True)
rate = rospy.Rate(50)
count = 0
while not rospy.is_shutdown():
    chatter.publish(String('hello %d' % count))
    count += 1
    rate.sleep()
