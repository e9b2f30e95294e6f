# A participant of Cyclone DDS, with the commands of ros.py.
import os
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration


@dataclass
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
qos = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.History.KeepLast(5000))
kept = []


def say(*words):
    print(*words, flush=True)


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


for line in sys.stdin:
    words = line.split()
    globals()[words[0]](*words[1:])
