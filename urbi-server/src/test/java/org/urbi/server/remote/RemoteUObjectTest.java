package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;
import urbi.LockMode;
import urbi.UBinary;
import urbi.UContext;
import urbi.UEvent;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** UObjects that are connected to a kernel, and not plugged into it. */
class RemoteUObjectTest extends RemoteSession {
  /** Binds so many functions when it is initialized that others could have their turn meanwhile. */
  static class ManyFunctions extends UObject {
    static final int TALENTS = 1000;

    ManyFunctions(String name) {
      super(name);
      UBindFunction("init");
    }

    public void init() {
      for (int i = 0; i < TALENTS; i++) {
        UBindFunctionRename("talent", "talent" + i);
      }
    }

    public int talent() {
      return 1;
    }
  }

  @Test
  void slotsBoundByAFunctionExistWhenItReturns() {
    remote.start(type("Talented", ManyFunctions::new));
    for (int i = 0; i < 10; i++) {
      assertEquals("1", eval("Talented.new.talent" + (ManyFunctions.TALENTS - 1)));
    }
  }

  /** The manual's. */
  static class Adder extends UObject {
    private final UVar v = new UVar();

    Adder(String name) {
      super(name);
      UBindFunction("init");
    }

    public int init(double initial) {
      UBindVar(v, "v");
      v.setValue(initial);
      UBindFunctions("add", "fail", "echo", "whole");
      return 0;
    }

    public double add(double other) {
      return v.doubleValue() + other;
    }

    public void fail(String text) {
      throw new IllegalStateException(text);
    }

    public int whole(int value) {
      return value;
    }

    public UValue echo(UValue value) {
      return value;
    }
  }

  /** Its notification lets others run until it has heard of two values. */
  static class Patient extends UObject {
    private final UVar v = new UVar();
    private int heard;

    Patient(String name) {
      super(name);
      UBindVar(v, "v");
      UNotifyChange(v, "hear");
      UBindFunctions("write", "count");
    }

    public int hear(UVar changed) {
      heard++;
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
      while (heard < 2 && System.nanoTime() - end < 0) {
        yield_for(1000);
      }
      return 0;
    }

    public void write(int value) {
      v.setValue(value);
    }

    public int count() {
      return heard;
    }
  }

  @Test
  void whoYieldsHearsOfWhatOthersWrite() {
    remote.start(type("Patient", Patient::new));
    assertEquals("2", eval("{ Patient.v = 1 | Patient.write(2) | Patient.count }"));
  }

  @Test
  void theManualsAdder() {
    remote.start(type("Adder", Adder::new));
    assertEquals("\"Adder\"", eval("Adder.asString"));
    assertEquals("lookup failed: v", error("Adder.v"));
    client.syncEval("var Global.a = Adder.new(51)");
    assertEquals("51", eval("a.v"));
    assertEquals("61", eval("a.add(10)"));
    assertEquals("1", eval("{ a.v = 0.5; a.add(0.5) }"));
    client.syncEval("var Global.b = Adder.new(1)");
    assertEquals("[2, 1.5]", eval("[b.add(1), a.add(1)]"));
  }

  @Test
  void valuesGoThereAndBack() {
    remote.start(type("Adder", Adder::new));
    client.syncEval("var Global.a = Adder.new(0)");
    assertEquals("[1, \"\\\"é\", [\"k\" => [2]]]", eval("a.echo([1, \"\\\"é\", [\"k\" => [2]]])"));
    byte[] data = new byte[100_000];
    new Random(5).nextBytes(data);
    UValue image = new UValue(new UBinary("rgb 1 2", data));
    client.send("var Global.image = ");
    client.send(image);
    client.send(";");
    assertEquals(image, client.syncEval("a.echo(image)"));
  }

  @Test
  void errorsGoToTheCaller() {
    remote.start(type("Adder", Adder::new));
    assertTrue(error("Adder.new").contains("expected 1"), error("Adder.new"));
    client.syncEval("var Global.a = Adder.new(0)");
    assertEquals(
        "fail: exception caught while calling "
            + eval("a.__uobjectName").replace("\"", "")
            + ".fail: no way",
        error("a.fail(\"no way\")"));
    String name = eval("a.__uobjectName").replace("\"", "");
    assertEquals(
        name + ".add: argument 1: unexpected \"many\", expected a Float",
        error("a.add(\"many\")").replaceFirst("\\n.*", ""));
    assertEquals("[-2147483648, 5]", eval("[a.whole(2147483648), a.whole(5.9)]"));
    assertEquals("3", eval("1 + 2"));
  }

