#!/usr/bin/python3
"""What the other half of either.u is in ROS 1: a talker, an echo, a topic that is kept, a service."""
import os
import genmsg, genmsg.gentools, genmsg.msg_loader, genpy.dynamic
import rospy
from std_msgs.msg import String

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                    '../resources/org/urbi/ros/share/test_msgs/srv/BasicTypes.srv')
with open(FILE, encoding='utf-8') as found:
    TEXT = found.read()


def half(index):
    name = 'test_msgs/BasicTypes' + ('Request', 'Response')[index]
    return genpy.dynamic.generate_dynamic(name, TEXT.split('---\n')[index])[name]


class BasicTypes:
    _type = 'test_msgs/BasicTypes'
    _md5sum = genmsg.gentools.compute_md5(
        *(lambda context: (context, genmsg.msg_loader.load_srv_from_string(context, TEXT, 'test_msgs/BasicTypes')))(
            genmsg.msg_loader.MsgContext.create_default()))
    _request_class = half(0)
    _response_class = half(1)


def increment(request):
    return BasicTypes._response_class(int32_value=request.int32_value + 1,
                                      string_value=request.string_value + '!')


rospy.init_node('peer', disable_signals=True)
chatter = rospy.Publisher('/chatter', String, queue_size=10)
echo = rospy.Publisher('/echo_out', String, queue_size=100)
kept = rospy.Publisher('/kept', String, queue_size=1, latch=True)
kept.publish(String('kept'))
rospy.Subscriber('/echo_in', String, echo.publish)
rospy.Service('/increment', BasicTypes, increment)
print('ready', flush=True)
rate = rospy.Rate(50)
while not rospy.is_shutdown():
    chatter.publish(String('hello'))
    rate.sleep()
