package org.urbi.bench.remote;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import urbi.UClass;
import urbi.UModule;
import urbi.remote.RemoteContext;

/** The other process: a UObject, and a bare echo. */
public final class ComponentProcess {
  private ComponentProcess() {}

  /** Connects to the server on a port, and says on which port it echoes. */
  public static void main(String[] arguments) throws IOException {
    ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    Thread.ofPlatform().daemon().start(() -> echoAll(listener));
    var context = new RemoteContext("127.0.0.1", Integer.parseInt(arguments[0]));
    context.start(new UClass("Component", new UModule("bench"), Component::new));
    System.out.println(listener.getLocalPort());
    context.onClosed().join();
  }

  private static void echoAll(ServerSocket listener) {
    byte[] buffer = new byte[1 << 16];
    try (Socket socket = listener.accept()) {
      socket.setTcpNoDelay(true);
      InputStream in = socket.getInputStream();
      OutputStream out = socket.getOutputStream();
      for (int size = in.read(buffer); size > 0; size = in.read(buffer)) {
        out.write(buffer, 0, size);
      }
    } catch (IOException e) {
      // The other side has gone.
    }
  }
}
