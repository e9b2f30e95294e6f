package urbi.remote;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.PortUnreachableException;
import java.util.function.ObjIntConsumer;
import urbi.spi.ComponentFailureLog;

/** Receives datagrams until the socket is closed: none of them ends that, whatever it holds. */
final class DatagramReceiver implements Runnable {
  private static final int MAX_SIZE = 1 << 16;

  private final DatagramSocket socket;
  private final ObjIntConsumer<byte[]> session;
  private final Runnable broken;
  private final ComponentFailureLog failureLog;

  /**
   * @param session is given the bytes, which stay those of the receiver, and how many they are
   * @param broken is told when nothing can be received any more
   */
  DatagramReceiver(
      DatagramSocket socket,
      ObjIntConsumer<byte[]> session,
      Runnable broken,
      ComponentFailureLog failureLog) {
    this.socket = socket;
    this.session = session;
    this.broken = broken;
    this.failureLog = failureLog;
  }

  @Override
  public void run() {
    byte[] bytes = new byte[MAX_SIZE];
    while (!socket.isClosed()) {
      try {
        DatagramPacket packet = new DatagramPacket(bytes, bytes.length);
        socket.receive(packet);
        take(bytes, packet.getLength());
      } catch (PortUnreachableException e) {
        // Nobody listens there now; probes and reports that do not come tell the same.
      } catch (IOException e) {
        if (!socket.isClosed()) {
          broken.run();
          return;
        }
      }
    }
  }

  private void take(byte[] bytes, int length) {
    try {
      session.accept(bytes, length);
    } catch (RuntimeException | Error e) {
      failureLog.log("a datagram of the server", e);
    }
  }
}
