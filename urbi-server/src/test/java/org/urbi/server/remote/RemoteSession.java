package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClass;
import urbi.UClientException;
import urbi.UModule;
import urbi.USyncClient;
import urbi.remote.RemoteContext;

/** A kernel with a server, a remote process that is this one, and a client. */
abstract class RemoteSession {
  static final String HOST = "127.0.0.1";

  Kernel kernel;
  ConsoleServer server;
  RemoteContext remote;
  USyncClient client;

  /** What the kernel has put into its log. */
  final BlockingQueue<String> log = new LinkedBlockingQueue<>();

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().log(log::add).start();
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            each -> kernel.connect(each, false),
            kernel::connectRemote,
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
    remote = new RemoteContext(HOST, server.port());
    client = USyncClient.connect(HOST, server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
  }

  @AfterEach
  void stop() {
    client.close();
    remote.close();
    kernel.close();
    server.close();
  }

  static UClass type(String name, UClass.Factory factory) {
    return new UClass(name, new UModule("test"), factory);
  }

  String eval(String expression) {
    return client.syncEval(expression).toString();
  }

  String error(String expression) {
    String message =
        assertThrows(UClientException.class, () -> client.syncEval(expression)).getMessage();
    return message.replaceFirst("^[\\d.-]*: ", "");
  }
}
