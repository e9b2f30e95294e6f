"""A process with UObjects that speaks as those do that are linked with the C++ SDK of Urbi 2.7.

Written from a description of what goes over the wire, with nothing but the standard library, to
see a server from the other side. Functions of objects are Python functions.
"""

import re
import socket
import struct
import threading

HOST = "127.0.0.1"
PATIENCE = 120  # seconds: what takes longer hangs


class Binary:
    def __init__(self, keywords, data):
        self.keywords = keywords
        self.data = data

    def __eq__(self, other):
        return isinstance(other, Binary) and vars(self) == vars(other)

    def __repr__(self):
        return f"Binary({self.keywords!r}, {self.data[:40]!r} of {len(self.data)})"


class Name(str):
    """The name of an object, which stands for it."""


class Other(str):
    """What a client does not know: it is read to the end of its line."""


class Text(str):
    """*** text"""


class Error(str):
    """!!! text"""


class Closed(Exception):
    pass


class Lines:
    """Reads what a server sends: messages with a tag and a value."""

    HEADER = re.compile(rb"\[(\d{8,})(?::([A-Za-z0-9_.]{1,63}))?\] ")
    NUMBER = re.compile(rb"-?(inf|nan|[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?)")

    def __init__(self, sock):
        self.sock = sock
        self.buffer = b""

    def more(self):
        try:
            received = self.sock.recv(1 << 20)
        except OSError as e:
            raise Closed from e
        if not received:
            raise Closed
        self.buffer += received

    def need(self, count):
        while len(self.buffer) < count:
            self.more()

    def take(self, count):
        self.need(count)
        taken, self.buffer = self.buffer[:count], self.buffer[count:]
        return taken

    def until(self, end):
        searched = 0
        while True:
            found = self.buffer.find(end, searched)
            if found >= 0:
                return self.take(found + len(end))[: -len(end)]
            searched = max(0, len(self.buffer) - len(end))
            self.more()

    def message(self):
        while True:
            self.need(1)
            if self.buffer[:1] != b"\n":
                break
            self.take(1)
        header = self.until(b"] ") + b"] "
        match = Lines.HEADER.fullmatch(header)
        assert match, f"no header: {header!r}"
        tag = (match.group(2) or b"").decode()
        self.need(1)
        if self.buffer[:1] in (b"*", b"!"):
            kind = Text if self.buffer[:1] == b"*" else Error
            line = self.until(b"\n").decode("utf-8", "replace")
            return tag, kind(line[4:])
        value = self.value()
        rest = self.until(b"\n")
        if rest or isinstance(value, Other):
            value = Other(repr(value) + rest.decode("latin-1"))
        return tag, value

    def blanks(self):
        self.need(1)
        while self.buffer[:1] == b" ":
            self.take(1)
            self.need(1)

    def value(self):
        self.blanks()
        first = self.buffer[:1]
        if first == b'"':
            return self.string()
        if first == b"[":
            return self.list()
        word = b""
        while True:
            self.need(1)
            if not re.match(rb"[-+.A-Za-z0-9]", self.buffer[:1]):
                break
            word += self.take(1)
        if word == b"BIN":
            head = self.until(b"\n").decode().strip().split(" ", 1)
            return Binary(head[1] if len(head) > 1 else "", self.take(int(head[0])))
        if word in (b"true", b"false"):
            return 1.0 if word == b"true" else 0.0
        if word in (b"nil", b"void"):
            return None
        if Lines.NUMBER.fullmatch(word):
            return float(word)
        return Other(word.decode())

    def string(self):
        self.take(1)
        result = b""
        while True:
            each = self.take(1)
            if each == b'"':
                break
            if each == b"\\":
                each = self.take(1)
                if each == b"x":
                    each = bytes([int(self.take(2), 16)])
                else:
                    each = {b"n": b"\n", b"t": b"\t", b"r": b"\r"}.get(each, each)
            else:
                assert each[0] < 0x7F and each[0] >= 0x20, f"not escaped: {each!r}"
            result += each
        return result.decode("utf-8", "surrogateescape")

    def list(self):
        self.take(1)
        elements, entries = [], None
        while True:
            self.blanks()
            if self.buffer[:1] == b"]":
                self.take(1)
                return elements if entries is None else entries
            if self.buffer[:1] == b",":
                self.take(1)
                continue
            if self.buffer[:1] == b"=":
                self.take(2)
                entries = {}
                continue
            element = self.value()
            self.blanks()
            if self.buffer[:1] == b"=":
                self.take(2)
                entries = {} if entries is None else entries
                entries[element] = self.value()
            else:
                elements.append(element)


