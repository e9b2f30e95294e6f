package org.urbi.server.net;

import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;

/**
 * Reserves file descriptors for the rest of the process: files that programs open, processes,
 * classes that the JVM has yet to load. Java cannot tell how many descriptors are free without
 * listing all of them, so this class tries at intervals whether it can open the reserved number.
 */
final class DescriptorReserve {
  private static final int LEFT_TO_OTHERS = 24;

  /** The number of clients between two trials. */
  private static final int CLIENTS_PER_TRIAL = 8;

  private int unseen;

  /** Whether enough descriptors are left after one more client. */
  boolean allowsOneMore() {
    if (unseen == 0 && !canOpen(LEFT_TO_OTHERS + CLIENTS_PER_TRIAL)) {
      return false;
    }
    unseen = (unseen + 1) % CLIENTS_PER_TRIAL;
    return true;
  }

  private static boolean canOpen(int number) {
    List<SocketChannel> opened = new ArrayList<>(number);
    try {
      for (int i = 0; i < number; i++) {
        opened.add(SocketChannel.open());
      }
      return true;
    } catch (IOException e) {
      return false;
    } finally {
      opened.forEach(DescriptorReserve::close);
    }
  }

  private static void close(SocketChannel socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // It was never connected: there is nothing to lose.
    }
  }
}
