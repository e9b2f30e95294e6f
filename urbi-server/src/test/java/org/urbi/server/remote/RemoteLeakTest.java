package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClass;
import urbi.UModule;
import urbi.UObject;
import urbi.USyncClient;
import urbi.UVar;
import urbi.remote.RemoteContext;
import urbi.rtp.RtpOptions;

/** Nothing is left of processes that came with objects, and went. */
class RemoteLeakTest {
  private static final String HOST = "127.0.0.1";
  private static final int CYCLES = 1000;
  private static final int WARM_UP = 300;

  /** How long those who have left are given when nothing is known that could be waited for. */
  private static final Duration SETTLING = Duration.ofSeconds(2);

  static class Machine extends UObject {
    final UVar speed = new UVar();

    Machine(String name) {
      super(name);
      UBindFunction("init");
    }

    public int init(double initial) {
      UBindVar(speed, "speed");
      speed.setValue(initial);
      UNotifyChange(speed, "onSpeed");
      UBindFunctions("twice", "onSpeed");
      USetTimer(50, this, "tick");
      return 0;
    }

    public void onSpeed(UVar changed) {
      changed.doubleValue();
    }

    public void tick() {
      speed.doubleValue();
    }

    public double twice(double value) {
      return 2 * value;
    }
  }

  private ConsoleServer server;
  private USyncClient client;

  private double eval(String expression) {
    return client.syncEval(expression).doubleValue();
  }

  private void cycle(int number) throws Exception {
    try (RemoteContext passing = new RemoteContext(HOST, server.port())) {
      if (number % 10 == 0) {
        RtpOptions options = new RtpOptions(0, 0, Duration.ofSeconds(10));
        assertTrue(passing.useRtp(options).get());
      }
      passing.start(new UClass("Machine", new UModule("test"), Machine::new));
      assertEquals(6, eval("{ var m = Machine.new(1) | m.speed = 3 | m.twice(3) }"));
    }
    eval("{ while (uobjects.hasLocalSlot(\"Machine\")) sleep(1ms) | 0 }");
  }

  private void cycles(int count) throws Exception {
    for (int i = 0; i < count; i++) {
      cycle(i);
    }
  }

  private record Left(double jobs, double lobbies, double objects, int threads) {}

  /** How many there are, when those who leave have had the time to. */
  private Left settled(Left expected) throws InterruptedException {
    Left left;
    long begin = System.nanoTime();
    Duration patience = expected == null ? SETTLING : TestTimeout.LONG;
    do {
      left =
          new Left(
              eval("jobs.size"),
              eval("Lobby.instances.size"),
              eval("uobjects.localSlotNames.size"),
              ManagementFactory.getThreadMXBean().getThreadCount());
      if (expected != null
          && left.jobs <= expected.jobs
          && left.lobbies <= expected.lobbies
          && left.objects <= expected.objects
          && left.threads <= expected.threads) {
        return left;
      }
      Thread.sleep(10);
    } while (System.nanoTime() - begin < patience.toNanos());
    return left;
  }

  private static long heap() throws InterruptedException {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 5; i++) {
      System.gc();
      Thread.sleep(50);
      least = Math.min(least, ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
    }
    return least;
  }

  @Test
  void thousandProcessesConnectAndLeave() throws Exception {
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    try (Kernel kernel = Kernel.builder().start();
        ConsoleServer opened = open(kernel, nowhere);
        USyncClient asking = USyncClient.connect(HOST, opened.port(), TestTimeout.LONG)) {
      server = opened;
      client = asking;
      client.setDefaultTimeout(TestTimeout.LONG);
      assertEquals(1, eval("{ loadModule(\"urbi/rtp\") | 1 }"));
      cycles(WARM_UP);
      Left before = settled(null);
      long heapBefore = heap();
      cycles(CYCLES);
      Left after = settled(before);
      long heapAfter = heap();
      assertTrue(after.jobs <= before.jobs, before + " became " + after);
      assertTrue(after.lobbies <= before.lobbies, before + " became " + after);
      assertEquals(before.objects, after.objects);
      assertTrue(after.threads <= before.threads, before + " became " + after);
      assertTrue(heapAfter <= 1.05 * heapBefore, "heap: " + heapBefore + " became " + heapAfter);
    }
  }

  private static ConsoleServer open(Kernel kernel, PrintStream nowhere) throws IOException {
    return new ConsoleServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        each -> kernel.connect(each, false),
        kernel::connectRemote,
        Limits.DEFAULT,
        new Trace(Trace.Level.NONE, nowhere));
  }
}
