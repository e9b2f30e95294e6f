package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.job.JobThreads;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.LockMode;
import urbi.UClass;
import urbi.UClientException;
import urbi.UModule;
import urbi.UObject;
import urbi.USyncClient;
import urbi.UValue;
import urbi.UVar;
import urbi.remote.RemoteContext;
import urbi.wire.Frame;
import urbi.wire.Protocol;

/** Calls one after the other, whose answers the kernel thread itself reads before long. */
class RemoteAnswersTest {
  private static final String HOST = "127.0.0.1";

  private Kernel kernel;
  private ConsoleServer server;
  private USyncClient client;

  @BeforeEach
  void start() throws IOException {
    start(JobThreads.AUTO);
  }

  private void start(JobThreads threads) throws IOException {
    kernel = Kernel.builder().jobThreads(threads).start();
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            each -> kernel.connect(each, false),
            kernel::connectRemote,
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
    client = USyncClient.connect(HOST, server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
  }

  @AfterEach
  void stop() {
    client.close();
    kernel.close();
    server.close();
  }

  private String eval(String expression) {
    return client.syncEval(expression).toString();
  }

  private String error(String expression) {
    return assertThrows(UClientException.class, () -> client.syncEval(expression)).getMessage();
  }

  private RemoteContext remote(String name, UClass.Factory factory) {
    RemoteContext remote = new RemoteContext(HOST, server.port());
    remote.start(new UClass(name, new UModule("test"), factory));
    return remote;
  }

  static class Counter extends UObject {
    final UVar v = new UVar();
    double last;

    Counter(String name) {
      super(name);
      UBindVar(v, "v");
      UBindFunctions("next", "echo", "code", "hang");
      UBindThreadedFunction("later", LockMode.LOCK_NONE);
    }

    public double next() {
      v.setValue(++last);
      return last;
    }

    public UValue echo(UValue value) {
      return value;
    }

    public double code(double value) {
      send("Global.n = " + value + ";");
      return value;
    }

    public double later(double seconds) throws InterruptedException {
      Thread.sleep((long) (seconds * 1000));
      return seconds;
    }

    public void hang() throws InterruptedException {
      Thread.sleep(60_000);
    }
  }

  @Test
  void messagesBeforeAnAnswerAreProcessedBeforeIt() {
    try (RemoteContext ignored = remote("Counter", Counter::new)) {
      assertEquals(
          "[3000, 0]",
          eval(
              "{ var wrong = 0 | var n = 0 |"
                  + " while (n < 3000) { n = Counter.next | if (Counter.v != n) wrong += 1 } |"
                  + " [n, wrong] }"));
    }
  }

  @Test
  void orderIsTheSameOnTheOtherBackEnd() throws IOException {
    stop();
    start(JobThreads.BATON);
    messagesBeforeAnAnswerAreProcessedBeforeIt();
  }

  @Test
  void largeAndSmallAnswersMixed() {
    try (RemoteContext ignored = remote("Counter", Counter::new)) {
      assertEquals(
          "300",
          eval(
              "{ var text = \"0123456789\" * 50000 | var right = 0 |"
                  + " for| (var i = 0; i < 300; i += 1) {"
                  + "   for| (var j = 0; j < 20; j += 1) Counter.echo(j) |"
                  + "   if (i % 10 != 0 || Counter.echo(text) == text) right += 1 } |"
                  + " right }"));
    }
  }

  @Test
  void codeOfTheProcessIsExecutedMeanwhile() {
    eval("{ var Global.n = 0 | 0 }");
    try (RemoteContext ignored = remote("Counter", Counter::new)) {
      assertEquals(
          "2000",
          eval(
              "{ for| (var i = 1; i <= 2000; i += 1) Counter.code(i) |"
                  + " while (Global.n != 2000) sleep(1ms) | Global.n }"));
    }
  }

  @Test
  void severalProcessesAtATimeAndTimers() {
    eval("{ var Global.ticks = 0 | 0 }");
    client.send("every| (7ms) Global.ticks += 1,");
    try (RemoteContext one = remote("Counter", Counter::new);
        RemoteContext other = remote("Other", Counter::new)) {
      assertEquals(
          "[2000, 2000, 1, 0.1]",
          eval(
              "{ var a = 0 | var b = 0 | var t = time | var before = Global.ticks | var slow = 0 |"
                  + " { while (a < 2000) a = Counter.next } & { while (b < 2000) b = Other.next }"
                  + " & { slow = Counter.later(0.1) } |"
                  + " [a, b, ((Global.ticks - before) / ((time - t) / 7ms)).min(1).round, slow] }"));
    }
  }

  @Test
  void busyKernelNoticesThatAProcessHasEnded() {
    RemoteContext remote = remote("Counter", Counter::new);
    eval("for| (var i = 0; i < 1000; i += 1) Counter.echo(i)");
    client.send("var Global.stop = false | while (!stop) { 1 },");
    eval("for| (var i = 0; i < 100; i += 1) Counter.echo(i)");
    remote.close();
    eval("{ while (uobjects.hasLocalSlot(\"Counter\")) sleep(1ms) | Global.stop = true }");
    assertEquals("3", eval("1 + 2"));
  }

  @Test
  void processEndsDuringACall() throws Exception {
    RemoteContext remote = remote("Counter", Counter::new);
    client.send("for| (var i = 0; i < 1000; i += 1) Counter.echo(i) | var Global.hot = 1;");
    eval("{ while (!Global.hasSlot(\"hot\")) sleep(1ms) }");
    Thread.ofPlatform()
        .start(() -> {
          try {
            Thread.sleep(200);
          } catch (InterruptedException e) {
            return;
          }
          remote.close();
        });
    String failure = error("{ for| (var i = 0; i < 1000; i += 1) Counter.echo(i) | Counter.hang }");
    assertTrue(failure.contains("the remote process has gone"), failure);
    try (RemoteContext again = remote("Counter", Counter::new)) {
      assertEquals("5", eval("Counter.echo(5)"));
    }
  }

  /** Code that never lets others run: a keep-alive question is answered all the same. */
  @Test
  void busyKernelStillReadsTheConnection() throws Exception {
    try (RawProcess process = new RawProcess(server.port())) {
      client.send(
          "for| (var i = 0; i < 1000; i += 1) Raw.echo(i) |"
              + " var Global.sum = 0 | for| (var i = 0; i < 30000000; i += 1) sum += 1,");
      process.answer(1000);
      process.send(Frame.PING);
      long asked = System.nanoTime();
      assertEquals(Frame.PONG, process.receive());
      assertTrue(System.nanoTime() - asked < 10e9);
    }
  }

  @Test
  void garbageInsteadOfAnAnswer() throws Exception {
    try (RawProcess process = new RawProcess(server.port())) {
      client.send("for| (var i = 0; i < 1001; i += 1) Raw.echo(i);");
      process.answer(1000);
      assertEquals(Frame.CALL, process.receive());
      process.out.write(new byte[] {-1, -1, -1, -1, 20, 0, 0});
      process.out.flush();
      assertEquals(-1, process.in.read());
    }
    assertEquals("3", eval("1 + 2"));
  }

  /** A process with an object {@code Raw}, byte by byte. */
  private static final class RawProcess implements AutoCloseable {
    final Socket socket;
    final DataInputStream in;
    final DataOutputStream out;
    private int call;

    RawProcess(int port) throws IOException {
      socket = new Socket(HOST, port);
      socket.setTcpNoDelay(true);
      in = new DataInputStream(socket.getInputStream());
      out = new DataOutputStream(socket.getOutputStream());
      out.write(Protocol.request().getBytes(StandardCharsets.US_ASCII));
      while (in.readByte() != '\n') {
        // The server agrees.
      }
      byte[] name = "Raw".getBytes(StandardCharsets.US_ASCII);
      send(Frame.CLASS, new byte[] {0, 0, 0, 1}, text(name));
      byte[] echo = "echo".getBytes(StandardCharsets.US_ASCII);
      send(Frame.BIND, text(name), text(echo), new byte[] {1});
      send(Frame.FENCE, new byte[] {0, 0, 0, 2});
      assertEquals(Frame.REPLY, receive());
      assertEquals(Frame.REPLY, receive());
    }

    private static byte[] text(byte[] text) {
      byte[] sized = new byte[4 + text.length];
      sized[3] = (byte) text.length;
      System.arraycopy(text, 0, sized, 4, text.length);
      return sized;
    }

    void send(int type, byte[]... fields) throws IOException {
      int length = 1;
      for (byte[] field : fields) {
        length += field.length;
      }
      out.writeInt(length);
      out.writeByte(type);
      for (byte[] field : fields) {
        out.write(field);
      }
      out.flush();
    }

    /** The type of the next frame that wants something. */
    int receive() throws IOException {
      while (true) {
        byte[] frame = new byte[in.readInt()];
        in.readFully(frame);
        if (frame[0] == Frame.CALL) {
          call = new DataInputStream(new java.io.ByteArrayInputStream(frame, 1, 4)).readInt();
        }
        if (frame[0] != Frame.OUTPUT && frame[0] != Frame.TIME) {
          return frame[0];
        }
      }
    }

    /** Answers so many calls by void. */
    void answer(int calls) throws IOException {
      for (int i = 0; i < calls; i++) {
        assertEquals(Frame.CALL, receive());
        byte[] number = {(byte) (call >> 24), (byte) (call >> 16), (byte) (call >> 8), (byte) call};
        send(Frame.RESULT, number, new byte[] {0});
      }
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }
}