  static class Broken extends UObject {
    Broken(String name) {
      super(name);
      UBindFunction("init");
      if (!name.equals("Broken")) {
        throw new IllegalStateException("out of order");
      }
    }

    public int init() {
      return 0;
    }
  }

  @Test
  void aConstructorThatThrows() {
    remote.start(type("Broken", Broken::new));
    assertTrue(error("Broken.new").contains("out of order"), error("Broken.new"));
    assertThrows(
        IllegalStateException.class,
        () ->
            remote.start(
                type(
                    "Worse",
                    name -> {
                      throw new IllegalStateException("never");
                    })));
    assertEquals("3", eval("1 + 2"));
  }

  static class Watcher extends UObject {
    static final BlockingQueue<String> SEEN = new LinkedBlockingQueue<>();
    final UVar own = new UVar();
    final UVar sensor = new UVar();
    final UVar other = new UVar();
    final UEvent event = new UEvent();

    Watcher(String name) {
      super(name);
      UBindVar(own, "own");
      UBindVar(sensor, "sensor");
      UOwned(sensor);
      UBindEvent(event, "event");
      UBindFunctions("write", "emit", "read", "threaded");
      own.setValue(1);
      sensor.setValue(2);
      UNotifyChange(own, "ownChanged");
      UNotifyChange(sensor, "sensorChanged");
    }

    public void ownChanged(UVar v) {
      SEEN.add("own " + v.intValue());
    }

    public void sensorChanged(double target) {
      SEEN.add("sensor " + target);
      sensor.setValue(target / 2);
    }

    public void write(double value) {
      own.setValue(value);
    }

    public void emit(double value) {
      event.emit(value, "x");
    }

    public double read(String name) {
      return new UVar(name).doubleValue();
    }

    public void threaded() {
      UBindThreadedFunction("wait_", LockMode.LOCK_NONE);
    }

    public double wait_() throws InterruptedException {
      Thread.sleep(300);
      return 5;
    }
  }

  private static String seen() throws InterruptedException {
    return Watcher.SEEN.take();
  }

  @Test
  void variablesAndEvents() throws InterruptedException {
    Watcher.SEEN.clear();
    remote.start(type("Watcher", Watcher::new));
    assertEquals("[1, 2]", eval("[Watcher.own, Watcher.sensor]"));
    eval("Watcher.own = 7");
    assertEquals("own 7", seen());
    eval("Watcher.write(8)");
    assertEquals("own 8", seen());
    assertEquals("8", eval("Watcher.own"));
    eval("Watcher.sensor = 20");
    assertEquals("sensor 20.0", seen());
    assertEquals("10", eval("{ Watcher.read(\"Watcher.own\"); Watcher.sensor }"));
    client.send("var Global.heard = nil | at (Watcher.event?(var a, var b)) heard = [a, b];");
    eval("Watcher.emit(3)");
    assertEquals("[3, \"x\"]", eval("{ waituntil(!heard.isNil); heard }"));
    client.syncEval("var Global.x = 3.25");
    assertEquals("3.25", eval("Watcher.read(\"Global.x\")"));
    assertTrue(
        error("Watcher.read(\"nowhere.x\")").contains("UVar creation on non existing object"));
    assertEquals(null, Watcher.SEEN.poll());
  }

  @Test
  void aSlowFunctionDoesNotBlockTheKernel() {
    Watcher.SEEN.clear();
    remote.start(type("Watcher", Watcher::new));
    eval("Watcher.threaded");
    assertEquals(
        "[5, 5, 1]",
        eval(
            "{ var t = time; var r = []; { r << Watcher.wait_ } & { r << Watcher.wait_ };"
                + " r << (time - t < 550ms) }"));
  }

  static class Yielding extends UObject {
    private boolean called;

