#!/usr/bin/python3
"""The topics and services of the turtle of ROS's tutorials, without its window."""
import os
import genmsg, genmsg.gentools, genmsg.msg_loader, genpy.dynamic
import rospy
from std_srvs.srv import Empty, EmptyResponse

SHARE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'share', 'turtlesim')


def text(file):
    with open(os.path.join(SHARE, file), encoding='utf-8') as found:
        return found.read()


def message(name):
    return genpy.dynamic.generate_dynamic('turtlesim/' + name, text('msg/%s.msg' % name))['turtlesim/' + name]


def service(name):
    request, response = text('srv/%s.srv' % name).split('---\n')
    context = genmsg.msg_loader.MsgContext.create_default()
    spec = genmsg.msg_loader.load_srv_from_string(context, text('srv/%s.srv' % name), 'turtlesim/' + name)

    class Service:
        _type = 'turtlesim/' + name
        _md5sum = genmsg.gentools.compute_md5(context, spec)
        _request_class = genpy.dynamic.generate_dynamic('turtlesim/%sRequest' % name, request)['turtlesim/%sRequest' % name]
        _response_class = genpy.dynamic.generate_dynamic('turtlesim/%sResponse' % name, response)['turtlesim/%sResponse' % name]
    return Service


rospy.init_node('turtlesim', disable_signals=True)
Pose, Velocity = message('Pose'), message('Velocity')
pose = rospy.Publisher('/turtle1/pose', Pose, queue_size=100)
state = Pose()


def moved(velocity):
    state.linear_velocity = velocity.linear
    state.angular_velocity = velocity.angular
    pose.publish(state)


rospy.Subscriber('/turtle1/command_velocity', Velocity, moved)
for name in ('/clear', '/reset'):
    rospy.Service(name, Empty, lambda request: EmptyResponse())
Spawn = service('Spawn')
rospy.Service('/spawn', Spawn, lambda request: Spawn._response_class(name=request.name))
for name, kind in (('/kill', 'Kill'), ('/turtle1/set_pen', 'SetPen'),
                   ('/turtle1/teleport_absolute', 'TeleportAbsolute'),
                   ('/turtle1/teleport_relative', 'TeleportRelative')):
    made = service(kind)
    rospy.Service(name, made, lambda request, made=made: made._response_class())
print('ready', flush=True)
rospy.spin()
