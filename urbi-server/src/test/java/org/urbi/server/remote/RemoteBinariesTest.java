package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import urbi.LockMode;
import urbi.UBinary;
import urbi.UObject;
import urbi.UVar;

/** Binaries on their way to and from a remote process. */
class RemoteBinariesTest extends RemoteSession {
  private static final int BIG = 24_000_000;

  static class Store extends UObject {
    static final BlockingQueue<UBinary> SEEN = new LinkedBlockingQueue<>();
    final UVar val = new UVar();

    Store(String name) {
      super(name);
      UBindVar(val, "val");
      UBindFunction("same");
      UBindFunction("make");
      UBindThreadedFunction("turned", LockMode.LOCK_NONE);
      UNotifyChange(val, "changed");
    }

    public UBinary same(UBinary given) {
      return given;
    }

    public int make(int size) {
      byte[] data = new byte[size];
      Arrays.fill(data, (byte) 'x');
      val.setValue(new UBinary("raw made", data));
      return 0;
    }

    public UBinary turned(UBinary given) {
      byte[] data = given.getData().clone();
      for (int i = 0; i < data.length; i++) {
        data[i] ^= 1;
      }
      return new UBinary(given.getMessage(), data);
    }

    public void changed(UBinary value) {
      SEEN.add(value);
    }
  }

  @Test
  void largeBinariesTravelBothWays() throws Exception {
    remote.start(type("Store", Store::new));
    client.syncEval("var Global.big = Binary.new(\"raw 1\", \"abcdefgh\" * " + BIG / 8 + "); 0");
    assertEquals("1", eval("if (Store.same(big) == big) 1 else 0"));
    client.syncEval("Store.val = big; 0");
    assertEquals(BIG, Store.SEEN.take().getSize());
    assertEquals("0", eval("Store.make(" + BIG + ")"));
    assertEquals(String.valueOf(BIG), eval("Store.val.data.size"));
    assertEquals("\"raw made\"", eval("Store.val.keywords"));
  }

  @Test
  void threadsMayHaveManyAtATime() {
    remote.start(type("Store", Store::new));
    String each =
        "var b = Binary.new(\"n \" + i, \"ab\" * (1000 + i))| var t = Store.turned(b)|"
            + " assert (t.keywords == b.keywords)| assert (t.data.size == b.data.size)|"
            + " assert (Store.turned(t) == b)| Global.done += 1";
    client.syncEval("var Global.done = 0");
    client.syncEval("for& (var i : 100) { " + each + " }; 0");
    assertEquals("100", eval("done"));
  }

  @Test
  void destroyedObjectGetsNoNotifications() throws Exception {
    remote.start(type("Store", Store::new));
    Store.SEEN.clear();
    client.syncEval("var Global.s = Store.new; 0");
    client.syncEval("s.val = Binary.new(\"\", \"a\"); 0");
    assertEquals(1, Store.SEEN.take().getSize());
    client.syncEval("var Global.v = s.&val; s.destroy; 0");
    client.syncEval("v.val = Binary.new(\"\", \"bb\"); 0");
    client.syncEval("Store.val = Binary.new(\"\", \"ccc\"); 0");
    assertEquals(3, Store.SEEN.take().getSize());
  }
}
