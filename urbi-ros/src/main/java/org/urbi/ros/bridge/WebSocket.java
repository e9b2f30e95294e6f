package org.urbi.ros.bridge;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/**
 * The server's end of a WebSocket (RFC 6455), to which texts come. One thread reads; any may write.
 * Memory is taken for what has come, never for what is announced.
 */
final class WebSocket implements AutoCloseable {
  /** How many bytes a message of a client may have. */
  static final int LONGEST = 32 << 20;

  /**
   * A client that says nothing for so many milliseconds is asked whether it is still there; if it
   * is silent again, it is let go.
   */
  private static final int SILENCE = 20_000;

  private static final int CHUNK = 1 << 16;
  private static final int CONTINUED = 0;
  private static final int TEXT = 1;
  private static final int BINARY = 2;
  private static final int CLOSE = 8;
  private static final int PING = 9;
  private static final int PONG = 10;
  private static final int PROTOCOL_ERROR = 1002;
  private static final int NOT_TEXT = 1003;
  private static final int NOT_UTF = 1007;
  private static final int TOO_LONG = 1009;
  private static final int DEFECT = 1011;

  private final Socket socket;
  private final InputStream in;
  private final OutputStream out;
  private boolean asked;

  WebSocket(Socket socket, InputStream in, OutputStream out) throws IOException {
    this.socket = socket;
    this.in = in;
    this.out = out;
    socket.setSoTimeout(SILENCE);
  }

  /** The client does not keep to the protocol: the status with which it is let go. */
  private static final class Violation extends IOException {
    final int status;

    Violation(int status, String message) {
      super(message);
      this.status = status;
    }
  }

  /**
   * The next message; null when the client has said good-bye.
   *
   * @throws IOException if it goes without that, is silent, or breaks the protocol
   */
  @Nullable String read() throws IOException {
    try {
      return message();
    } catch (Violation e) {
      sayGoodBye(e.status, String.valueOf(e.getMessage()));
      throw e;
    } catch (RuntimeException | Error e) {
      sayGoodBye(DEFECT, "internal error");
      throw e;
    }
  }

  private @Nullable String message() throws IOException {
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    boolean begun = false;
    while (true) {
      int first = firstByte();
      int kind = first & 0xF;
      boolean last = (first & 0x80) != 0;
      if ((first & 0x70) != 0) {
        throw new Violation(PROTOCOL_ERROR, "no extensions are in use");
      }
      int second = next();
      if ((second & 0x80) == 0) {
        throw new Violation(PROTOCOL_ERROR, "clients mask what they send");
      }
      long length = length(second & 0x7F);
      if (kind >= CLOSE) {
        if (!last || length > 125) {
          throw new Violation(PROTOCOL_ERROR, "control frames are short");
        }
        ByteArrayOutputStream control = new ByteArrayOutputStream();
        payload(length, control);
        if (kind == CLOSE) {
          sayGoodBye(1000, "");
          return null;
        }
        if (kind == PING) {
          write(PONG, control.toByteArray());
        }
        continue;
      }
      if (kind == BINARY) {
        throw new Violation(NOT_TEXT, "text expected: this is a server of JSON");
      }
      if (kind > BINARY || begun != (kind == CONTINUED)) {
        throw new Violation(PROTOCOL_ERROR, "a frame out of place");
      }
      if (length > LONGEST - message.size()) {
        throw new Violation(TOO_LONG, "messages have " + LONGEST + " bytes at most");
      }
      begun = true;
      payload(length, message);
      if (last) {
        return text(message.toByteArray());
      }
    }
  }

  private static String text(byte[] bytes) throws Violation {
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    } catch (CharacterCodingException e) {
      throw new Violation(NOT_UTF, "UTF-8 expected");
    }
  }

  /** Waits for a frame; who is silent is asked whether it is there. */
  private int firstByte() throws IOException {
    while (true) {
      try {
        int first = next();
        asked = false;
        return first;
      } catch (SocketTimeoutException e) {
        if (asked) {
          throw e;
        }
        asked = true;
        write(PING, new byte[0]);
      }
    }
  }

  private int next() throws IOException {
    int next = in.read();
    if (next < 0) {
      throw new EOFException("the client has gone");
    }
    return next;
  }

  private long length(int brief) throws IOException {
    int bytes = brief == 126 ? 2 : brief == 127 ? 8 : 0;
    long length = bytes == 0 ? brief : 0;
    for (int i = 0; i < bytes; i++) {
      length = length << 8 | next();
    }
    if (length < 0) {
      throw new Violation(PROTOCOL_ERROR, "no such length");
    }
    return length;
  }

  private void payload(long length, ByteArrayOutputStream to) throws IOException {
    byte[] mask = in.readNBytes(4);
    long done = 0;
    while (done < length) {
      byte[] chunk = in.readNBytes((int) Math.min(CHUNK, length - done));
      if (chunk.length == 0 || mask.length < 4) {
        throw new EOFException("the client has gone in the middle of a message");
      }
      // A chunk is a multiple of four bytes, unless it is the last one.
      for (int i = 0; i < chunk.length; i++) {
        chunk[i] ^= mask[i & 3];
      }
      to.write(chunk);
      done += chunk.length;
    }
  }

  /** A message of ours. */
  record Frame(int kind, byte[] payload) {
    static Frame text(String text) {
      return new Frame(TEXT, text.getBytes(StandardCharsets.UTF_8));
    }

    static Frame binary(byte[] bytes) {
      return new Frame(BINARY, bytes);
    }

    int size() {
      return payload.length;
    }
  }

  /** Sends a message; waits until the system has taken it. */
  void send(Frame message) throws IOException {
    write(message.kind, message.payload);
  }

  private void write(int kind, byte[] payload) throws IOException {
    ByteBuffer head = ByteBuffer.allocate(10).put((byte) (0x80 | kind));
    if (payload.length < 126) {
      head.put((byte) payload.length);
    } else if (payload.length <= 0xFFFF) {
      head.put((byte) 126).putShort((short) payload.length);
    } else {
      head.put((byte) 127).putLong(payload.length);
    }
    synchronized (out) {
      out.write(head.array(), 0, head.position());
      out.write(payload);
      out.flush();
    }
  }

  private void sayGoodBye(int status, String reason) throws IOException {
    byte[] text = reason.getBytes(StandardCharsets.UTF_8);
    write(CLOSE, ByteBuffer.allocate(2 + text.length).putShort((short) status).put(text).array());
  }

  /** Ends it at once, whoever waits in it. */
  @Override
  public void close() throws IOException {
    socket.close();
  }
}
