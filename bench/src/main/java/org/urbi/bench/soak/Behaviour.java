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
