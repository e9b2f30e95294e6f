package org.urbi.server.console;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Writes what lobbies say to a stream from a thread of its own, so that the kernel does not wait
 * for a slow pipe, and many short lines become one write. Only a reader that is late by more than
 * {@link #LIMIT} bytes makes it wait: what goes to a file or a pipe is never dropped.
 */
public final class StandardOutput implements Screen {
  private static final int LIMIT = 16 << 20;

  private final OutputStream stream;
  private final Thread writer;
  private StringBuilder waiting = new StringBuilder();
  private boolean closed;
  private boolean broken;

  public StandardOutput(OutputStream stream) {
    this.stream = stream;
    writer = Thread.ofPlatform().daemon().name("urbi-output").unstarted(this::write);
    writer.start();
  }

  @Override
  public synchronized void add(String bytes) {
    while (waiting.length() > LIMIT && !broken) {
      await();
    }
    if (!broken) {
      waiting.append(bytes);
      notifyAll();
    }
  }

  /** Waits until everything has been written. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    boolean interrupted = false;
    while (writer.isAlive()) {
      try {
        writer.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void write() {
    try {
      for (String bytes = next(); bytes != null; bytes = next()) {
        stream.write(bytes.getBytes(StandardCharsets.ISO_8859_1));
        stream.flush();
      }
    } catch (IOException e) {
      synchronized (this) {
        broken = true;
        notifyAll();
      }
    }
  }

  private synchronized String next() {
    while (waiting.isEmpty()) {
      if (closed) {
        return null;
      }
      await();
    }
    String bytes = waiting.toString();
    if (waiting.capacity() > LIMIT) {
      waiting = new StringBuilder();
    }
    waiting.setLength(0);
    notifyAll();
    return bytes;
  }

  private void await() {
    try {
      wait();
    } catch (InterruptedException e) {
      broken = true;
    }
  }
}
