package urbi;

import static java.util.Objects.requireNonNull;
import static java.util.Objects.requireNonNullElse;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;

/**
 * A client of a server, over TCP, TLS or a Unix domain socket, see {@link ServerConnection}.
 *
 * <p>Sending returns at once, and a thread of the client's sends; only who sends much faster than
 * the server takes has to wait. Callbacks are called one after the other by another thread: none of
 * them waits for something that another has to bring, see {@link USyncClient}.
 */
// It is connected when it has been constructed: its threads know it before a subclass is complete.
@SuppressWarnings("this-escape")
public class UClient extends UAbstractClient implements AutoCloseable {
  /** How long the constructors wait for a connection. */
  public static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(10);

  private static final int MAX_WAITING = 64 << 20;
  private static final int BUFFER = 1 << 16;

  private @Nullable ServerConnection connection;
  private final CompletableFuture<Void> closed = new CompletableFuture<>();
  private final UMessageReader reader = new UMessageReader(this::received);
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final ArrayDeque<byte[]> waiting = new ArrayDeque<>();
  private int waitingBytes;
  private boolean sending;
  private boolean synchronous;
  private volatile boolean ended;
  private volatile @Nullable String failure;
  private volatile @Nullable String version;
  private @Nullable Thread readerThread;
  private @Nullable KeepAlive keepAlive;

  /** Connects to the usual port, see {@link #UClient(String, int)}. */
  public UClient(String host) {
    this(host, URBI_PORT);
  }

  /**
   * Connects. Whether that went well is to be asked by {@link #error}; {@link #connect} throws
   * instead.
   */
  public UClient(String host, int port) {
    this(host, port, CONNECT_TIMEOUT);
  }

  /** Connects, and gives up after a while; see {@link #UClient(String, int)}. */
  public UClient(String host, int port, Duration timeout) {
    super(host, port);
    ServerConnection opened;
    try {
      opened = ServerConnection.open(host, port, (int) timeout.toMillis());
    } catch (IOException e) {
      close(reason(e));
      return;
    }
    connection = opened;
    readerThread =
        GuardedThreads.SDK.virtual("urbi-client-reader", () -> read(opened.in()), this::failed);
    readerThread.start();
    GuardedThreads.SDK
        .virtual("urbi-client-writer", () -> write(opened.out()), this::failed)
        .start();
  }

  /**
   * Connects.
   *
   * @throws UClientException if nobody answers
   */
  public static UClient connect(String host, int port, Duration timeout) {
    UClient client = new UClient(host, port, timeout);
    client.requireOpen();
    return client;
  }

  private String reason(IOException e) {
    String where = ServerConnection.name(getServerName(), getServerPort());
    return e instanceof UnknownHostException
        ? "unknown host: " + getServerName()
        : "cannot connect to " + where + ": " + e.getMessage();
  }

  /**
   * Throws unless the connection is open.
   *
   * @throws UClientException that says why it is not
   */
  final void requireOpen() {
    if (ended) {
      throw new UClientException(failure == null ? "the client is closed" : failure);
    }
  }

  @Override
  public int error() {
    return ended ? 1 : 0;
  }

  /** Why the connection is not there, or no longer; null while it is. */
  public @Nullable String errorMessage() {
    return failure;
  }

  /** Completed when the connection ends, whoever ends it. */
  public CompletableFuture<Void> onClosed() {
    return closed.copy();
  }

  /** Whether sending waits until the bytes are on their way. */
  public void setSynchronousSend(boolean enable) {
    lock.lock();
    try {
      synchronous = enable;
    } finally {
      lock.unlock();
    }
  }

  @Override
  protected int effectiveSend(byte[] bytes) {
    lock.lock();
    try {
      // The thread that calls callbacks never waits: what it would wait for might need it.
      while (!ended && waitingBytes > MAX_WAITING && Thread.currentThread() != readerThread) {
        changed.awaitUninterruptibly();
      }
      if (ended) {
        return 1;
      }
      waiting.add(bytes);
      waitingBytes += bytes.length;
      changed.signalAll();
      while (synchronous && !ended && (sending || !waiting.isEmpty())) {
        changed.awaitUninterruptibly();
      }
      return ended ? 1 : 0;
    } finally {
      lock.unlock();
    }
  }

  private void write(OutputStream out) {
    try {
      for (byte[] bytes = next(); bytes != null; bytes = next()) {
        out.write(bytes);
      }
    } catch (IOException e) {
      close("connection lost: " + e.getMessage());
    }
  }

  /** The next bytes to send, once those before have been sent; null at the end. */
  private byte @Nullable [] next() {
    lock.lock();
    try {
      sending = false;
      changed.signalAll();
      while (waiting.isEmpty() && !ended) {
        changed.awaitUninterruptibly();
      }
      if (ended) {
        return null;
      }
      byte[] bytes = waiting.poll();
      waitingBytes -= bytes.length;
      sending = true;
      return bytes;
    } finally {
      lock.unlock();
    }
  }

