package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.trust.Role;

/** What the kernel calls for a client when something comes over its sockets. */
class LeftSocketsTest {
  private Kernel kernel;
  private ServerSocket listener;
  private TestClient judge;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    judge = new TestClient(kernel, Role.OWNER);
    judge.say("var Global.calls = 0|; var Global.called = closure () { calls += 1 }|;");
  }

  @AfterEach
  void end() throws IOException {
    listener.close();
    kernel.close();
  }

  /** A socket of a client, connected to what this returns, calls the code for each thing sent. */
  private Socket connect(TestClient client, String received) throws IOException {
    client.say(
        "var Global.socket = Socket.new|;"
            + " socket.received.subscribe(Subscription.new(closure (data) { "
            + received
            + " }));"
            + " socket.connect(\"127.0.0.1\", "
            + listener.getLocalPort()
            + ");");
    return listener.accept();
  }

  private void await(String condition) {
    judge.say("while (!(" + condition + ")) sleep(2ms);");
  }

  @Test
  void whatItsCodeHasDetachedEndsWithTheClient() throws IOException {
    TestClient client = new TestClient(kernel, Role.OWNER);
    try (Socket peer = connect(client, "detach({ called; sleep(inf) })")) {
      peer.getOutputStream().write('x');
      await("calls == 1");
      client.connection().close();
      await("System.jobs.size == 1");
    }
  }

  /** The program that listens may have been sent by a client that has left. */
  @Test
  void whatComesWhenTheClientHasLeftIsDelivered() throws IOException {
    TestClient client = new TestClient(kernel, Role.OWNER);
    try (Socket peer = connect(client, "1")) {
      client.say("disown({ at (socket.received?) { sleep(5ms); called } }) | sleep(50ms);");
      client.connection().close();
      await("System.jobs.size == 1");
      for (int i = 1; i <= 2; i++) {
        peer.getOutputStream().write('x');
        await("calls == " + i);
      }
    }
  }

  @Test
  void whatComesForALobbyThatIsNoClientIsDelivered() throws IOException {
    kernel.eval("var Global.socket = Socket.new|");
    kernel.eval("at (socket.received?) called");
    kernel.eval("socket.connect(\"127.0.0.1\", " + listener.getLocalPort() + ")");
    try (Socket peer = listener.accept()) {
      peer.getOutputStream().write('x');
      await("calls == 1");
    }
  }

  /** The job that is to deliver it ends before it begins. */
  @Test
  void whatComesWhenTheBudgetIsExhaustedIsDeliveredLater() throws IOException {
    TestClient client = new TestClient(kernel, Role.OWNER, "jobs=3");
    try (Socket peer = connect(client, "called")) {
      client.say("var t = Tag.new|; t: for (2) detach({ sleep(inf) });");
      peer.getOutputStream().write('x');
      String heard = client.next();
      assertEquals(true, heard.contains("budget of this lobby is exhausted"), heard);
      client.say("t.stop;");
      await("calls == 1");
    }
  }
}
