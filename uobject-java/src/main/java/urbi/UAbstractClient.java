package urbi;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import urbi.time.Stopwatch;

/**
 * What a client of a server does, wherever its bytes go: it sends urbiscript, and calls callbacks
 * for the messages that come. How they are called, and on which thread, is up to the subclass.
 *
 * <p>The {@code send} methods return 0, or another number when nothing can be sent any more, see
 * {@link #error}.
 */
public abstract class UAbstractClient {
  /** The port on which a server listens by custom. */
  public static final int URBI_PORT = 54000;

  /** The tag of the messages that the client itself makes of its errors. */
  public static final String CLIENTERROR_TAG = "client error";

  private static final Stopwatch SINCE_START = new Stopwatch();

  private final String host;
  private final int port;
  private final Callbacks callbacks = new Callbacks();
  private final AtomicInteger lastTag = new AtomicInteger();
  private final ThreadLocal<StringBuilder> pack = new ThreadLocal<>();
  private volatile int timestamp;

  UAbstractClient(String host, int port) {
    this.host = host;
    this.port = port;
  }

  /** The machine on which a server is by default: this one. */
  public static String default_host() {
    return "127.0.0.1";
  }

  public String getServerName() {
    return host;
  }

  public int getServerPort() {
    return port;
  }

  /** Not 0 when there is no connection, or no longer. */
  public abstract int error();

  /** Sends bytes; 0 if that is possible. */
  protected abstract int effectiveSend(byte[] bytes);

  /** Sends urbiscript. */
  public int send(String code) {
    return effectiveSend(TextCoding.encode(code));
  }

  /** Sends urbiscript, made as {@link String#format} does. */
  public int send(String format, Object... arguments) {
    return send(String.format(Locale.ROOT, format, arguments));
  }

  /** Sends the literal of a value, and nothing before or after it. */
  public int send(UValue value) {
    return effectiveSend(value.toBytes());
  }

  /** Sends a binary, and nothing before or after it. */
  public int sendBinary(byte[] data, String header) {
    return send(new UValue(new UBinary(header, data)));
  }

  /** Sends bytes. */
  public int sendBin(byte[] data) {
    return effectiveSend(data.clone());
  }

  /** Sends text, made as {@link String#format} does, and bytes after it. */
  public int sendBin(byte[] data, String header, Object... arguments) {
    String text = arguments.length == 0 ? header : String.format(Locale.ROOT, header, arguments);
    var bytes = new ByteArrayOutputStream();
    bytes.writeBytes(TextCoding.encode(text));
    bytes.writeBytes(data);
    return effectiveSend(bytes.toByteArray());
  }

  /** Sends text, and the first bytes of some after it. */
  public int sendBin(byte[] data, int size, String header) {
    return sendBin(Arrays.copyOf(data, size), header);
  }

  /** Sends the first bytes of some. */
  public int sendBin(byte[] data, int size) {
    return effectiveSend(Arrays.copyOf(data, size));
  }

  /** What this thread {@linkplain #pack packs} is kept until {@link #endPack}. */
  public int startPack() {
    pack.set(new StringBuilder());
    return 0;
  }

  /** Sends urbiscript, together with what else is packed. */
  public int pack(String format, Object... arguments) {
    String text = arguments.length == 0 ? format : String.format(Locale.ROOT, format, arguments);
    StringBuilder packed = pack.get();
    if (packed == null) {
      return send(text);
    }
    packed.append(text);
    return 0;
  }

  /** Sends what has been packed. */
  public int endPack() {
    StringBuilder packed = pack.get();
    pack.remove();
    return packed == null ? 0 : send(packed.toString());
  }

  /** Sends a file of urbiscript; {@code /dev/stdin} is the standard input. */
  public int sendFile(String file) {
    try {
      return effectiveSend(
          file.equals("/dev/stdin") ? System.in.readAllBytes() : Files.readAllBytes(Path.of(file)));
    } catch (IOException e) {
      clientError("cannot read " + file + ": " + e.getMessage());
      return -1;
    }
  }

