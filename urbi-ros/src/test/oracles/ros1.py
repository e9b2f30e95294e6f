#!/usr/bin/python3
"""Writes what ROS 1 itself says of types: their MD5 sums, and messages as bytes.

Needs Debian's python3-rosmsg and the packages of messages. Usage: ros1.py FOLDER
"""
import glob, importlib, io, os, random, sys
import genmsg, genmsg.gentools, genmsg.msg_loader, genpy

SHARE = '/usr/share'
PACKAGES = ['std_msgs', 'geometry_msgs', 'sensor_msgs', 'nav_msgs', 'std_srvs', 'rosgraph_msgs',
            'tf2_msgs', 'actionlib_msgs', 'roscpp']


def literal(value):
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return '"' + value.replace('\\', '\\\\').replace('"', '\\"') + '"'
    if isinstance(value, (genpy.Time, genpy.Duration)):
        return '["sec" => %d, "nanosec" => %d]' % (value.secs, value.nsecs)
    if isinstance(value, genpy.Message):
        slots = value.__slots__
        if not slots:
            return '[=>]'
        return '[' + ', '.join('"%s" => %s' % (s, literal(getattr(value, s))) for s in slots) + ']'
    return '[' + ', '.join(literal(each) for each in value) + ']'


RANGES = {'int8': (-128, 127), 'byte': (-128, 127), 'uint8': (0, 255), 'char': (0, 255),
          'int16': (-2**15, 2**15 - 1), 'uint16': (0, 2**16 - 1), 'int32': (-2**31, 2**31 - 1),
          'uint32': (0, 2**32 - 1), 'int64': (-2**53, 2**53), 'uint64': (0, 2**53)}


def some(dice, kind):
    base, is_array, size = genmsg.msgs.parse_type(kind)
    if is_array:
        size = dice.randrange(4) if size is None else size
        values = [some(dice, base) for _ in range(size)]
        return bytes(values) if base in ('uint8', 'char') else values
    if base in RANGES:
        return dice.randint(*RANGES[base])
    if base == 'bool':
        return bool(dice.getrandbits(1))
    if base in ('float32', 'float64'):
        return dice.randint(-2**20, 2**20) / 64.0
    if base == 'string':
        return ''.join(dice.choice('abc "\\äß漢') for _ in range(dice.randrange(9)))
    if base == 'time':
        return genpy.Time(dice.randrange(2**32), dice.randrange(10**9))
    if base == 'duration':
        return genpy.Duration(dice.randint(-2**31, 2**31 - 1), dice.randrange(10**9))
    return message(dice, genpy.message.get_message_class(base))


def message(dice, cls):
    m = cls()
    for slot, kind in zip(m.__slots__, m._slot_types):
        setattr(m, slot, some(dice, kind))
    return m


def main(folder):
    path = {p: [SHARE + '/' + p + '/msg'] for p in PACKAGES}
    with open(folder + '/md5.txt', 'w', encoding='utf-8') as out:
        for pack in PACKAGES:
            for kind, load in (('msg', genmsg.msg_loader.load_msg_from_file),
                               ('srv', genmsg.msg_loader.load_srv_from_file)):
                for file in sorted(glob.glob('%s/%s/%s/*.%s' % (SHARE, pack, kind, kind))):
                    name = pack + '/' + os.path.basename(file)[:-4]
                    context = genmsg.msg_loader.MsgContext.create_default()
                    spec = load(context, file, name)
                    genmsg.msg_loader.load_depends(context, spec, path)
                    out.write('%s %s %s\n' % (kind, name, genmsg.gentools.compute_md5(context, spec)))
    dice = random.Random(1)
    with open(folder + '/ros1.txt', 'w', encoding='utf-8') as out:
        for line in open(folder + '/md5.txt', encoding='utf-8'):
            kind, name, _ = line.split()
            pack, short = name.split('/')
            if kind != 'msg':
                continue
            try:
                cls = getattr(importlib.import_module(pack + '.msg'), short)
            except (ImportError, AttributeError):
                continue
            for m in (cls(), message(dice, cls)):
                data = io.BytesIO()
                m.serialize(data)
                # As a reader gets it: floats of 32 bits are rounded.
                m = cls().deserialize(data.getvalue())
                out.write('%s\t%s\t%s\n' % (name, data.getvalue().hex(), literal(m)))


main(sys.argv[1])
