package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;
import urbi.USlot;
import urbi.UValue;
import urbi.remote.RemoteContext;
import urbi.wire.Frame;
import urbi.wire.WireOutput;

/** What a process makes of frames that come at once. */
class RemoteOrderTest {
  /** Agrees; answers whoever opens a variable that it is 1, and tells at once that it became 2. */
  private static void serve(ServerSocket listener) {
    try (Socket socket = listener.accept()) {
      var in = new DataInputStream(socket.getInputStream());
      while (in.readByte() != '\n') {
        // The process asks for the protocol.
      }
      socket
          .getOutputStream()
          .write("[00000000:uobject] 1 test\n".getBytes(StandardCharsets.US_ASCII));
      while (true) {
        byte[] frame = new byte[in.readInt()];
        in.readFully(frame);
        if (frame[0] == Frame.OPEN) {
          int question = ByteBuffer.wrap(frame).getInt(1);
          int variable = ByteBuffer.wrap(frame).getInt(5);
          socket
              .getOutputStream()
              .write(
                  new WireOutput(100)
                      .begin(Frame.REPLY)
                      .size(question)
                      .value(new UValue(1))
                      .end()
                      .begin(Frame.CHANGED)
                      .size(variable)
                      .number(5)
                      .value(new UValue(2))
                      .end()
                      .toBytes());
        }
      }
    } catch (IOException e) {
      // The process has gone.
    }
  }

  @Test
  void changeRightAfterTheFirstValueIsReceived() throws Exception {
    try (ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread.ofPlatform().daemon().start(() -> serve(listener));
      try (RemoteContext context = new RemoteContext("127.0.0.1", listener.getLocalPort())) {
        for (int i = 0; i < 100; i++) {
          USlot slot = context.variable("x.y" + i);
          long end = System.nanoTime() + TestTimeout.LONG.toNanos();
          while (slot.get().intValue() != 2 && System.nanoTime() < end) {
            Thread.sleep(5);
          }
          assertEquals(2, slot.get().intValue());
        }
      }
    }
  }
}