def as_text(value):
    """A value as urbiscript, in bytes."""
    if value is None:
        return b"nil"
    if isinstance(value, Name):
        return value.encode()
    if isinstance(value, str):
        escaped = b""
        for each in value.encode("utf-8", "surrogateescape"):
            if 0x20 <= each < 0x7F and each not in b'"\\':
                escaped += bytes([each])
            else:
                escaped += b"\\x%02x" % each
        return b'"' + escaped + b'"'
    if isinstance(value, Binary):
        return b'Global.Binary.new("%s", "\\B(%d)(%s)")' % (
            value.keywords.encode(),
            len(value.data),
            value.data,
        )
    if isinstance(value, dict):
        inside = b",".join(as_text(k) + b"=>" + as_text(v) for k, v in value.items())
        return b"[" + (inside or b"=>") + b"]"
    if isinstance(value, (list, tuple)):
        return b"[" + b", ".join(as_text(each) for each in value) + b"]"
    value = float(value)
    return (b"%d" % value) if value == int(value) else repr(value).encode()


def short(text):
    data = text if isinstance(text, bytes) else text.encode("utf-8", "surrogateescape")
    return struct.pack(">H", len(data) & 0xFFFF) + data


def as_bytes(value):
    """A value in binary mode."""
    if value is None:
        return b"\x07"
    if isinstance(value, Name):
        return b"\x06" + short(value)
    if isinstance(value, str):
        return b"\x05" + short(value)
    if isinstance(value, Binary):
        return b"\x00" + short(value.keywords) + struct.pack(">I", len(value.data)) + value.data
    if isinstance(value, dict):
        inside = b"".join(short(k) + as_bytes(v) for k, v in value.items())
        return b"\x01" + struct.pack(">I", len(value)) + inside
    if isinstance(value, (list, tuple)):
        return b"\x03" + struct.pack(">I", len(value)) + b"".join(as_bytes(v) for v in value)
    return b"\x02" + struct.pack("<d", float(value))


class Connection:
    def __init__(self, port):
        """Connects to a port; or takes a connection that there is."""
        there = isinstance(port, socket.socket)
        self.sock = port if there else socket.create_connection((HOST, port), PATIENCE)
        self.sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.lines = Lines(self.sock)

    def raw(self, data):
        self.sock.sendall(data if isinstance(data, bytes) else data.encode())

    def close(self):
        self.sock.close()

    def framed(self, code):
        """A block as the library sends it, with the place where it is written."""
        code = code if isinstance(code, bytes) else code.encode()
        return b'//#push 1 "client.cc"\n' + code + b"\n//#pop\n"

    def await_tag(self, tag, others=None):
        while True:
            got, value = self.lines.message()
            if got == tag:
                return value
            if others is not None:
                others.append((got, value))

    def greet(self):
        """What every client begins with; the version of the server."""
        self.raw(
            self.framed(
                """{ var __ver__ = 2; {var __ver__ = 1};
                if (__ver__ == 1) { __gostai_private____version << system.version; }
                else { var __gostai_private____version =
                         Channel.new("__gostai_private____version");
                       __gostai_private____version << System.version; } };"""
            )
        )
        self.raw(
            self.framed(
                "if (isdef(Channel))\n"
                "  var lobby.__gostai_private__internal_pong ="
                ' Channel.new("__gostai_private__internal_pong")|;'
            )
        )
        version = self.await_tag("__gostai_private____version")
        self.raw(
            self.framed('Channel.new("__gostai_private____ident") << connectionTag.name;')
        )
        self.name = self.await_tag("__gostai_private____ident")
        return version


class Console(Connection):
    """A plain client."""

    def __init__(self, port):
        super().__init__(port)
        self.version = self.greet()
        self.number = 0
        self.heard = []

    def start(self, expression):
        self.number += 1
        tag = f"URBI_{self.number}"
        self.raw(
            self.framed(
                f'try {{ Channel.new("{tag}") << {{{expression}}} }}\n'
                f'catch (var e)\n{{ lobby.send("!!! " + e, "{tag}"); }},'
            )
        )
        return tag

    def get(self, expression):
        """The value of an expression, or an Error."""
        return self.await_tag(self.start(expression), self.heard)

    def do(self, code):
        """Has a statement executed that has no value."""
        got = self.get(f"{{ {code} }}|true")
        assert got == 1.0, got

    def until(self, expression):
        """Waits until it is true."""
        self.do(f"waituntil ({expression})")


