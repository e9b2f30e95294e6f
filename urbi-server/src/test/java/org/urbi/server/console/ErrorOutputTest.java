package org.urbi.server.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.Test;

class ErrorOutputTest {
  private static final String LINE = "x".repeat(999);

  /** A pipe that takes so much as somebody reads. */
  private static final class Pipe extends OutputStream {
    final ByteArrayOutputStream read = new ByteArrayOutputStream();
    final Semaphore writes = new Semaphore(0);

    @Override
    public void write(int octet) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void write(byte[] bytes, int from, int length) {
      writes.acquireUninterruptibly();
      read.write(bytes, from, length);
    }

    String text() {
      return read.toString(StandardCharsets.UTF_8);
    }
  }

  private final Pipe pipe = new Pipe();

  @Test
  void messagesComeOutAsTheyWere() {
    pipe.writes.release(1_000_000);
    StringBuilder expected = new StringBuilder();
    try (ErrorOutput errors = new ErrorOutput(pipe)) {
      for (int i = 0; i < 500; i++) {
        errors.messages().println(i + "é" + LINE);
        errors.drain();
        expected.append(i).append("é").append(LINE).append('\n');
      }
    }
    assertEquals(expected.toString(), pipe.text());
  }

  @Test
  void nobodyWaitsForAReaderAndLossesAreTold() {
    try (ErrorOutput errors = new ErrorOutput(pipe)) {
      for (int i = 0; i < 1000; i++) {
        errors.messages().println(LINE);
      }
      pipe.writes.release(1_000_000);
      errors.drain();
      errors.messages().println("read again");
    }
    String text = pipe.text();
    assertTrue(text.startsWith(LINE + "\n" + LINE + "\n"), text);
    assertTrue(
        text.endsWith("urbi: messages are lost here, because nobody has read them\nread again\n"),
        text.substring(Math.max(0, text.length() - 200)));
    assertTrue(text.length() < 70_000, text.length() + " bytes");
  }

  /** Memory is wanting for large pieces always, and twice for small ones. */
  @Test
  void whatCannotBeWrittenForWantOfMemoryIsWrittenLater() {
    pipe.writes.release(1_000_000);
    OutputStream scarce =
        new OutputStream() {
          private int failures;

          @Override
          public void write(int octet) {
            throw new UnsupportedOperationException();
          }

          @Override
          public void write(byte[] bytes, int from, int length) {
            if (length > 8192 || failures++ < 2) {
              throw new OutOfMemoryError("of the test");
            }
            pipe.write(bytes, from, length);
          }
        };
    String message = LINE.repeat(50);
    try (ErrorOutput errors = new ErrorOutput(scarce)) {
      errors.messages().print(message);
    }
    assertEquals(message, pipe.text());
  }

  @Test
  void streamThatFailsHoldsNobodyUp() {
    OutputStream broken =
        new OutputStream() {
          @Override
          public void write(int octet) throws IOException {
            throw new IOException("broken");
          }
        };
    try (ErrorOutput errors = new ErrorOutput(broken)) {
      for (int i = 0; i < 1000; i++) {
        errors.messages().println(LINE);
      }
      errors.drain();
    }
  }
}
