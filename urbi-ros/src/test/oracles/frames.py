#!/usr/bin/python3
"""Writes what tf2 itself says of where frames are (Debian: python3-tf2-ros). Usage: frames.py FOLDER

put PARENT FRAME NANOSECONDS FIXED X Y Z QX QY QZ QW
look TARGET SOURCE NANOSECONDS and then the same seven numbers, or `nothing'
"""
import math, random, sys
import rospy, tf2_py
from geometry_msgs.msg import TransformStamped

TREE = [('map', 'odom', 0), ('odom', 'base', 0), ('base', 'laser', 1), ('base', 'arm', 0), ('arm', 'hand', 0),
        ('map', 'dock', 1), ('island', 'tree', 1)]
FRAMES = ['map', 'odom', 'base', 'laser', 'arm', 'hand', 'dock', 'tree']


def numbers(t):
    m, r = t.translation, t.rotation
    return ' '.join(repr(v) for v in (m.x, m.y, m.z, r.x, r.y, r.z, r.w))


def main(folder):
    dice = random.Random(1)
    buffer = tf2_py.BufferCore(rospy.Duration(10))
    with open(folder + '/frames.txt', 'w') as out:
        for parent, frame, fixed in TREE:
            for tick in range(1 if fixed else 6):
                t = TransformStamped()
                t.header.frame_id, t.child_frame_id = parent, frame
                t.header.stamp = rospy.Time(100 + tick, dice.randrange(10**9))
                q = [dice.gauss(0, 1) for _ in range(4)]
                length = math.sqrt(sum(v * v for v in q))
                m, r = t.transform.translation, t.transform.rotation
                m.x, m.y, m.z = (dice.uniform(-5, 5) for _ in range(3))
                r.x, r.y, r.z, r.w = (v / length for v in q)
                (buffer.set_transform_static if fixed else buffer.set_transform)(t, 'oracle')
                out.write('put %s %s %d %d %s\n' % (parent, frame, t.header.stamp.to_nsec(), fixed, numbers(t.transform)))
        for _ in range(150):
            target, source = dice.choice(FRAMES), dice.choice(FRAMES)
            when = rospy.Time(0) if dice.random() < 0.2 else rospy.Time(dice.randrange(99, 107), dice.randrange(10**9))
            try:
                told = numbers(buffer.lookup_transform_core(target, source, when).transform)
            except tf2_py.TransformException:
                told = 'nothing'
            out.write('look %s %s %d %s\n' % (target, source, when.to_nsec(), told))


main(sys.argv[1])
