package org.urbi.bench.soak;

import java.io.IOException;
import java.util.Random;

/** What a client does while it is connected. */
enum Behaviour {
  /** Sensible statements, typed by hand, whose answers are checked. */
  TYPE {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      int n = random.nextInt(1000);
      soakConnection.type(
          "{ var a = " + n + ";\nfunction twice(x) { x * 2 };\ntwice(a) };\n", random);
      soakConnection.expect("] " + 2 * n);
      soakConnection.type("{ var l = [];\nfor| (var i : 100) { l << i };\nl.size };\n", random);
      soakConnection.expect("] 100");
    }
  },
  /** Mistakes of every kind. */
  ERR {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send("nobody.home;\n1 +;\n\"open\n\";\n)]};\n");
      soakConnection.send("try { throw [1, 2] } catch (var e) { e };\n1 / 0;\nthrow \"ball\";\n");
      soakConnection.send("function deep(n) { deep(n + 1) };\n");
      if (random.nextInt(8) == 0) {
        soakConnection.send("deep(0);\n");
      }
      soakConnection.check();
    }
  },
  /** Handlers, loops and timers that are left behind when the client goes. */
  REACT {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send(
          """
          var e = Event.new;
          var x = 0;
          at (e?(var n)) { x += n };
          at (x > 10 ~ 5ms) { x = 0 } onleave { 1 };
          whenever (x % 2 == 1) { sleep(10ms) },
          every (10ms) { e!(3) },
          t: loop { sleep(1ms) },
          { sleep(20ms); t.stop } & { t.freeze; t.unfreeze };
          """);
      Soak.pause(random.nextInt(100));
      soakConnection.check();
    }
  },
  /** A loop that never ends, in the background. */
  SPIN {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send("loop {},\n");
      Soak.pause(random.nextInt(50));
      soakConnection.check();
    }
  },
  /** Much input at once, all of whose answers are read. */
  FLOOD {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      int lines = 200 + random.nextInt(2000);
      soakConnection.send("1 + 2 * 3;\n".repeat(lines));
      soakConnection.check();
    }
  },
  /** Much output that nobody reads. */
  DEAF {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send("var text = \"x\" * 1000|;\nfor (var i : 1000) { echo(text) },\n");
      Soak.pause(random.nextInt(200));
      soakConnection.glance();
    }
  },
  /** A statement that is never finished, and is long. */
  UNFINISHED {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send("{ var list = [" + "1, ".repeat(random.nextInt(20_000)));
      Soak.pause(random.nextInt(20));
    }
  },
  /** Programs that end, that do not, and that do not exist. */
  PROCESS {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send(
          """
          var p = Process.new("sleep", [%d]);
          p.run;
          var q = Process.new("echo", ["hello"]);
          q.run;
          q.join;
          try { Process.new("/nowhere/at/all", []).run } catch {};
          """
              .formatted(random.nextInt(20)));
      Soak.pause(random.nextInt(100));
      soakConnection.check();
    }
  },
  /** Files that are opened, written, read and forgotten. */
  FILES {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send(
          """
          var name = System.getenv("TMPDIR") + "/file-%d";
          var out = OutputStream.new(File.create(name));
          out << "x" * 1000;
          out.close;
          var input = InputStream.new(File.new(name));
          File.new(name).content.data.size;
          var never = InputStream.new(File.new("/dev/null"));
          try { File.new("/dev/zero/nothing").content } catch {};
          try { Directory.new("/nowhere") } catch {};
          """
              .formatted(random.nextInt(50)));
      soakConnection.check();
    }
  },
  /** Patterns that take for ever, and many that do not. */
  REGEXP {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send(
          "for (var i : 50) Regexp.new(\"a\" + i + \"(b|c)*d\").match(\"xa1bcbcd\");\n");
      if (random.nextInt(8) == 0) {
        soakConnection.send("Regexp.new(\"(a*)*b\").match(\"a\" * 30),\n");
      }
      soakConnection.check();
    }
  },
  /**
   * Components that are made, bound, notified of, and left behind; and files that are no modules.
   */
  COMPONENT {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      soakConnection.send(
          """
          try { loadModule("/dev/null") } catch {};
          var a = Adder.new;
          a.v = 20;
          at (a.v > 30) { 1 };
          a.v = 40;
          a.add(2);
          """);
      soakConnection.expect("] 42");
      soakConnection.check();
    }
  },
  /** Bytes that are no text. */
  NOISE {
    @Override
    void act(SoakConnection soakConnection, Random random) throws IOException {
      StringBuilder noise = new StringBuilder();
      int length = random.nextInt(5_000);
      for (int i = 0; i < length; i++) {
        noise.append((char) random.nextInt(256));
      }
      soakConnection.send(noise.toString());
      Soak.pause(random.nextInt(20));
    }
  };

  abstract void act(SoakConnection soakConnection, Random random) throws IOException;
}