class Process(Connection):
    """A process with UObjects. Messages are handled by a thread of its own."""

    def __init__(self, port, classes, text_mode=False, pid=1):
        super().__init__(port)
        self.hook = f"hookPoint_{HOST.replace('.', '_')}_{pid}"
        self.binary = False
        self.text_mode = text_mode
        self.classes = {each.__name__: each for each in classes}
        self.objects = {}
        self.values = {}
        self.errors = []
        self.ended = threading.Event()
        self.exit = None
        self.lock = threading.RLock()
        assert self.greet() == "2.7.5"
        self.prepare()
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def prepare(self):
        self.raw(
            self.framed(
                'try { Channel.new("URBI_1") << {[System.timeReference.year,'
                " System.timeReference.month, System.timeReference.day,"
                " System.timeReference.us,"
                ' PackageInfo.components["Urbi SDK"].major,'
                ' PackageInfo.components["Urbi SDK"].minor,'
                ' PackageInfo.components["Urbi SDK"].subMinor,'
                ' PackageInfo.components["Urbi SDK"].patch,]} }\n'
                'catch (var e)\n{ lobby.send("!!! " + e, "URBI_1"); },'
            )
        )
        reference = self.await_tag("URBI_1", self.errors)
        assert len(reference) == 8 and all(isinstance(n, float) for n in reference), reference
        assert reference[4:] == [2, 7, 5, 0], reference
        assert 0 <= reference[3] < 86400e6, reference
        self.raw(
            'if (!Object.hasSlot("uvalueSerialize"))'
            " function Object.uvalueSerialize() { this };\n"
            'if (!UObject.hasSlot("syncGet"))'
            " function UObject.syncGet(exp, tag)"
            ' { try { Channel.new(tag) << eval(exp) } catch (var e) { lobby.send("!!! " + e, tag) } };\n'
        )
        self.declare(self.hook, self.hook, None)
        self.raw(f"var hookPoint = {self.hook}|;\n")
        for name, each in self.classes.items():
            self.construct(name, each)
        if not self.text_mode:
            self.raw('binaryMode(1, "remotecontext_setmode");\n')
            assert self.await_tag("remotecontext_setmode", self.errors) == 1.0
            self.raw(b"\x02\x04\x08\x08")
            self.binary = True
            self.code(";\n")

    # -------------------------------------------------------------- to the server

    def code(self, text):
        data = text if isinstance(text, bytes) else text.encode()
        if not self.binary:
            self.raw(data)
            return
        for start in range(0, len(data), 8192):
            self.raw(b"\x0b" + short(data[start : start + 8192]))

    def declare(self, name, hook, functions):
        self.code(
            f"class {name}{{}}|external object {name}|external function (0) {name}.update from"
            f" {name}|if (!isdef({name}.load)) var {name}.load|external var {name}.load from {hook}|"
        )
        self.write(f"{name}.load", 1)
        if functions is None:
            self.code("\n;\n")

    def construct(self, name, each):
        """Makes an object, and tells of all that it binds."""
        with self.lock:
            self.declare(name, self.hook, True)
            self.objects[name] = made = each(self, name)
            self.code("\n;\n")
        return made

    def write(self, name, value):
        """A variable is set."""
        owner, slot = name.rsplit(".", 1)
        with self.lock:
            # What is sent last is what is had then, whichever thread comes first.
            self.values[name] = value
            if self.binary:
                self.raw(b"\x01" + short(name) + as_bytes(value) + struct.pack(">II", 5, 7))
            else:
                self.raw(
                    f'{owner}.getSlot("{slot}").update_timed('.encode()
                    + as_text(value)
                    + b", 30246574549)|"
                )

    def emit(self, name, *payload):
        with self.lock:
            if self.binary:
                self.raw(
                    b"\x02"
                    + short(name)
                    + struct.pack(">I", len(payload))
                    + b"".join(as_bytes(each) for each in payload)
                )
            else:
                self.raw(
                    f"{name}!(".encode() + b",".join(as_text(e) for e in payload) + b");\n"
                )

    def reply(self, call, value, error=None):
        with self.lock:
            if error is not None:
                text = f"Exception while calling remote bound method: {error}"
                self.code(f'Global.UObject.funCall("{call}", Exception.new("{text}")),')
            elif self.binary:
                self.raw(b"\x0a" + short(call) + as_bytes(value))
            elif value is None:
                self.raw(f'Global.UObject.funCall("{call}");\n')
            else:
                self.raw(
                    f'Global.UObject.funCall("{call}", '.encode() + as_text(value) + b"),\n"
                )
            self.code(";\n")

    def sync_get(self, expression, tag):
        self.code(f'UObject.syncGet("{expression}","{tag}"),')

    # -------------------------------------------------------------- from the server

    def run(self):
        try:
            while not self.ended.is_set():
                tag, value = self.lines.message()
                if tag == "__ExternalMessage__":
                    self.take(value)
                else:
                    self.errors.append((tag, value))
        except Closed:
            self.exit = 0
        finally:
            self.ended.set()
            self.sock.close()

    def take(self, message):
        code, name = int(message[0]), message[1]
        if code == 0:
            self.call(name, message[2], message[3:])
        elif code == 1:
            assert len(message) == 4, message
            self.values[name] = message[2]
            owner, slot = name.rsplit(".", 1)
            for each in list(self.objects.values()):
                each.changed(name, message[2])
        elif code in (2, 3):
            owner, event = name.rsplit(".", 1)
            if owner in self.objects:
                self.objects[owner].happened(code, event, message[2:])
        elif code == 4:
            if message[2] in self.objects:
                self.construct(name, type(self.objects[message[2]]))
        elif code == 5:
            self.delete(name)
        else:
            raise AssertionError(f"unknown server message type: {message}")

    def call(self, name, call, arguments):
        owner, function = name.rsplit(".", 1)
        function, arity = function.rsplit("__", 1)
        assert int(arity) == len(arguments)
        bound = self.objects[owner].functions[function]
        assert bound[0] == int(arity), name

        def answer():
            try:
                self.reply(call, bound[1](*arguments))
            except Silence:
                pass
            except Exception as e:
                self.reply(call, None, str(e))

        if bound[2]:
            threading.Thread(target=answer, daemon=True).start()
        else:
            answer()

    def delete(self, name):
        gone = self.objects.pop(name, None)
        if gone is not None:
            for slot, count in gone.uses.items():
                self.code(f'UObject.unnotify("{name}", "{slot}",{count})|')
            self.code(";\n")
        if not self.objects:
            self.ended.set()
            self.sock.shutdown(socket.SHUT_RDWR)

    def kill(self):
        """The process dies, and says nothing."""
        self.ended.set()
        try:
            self.sock.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            self.sock.shutdown(socket.SHUT_RDWR)
        except OSError:
            # The thread that reads has seen that it is over, and closed it.
            pass
        self.sock.close()


