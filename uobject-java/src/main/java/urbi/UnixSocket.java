package urbi;

import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.util.concurrent.TimeUnit;
import urbi.time.Stopwatch;

/**
 * A connection by a Unix domain socket. The JDK has a channel for that alone, which has no time
 * limits and is closed when a thread that uses it is interrupted; this has the former, and is not.
 */
final class UnixSocket extends Socket {
  /** How long one waits that finds the queue of the server full. */
  private static final long RETRY_MILLISECONDS = 10;

  private final SocketChannel channel;
  private final Selector readable = Selector.open();
  private final Selector writable = Selector.open();
  private volatile int timeout;

  private UnixSocket(SocketChannel channel) throws IOException {
    this.channel = channel;
    channel.register(readable, SelectionKey.OP_READ);
    channel.register(writable, SelectionKey.OP_WRITE);
  }

  /**
   * Connects.
   *
   * @param milliseconds how long that may take; 0 for as long as it likes
   * @throws IOException if nobody listens there, or does not let anybody in
   */
  static UnixSocket connect(String file, int milliseconds) throws IOException {
    UnixDomainSocketAddress address = UnixDomainSocketAddress.of(file);
    Stopwatch waited = new Stopwatch();
    while (true) {
      SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX);
      try {
        channel.configureBlocking(false);
        channel.connect(address);
        return new UnixSocket(channel);
      } catch (IOException e) {
        channel.close();
        if (e instanceof ConnectException || !Files.isWritable(address.getPath())) {
          throw e;
        }
        // The queue of the server is full, for which Java has no exception of its own.
      }
      if (milliseconds > 0 && waited.elapsed(TimeUnit.MILLISECONDS) > milliseconds) {
        throw new SocketTimeoutException("connect timed out");
      }
      pause();
    }
  }

  private static void pause() throws IOException {
    try {
      Thread.sleep(RETRY_MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while connecting");
    }
  }

  @Override
  public InputStream getInputStream() {
    return new InputStream() {
      @Override
      public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one) < 0 ? -1 : one[0] & 0xff;
      }

      @Override
      public int read(byte[] bytes, int from, int length) throws IOException {
        return length == 0 ? 0 : receive(ByteBuffer.wrap(bytes, from, length));
      }
    };
  }

  @Override
  public OutputStream getOutputStream() {
    return new OutputStream() {
      @Override
      public void write(int octet) throws IOException {
        write(new byte[] {(byte) octet});
      }

      @Override
      public void write(byte[] bytes, int from, int length) throws IOException {
        send(ByteBuffer.wrap(bytes, from, length));
      }
    };
  }

  private int receive(ByteBuffer space) throws IOException {
    try {
      int size = channel.read(space);
      while (size == 0) {
        await(readable, timeout);
        size = channel.read(space);
      }
      return size;
    } catch (ClosedChannelException | ClosedSelectorException e) {
      throw closed(e);
    }
  }

  private void send(ByteBuffer bytes) throws IOException {
    try {
      channel.write(bytes);
      while (bytes.hasRemaining()) {
        await(writable, 0);
        channel.write(bytes);
      }
    } catch (ClosedChannelException | ClosedSelectorException e) {
      throw closed(e);
    }
  }

  private static SocketException closed(Exception e) {
    return new SocketException("Socket closed", e);
  }

  /** Waits. If the thread was interrupted it still is afterwards, for whoever looks at that. */
  private static void await(Selector selector, int milliseconds) throws IOException {
    boolean interrupted = Thread.interrupted();
    try {
      boolean ready = selector.select(key -> {}, milliseconds) > 0;
      if (!ready && milliseconds > 0 && !Thread.currentThread().isInterrupted()) {
        throw new SocketTimeoutException("Read timed out");
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** The server is on this machine. */
  @Override
  public InetAddress getInetAddress() {
    return InetAddress.getLoopbackAddress();
  }

  @Override
  public void setSoTimeout(int milliseconds) {
    timeout = milliseconds;
  }

  @Override
  public void close() throws IOException {
    // Else who waits in one of them would not notice.
    readable.close();
    writable.close();
    channel.close();
  }
}
