package urbi;

import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;
import urbi.time.Stopwatch;

/**
 * A client that also asks and waits for the answer. That may be done in callbacks, too: they are
 * called by a thread of their own, or, once {@link #stopCallbackThread} was called, by {@link
 * #processEvents}.
 *
 * <p>All methods that wait throw {@link UClientException}: with the server's words when what it was
 * asked is an error, and when the connection ends or the time is over. A time of zero is no limit.
 */
// It is connected when it has been constructed: its threads know it before a subclass is complete.
@SuppressWarnings("this-escape")
public class USyncClient extends UClient {
  private final UMessage end =
      new UMessage(this, 0, "", UMessageType.MESSAGE_SYSTEM, new byte[0], false);
  private static final Duration FOREVER = Duration.ZERO;

  private final BlockingQueue<UMessage> queue = new LinkedBlockingQueue<>();
  private final Queue<Question> questions = new ConcurrentLinkedQueue<>();
  private volatile boolean synchronous;
  private Duration timeout = FOREVER;
  private Thread callbackThread;

  /** Connects to the usual port, see {@link UClient#UClient(String, int)}. */
  public USyncClient(String host) {
    this(host, URBI_PORT);
  }

  /** Connects, see {@link UClient#UClient(String, int)}. */
  public USyncClient(String host, int port) {
    this(host, port, CONNECT_TIMEOUT);
  }

  /** Connects, see {@link UClient#UClient(String, int, Duration)}. */
  public USyncClient(String host, int port, Duration timeout) {
    super(host, port, timeout);
    callbackThread =
        GuardedThreads.SDK.virtual("urbi-client-callbacks", this::callbackThread, this::failed);
    callbackThread.start();
    onClosed().thenRun(() -> queue.add(end));
  }

  /**
   * Connects.
   *
   * @throws UClientException if nobody answers
   */
  public static USyncClient connect(String host, int port, Duration timeout) {
    USyncClient client = new USyncClient(host, port, timeout);
    client.requireOpen();
    return client;
  }

  /** How long questions wait for their answers when they do not say; at first, without limit. */
  public void setDefaultTimeout(Duration time) {
    timeout = time;
  }

  /** A question that waits for its answer. */
  private static final class Question {
    final CompletableFuture<UMessage> answer = new CompletableFuture<>();
    volatile @Nullable UMessage error;
  }

  @Override
  public void notifyCallbacks(UMessage message) {
    if (questions != null && message.getType() == UMessageType.MESSAGE_ERROR) {
      // A server executes what it was sent in that order.
      Question oldest = questions.peek();
      if (oldest != null && oldest.error == null) {
        oldest.error = message;
      }
    }
    // The queue does not exist while the constructor of the superclass runs.
    if (synchronous || queue == null || isAnswer(message)) {
      super.notifyCallbacks(message);
    } else {
      queue.add(message);
    }
  }

  /** The answers to questions do not queue behind callbacks, which may have asked them. */
  private static boolean isAnswer(UMessage message) {
    return message.getTag().startsWith("URBI_");
  }

  private void callbackThread() {
    try {
      for (UMessage message = queue.take(); message != end; message = queue.take()) {
        super.notifyCallbacks(message);
      }
    } catch (InterruptedException e) {
      // Stopped: from now on somebody else calls them.
    }
  }

