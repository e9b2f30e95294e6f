package urbi.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.ObjIntConsumer;
import org.junit.jupiter.api.Test;
import urbi.spi.ComponentFailureLog;
import urbi.thread.Awaited;

/** Datagrams that make no sense, or meet a defect. */
class DatagramReceiverTest {
  private final List<String> logged = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Integer> last = new CompletableFuture<>();
  private final CompletableFuture<Void> broken = new CompletableFuture<>();

  private void take(byte[] bytes, int length) {
    switch (bytes[0]) {
      case 1 -> throw new IllegalStateException("malformed");
      case 2 -> throw new NoClassDefFoundError("lost");
      default -> last.complete(length);
    }
  }

  @Test
  void doNotEndTheReceiving() throws Exception {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        DatagramSocket sender = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      ObjIntConsumer<byte[]> session = this::take;
      var receiver =
          new DatagramReceiver(
              socket, session, () -> broken.complete(null), new ComponentFailureLog(logged::add));
      Thread thread = Thread.ofVirtual().start(receiver);
      for (byte[] bytes : List.of(new byte[] {1}, new byte[] {1}, new byte[] {2}, new byte[3])) {
        sender.send(new DatagramPacket(bytes, bytes.length, socket.getLocalSocketAddress()));
      }
      assertEquals(3, Awaited.value(last));
      // The same one twice has one stack.
      assertEquals(2, logged.size(), logged::toString);
      assertTrue(logged.getFirst().contains("malformed\n\tat "), logged::toString);
      socket.close();
      Awaited.end(thread);
      assertFalse(broken.isDone());
    }
  }
}
