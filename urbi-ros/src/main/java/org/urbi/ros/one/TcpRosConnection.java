package org.urbi.ros.one;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.Map;

/** A connection of TCPROS: headers, and then messages with their lengths before them. */
final class TcpRosConnection implements AutoCloseable {
  /** Larger than any message that is sent on purpose. */
  private static final int MAX_MESSAGE = 1 << 28;

  private static final int BUFFER = 1 << 16;

  /** Milliseconds in which a peer has to say the rest of what it has begun. */
  private static final int PATIENCE = 10_000;

  private final Socket socket;
  private final DataInputStream in;
  private final OutputStream out;

  /** A connection that somebody has made to us. */
  TcpRosConnection(Socket socket) throws IOException {
    this.socket = socket;
    socket.setTcpNoDelay(true);
    socket.setKeepAlive(true);
    in = new DataInputStream(new BufferedInputStream(socket.getInputStream(), BUFFER));
    out = new BufferedOutputStream(socket.getOutputStream(), BUFFER);
  }

  /** Connects to another node. */
  static TcpRosConnection to(String host, int port) throws IOException {
    Socket socket = new Socket();
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
    out.flush();
  }

  Map<String, String> readHeader() throws IOException {
    socket.setSoTimeout(PATIENCE);
    Map<String, String> header = ConnectionHeader.read(in);
    socket.setSoTimeout(0);
    return header;
  }

  /** Writes a message; it leaves with {@link #flush}, or before. */
  void write(byte[] message) throws IOException {
    int length = message.length;
    out.write(length);
    out.write(length >> 8);
    out.write(length >> 16);
    out.write(length >> 24);
    out.write(message);
  }

  void writeByte(int value) throws IOException {
    out.write(value);
  }

  void flush() throws IOException {
    out.flush();
  }

  /** Waits for a message; its rest has to come soon when it has begun. */
  byte[] read() throws IOException {
    int length = in.read();
    if (length < 0) {
      throw new EOFException("the peer has closed the connection");
    }
    socket.setSoTimeout(PATIENCE);
    for (int shift = 8; shift < 32; shift += 8) {
      length |= in.readUnsignedByte() << shift;
    }
    if (length < 0 || length > MAX_MESSAGE) {
      throw new IOException("a message of " + (length & 0xFFFF_FFFFL) + " bytes");
    }
    // What is said to be long takes memory only as it comes.
    byte[] message = in.readNBytes(length);
    if (message.length < length) {
      throw new EOFException("the peer has closed the connection in the middle of a message");
    }
    socket.setSoTimeout(0);
    return message;
  }

  int readByte() throws IOException {
    return in.readUnsignedByte();
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