    Yielding(String name) {
      super(name);
      // As components of 2.7 do, it shows urbiscript a method that it inherits.
      UBindFunctions("waits", "comes", "yield");
    }

    /** Waits, and lets others be called, until one was. */
    public String waits() {
      long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
      while (!called && System.nanoTime() - deadline < 0) {
        UContext.current().yieldFor(Duration.ofMillis(20));
      }
      return called ? "called" : "not called";
    }

    public int comes() {
      called = true;
      return 7;
    }
  }

  @Test
  void yieldLetsOtherFunctionsRun() {
    remote.start(type("Yielding", Yielding::new));
    assertEquals(
        "[1, 1]",
        eval(
            "{ var r = []; { r << Yielding.waits } & { sleep(50ms); r << Yielding.comes };"
                + " [r.has(\"called\"), r.has(7)] }"));
    assertEquals("1", eval("Yielding.yield.isVoid"));
  }

  static class Ticker extends UObject {
    int ticks;
    int updates;

    Ticker(String name) {
      super(name);
      USetTimer(5, this, "tick");
      USetUpdate(5);
      UBindFunctions("countsChecks", "urbi");
    }

    public int tick() {
      ticks++;
      return 0;
    }

    @Override
    public int update() {
      updates++;
      return 0;
    }

    public boolean countsChecks() {
      return ticks > 3 && updates > 3;
    }

    public void urbi() {
      send("var Global.sent = 12; 1");
      send("var Global.unended = 14 // The end of the text is the end of the statement.");
      call("Global", "setSlot", "called", 13);
    }
  }

  @Test
  void timersAndUrbiscript() {
    remote.start(type("Ticker", Ticker::new));
    assertEquals("1", eval("{ while (!Ticker.countsChecks) sleep(5ms); 1 }"));
    eval("Ticker.urbi");
    assertEquals(
        "[12, 14, 13]",
        eval(
            "{ while (!Global.hasSlot(\"unended\") || !Global.hasSlot(\"called\")) sleep(5ms);"
                + " [Global.sent, Global.unended, Global.called] }"));
  }

  static class OneThread extends UObject {
    final UVar v = new UVar();
    final Set<Thread> seen = ConcurrentHashMap.newKeySet();

    OneThread(String name) {
      super(name);
      see();
      UBindVar(v, "v");
      UNotifyChange(v, "see");
      UNotifyAccess(v, "see");
      USetTimer(5, this, "see");
      UBindFunctions("see", "slow", "asks", "threads");
    }

    public int see() {
      return seen.add(Thread.currentThread()) ? 1 : 0;
    }

    /** Takes so long that another thread reads meanwhile. */
    public void slow() throws InterruptedException {
      see();
      Thread.sleep(50);
    }

    /** Waits for what another thread has to read. */
    public void asks() {
      see();
      v.syncValue();
    }

    public int threads() {
      see();
      return seen.size();
    }
  }

  @Test
  void allButThreadedCallsRunsOnOneThread() {
    remote.start(type("OneThread", OneThread::new));
    assertEquals(
        "1",
        eval(
            "{ for (var i : 20) { OneThread.v = i | OneThread.asks | OneThread.see }"
                + " | OneThread.slow | OneThread.v | OneThread.new.slow | sleep(30ms)"
                + " | OneThread.threads }"));
  }

  static class LateBinder extends UObject {
    static final CountDownLatch BEGUN = new CountDownLatch(1);
    static final CountDownLatch SEEN = new CountDownLatch(1);

    LateBinder(String name) throws InterruptedException {
      super(name);
      BEGUN.countDown();
      SEEN.await();
      UBindFunction("late");
    }

    public int late() {
      return 42;
    }
  }

  @Test
  void objectIsVisibleAfterItsConstructor() throws InterruptedException {
    Thread starter =
        Thread.ofPlatform().start(() -> remote.start(type("LateBinder", LateBinder::new)));
    LateBinder.BEGUN.await();
    assertEquals("[0, 0]", eval("[uobjects.hasSlot(\"LateBinder\"), isdef(LateBinder)]"));
    LateBinder.SEEN.countDown();
    starter.join();
    assertEquals("42", eval("LateBinder.late"));
    assertEquals("42", eval("LateBinder.new.late"));
  }
}
