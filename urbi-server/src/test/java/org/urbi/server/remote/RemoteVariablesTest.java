package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import urbi.UImage;
import urbi.UObject;
import urbi.UVar;

/** What remote UObjects hear of variables: changes, accesses, and large values. */
class RemoteVariablesTest extends RemoteSession {
  static class Follower extends UObject {
    private int changes;

    Follower(String name) {
      super(name);
      UBindFunctions("follow", "leave", "count");
    }

    public void follow() {
      UNotifyChange("Global.followed", "changed");
    }

    public void changed(UVar followed) {
      changes++;
    }

    public void leave() {
      send("UObject.unnotify(\"Global\", \"followed\", 1); var Global.half = 1");
      send("UObject.unnotify(\"Global\", \"followed\", 1); var Global.left = 1");
    }

    public int count() {
      return changes;
    }
  }

  /** A variable made for a notification is used twice: by itself, and by the notification. */
  @Test
  void whatIsUsedLessByNameIsNotToldAnyMore() {
    remote.start(type("Follower", Follower::new));
    assertEquals("1", eval("{ UVar.new(Global, \"followed\"); Follower.follow; followed = 1 }"));
    assertEquals("1", eval("Follower.count"));
    eval("Follower.leave");
    assertEquals("1", eval("{ while (!Global.hasSlot(\"left\")) sleep(1ms); Global.half }"));
    assertEquals("2", eval("followed = 2"));
    assertEquals("1", eval("Follower.count"));
    assertEquals(
        "1", eval("Follower.isRemote && Follower.lobby.isA(Lobby) && Follower.lobby !== lobby"));
  }

  static class SelfObserver extends UObject {
    final UVar v = new UVar();
    private String seen = "";

    SelfObserver(String name) {
      super(name);
      UBindVar(v, "v");
      UNotifyChange(v, "changed");
      UBindFunctions("write", "seen");
    }

    public void changed(int value) {
      seen += value + " ";
      if (value < 10) {
        v.setValue(value + 1);
      }
    }

    public String write(int value) {
      v.setValue(value);
      return seen;
    }

    public String seen() {
      return seen;
    }
  }

  /** As a plugged object: at once, and what it sets then it knows. */
  @Test
  void ownChangesAreNotifiedInTheMiddleOfTheFunction() {
    remote.start(type("SelfObserver", SelfObserver::new));
    assertEquals("\"1 \"", eval("SelfObserver.write(1)"));
    assertEquals("2", eval("SelfObserver.v"));
    assertEquals("5", eval("SelfObserver.v = 5"));
    assertEquals("\"1 5 \"", eval("SelfObserver.seen"));
    assertEquals("6", eval("SelfObserver.v"));
    assertEquals("\"1 5 20 \"", eval("SelfObserver.write(20)"));
    assertEquals("\"1 5 20 \"", eval("SelfObserver.seen"));
  }

  static class Accessed extends UObject {
    final UVar v = new UVar();
    int reads;

    Accessed(String name) {
      super(name);
      UBindVar(v, "v");
      UNotifyAccess(v, "read");
      UBindFunctions("reads", "age");
    }

    public void read(UVar var) {
      var.setValue(++reads);
    }

    public int reads() {
      return reads;
    }

    /** How many seconds after a moment of the kernel's the variable was set here. */
    public double age(double seconds) {
      v.setValue(0);
      return v.timestamp() / 1e6 - seconds;
    }
  }

  @Test
  void accessIsNotifiedOnce() {
    remote.start(type("Accessed", Accessed::new));
    assertEquals(
        "[500, 0]",
        eval(
            "{ var wrong = 0 |"
                + " for| (var i = 1; i <= 500; i += 1) if (Accessed.v != i) wrong += 1 |"
                + " [Accessed.reads, wrong] }"));
  }

  @Test
  void conditionIsNotNotifiedOfItsOwnChanges() {
    remote.start(type("Accessed", Accessed::new));
    client.send("at (Accessed.v == -1) nil;");
    double reads =
        client
            .syncEval("{ var before = Accessed.reads | sleep(400ms) | Accessed.reads - before }")
            .doubleValue();
    assertTrue(reads >= 2 && reads <= 25, reads + " in 20 periods");
  }

  @Test
  void remoteAssignmentHasTheTimeOfTheKernel() {
    remote.start(type("Accessed", Accessed::new));
    double age = client.syncEval("Accessed.age(System.time)").doubleValue();
    assertTrue(Math.abs(age) < 5, "off by " + age + " s");
  }

  static class Camera extends UObject {
    static final BlockingQueue<UImage> SEEN = new LinkedBlockingQueue<>();
    final UVar val = new UVar();

    Camera(String name) {
      super(name);
      UBindVar(val, "val");
      UNotifyChange("Global.image", "onImage");
      UBindFunction("shoot");
    }

    public void onImage(UImage image) {
      SEEN.add(image);
    }

    public void shoot(int size) {
      byte[] data = new byte[size];
      new Random(size).nextBytes(data);
      val.setValue(new UImage(urbi.UImageFormat.IMAGE_RGB, 640, 480, data));
    }
  }

  @Test
  void imagesBothWays() throws Exception {
    client.syncEval("var Global.image = 0");
    remote.start(type("Camera", Camera::new));
    eval("Camera.shoot(921600)");
    byte[] expected = new byte[921600];
    new Random(921600).nextBytes(expected);
    eval("{ Global.image = Camera.val | 0 }");
    UImage image = Camera.SEEN.take();
    assertEquals(640, image.getWidth());
    assertArrayEquals(expected, image.getData());
  }
}