  private void read(InputStream in) {
    byte[] buffer = new byte[BUFFER];
    try {
      for (int size = in.read(buffer); size >= 0; size = in.read(buffer)) {
        alive();
        reader.feed(buffer, 0, size);
      }
      close("the server has closed the connection");
    } catch (IOException e) {
      close("connection lost: " + e.getMessage());
    } catch (UParseException e) {
      close("this is no Urbi server: " + e.getMessage());
    }
  }

  /** Something has come from the server. */
  private void alive() {
    KeepAlive check = keepAlive;
    if (check != null) {
      check.alive();
    }
  }

  /**
   * Asks the server at intervals whether it is there, and closes the connection when it does not
   * answer.
   *
   * @param pingInterval milliseconds without a word from the server before it is asked; 0 for never
   * @param pongTimeout milliseconds that it has for the answer
   */
  public synchronized void setKeepAliveCheck(int pingInterval, int pongTimeout) {
    if (keepAlive != null) {
      keepAlive.stop();
      keepAlive = null;
    }
    if (pingInterval > 0 && !ended) {
      keepAlive =
          new KeepAlive(
              pingInterval,
              pongTimeout,
              () -> send("lobby.send(\"\", \"URBI_pong\");\n"),
              () -> close("the server does not answer within " + pongTimeout + " ms"),
              this::failed);
    }
  }

  /** The version of the server, as {@code 3.0.0}; waits for the answer. */
  public String kernelVersion() {
    waitForKernelVersion();
    return requireNonNull(version, "it was waited for");
  }

  /** The first number of the version of the server. */
  public int kernelMajor() {
    return versionPart(0);
  }

  /** The second number of the version of the server. */
  public int kernelMinor() {
    return versionPart(1);
  }

  private int versionPart(int index) {
    String[] parts = kernelVersion().split("\\D+");
    return index < parts.length && !parts[index].isEmpty() ? Integer.parseInt(parts[index]) : 0;
  }

  /**
   * Waits until the version of the server is known. Not to be called in a callback.
   *
   * @throws UClientException if it does not answer
   */
  public void waitForKernelVersion() {
    if (version == null) {
      version = ask("System.version", CONNECT_TIMEOUT).getValue().stringValue();
    }
  }

  /** What identifies this connection in the server: the name of its lobby. */
  public String connectionID() {
    return ask("lobby.uid", CONNECT_TIMEOUT).getValue().stringValue();
  }

  /** The first message of the answer to an expression. */
  UMessage ask(String expression, Duration timeout) {
    var answer = new CompletableFuture<UMessage>();
    int callback =
        sendCommand(
            message -> {
              answer.complete(message);
              return UCallbackAction.URBI_REMOVE;
            },
            "%s",
            expression);
    try {
      return await(answer, expression, timeout);
    } finally {
      deleteCallback(callback);
    }
  }

  /** Waits for an answer, for the end of the connection, or for some time. */
  final <T> T await(CompletableFuture<T> answer, String question, Duration timeout) {
    if (Thread.currentThread() == readerThread) {
      throw new UClientException("a callback cannot wait for the answer to: " + question);
    }
    try {
      CompletableFuture<Object> first = CompletableFuture.anyOf(answer, closed);
      if (timeout.isZero()) {
        first.get();
      } else {
        first.get(timeout.toNanos(), TimeUnit.NANOSECONDS);
      }
    } catch (TimeoutException e) {
      throw new UClientException(
          "no answer within " + timeout.toMillis() + " ms to: " + question, e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new UClientException("interrupted while waiting for the answer to: " + question, e);
    } catch (ExecutionException e) {
      Throwable cause = requireNonNullElse(e.getCause(), e);
      throw new UClientException(cause.getMessage(), cause);
    }
    if (!answer.isDone()) {
      throw new UClientException(
          (failure == null ? "the client is closed" : failure)
              + " before the answer to: "
              + question);
    }
    return answer.join();
  }

  /** Closes the connection; 0. */
  public int closeUClient() {
    close();
    return 0;
  }

  @Override
  public void close() {
    close(null);
  }

  /** One of its threads has met a defect, so that whoever waits for it would wait for ever. */
  final void failed(Throwable defect) {
    close(InternalFailure.text(defect));
  }

  private void close(@Nullable String why) {
    lock.lock();
    try {
      if (ended) {
        return;
      }
      failure = why;
      ended = true;
      waiting.clear();
      waitingBytes = 0;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
    setKeepAliveCheck(0, 0);
    try {
      if (connection != null) {
        connection.close();
      }
    } catch (IOException e) {
      // There is nothing left to be closed.
    }
    try {
      if (why != null) {
        clientError(why);
      }
    } finally {
      closed.complete(null);
    }
  }
}
