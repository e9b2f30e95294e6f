"""What a server does for processes with UObjects that speak as those of Urbi 2.7.

The environment says where the server is: URBI_PORT.
"""

import os
import socket
import threading
import time
import unittest

import sdk_client
from sdk_client import Binary, Console, Error, Name, Process, RemoteObject, Silence, as_bytes, short

PORT = int(os.environ["URBI_PORT"])


class Dev(RemoteObject):
    made = []

    def __init__(self, process, name):
        super().__init__(process, name)
        Dev.made.append(self)
        self.started = []
        self.released = threading.Event()
        self.bind_function(self.init, "init", 1)
        self.bind_function(self.add, "add", 2)
        self.bind_function(lambda x: x, "echo", 1)
        self.bind_function(lambda: None, "nothing", 0)
        self.bind_function(self.fail, "fail", 0)
        self.bind_function(self.slow, "slow", 1, threaded=True)
        self.bind_function(self.never, "never", 0, threaded=True)
        self.bind_function(self.set_a, "set_a", 1)
        self.bind_function(self.emit, "emit", 0)
        self.bind_function(lambda: Name(self.name), "self", 0)
        self.bind_variable("a", 1)
        self.bind_variable("b")
        self.input_port("inp")
        self.bind_event("e2")
        self.listen("onEv", 1)

    def init(self, value):
        if value == 3:
            return 3
        if value == 4:
            raise RuntimeError("no such device")
        self.bind_variable("late", value)
        return 0

    def add(self, a, b):
        return a + b

    def fail(self):
        raise RuntimeError("it is broken")

    def slow(self, value):
        self.started.append(value)
        assert self.released.wait(sdk_client.PATIENCE)
        return value

    def never(self):
        raise Silence

    def set_a(self, value):
        self.write("a", value)
        return self.read("a")

    def emit(self):
        self.process.emit(f"{self.name}.e2", 5, "two")


def eventually(condition):
    """Waits for what another thread does."""
    end = time.monotonic() + sdk_client.PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("never")
        time.sleep(0.01)


