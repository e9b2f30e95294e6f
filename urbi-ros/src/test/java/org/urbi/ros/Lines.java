package org.urbi.ros;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** The lines that a program prints, each of which is waited for in a limited time. */
public final class Lines {
  /** In its place comes the end. */
  private static final String END = "(it has ended)";

  private final CountDownLatch ended = new CountDownLatch(1);
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
  private final List<String> seen = new ArrayList<>();

  /** Those of that output. It is read at once, so that the program never waits. */
  public Lines(BufferedReader output) {
    // A virtual thread that waits for a pipe keeps others from running, on a small machine all.
    Thread.ofPlatform().daemon().start(() -> read(output));
  }

  private void read(BufferedReader output) {
    try (output) {
      for (String line = output.readLine(); line != null; line = output.readLine()) {
        lines.add(line);
      }
    } catch (IOException e) {
      lines.add(String.valueOf(e.getMessage()));
    } finally {
      lines.add(END);
      ended.countDown();
    }
  }

  /** The next one. */
  public String next() throws InterruptedException {
    String line = Awaited.next(lines, seen);
    if (line.equals(END)) {
      lines.add(END);
      throw new AssertionError("the program has ended; it said: " + seen);
    }
    seen.add(line);
    return line;
  }

  /** The next one is that; if it is another, the failure has all that the program printed. */
  public void says(String expected) throws InterruptedException {
    String line = next();
    if (!line.equals(expected)) {
      // What a program says when it fails has many lines, and then it ends.
      endWithin(2, TimeUnit.SECONDS);
      lines.drainTo(seen);
      throw new AssertionError("expected: " + expected + "; it said: " + String.join("\n", seen));
    }
  }

  /** Waits for a line that begins so. */
  public void await(String beginning) throws InterruptedException {
    while (!next().startsWith(beginning)) {}
  }

  /** Whether the program ends in that time. */
  public boolean endWithin(long time, TimeUnit unit) throws InterruptedException {
    return ended.await(time, unit);
  }

  /** All that are left, when the program has ended. */
  public List<String> rest() throws InterruptedException {
    List<String> rest = new ArrayList<>();
    for (String line = Awaited.next(lines, rest); !line.equals(END); ) {
      rest.add(line);
      line = Awaited.next(lines, rest);
    }
    lines.add(END);
    return rest;
  }
}
