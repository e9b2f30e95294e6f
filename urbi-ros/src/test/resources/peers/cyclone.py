# A participant of Cyclone DDS, with the commands of ros.py.
import os
import sys
import time
from dataclasses import dataclass

import guard  # noqa: F401
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, int32, sequence, uint32
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration
from talk import say


@dataclass
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32
    nanosec: uint32


@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64
    y: float64
    z: float64


@dataclass
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64
    y: float64
    z: float64
    w: float64


@dataclass
class Transform(IdlStruct, typename="geometry_msgs::msg::dds_::Transform_"):
    translation: Vector3
    rotation: Quaternion


@dataclass
class TransformStamped(IdlStruct, typename="geometry_msgs::msg::dds_::TransformStamped_"):
    header: Header
    child_frame_id: str
    transform: Transform


@dataclass
class TFMessage(IdlStruct, typename="tf2_msgs::msg::dds_::TFMessage_"):
    transforms: sequence[TransformStamped]


participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
qos = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.History.KeepLast(5000))
kept = []


def publish(topic, count, size, rate):
    writer = DataWriter(participant, Topic(participant, "rt/" + topic, String), qos=qos)
    kept.append(writer)
    while not writer.get_matched_subscriptions():
        time.sleep(0.005)
    say("matched")
    text = "x" * int(size)
    due = time.time()
    for i in range(int(count)):
        writer.write(String(data="%d:%s" % (i, text)))
        due += 1 / float(rate)
        time.sleep(max(0, due - time.time()))
    say("published")


def subscribe(topic, count):
    reader = DataReader(participant, Topic(participant, "rt/" + topic, String), qos=qos)
    kept.append(reader)
    got = []
    say("subscribed")
    while len(got) < int(count):
        got += [int(sample.data.split(":")[0]) for sample in reader.take(N=100)]
        time.sleep(0.001)
    say("got", len(got), "in order" if got == list(range(int(count))) else "in disorder")


def transform(parent, frame, seconds, x, z):
    return TransformStamped(Header(Time(seconds, 0), parent), frame,
                            Transform(Vector3(x, 0.0, z), Quaternion(0.0, 0.0, 0.0, 1.0)))


# The base goes from 1 to 2 in a second; the laser is fixed on it.
def transforms():
    latched = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.Durability.TransientLocal,
                  Policy.History.KeepLast(1))
    fixed = DataWriter(participant, Topic(participant, "rt/tf_static", TFMessage), qos=latched)
    fixed.write(TFMessage([transform("base", "laser", 0, 0.0, 0.25)]))
    moving = DataWriter(participant, Topic(participant, "rt/tf", TFMessage), qos=qos)
    kept.extend([fixed, moving])
    while not moving.get_matched_subscriptions():
        time.sleep(0.005)
    moving.write(TFMessage([transform("odom", "base", 10, 1.0, 0.0)]))
    moving.write(TFMessage([transform("odom", "base", 11, 2.0, 0.0)]))
    say("told")


for line in sys.stdin:
    words = line.split()
    globals()[words[0]](*words[1:])
