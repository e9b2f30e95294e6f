package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClientException;
import urbi.UObject;
import urbi.USyncClient;
import urbi.UVar;
import urbi.remote.RemoteContext;
import urbi.wire.Protocol;

/** Remote processes that come and go, in good ways and in bad ones. */
class RemoteConnectionTest extends RemoteSession {
  static class Stuck extends UObject {
    static final CountDownLatch CALLED = new CountDownLatch(1);

    Stuck(String name) {
      super(name);
      UBindFunction("hang");
    }

    public void hang() throws InterruptedException {
      CALLED.countDown();
      Thread.sleep(30_000);
    }
  }

  static class NeverSet extends UObject {
    final UVar v = new UVar();

    NeverSet(String name) {
      super(name);
      UBindVar(v, "v");
      v.setValue(3);
      UNotifyAccess(v, "hang");
    }

    public void hang(UVar accessed) throws InterruptedException {
      Thread.sleep(30_000);
    }
  }

  @Test
  void accessThatAProcessDoesNotAnswerIsNamed() throws Exception {
    remote.start(type("NeverSet", NeverSet::new));
    assertEquals("3", eval("NeverSet.v"));
    assertEquals(
        "the remote process has not set NeverSet.v within 2 s of an access: the value is old",
        log.take().replaceFirst("^\\w+: ", ""));
  }

  @Test
  void lostRemoteIsNoticedAndCanReconnect() throws Exception {
    remote.start(type("Stuck", Stuck::new));
    remote.start(type("Adder", RemoteUObjectTest.Adder::new));
    client.syncEval("var Global.a = Adder.new(5)");
    CompletableFuture<String> error =
        CompletableFuture.supplyAsync(() -> {
          try (USyncClient other = USyncClient.connect(HOST, server.port(), TestTimeout.LONG)) {
            return assertThrows(
                    UClientException.class, () -> other.syncEval("Stuck.hang", TestTimeout.LONG))
                .getMessage();
          }
        });
    Stuck.CALLED.await();
    assertEquals("3", eval("1 + 2"));
    remote.close();
    assertTrue(error.get().contains("the remote process has gone"), error.get());
    eval("while (uobjects.hasLocalSlot(\"Adder\")) sleep(1ms)");
    assertTrue(error("a.add(1)").contains("the remote process has gone"), error("a.add(1)"));
    assertEquals("0", eval("if (uobjects.hasLocalSlot(\"Adder\")) 1 else 0"));
    remote = new RemoteContext(HOST, server.port());
    remote.start(type("Adder", RemoteUObjectTest.Adder::new));
    assertEquals("3", eval("Adder.new(1).add(2)"));
  }

  @Test
  void endOfTheKernelIsNoticed() throws Exception {
    remote.start(type("Adder", RemoteUObjectTest.Adder::new));
    kernel.close();
    assertNotEquals(null, remote.onClosed().get());
    assertThrows(UClientException.class, () -> remote.variable("Global.x"));
    assertThrows(UClientException.class, () -> remote.send("1;"));
  }

  @Test
  void garbageEndsOnlyItsConnection() throws Exception {
    Random random = new Random(9);
    for (int i = 0; i < 50; i++) {
      try (Socket socket = new Socket(HOST, server.port())) {
        OutputStream out = socket.getOutputStream();
        out.write(Protocol.request().getBytes(StandardCharsets.US_ASCII));
        byte[] garbage = new byte[200];
        random.nextBytes(garbage);
        if (i % 2 == 0) {
          garbage[0] = 0;
          garbage[1] = 0;
          garbage[2] = 0;
          garbage[3] = (byte) (1 + random.nextInt(100));
          garbage[4] = (byte) (16 + random.nextInt(22));
        }
        try {
          out.write(garbage);
          socket.shutdownOutput();
          socket.getInputStream().readAllBytes();
        } catch (IOException e) {
          // The server has hung up already.
        }
      }
    }
    assertEquals("3", eval("1 + 2"));
  }

  @Test
  void nothingIsLeftOfProcessesThatHaveEnded() {
    remote.start(type("Watcher", RemoteUObjectTest.Watcher::new));
    double jobs = client.syncEval("jobs.size").doubleValue();
    for (int i = 0; i < 100; i++) {
      try (RemoteContext passing = new RemoteContext(HOST, server.port())) {
        passing.start(type("Adder", RemoteUObjectTest.Adder::new));
        passing.variable("Adder.x").useRtp(true);
        assertEquals("3", eval("Adder.new(1).add(2)"));
      }
      eval("while (uobjects.hasLocalSlot(\"Adder\")) sleep(1ms)");
    }
    eval("while (Lobby.instances.size > 3) sleep(1ms)");
    eval("while (jobs.size > " + jobs + ") sleep(1ms)");
  }

  @Test
  void versionsAreAgreedUpon() throws Exception {
    try (Socket socket = new Socket(HOST, server.port())) {
      socket.getOutputStream().write("\"urbi-uobject 7 9\";\n".getBytes(StandardCharsets.US_ASCII));
      InputStream in = socket.getInputStream();
      assertEquals(
          "[00000000:uobject] !!! this server speaks versions 1 to 1 of the UObject protocol\n",
          new String(in.readAllBytes(), StandardCharsets.US_ASCII));
    }
    ConsoleServer plain =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            each -> kernel.connect(each, false),
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, System.err));
    try (plain) {
      assertTrue(
          assertThrows(UClientException.class, () -> new RemoteContext(HOST, plain.port()))
              .getMessage()
              .startsWith("the server does not speak the UObject protocol"));
    }
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread.ofVirtual()
          .start(() -> {
            try (Socket peer = other.accept()) {
              peer.getOutputStream()
                  .write("SSH-2.0\r\n".repeat(200).getBytes(StandardCharsets.US_ASCII));
            } catch (IOException e) {
              // The other side has seen enough.
            }
          });
      assertThrows(UClientException.class, () -> new RemoteContext(HOST, other.getLocalPort()));
    }
  }
}
