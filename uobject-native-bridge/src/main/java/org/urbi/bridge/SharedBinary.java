package org.urbi.bridge;

import java.util.Arrays;
import urbi.UBinary;

/**
 * A binary whose data are in C++ memory, while a variable in bypass mode is written (manual,
 * "0-copy mode"): C++ code that is notified gets their address, and Java code a copy if it looks at
 * them.
 */
final class SharedBinary implements AutoCloseable {
  /** Those that are being written, in all threads; hardly ever more than one. */
  private static volatile SharedBinary[] present = {};

  private final long address;
  private final UBinary binary;
  private boolean over;

  /** The data at an address, until {@link #close}. */
  SharedBinary(String header, long address, int size) {
    this.address = address;
    this.binary = new UBinary(header, size, () -> copy(size));
    synchronized (SharedBinary.class) {
      present = Arrays.copyOf(present, present.length + 1);
      present[present.length - 1] = this;
    }
  }

  UBinary binary() {
    return binary;
  }

  private synchronized byte[] copy(int size) {
    if (over) {
      throw new IllegalStateException(
          "the data of a binary in bypass mode are there only while it is written");
    }
    return RawMemory.getBytes(address, size);
  }

  /** Where the data of a binary are in C++ memory; 0 if they are not. */
  static long addressOf(UBinary wanted) {
    for (SharedBinary each : present) {
      if (each.binary == wanted) {
        return each.address;
      }
    }
    return 0;
  }

  @Override
  public void close() {
    synchronized (this) {
      over = true;
    }
    synchronized (SharedBinary.class) {
      SharedBinary[] rest = new SharedBinary[present.length - 1];
      int at = 0;
      for (SharedBinary each : present) {
        if (each != this) {
          rest[at++] = each;
        }
      }
      present = rest;
    }
  }
}
