"""Reads an MCAP file with the library of its inventors, and tells what is in it: read.py FILE [whole].

With "whole" it wants the summary; without, it reads as far as it goes.
"""
import sys
from collections import Counter

from mcap.exceptions import EndOfFile
from mcap.reader import make_reader
from mcap.records import Channel, Message, Schema
from mcap.stream_reader import StreamReader


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


with open(sys.argv[1], "rb") as file:
    messages = by_summary(file) if sys.argv[2:] == ["whole"] else as_far_as_it_goes(file)
    count, last = Counter(), {}
    for schema, channel, message in messages:
        count[channel.topic] += 1
        last[channel.topic] = message.data
        if count[channel.topic] == 1:
            print("channel", channel.topic, channel.message_encoding, schema.name, schema.encoding)
    for topic, number in count.items():
        print("messages", topic, number, last[topic][:60].decode())
