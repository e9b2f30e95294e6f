package org.urbi.kernel.outside;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What comes over a socket is read together if it comes together. */
class GatheringStreamTest {
  private static final String END = "end";
  private static final String RESET = "reset";
  private static final String NOTHING = "nothing for a while";

  /** A socket to which comes what was said, in which order; it never really waits. */
  private static final class ScriptedSocket extends Socket {
    private final Deque<String> coming;
    private int limit;

    ScriptedSocket(String... coming) {
      this.coming = new ArrayDeque<>(List.of(coming));
    }

    @Override
    public void setSoTimeout(int milliseconds) {
      limit = milliseconds;
    }

    @Override
    public InputStream getInputStream() {
      return new InputStream() {
        @Override
        public int read() {
          throw new UnsupportedOperationException();
        }

        @Override
        public int read(byte[] bytes, int from, int length) throws IOException {
          String next = coming.remove();
          if (next.equals(NOTHING)) {
            if (limit > 0) {
              throw new SocketTimeoutException();
            }
            return read(bytes, from, length);
          }
          if (next.equals(RESET)) {
            coming.push(RESET);
            throw new SocketException("Connection reset");
          }
          if (next.equals(END)) {
            coming.push(END);
            return -1;
          }
          System.arraycopy(next.getBytes(US_ASCII), 0, bytes, from, next.length());
          return next.length();
        }
      };
    }
  }

  /** What the readings give, one after the other, up to the end. */
  private static List<String> readings(int room, String... coming) throws IOException {
    List<String> all = new ArrayList<>();
    try (GatheringStream stream = new GatheringStream(new ScriptedSocket(coming))) {
      byte[] bytes = new byte[room];
      int length;
      while ((length = stream.read(bytes)) >= 0) {
        all.add(new String(bytes, 0, length, US_ASCII));
      }
    }
    return all;
  }

  @Test
  void whatComesTogetherIsReadTogether() throws IOException {
    assertEquals(List.of("off"), readings(8, "o", "ff", NOTHING, END));
  }

  @Test
  void theEndIsKnownBeforeTheLastDataAreTold() throws IOException {
    ScriptedSocket socket = new ScriptedSocket("off", END);
    try (GatheringStream stream = new GatheringStream(socket)) {
      assertEquals(3, stream.read(new byte[8]));
      assertEquals(List.of(END), List.copyOf(socket.coming));
      assertEquals(-1, stream.read(new byte[8]));
    }
  }

  @Test
  void whatCameBeforeTheConnectionBrokeIsNotLost() throws IOException {
    try (GatheringStream stream = new GatheringStream(new ScriptedSocket("off", RESET))) {
      assertEquals(3, stream.read(new byte[8]));
      assertThrows(SocketException.class, () -> stream.read(new byte[8]));
    }
  }

  @Test
  void aPauseEndsWhatIsReadTogether() throws IOException {
    assertEquals(List.of("one", "two"), readings(8, "one", NOTHING, NOTHING, "two", NOTHING, END));
  }

  @Test
  void whatDripsInIsNotKeptForLong() throws IOException {
    assertEquals(List.of("123", "4"), readings(8, "1", "2", "3", "4", NOTHING, END));
  }

  @Test
  void whatIsFullDoesNotWait() throws IOException {
    assertEquals(List.of("abcd", "efgh"), readings(4, "abcd", "efgh", END));
  }
}
