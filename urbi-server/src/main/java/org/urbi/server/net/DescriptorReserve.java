package org.urbi.server.net;

import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;

/**
 * The file descriptors that clients leave to the rest of the process: files that programs open,
 * processes, the classes that the JVM has not loaded yet. Java does not tell how many are left
 * without listing them all; so it is tried, now and then, whether so many could be had.
 */
final class DescriptorReserve {
  private static final int LEFT_TO_OTHERS = 24;

  /** So many clients may come between two trials. */
  private static final int CLIENTS_PER_TRIAL = 8;

  private int unseen;

  /** Whether one client more leaves enough to the others. */
  boolean admitsOne() {
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
