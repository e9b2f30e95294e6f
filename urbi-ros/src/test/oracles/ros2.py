"""Writes what ROS 2 itself says of types: their hashes, and messages as bytes.

Needs rclpy and the packages of messages, with their descriptions in SHARE. Usage: ros2.py SHARE FOLDER
"""
import array, glob, importlib, json, os, random, re, sys
import numpy
from rclpy.serialization import serialize_message, deserialize_message

PACKAGES = ['std_msgs', 'geometry_msgs', 'sensor_msgs', 'nav_msgs', 'std_srvs', 'rosgraph_msgs',
            'builtin_interfaces', 'rcl_interfaces', 'action_msgs', 'unique_identifier_msgs',
            'service_msgs', 'rmw_dds_common', 'test_msgs']


def literal(value):
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, (int, numpy.integer)):
        return str(int(value))
    if isinstance(value, (float, numpy.floating)):
        return repr(float(value))
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, str):
        return '"' + value.replace('\\', '\\\\').replace('"', '\\"') + '"'
    if hasattr(value, 'get_fields_and_field_types'):
        names = list(value.get_fields_and_field_types())
        if names == ['structure_needs_at_least_one_member'] or not names:
            return '[=>]'
        return '[' + ', '.join('"%s" => %s' % (s, literal(getattr(value, s))) for s in names) + ']'
    return '[' + ', '.join(literal(each) for each in value) + ']'


RANGES = {'int8': (-128, 127), 'uint8': (0, 255), 'char': (0, 255), 'int16': (-2**15, 2**15 - 1),
          'uint16': (0, 2**16 - 1), 'int32': (-2**31, 2**31 - 1), 'uint32': (0, 2**32 - 1),
          'int64': (-2**53, 2**53), 'uint64': (0, 2**53)}


def some(dice, kind):
    sequence = re.fullmatch(r'sequence<(.*?)(?:, (\d+))?>', kind)
    fixed = re.fullmatch(r'(.*)\[(\d+)]', kind)
    if sequence or fixed:
        base = (sequence or fixed).group(1)
        size = int(fixed.group(2)) if fixed else dice.randint(0, min(3, int(sequence.group(2) or 3)))
        return [some(dice, base) for _ in range(size)]
    if kind in RANGES:
        return dice.randint(*RANGES[kind])
    if kind == 'octet':
        return bytes([dice.randrange(256)])
    if kind == 'boolean':
        return bool(dice.getrandbits(1))
    if kind in ('float', 'double'):
        return dice.randint(-2**20, 2**20) / 64.0
    if kind.startswith(('string', 'wstring')):
        return ''.join(dice.choice('abc "\\äß漢') for _ in range(dice.randrange(9)))
    pack, name = kind.split('/')
    return message(dice, getattr(importlib.import_module(pack + '.msg'), name))


def message(dice, cls):
    m = cls()
    for name, kind in m.get_fields_and_field_types().items():
        if name != 'structure_needs_at_least_one_member':
            setattr(m, name, some(dice, kind))
    return m


def main(share, folder):
    dice = random.Random(1)
    with open(folder + '/rihs.txt', 'w', encoding='utf-8') as out, \
            open(folder + '/ros2.txt', 'w', encoding='utf-8') as vectors:
        for pack in PACKAGES:
            for kind in ('msg', 'srv', 'action'):
                for file in sorted(glob.glob('%s/%s/%s/*.json' % (share, pack, kind))):
                    if not os.path.exists(file[:-5] + '.' + kind):
                        continue
                    hashes = json.load(open(file, encoding='utf-8'))['type_hashes']
                    if isinstance(hashes, dict):
                        hashes = [hashes]
                    own = '%s/%s/%s' % (pack, kind, os.path.basename(file)[:-5])
                    for each in hashes:
                        if each['type_name'].startswith(own):
                            out.write('%s %s\n' % (each['type_name'], each['hash_string']))
                    if kind == 'msg':
                        cls = getattr(importlib.import_module(pack + '.msg'), own.split('/')[2])
                        for m in (cls(), message(dice, cls)):
                            data = serialize_message(m)
                            m = deserialize_message(data, cls)
                            vectors.write('%s\t%s\t%s\n' % (own, data.hex(), literal(m)))


if __name__ == '__main__':
    main(sys.argv[1], sys.argv[2])
