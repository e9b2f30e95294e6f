package org.urbi.bridge;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import urbi.UBinary;

/**
 * The data of a binary in C++ memory, while a variable in bypass mode is written (manual, "0-copy
 * mode"): C++ code that is notified gets their address, and Java code a copy if it looks at them.
 */
final class SharedBinary implements Supplier<byte[]>, AutoCloseable {
  private static final int OVER = -1;

  private final HeaderCache header;
  private final long address;
  private final int size;

  /** How many threads copy the data, or {@link #OVER}. */
  private final AtomicInteger copying = new AtomicInteger();

  /** The data at an address, until {@link #close}. */
  SharedBinary(HeaderCache header, long address, int size) {
    this.header = header;
    this.address = address;
    this.size = size;
  }

  UBinary binary() {
    return new UBinary(header.text(), size, this);
  }

  @Override
  public byte[] get() {
    if (copying.getAndUpdate(threads -> threads == OVER ? OVER : threads + 1) == OVER) {
      throw new IllegalStateException(
          "the data of a binary in bypass mode are there only while it is written");
    }
    try {
      return RawMemory.getBytes(address, size);
    } finally {
      copying.decrementAndGet();
    }
  }

  /** The one that a binary is; null if its data are not in C++ memory, or no longer. */
  static @Nullable SharedBinary of(UBinary binary) {
    return binary.source() instanceof SharedBinary shared && shared.copying.get() != OVER
        ? shared
        : null;
  }

  HeaderCache header() {
    return header;
  }

  long address() {
    return address;
  }

  /** Waits for those who copy the data. */
  @Override
  public void close() {
    while (!copying.compareAndSet(0, OVER)) {
      Thread.onSpinWait();
    }
  }
}