class Silence(Exception):
    """A function that never answers."""


class RemoteObject:
    """An object of such a process; the constructor of a class binds what it has."""

    def __init__(self, process, name):
        self.process = process
        self.name = name
        self.functions = {"update": (0, lambda: 0, False)}
        self.uses = {"load": 2}
        self.seen = []
        self.events = []

    def bind_function(self, function, name, arity, threaded=False):
        self.functions[name] = (arity, function, threaded)
        self.process.code(f"external function ({arity}) {self.name}.{name} from {self.name}|")

    def bind_variable(self, slot, value=None):
        full = f"{self.name}.{slot}"
        self.process.code(
            f"if (!isdef({full})) var {full}|external var {full} from {self.name}|"
        )
        self.uses[slot] = self.uses.get(slot, 0) + 1
        if value is not None:
            self.write(slot, value)

    def bind_event(self, slot):
        full = f"{self.name}.{slot}"
        self.process.code(f"try{{var {full} = Event.new()}} catch(var e) {{}}|")

    def listen(self, slot, arity):
        self.process.code(f"external event ({arity}) {self.name}.{slot} from {self.name}|")

    def input_port(self, slot):
        self.bind_variable(slot)
        self.process.code(f'{self.name}.getSlot("{slot}").setSlot("inputPort", true)|')

    def write(self, slot, value):
        self.process.write(f"{self.name}.{slot}", value)

    def read(self, slot):
        return self.process.values.get(f"{self.name}.{slot}")

    def changed(self, name, value):
        self.seen.append((name, value))

    def happened(self, code, event, payload):
        self.events.append((code, event, payload))
