"""Reads an MCAP file with the libraries of its inventors, and tells what is in it: read.py FILE [whole | live].

With "whole" it wants the summary; without, it reads as far as it goes. With "live" the file has what look-ros.cjs has
written.
"""
import json
import sys
from base64 import b64decode
from collections import Counter

from mcap.exceptions import EndOfFile
from mcap.reader import make_reader
from mcap.records import Channel, Message, Schema
from mcap.stream_reader import StreamReader
from mcap_ros2.decoder import DecoderFactory
from mcap_ros2.reader import read_ros2_messages


def by_summary(stream):
    reader = make_reader(stream, validate_crcs=True)
    statistics = reader.get_summary().statistics
    print("summary", statistics.message_count, statistics.channel_count, statistics.schema_count)
    yield from reader.iter_messages()


def as_far_as_it_goes(stream):
    schemas, channels = {}, {}
    try:
        for record in StreamReader(stream, validate_crcs=True).records:
            if isinstance(record, Schema):
                schemas[record.id] = record
            elif isinstance(record, Channel):
                channels[record.id] = record
            elif isinstance(record, Message):
                channel = channels[record.channel_id]
                yield schemas[channel.schema_id], channel, record
    except EndOfFile:
        print("ends early")


def plain(value):
    """What a library has made of a message of ROS 2, as JSON has it; of bytes the beginning."""
    if isinstance(value, (bytes, memoryview)):
        return bytes(value[:3]).hex()
    if hasattr(value, "__slots__"):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    return [plain(each) for each in value] if isinstance(value, (list, tuple)) else value


def text(schema, data):
    if schema.encoding != "ros2msg":
        return data.decode()
    message = DecoderFactory().decoder_for("cdr", schema)(data)
    return json.dumps(plain(message), separators=(",", ":"), ensure_ascii=False)


if sys.argv[2:] == ["live"]:
    with open(sys.argv[1]) as lines:
        for topic, name, definition, data in map(str.split, lines):
            schema = Schema(1, b64decode(definition), "ros2msg", b64decode(name).decode())
            print(topic, schema.name, text(schema, b64decode(data)))
    sys.exit()

whole = sys.argv[2:] == ["whole"]
with open(sys.argv[1], "rb") as file:
    messages = by_summary(file) if whole else as_far_as_it_goes(file)
    count, last, topics = Counter(), {}, set()
    for schema, channel, message in messages:
        key = (channel.topic, schema.name)
        count[key] += 1
        last[key] = (schema, message.data)
        if channel.message_encoding == "cdr":
            topics.add(channel.topic)
        if count[key] == 1:
            print("channel", channel.topic, channel.message_encoding, schema.name, schema.encoding)
    for key, number in count.items():
        print("messages", key[0], number, text(*last[key])[:200])
if whole:
    only = sorted(topic for topic, _ in count if [t for t, _ in count].count(topic) == 1 and topic in topics)
    print("of ROS", sum(1 for _ in read_ros2_messages(sys.argv[1], topics=only)))
