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


LOOKED_AT = ("/jobs", "/turns")


def by_summary(stream):
    reader = make_reader(stream, validate_crcs=True)
    summary = reader.get_summary()
    statistics = summary.statistics
    # How often jobs are looked at depends on the machine.
    looks = [number for number, channel in summary.channels.items() if channel.topic in LOOKED_AT]
    count = statistics.message_count - sum(statistics.channel_message_counts[number] for number in looks)
    print("summary", count, statistics.channel_count - len(looks), statistics.schema_count - len(looks))
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


def told_of_jobs(topic, content, names):
    """What a message tells of jobs: names has those of all that were seen."""
    if topic == "/jobs":
        for job in content["jobs"]:
            names[job["number"]] = job["name"]
            yield f"job {job['name']} waits for {job['waits']} under {' '.join(job['tags'])}"
    else:
        for turn in content["turns"]:
            assert turn["begin"] <= turn["end"] <= content["machine"], turn
            wakers = [names.get(number, "?") for number in turn["wakers"][:1]]
            yield f"turn of {names.get(turn['job'], '?')} after {turn['waited']} by {' '.join(wakers)}"


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
    count, last, topics, names, told = Counter(), {}, set(), {}, {}
    for schema, channel, message in messages:
        key = (channel.topic, schema.name)
        count[key] += 1
        last[key] = (schema, message.data)
        if channel.message_encoding == "cdr":
            topics.add(channel.topic)
        if channel.topic in LOOKED_AT:
            told.update(dict.fromkeys(told_of_jobs(channel.topic, json.loads(message.data), names)))
        if count[key] == 1:
            print("channel", channel.topic, channel.message_encoding, schema.name, schema.encoding)
    for line in told:
        print(line)
    for key, number in count.items():
        print("messages", key[0], number, text(*last[key])[:200])
if whole:
    only = sorted(topic for topic, _ in count if [t for t, _ in count].count(topic) == 1 and topic in topics)
    print("of ROS", sum(1 for _ in read_ros2_messages(sys.argv[1], topics=only)))
