package org.urbi.ros.one;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.Map;

/**
 * A connection of TCPROS: headers, and then messages with their lengths before them. One thread
 * reads, one writes.
 */
final class TcpRosConnection implements AutoCloseable {
  /** Larger than any message that is sent on purpose. */
  private static final int MAX_MESSAGE = 1 << 28;

  /** How much is read or written at a time where messages are small. */
  private static final int BUFFER = 1 << 16;

  /** So much is kept for the next message: an image of a camera, not a whole map. */
  private static final int MAX_KEPT = 1 << 25;

  /** Milliseconds in which a peer has to say the rest of what it has begun. */
  private static final int PATIENCE = 10_000;

  private static final VarHandle LITTLE_ENDIAN =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  private final Socket socket;
  private final InputStream in;
  private final OutputStream out;

  /** What has come and is not taken yet: from {@code start} to {@code end}. */
  private byte[] received = new byte[BUFFER];

  private int start;
  private int end;

  /** For how long the socket waits now, in milliseconds; 0 for as long as it takes. */
  private int limit;

  private final ByteBuffer toSend = ByteBuffer.allocate(BUFFER).order(ByteOrder.LITTLE_ENDIAN);

  /** A connection that somebody has made to us. */
  TcpRosConnection(Socket socket) throws IOException {
    this.socket = socket;
    socket.setTcpNoDelay(true);
    socket.setKeepAlive(true);
    in = socket.getInputStream();
    out = socket.getOutputStream();
  }

  /** Connects to another node. */
  static TcpRosConnection to(String host, int port) throws IOException {
    return connected(new Socket(), host, port);
  }

  /** Connects to another node by a connection that can be asked whether it {@link #isOver}. */
  static TcpRosConnection watched(String host, int port) throws IOException {
    return connected(SocketChannel.open().socket(), host, port);
  }

  private static TcpRosConnection connected(Socket socket, String host, int port)
      throws IOException {
    try {
      socket.connect(new InetSocketAddress(host, port), PATIENCE);
      return new TcpRosConnection(socket);
    } catch (IOException | IllegalArgumentException e) {
      socket.close();
      throw new IOException("no connection to " + host + ":" + port + ": " + e.getMessage(), e);
    }
  }

  void sendHeader(Map<String, String> fields) throws IOException {
    out.write(ConnectionHeader.write(fields));
  }

  Map<String, String> readHeader() throws IOException {
    return ConnectionHeader.read(read(true, ConnectionHeader.MAX_SIZE));
  }

  // ------------------------------------------------------------------ writing

  /** Writes a message; it leaves with {@link #flush}, or before. */
  void write(byte[] message) throws IOException {
    if (toSend.remaining() < Integer.BYTES) {
      flush();
    }
    toSend.putInt(message.length);
    int head = Math.min(toSend.remaining(), message.length);
    toSend.put(message, 0, head);
    if (head < message.length) {
      flush();
      int rest = message.length - head;
      if (rest < BUFFER) {
        toSend.put(message, head, rest);
      } else {
        out.write(message, head, rest);
      }
    }
  }

  void writeByte(int value) throws IOException {
    if (!toSend.hasRemaining()) {
      flush();
    }
    toSend.put((byte) value);
  }

  void flush() throws IOException {
    out.write(toSend.array(), 0, toSend.position());
    toSend.clear();
  }

  // ------------------------------------------------------------------ reading

  /**
   * Waits for a message; its rest has to come soon when it has begun. The bytes are only lent,
   * until the next is read.
   */
  ByteBuffer read() throws IOException {
    return read(false, MAX_MESSAGE);
  }

  private ByteBuffer read(boolean isDue, int most) throws IOException {
    await(Integer.BYTES, isDue);
    int length = (int) LITTLE_ENDIAN.get(received, start);
    if (length < 0 || length > most) {
      throw new IOException(
          "no TCPROS: a message or a header of " + (length & 0xFFFF_FFFFL) + " bytes");
    }
    await(Integer.BYTES + length, true);
    ByteBuffer message =
        ByteBuffer.wrap(received, start + Integer.BYTES, length).order(ByteOrder.LITTLE_ENDIAN);
    start += Integer.BYTES + length;
    return message;
  }

  /**
   * Whether the peer has closed the connection while nothing was expected of it, or has sent
   * something all the same, which nobody can tell from what will be expected. Waits for nothing.
   */
  boolean isOver() {
    SocketChannel channel = socket.getChannel();
    try {
      channel.configureBlocking(false);
      boolean isSilent = start == end && channel.read(ByteBuffer.allocate(1)) == 0;
      channel.configureBlocking(true);
      return !isSilent;
    } catch (IOException e) {
      return true;
    }
  }

  int readByte() throws IOException {
    await(1, false);
    return received[start++] & 0xFF;
  }

  /** Waits until so many bytes are there: as long as it takes, if none has to come soon. */
  private void await(int count, boolean isDue) throws IOException {
    if (end - start >= count) {
      return;
    }
    makeRoom();
    while (end < count) {
      boolean isBegun = isDue || end > 0;
      limit(isBegun ? PATIENCE : 0);
      if (end == received.length) {
        // What is said to be long takes memory only as it comes.
        received = Arrays.copyOf(received, (int) Math.min(count, 2L * end));
      }
      // Of what follows a large message nothing is read, so that it need not be moved.
      int room = (count > BUFFER ? Math.min(count, received.length) : received.length) - end;
      int read = in.read(received, end, room);
      if (read < 0) {
        throw new EOFException(
            "the peer has closed the connection" + (isBegun ? " in the middle of a message" : ""));
      }
      end += read;
    }
  }

  /** Moves what is there to the beginning. */
  private void makeRoom() {
    if (start == end && received.length > MAX_KEPT) {
      received = new byte[BUFFER];
    } else if (start > 0) {
      System.arraycopy(received, start, received, 0, end - start);
    }
    end -= start;
    start = 0;
  }

  private void limit(int milliseconds) throws IOException {
    if (milliseconds != limit) {
      limit = milliseconds;
      socket.setSoTimeout(milliseconds);
    }
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      // It is closed, one way or another.
      return;
    }
  }
}