class Dialogues:
    """Exchanges that are the same in text mode and in binary mode."""

    text_mode = False
    pid = 1000 * os.getpid()

    def setUp(self):
        Dialogues.pid += 1
        self.console = Console(PORT)
        # A class of its own name for each test.
        self.type = type(f"Dev{Dialogues.pid}", (Dev,), {})
        self.process = Process(PORT, [self.type], self.text_mode, Dialogues.pid)
        self.console.until(f'uobjects.hasLocalSlot("{self.type.__name__}")')
        self.console.do(f"var lobby.m{Dialogues.pid} = {self.type.__name__}.new(5)|")
        self.m = f"m{Dialogues.pid}"
        self.dev = Dev.made[-1]

    def tearDown(self):
        self.dev.released.set()
        if not self.process.ended.is_set():
            self.process.kill()
        self.console.until(f'!uobjects.hasLocalSlot("{self.process.hook}")')
        self.console.close()

    def get(self, expression):
        return self.console.get(expression.replace("m.", self.m + "."))

    def do(self, code):
        self.console.do(code.replace("m.", self.m + "."))

    def assertError(self, expression, text):
        got = self.get(expression)
        self.assertIsInstance(got, Error)
        self.assertIn(text, got)

    def test_handshake_leaves_no_errors(self):
        self.assertEqual(self.process.errors, [])
        self.assertEqual(self.get(f'uobjects.hasLocalSlot("{self.process.hook}")'), 1)
        self.assertRegex(self.process.name, "^Lobby")

    def test_calls(self):
        self.assertEqual(self.get("m.add(1, 2.5)"), 3.5)
        self.assertError("m.add(1)", "expected 2 arguments, given 1")
        self.assertEqual(self.get("m.nothing.isVoid || m.nothing.isNil"), 1)
        self.assertError("m.fail", "it is broken")
        self.assertEqual(self.get("m.add(1, 1)"), 2)

    def test_every_kind_of_value_comes_back(self):
        for written, value in [
            ('"a\\n\\"b\\xc3\\xa9"', 'a\n"bé'),
            ('[1, "x", [nil, true], ["k" => 1]]', [1, "x", [None, 1], {"k": 1}]),
            ("[=>]", {}),
            ("[]", []),
            ('""', ""),
            ('Binary.new("foo bar", "abc;d")', Binary("foo bar", b"abc;d")),
            ('Binary.new("", "\\x00\\xff\\n\\"")', Binary("", b'\x00\xff\n"')),
            ("1099511627776", 2.0**40),
            ("1e300", 1e300),
            ("0.1", 0.1),
            ("-7", -7),
        ]:
            with self.subTest(written):
                self.assertEqual(self.get(f"m.echo({written})"), value)
        if not self.text_mode:
            self.assertEqual(self.get("m.echo(inf)"), float("inf"))
        self.assertEqual(self.get(f"m.echo(m.a.isA(Float))"), 1)

    def test_big_binaries(self):
        self.do('var lobby.big = Binary.new("raw", "0123456789abcdef" * 65536)|')
        got = self.get("m.echo(big)")
        self.assertEqual(got, Binary("raw", b"0123456789abcdef" * 65536))

    def test_objects_travel_by_their_names(self):
        self.assertEqual(self.get("m.echo(m.self)"), self.dev.name)
        self.assertEqual(self.get(f"m.self === {self.m}"), 1)

    def test_threaded_functions_answer_in_any_order(self):
        slow = self.console.start(f"{self.m}.slow(4)")
        eventually(lambda: self.dev.started == [4])
        self.assertEqual(self.get("m.add(1, 1)"), 2)
        self.dev.released.set()
        self.assertEqual(self.console.await_tag(slow), 4)

    def test_changes_are_told_once(self):
        self.do("m.a = 7")
        eventually(lambda: (f"{self.dev.name}.a", 7) in self.dev.seen)
        self.assertEqual([v for n, v in self.dev.seen if n.endswith(".a")], [7])
        self.do('m.a = [1, "x"]')
        eventually(lambda: self.dev.read("a") == [1, "x"])

    def test_what_the_process_writes_is_not_told_to_it(self):
        self.do('var lobby.changes = []|at (m.a->changed?(var v)) changes << v|')
        self.assertEqual(self.get("m.set_a(12)"), 12)
        self.assertEqual(self.get("m.a"), 12)
        self.assertEqual(self.get("changes"), [12])
        self.assertEqual(self.get("m.add(0, 0)"), 0)
        self.assertEqual([s for s in self.dev.seen if s[0].endswith(".a")], [])
        for value in ["text", [1, [2]], {"k": [1]}, Binary("rgb 2 1", b"abcdef")]:
            self.get("m.echo(0)")
            self.dev.write("a", value)
            self.process.code(";\n")
            self.process.sync_get(f"{self.dev.name}.a", "remotecontext_9")
            eventually(lambda: ("remotecontext_9", value) in self.process.errors)

    def test_unnotify_ends_notifications(self):
        self.do("m.b = 1")
        eventually(lambda: self.dev.read("b") == 1)
        self.process.code(f'UObject.unnotify("{self.dev.name}", "b",1)|;\n')
        self.process.code('UObject.unnotify("NoObject", "b",1)|;\n')
        self.assertEqual(self.get("m.echo(0)"), 0)
        self.do("m.b = 2")
        self.assertEqual(self.get("m.echo(0)"), 0)
        self.assertEqual(self.dev.read("b"), 1)
        self.assertEqual(self.process.errors, [])

    def test_variables_of_others(self):
        self.do(f"var Global.other{self.pid} = UObject.clone|")
        self.do(f"var other{self.pid}.v = 1|")
        self.process.code(f"external var Global.other{self.pid}.v from {self.process.hook}|;\n")
        self.process.sync_get("1", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 1.0) in self.process.errors)
        self.do(f"other{self.pid}.v = 3")
        eventually(lambda: self.process.values.get(f"Global.other{self.pid}.v") == 3)

    def test_input_ports(self):
        self.do("var lobby.src = UObject.clone|UVar.new(src, \"v\")|src.&v >> m.&inp|")
        self.do("src.v = 8")
        eventually(lambda: (f"{self.dev.name}.inp", 8) in self.dev.seen)
        self.assertNotEqual(self.get("[m.inp]"), [8])

    def test_events(self):
        self.do("var lobby.got = []|at (m.e2?(var x, var y)) got << [x, y]|")
        self.do("m.emit")
        self.console.until("!got.empty")
        self.assertEqual(self.get("got"), [[5, "two"]])
        self.do("m.onEv!(4)")
        eventually(lambda: len(self.dev.events) == 2)
        self.assertEqual(self.dev.events, [(2, "onEv__1", [4]), (3, "onEv__1", [4])])
        self.do("m.onEv!(4, 5)")
        self.assertEqual(self.get("m.echo(0)"), 0)
        self.assertEqual(len(self.dev.events), 2)

    def test_properties(self):
        name = self.dev.name
        self.process.code(f"{name}.a->rangemin = -4|{name}.a->rangemax = 4|;\n")
        self.process.code(f'{name}.a->blend = "mix"|;\n')
        self.process.sync_get(f"{name}.a->rangemin", "remotecontext_1")
        self.process.sync_get(f"{name}.a->nonsense", "remotecontext_2")
        self.process.sync_get(f"{name}.a.uvalueSerialize", "remotecontext_3")
        eventually(lambda: len(self.process.errors) >= 3)
        answers = dict(self.process.errors)
        self.assertEqual(answers["remotecontext_1"], -4)
        self.assertIsInstance(answers["remotecontext_2"], Error)
        self.assertEqual(answers["remotecontext_3"], 1)
        self.do("m.a = 100")
        eventually(lambda: self.dev.read("a") == 4)
        self.assertEqual(self.get("m.a"), 4)

    def test_init_that_fails(self):
        kind = self.type.__name__
        before = len(self.process.objects)
        self.assertError(f"{kind}.new(3)", f"{kind} construction failed: init returned 3.")
        self.assertError(f"{kind}.new(4)", "no such device")
        self.assertError(f"{kind}.new", "expected 1 argument")
        eventually(lambda: len(self.process.objects) == before)
        names = self.get("uobjects.localSlotNames")
        self.assertEqual([n for n in names if n.startswith(kind + "_")], [self.dev.name])

    def test_objects_of_objects(self):
        self.do(f"class Global.Sub{self.pid} : {self.type.__name__} {{}}|")
        self.do(f"var lobby.s = Sub{self.pid}.new(1)|var lobby.n = {self.m}.new(2)|")
        self.assertEqual(self.get("s.add(1, 2)"), 3)
        self.assertEqual(self.get("n.late"), 2)

    def test_destruction(self):
        name = self.dev.name
        self.do(f"m.destroy")
        eventually(lambda: name not in self.process.objects)
        self.assertEqual(self.get(f'uobjects.hasLocalSlot("{name}")'), 0)
        self.assertIsInstance(self.get("m.add(1, 2)"), Error)
        self.process.code(f'{name}.getSlot("a").update_timed(3, 4)|;\n')
        self.process.sync_get("2", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 2.0) in self.process.errors)
        self.do(f"{self.type.__name__}.destroy|{self.process.hook}.destroy")
        self.assertTrue(self.process.ended.wait(sdk_client.PATIENCE))

    def test_a_process_that_dies(self):
        waiting = self.console.start(f"{self.m}.never")
        self.assertEqual(self.get("m.add(1, 1)"), 2)
        self.process.kill()
        self.assertIn("gone", self.console.await_tag(waiting))
        self.console.until(f'!uobjects.hasLocalSlot("{self.type.__name__}")')
        self.assertEqual(self.get(f'uobjects.hasLocalSlot("{self.dev.name}")'), 0)
        self.assertIsInstance(self.get("m.add(1, 1)"), Error)
        self.assertIsInstance(self.get(f"{self.type.__name__}.new(1)"), Error)

    def test_a_class_that_is_there_already(self):
        kind = self.type.__name__
        other = Process(PORT, [type("Own" + kind, (Dev,), {})], self.text_mode, 10000 + self.pid)
        other.code(f"class {kind}{{}}|external object {kind}|external function (2) {kind}.add from {kind}|\n;\n")
        other.sync_get("1", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 1.0) in other.errors)
        self.assertIn("there is a UObject", str(other.errors))
        self.assertEqual(self.get("m.add(1, 2)"), 3)
        self.assertEqual(self.get(f"{kind}.add(1, 2)"), 3)
        other.kill()
        self.console.until(f'!uobjects.hasLocalSlot("Own{kind}")')
        self.assertEqual(self.get(f"{kind}.add(1, 2)"), 3)

    def test_results_for_nobody(self):
        self.process.reply("_999999", 4)
        self.process.reply("nonsense", None, "x")
        self.assertEqual(self.get("m.add(1, 2)"), 3)

    def test_many_bindings(self):
        name = self.dev.name
        text = "".join(
            f"if (!isdef({name}.v{i})) var {name}.v{i}|external var {name}.v{i} from {name}|"
            for i in range(300)
        )
        self.process.code(text + ";\n")
        self.process.sync_get("1", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 1.0) in self.process.errors)
        self.do("m.v299 = 4")
        eventually(lambda: self.dev.read("v299") == 4)

    def test_writes_of_many_threads(self):
        def write(start):
            for i in range(200):
                self.dev.write("b", start + i)

        threads = [threading.Thread(target=write, args=(1000 * n,)) for n in range(5)]
        [each.start() for each in threads]
        [each.join() for each in threads]
        self.process.code(";\n")
        self.process.sync_get(f"{self.dev.name}.b", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", self.dev.read("b")) in self.process.errors)

    def test_many_calls(self):
        self.assertEqual(
            self.get("{ var n = 0; for (var i : 2000) n = m.add(n, 1)| n }"), 2000
        )


class BinaryModeTest(Dialogues, unittest.TestCase):
    def test_a_statement_that_waits_for_its_own_process(self):
        self.process.code(f"{self.dev.name}.add(1, 2) + 1;\n")
        eventually(lambda: ("", 4.0) in self.process.errors)

    def test_statements_between_messages(self):
        self.process.raw(
            self.process.framed(
                'try { Channel.new("URBI_7") << {1 + 1} }\n'
                'catch (var e)\n{ lobby.send("!!! " + e, "URBI_7"); },'
            )
        )
        eventually(lambda: ("URBI_7", 2.0) in self.process.errors)
        self.assertEqual(self.get("m.add(1, 2)"), 3)

    def test_messages_in_pieces(self):
        name = f"{self.dev.name}.a"
        message = (
            b"\x01" + short(name) + as_bytes({"k": [1, Binary("x", b"yz")]}) + b"\0\0\0\1\0\0\0\0"
        )
        for byte in message:
            self.process.raw(bytes([byte]))
        self.process.sync_get(name, "remotecontext_1")
        expected = ("remotecontext_1", {"k": [1, Binary("x", b"yz")]})
        eventually(lambda: expected in self.process.errors)

    def assertLetGo(self, data):
        self.process.raw(data)
        self.assertTrue(self.process.ended.wait(sdk_client.PATIENCE))
        self.console.until(f'!uobjects.hasLocalSlot("{self.type.__name__}")')
        self.assertIn("does not keep to the protocol", str(self.process.errors))

    def test_a_binary_of_4_gigabytes(self):
        self.assertLetGo(b"\x01" + short("Dev.a") + b"\0" + short("") + b"\xff\xff\xff\xff")

    def test_a_list_of_4_billion(self):
        self.assertLetGo(b"\x01" + short("Dev.a") + b"\x03\xff\xff\xff\xff")

    def test_an_unknown_kind_of_message(self):
        self.assertLetGo(b"\x05")

    def test_an_unknown_kind_of_value(self):
        self.assertLetGo(b"\x01" + short("Dev.a") + b"\x63")

    def test_lists_in_lists(self):
        self.assertLetGo(b"\x01" + short("Dev.a") + b"\x03\0\0\0\1" * 501)

    def test_half_a_message_and_nothing_more(self):
        self.process.raw(b"\x01" + short("Dev.a") + b"\0" + short("") + b"\0\0\0\4ab")
        self.process.kill()
        self.console.until(f'!uobjects.hasLocalSlot("{self.type.__name__}")')

    def test_errors_leave_the_next_message_alone(self):
        self.process.code("1 +;\n")
        self.process.raw(b"\x01" + short("Nobody.a") + as_bytes(1) + bytes(8))
        self.process.emit("Nobody.e", 1)
        self.process.code("nobody.nothing;\n")
        self.process.sync_get("2", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 2.0) in self.process.errors)
        errors = [value for tag, value in self.process.errors if tag == "error"]
        self.assertGreaterEqual(len(errors), 4)
        self.assertNotIn("internal error", str(errors))

    def test_a_binary_of_10_megabytes(self):
        self.dev.write("b", Binary("raw", b"x" * 10_000_000))
        self.process.sync_get(f"{self.dev.name}.b.data.size", "remotecontext_1")
        eventually(lambda: ("remotecontext_1", 1e7) in self.process.errors)
        got = self.get(f"m.b")
        self.assertEqual(len(got.data), 10_000_000)

    def test_a_process_that_is_called(self):
        Dialogues.pid += 1
        kind = f"Called{Dialogues.pid}"
        with socket.create_server((sdk_client.HOST, 0)) as listener:
            port = listener.getsockname()[1]
            self.do(f'Lobby.reverseConnect("{sdk_client.HOST}", {port})|')
            sock = listener.accept()[0]
        process = Process(sock, [type(kind, (Dev,), {})], False, Dialogues.pid)
        self.console.until(f'uobjects.hasLocalSlot("{kind}")')
        self.assertEqual(self.get(f"{kind}.add(1, 2)"), 3)
        process.kill()
        self.console.until(f'!uobjects.hasLocalSlot("{kind}")')

    def test_a_flood_to_a_process_that_does_not_read(self):
        Dialogues.pid += 1
        deaf = Deaf(PORT, [type(f"Deaf{Dialogues.pid}", (Dev,), {})], False, Dialogues.pid)
        kind = f"Deaf{Dialogues.pid}"
        self.console.until(f'uobjects.hasLocalSlot("{kind}")')
        # It is let go, and its object with it, before all is said.
        self.get(f'var lobby.lump = "x" * 1000000|for (400) {kind}.a = lump|')
        self.console.until(f'!uobjects.hasLocalSlot("{kind}")')
        deaf.close()


class Deaf(Process):
    def run(self):
        self.ended.wait()


class TextModeTest(Dialogues, unittest.TestCase):
    text_mode = True


class PlainClientTest(unittest.TestCase):
    def test_values_and_errors(self):
        console = Console(PORT)
        self.assertEqual(console.version, "2.7.5")
        self.assertEqual(console.get("1 + 1"), 2)
        self.assertEqual(console.get('["k" => [1, "x"]]'), {"k": [1, "x"]})
        self.assertIsInstance(console.get("nothing.here"), Error)
        console.raw(b'Global.Binary.new("raw", "\\B(4)(a;\n")")|;')
        console.raw("__gostai_private__internal_pong << 1,")
        self.assertEqual(console.await_tag("__gostai_private__internal_pong"), 1)
        console.close()


if __name__ == "__main__":
    unittest.main()