  /** Ends the thread that calls callbacks: {@link #processEvents} is to be called instead. */
  public void stopCallbackThread() {
    callbackThread.interrupt();
    try {
      callbackThread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether this thread is the one that calls callbacks. */
  public boolean isCallbackThread() {
    return Thread.currentThread() == callbackThread;
  }

  /** Calls the callbacks for the messages that wait; whether there were any. */
  public boolean processEvents() {
    return processEvents(-1);
  }

  /**
   * Calls the callbacks for the messages that wait.
   *
   * @param microseconds how long new ones are begun; -1 without limit
   * @return whether there were any
   */
  public boolean processEvents(long microseconds) {
    Stopwatch time = new Stopwatch();
    boolean any = false;
    while (microseconds < 0 || !any || time.elapsed(TimeUnit.MICROSECONDS) < microseconds) {
      UMessage message = queue.poll();
      if (message == null || message == end) {
        break;
      }
      super.notifyCallbacks(message);
      any = true;
    }
    return any;
  }

  /** Whether callbacks are called at once, by the thread that reads. Then they cannot ask. */
  public void setSynchronous(boolean enable) {
    synchronous = enable;
  }

  /** The value of an expression, as a message; that of void is nothing. */
  public UMessage syncGet(String expression) {
    return syncGet(timeout, expression);
  }

  /** The value of an expression made as {@link String#format} does. */
  public UMessage syncGet(String format, Object... arguments) {
    return syncGet(String.format(Locale.ROOT, format, arguments));
  }

  /** The value of an expression, within some time. */
  public UMessage syncGet(Duration time, String expression) {
    return syncGetTag(time, expression, fresh());
  }

  /** The value of an expression, within some microseconds. */
  public UMessage syncGet(long microseconds, String expression) {
    return syncGet(Duration.of(microseconds, ChronoUnit.MICROS), expression);
  }

  private UMessage syncGetTag(Duration time, String expression, String tag) {
    requireOpen();
    var question = new Question();
    int callback =
        setCallback(
            message -> {
              questions.remove(question);
              question.answer.complete(message);
              return UCallbackAction.URBI_REMOVE;
            },
            tag);
    try {
      synchronized (questions) {
        questions.add(question);
        // What is sent last comes last: if nothing came before, there was an error, or no value.
        send(tagged(tag, expression) + "lobby.send(\"void\", \"" + tag + "\");\n");
      }
      UMessage message = await(question.answer, expression, time);
      if (question.error != null && message.getValue().isVoid()) {
        throw new UClientException(question.error.getMessage());
      }
      return message;
    } finally {
      questions.remove(question);
      deleteCallback(callback);
    }
  }

  /** The value of an expression. */
  public UValue syncEval(String expression) {
    return syncGet(expression).getValue();
  }

  /** The value of an expression, within some time. */
  public UValue syncEval(String expression, Duration time) {
    return syncGet(time, expression).getValue();
  }

  /** Sends bytes, and waits until they are on their way; 0 if all went well. */
  public int syncSend(byte[] bytes) {
    setSynchronousSend(true);
    try {
      return effectiveSend(bytes);
    } finally {
      setSynchronousSend(false);
    }
  }

  /** The number that is {@code device.val}. */
  public double syncGetDevice(String device) {
    return syncEval(device + ".val").doubleValue();
  }

  /** The number that is a field of a device. */
  public double syncGetDevice(String device, String field) {
    return syncEval(device + "." + field).doubleValue();
  }

  /** The number that is the normalized value of a device. */
  public double syncGetNormalizedDevice(String device) {
    return syncGetDevice(device, "valn");
  }

  /** The value of a slot. */
  public UValue syncGetValue(String name) {
    return syncEval(name);
  }

  /** The number that a command results in. */
  public double syncGetResult(String command) {
    return syncEval(command).doubleValue();
  }

  /**
   * An image of a camera.
   *
   * @param format in which it is wanted
   */
  public UImage syncGetImage(String camera, UImageFormat format, Duration time) {
    UImage image = new UImage();
    image.setImageFormat(format);
    UConversion.convert(syncEval(camera + ".val", time).uimageValue(), image);
    return image;
  }

  /**
   * What a microphone hears for some time.
   *
   * @param milliseconds how long
   */
  public USound syncGetSound(String device, int milliseconds, Duration time) {
    return syncEval(
            "{ var '$sound' = Binary.new(\"\", \"\") | timeout("
                + milliseconds
                + "ms) { at ("
                + device
                + ".val->changed?) '$sound' = '$sound' + "
                + device
                + ".val; sleep(inf) } | '$sound' }",
            time)
        .usoundValue();
  }

  /** Waits for the next message with a tag. */
  public UMessage waitForTag(String tag, Duration time) {
    var answer = new CompletableFuture<UMessage>();
    int callback =
        setCallback(
            message -> {
              answer.complete(message);
              return UCallbackAction.URBI_REMOVE;
            },
            tag);
    try {
      return await(answer, "tag " + tag, time);
    } finally {
      deleteCallback(callback);
    }
  }

  /** How long the server takes to execute a statement and to answer. */
  public Duration ping(Duration time) {
    Stopwatch taken = new Stopwatch();
    syncGet(time, "0");
    return Duration.ofNanos(taken.elapsed(TimeUnit.NANOSECONDS));
  }
}
