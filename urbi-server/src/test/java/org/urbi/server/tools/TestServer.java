package org.urbi.server.tools;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;

/** A kernel with a network console on a free port. */
final class TestServer implements AutoCloseable {
  private final Kernel kernel = Kernel.builder().output(line -> {}).log(line -> {}).start();
  private final ConsoleServer server;

  TestServer() throws IOException {
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> kernel.connect(client, false),
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
  }

  Kernel kernel() {
    return kernel;
  }

  /** The option that has a tool connect to it. */
  String port() {
    return "--port=" + server.port();
  }

  @Override
  public void close() {
    kernel.close();
    server.close();
  }
}
