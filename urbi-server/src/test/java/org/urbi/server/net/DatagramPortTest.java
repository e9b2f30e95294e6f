package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import io.netty.channel.Channel;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.nio.NioIoHandler;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import urbi.rtp.RtpSession;

class DatagramPortTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();

  private final MultiThreadIoEventLoopGroup loop =
      new MultiThreadIoEventLoopGroup(1, NioIoHandler.newFactory());
  private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private final Map<String, Channel> channels = new ConcurrentHashMap<>();

  @AfterEach
  void stop() {
    loop.shutdownGracefully();
  }

  private DatagramPort port(InetSocketAddress server) {
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    return new DatagramPort(loop, () -> server, new Trace(Trace.Level.NONE, nowhere));
  }

  private static int freePort() throws IOException {
    try (DatagramSocket free = new DatagramSocket(0, HERE)) {
      return free.getLocalPort();
    }
  }

  private void open(DatagramPort port, String name, Runnable then) {
    port.open(
        channel -> {
          channels.put(name, channel);
          answers.add(name);
          then.run();
        },
        why -> answers.add(name + ": " + why));
  }

  /** The last offer of a process counts, however close the offers follow one another. */
  @Test
  void whoAsksWhileItIsOpenedIsToldInOrder() throws Exception {
    DatagramPort port = port(new InetSocketAddress(HERE, freePort()));
    assertToldInOrder(port);
    assertSame(channels.get("first"), channels.get("second"));
    assertSame(channels.get("first"), channels.get("third"));
    port.close();
  }

  /** The third asks when the first is told, while the second still waits. */
  private void assertToldInOrder(DatagramPort port) throws InterruptedException {
    loop.execute(() -> {
      open(port, "first", () -> loop.execute(() -> open(port, "third", () -> {})));
      open(port, "second", () -> {});
    });
    assertEquals("first", answers.take());
    assertEquals("second", answers.take());
    assertEquals("third", answers.take());
  }

  /** It would stay open for ever: nobody closes it a second time. */
  @Test
  void portThatIsClosedWhileItIsOpenedIsNotLeftOpen() throws Exception {
    DatagramPort port = port(new InetSocketAddress(HERE, 0));
    loop.execute(() -> {
      port.close();
      open(port, "late", () -> {});
    });
    assertEquals("late: cannot take datagrams: the port has been closed", answers.take());
  }

  @Test
  void takenPortIsReplacedByAnother() throws Exception {
    try (DatagramSocket other = new DatagramSocket(0, HERE)) {
      DatagramPort port = port(new InetSocketAddress(HERE, other.getLocalPort()));
      assertToldInOrder(port);
      port.close();
    }
  }

  @Test
  void aDatagramThatMeetsADefectIsNotTheLast() throws Exception {
    byte[] bytes = {1};
    DatagramPort port = port(new InetSocketAddress(HERE, 0));
    AtomicInteger taken = new AtomicInteger();
    port.add(
        RtpSession.token(bytes, bytes.length),
        (datagram, sender) -> {
          if (taken.incrementAndGet() == 1) {
            throw new NoClassDefFoundError("lost");
          }
          answers.add("taken");
        });
    loop.execute(() -> open(port, "open", () -> {}));
    assertEquals("open", answers.take());
    try (DatagramSocket sender = new DatagramSocket(0, HERE)) {
      for (int i = 0; i < 2; i++) {
        sender.send(new DatagramPacket(bytes, bytes.length, channels.get("open").localAddress()));
      }
      assertEquals("taken", answers.poll(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
    }
    port.close();
  }

  /** An address of another machine: everybody is told, and who asks later is served again. */
  @Test
  void refusalIsToldToAllWhoWait() throws Exception {
    DatagramPort port = port(new InetSocketAddress("192.0.2.1", 0));
    loop.execute(() -> {
      open(port, "first", () -> {});
      open(port, "second", () -> {});
    });
    assertEquals("first: cannot take datagrams", answers.take().split(":? ?[A-Z]", 2)[0]);
    assertEquals("second: cannot take datagrams", answers.take().split(":? ?[A-Z]", 2)[0]);
    loop.execute(() -> open(port, "third", () -> {}));
    assertEquals("third: cannot take datagrams", answers.take().split(":? ?[A-Z]", 2)[0]);
  }
}