  /**
   * Sends a command whose result comes under a tag of its own, and has a callback called for that.
   *
   * @return the number of the callback
   */
  public int sendCommand(UMessageHandler handler, String format, Object... arguments) {
    String command = arguments.length == 0 ? format : String.format(Locale.ROOT, format, arguments);
    String tag = fresh();
    int id = setCallback(handler, tag);
    send(tagged(tag, command));
    return id;
  }

  /** Urbiscript that sends the value of an expression under a tag, or nothing when it is void. */
  static String tagged(String tag, String expression) {
    String body = expression.strip();
    while (body.endsWith(";") || body.endsWith(",")) {
      body = body.substring(0, body.length() - 1).stripTrailing();
    }
    return "{ var '$value' = { "
        + body
        + " }.acceptVoid | if (!'$value'.isVoid) { var '$channel' = Channel.new(\""
        + tag
        + "\") | '$channel'.quote = true | '$channel' << '$value' } };\n";
  }

  /** Has a sound played: sets the value of a device to it. */
  public int sendSound(String device, USound sound) {
    var bytes = new ByteArrayOutputStream();
    bytes.writeBytes(TextCoding.encode(device + ".val = "));
    bytes.writeBytes(new UValue(sound).toBytes());
    bytes.writeBytes(new byte[] {';', '\n'});
    return effectiveSend(bytes.toByteArray());
  }

  /**
   * Has a callback called for each message with a tag.
   *
   * @return its number, for {@link #deleteCallback}
   */
  public int setCallback(UMessageHandler handler, String tag) {
    return callbacks.add(tag, message -> message.getTag().equals(tag), handler);
  }

  /** Has a callback called for each error that the server sends. */
  public int setErrorCallback(UMessageHandler handler) {
    return callbacks.add(
        "error",
        message ->
            message.getType() == UMessageType.MESSAGE_ERROR
                && !message.getTag().equals(CLIENTERROR_TAG),
        handler);
  }

  /** Has a callback called for each message of the server. */
  public int setWildcardCallback(UMessageHandler handler) {
    return callbacks.add("*", message -> !message.getTag().equals(CLIENTERROR_TAG), handler);
  }

  /** Has a callback called for each error of the connection. */
  public int setClientErrorCallback(UMessageHandler handler) {
    return setCallback(handler, CLIENTERROR_TAG);
  }

  /** The tag with which a callback has been set; null if there is no such callback. */
  public @Nullable String getAssociatedTag(long callback) {
    return callbacks.tag(callback);
  }

  /** Ends a callback; 1 if there was one, 0 if not. */
  public int deleteCallback(long callback) {
    return callbacks.remove(callback) ? 1 : 0;
  }

  /** A tag that this client has not used. */
  public String fresh() {
    return "URBI_" + lastTag.incrementAndGet();
  }

  /** A tag that this client has not used. */
  public String makeUniqueTag() {
    return fresh();
  }

  /** Calls the callbacks for a message as if it had come from the server. */
  public void notifyCallbacks(UMessage message) {
    callbacks.call(message);
  }

  /** Milliseconds since some time that does not change. */
  public long getCurrentTime() {
    return SINCE_START.elapsed(TimeUnit.MILLISECONDS);
  }

  /** The time stamp of the last message. */
  public int getCurrentTimestamp() {
    return timestamp;
  }

  void received(int time, String tag, UMessageType type, byte[] raw, boolean continuation) {
    timestamp = time;
    notifyCallbacks(new UMessage(this, time, tag, type, raw, continuation));
  }

  /** Tells those who want to know about an error of the connection. */
  void clientError(String text) {
    byte[] raw = ("!!! " + text).getBytes(StandardCharsets.UTF_8);
    notifyCallbacks(
        new UMessage(this, timestamp, CLIENTERROR_TAG, UMessageType.MESSAGE_ERROR, raw, false));
  }
}
