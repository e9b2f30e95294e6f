package urbi.remote;

import static java.util.Objects.requireNonNullElse;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.Log;
import urbi.UCallback;
import urbi.UClass;
import urbi.UClientException;
import urbi.UContext;
import urbi.UEmitter;
import urbi.UHubClass;
import urbi.UObject;
import urbi.UObjectHub;
import urbi.UObjectMode;
import urbi.USlot;
import urbi.UValue;
import urbi.rtp.RtpMode;
import urbi.rtp.RtpOptions;
import urbi.rtp.RtpStatistics;
import urbi.spi.ComponentFailureLog;
import urbi.spi.Failure;
import urbi.spi.SentCode;
import urbi.spi.ThreadPool;
import urbi.thread.InternalFailure;
import urbi.time.Stopwatch;
import urbi.wire.Frame;
import urbi.wire.WireException;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/**
 * The context of UObjects in a process that is connected to a kernel.
 *
 * <p>One thread makes UObjects and calls their functions, timers and notifications, unless they are
 * threaded. Requests that need no answer are sent without waiting; the connection keeps their
 * order.
 */
public final class RemoteContext implements UContext, AutoCloseable {
  private static final int CONNECT_MILLISECONDS = 10_000;

  /** Why the connection has ended, where that is what {@link #endWithLastObject} asks for. */
  static final String NO_OBJECT = "urbiscript has destroyed the last object";

  private final @Nullable InetSocketAddress server;
  private final Connection link;
  private final Dispatcher dispatcher =
      new Dispatcher(this::readOne, this::execute, this::ping, this::failed);
  private final PendingRequests requests = new PendingRequests();
  private final ThreadPool threads = new ThreadPool("urbi-remote-function-");
  private final RemoteTimers timers = new RemoteTimers(dispatcher);
  private final Map<Integer, RemoteSlot> slots = new ConcurrentHashMap<>();
  private final AtomicInteger lastSlot = new AtomicInteger();
  private final AtomicReference<String> end = new AtomicReference<>();
  private final CompletableFuture<String> closed = new CompletableFuture<>();
  private final KernelTime time = new KernelTime();
  private volatile boolean endsWithLastObject;
  private int yields;
  private volatile @Nullable Consumer<String> trace;
  private final ComponentFailureLog failureLog = new ComponentFailureLog(Log::error);
  private final OutputListeners output = new OutputListeners(failureLog);
  private final SlowCallMonitor turn = new SlowCallMonitor(this::complain);
  private final RemoteFunctions functions = new RemoteFunctions(this, failureLog, turn);
  private final OwnObjects objects = new OwnObjects(this, functions, failureLog);
  private final ConnectionMonitor watch;
  private final RemoteDatagrams datagrams;

  /**
   * Connects to a server.
   *
   * @throws UClientException if nobody answers, or somebody who does not speak the protocol
   */
  public RemoteContext(String host, int port) {
    this(host, port, new Stopwatch());
  }

  /**
   * @param silence measures that of the server
   */
  RemoteContext(String host, int port, Stopwatch silence) {
    this(host, port, silence, InetSocketAddress.createUnresolved(host, port));
  }

  private RemoteContext(
      String host, int port, Stopwatch silence, @Nullable InetSocketAddress server) {
    this.server = server;
    link = new Connection(host, port, CONNECT_MILLISECONDS);
    watch =
        new ConnectionMonitor(
            silence,
            turn::complain,
            this::ping,
            () -> end("the server does not answer any more"),
            this::failed);
    datagrams = new RemoteDatagrams(this, link.address(), failureLog);
    dispatcher.start();
    watch.start();
  }

  /**
   * Of a module that the kernel runs in a process of its own. The port is for this connection
   * alone, so the module has no server for clients, as in the kernel's process.
   */
  static RemoteContext ofModule(int port) {
    return new RemoteContext("127.0.0.1", port, new Stopwatch(), null);
  }

  /** Has what the server shows to this connection passed on, in pieces as they come. */
  public void onOutput(Consumer<byte[]> listener) {
    output.add(listener);
  }

  /** Measures the code that is executed in turn. */
  SlowCallMonitor turn() {
    return turn;
  }

  /** Has the connection end when urbiscript has destroyed the last object of this process. */
  void endWithLastObject() {
    endsWithLastObject = true;
  }

  /** Has each call of a function told of, and each failure; null for none. */
  public void trace(Consumer<String> told) {
    trace = told;
  }

  /** Has the server say something. */
  private void ping() {
    try {
      sendNow(out -> out.begin(Frame.PING).end());
    } catch (UClientException e) {
      // There is no connection any more: who reads notices it.
    }
  }

  /** Microseconds since the kernel was started. */
  long now() {
    return time.now();
  }

  /** Completed with the reason when the connection ends. */
  public CompletableFuture<String> onClosed() {
    return closed.copy();
  }

  // ------------------------------------------------------------------ sending

  void send(Consumer<WireOutput> frames) {
    link.send(frames, false);
  }

  void sendNow(Consumer<WireOutput> frames) {
    link.send(frames, true);
  }

  UValue ask(BiConsumer<WireOutput, Integer> question) {
    return ask(question, answer -> {});
  }

  /**
   * Asks and waits.
   *
   * @param first is given the answer before anything is read that has come after it
   */
  UValue ask(BiConsumer<WireOutput, Integer> question, Consumer<UValue> first) {
    dispatcher.letRead();
    if (!dispatcher.isExecuting()) {
      return answer(question, first);
    }
    turn.pause();
    try {
      return answer(question, first);
    } finally {
      turn.resume();
    }
  }

  private UValue answer(BiConsumer<WireOutput, Integer> question, Consumer<UValue> first) {
    return requests.ask(number -> sendNow(out -> question.accept(out, number)), first);
  }

  // ------------------------------------------------------------------ receiving

  private boolean readOne() {
    try {
      WireInput frame = link.receive();
      watch.alive();
      take(frame.octet(), frame);
      return true;
    } catch (IOException e) {
      end("connection lost: " + e.getMessage());
    } catch (WireException e) {
      end("the server does not keep to the protocol: " + e.getMessage());
    } catch (UClientException e) {
      end(requireNonNullElse(e.getMessage(), "the connection is closed"));
    } catch (RuntimeException | Error e) {
      InternalFailure.log("reading what the server has sent", e);
      failed(e);
    }
    return false;
  }

  /** Without that thread somebody would wait for ever. */
  private void failed(Throwable defect) {
    end(InternalFailure.text(defect));
  }

  private void take(int type, WireInput frame) {
    switch (type) {
      case Frame.PING -> sendNow(out -> out.begin(Frame.PONG).end());
      case Frame.PONG -> {}
      case Frame.CALL -> functions.call(frame.size(), frame.text(), frame.text(), frame.values());
      case Frame.CHANGED -> time.heard(changed(frame));
      case Frame.REPLY -> requests.answer(frame.size(), frame.value());
      case Frame.REFUSAL -> requests.refuse(frame.size(), frame.text());
      case Frame.NEW -> {
        String className = frame.text();
        String name = frame.text();
        int number = frame.size();
        later(() -> {
          objects.make(className, name);
          functions.result(number, null);
        });
      }
      case Frame.LEFT, Frame.RTP_LOADED, Frame.RTP_TERMS, Frame.RTP_REFUSED ->
          datagrams.take(type, frame);
      case Frame.RTP_MODE -> {
        RemoteSlot slot = slots.get(frame.size());
        RtpMode mode = RtpMode.of(frame.octet());
        if (slot != null) {
          slot.setRtp(mode);
        }
      }
      case Frame.GONE -> {
        String name = frame.text();
        later(() -> objectRemoved(name));
      }
      case Frame.ACCESS -> {
        RemoteSlot slot = slots.get(frame.size());
        int number = frame.size();
        if (slot != null) {
          slot.accessed(number);
        } else {
          sendNow(out -> out.begin(Frame.ACCESSED).size(number).end());
        }
      }
      case Frame.TIME -> time.heard(frame.number());
      case Frame.OUTPUT -> output.tell(frame.rest());
      default -> throw new WireException("no kind of frame: " + type);
    }
  }

  /** A variable has changed; returns when, in microseconds after the kernel was started. */
  private long changed(WireInput frame) {
    RemoteSlot slot = slots.get(frame.size());
    long when = frame.number();
    if (slot != null) {
      slot.changed(when, frame.value());
    }
    return when;
  }

  /** A datagram tells of a new value; returns when all have been told that are told in turn. */
  void changedInDatagram(WireInput frame) throws InterruptedException {
    var told = new CountDownLatch(1);
    changed(frame);
    dispatcher.run(told::countDown);
    told.await();
  }

  /** Has something executed by the thread that calls UObjects, in turn. */
  void later(Runnable task) {
    dispatcher.run(task);
  }

  /** Executes a task of a component: whatever it throws, the thread goes on. */
  void execute(Runnable task) {
    UContext before = UContext.enter(this);
    try {
      task.run();
    } catch (UClientException e) {
      // The connection is lost, and whoever wants to know is told by that.
    } catch (Throwable e) {
      failureLog.log("a task of the remote process", e);
      complain("exception caught: " + Failure.text(e));
    } finally {
      UContext.enter(before);
    }
  }

  /** Who is told of each call; null for nobody. */
  @Nullable Consumer<String> trace() {
    return trace;
  }

  /** Why an object is not there, or else that. */
  String failure(String object, String otherwise) {
    return objects.failure(object, otherwise);
  }

  /** Tells people of what nobody waits for. */
  void complain(String text) {
    try {
      report(text);
    } catch (UClientException e) {
      // Nobody is there to read it.
    }
  }

  // ------------------------------------------------------------------ classes and objects

  @Override
  public UObjectMode getRunningMode() {
    return UObjectMode.MODE_REMOTE;
  }

  @Override
  public @Nullable InetSocketAddress server() {
    return server;
  }

  @Override
  public void start(UClass type) {
    objects.start(type);
  }

  @Override
  public void startHub(UHubClass type) {
    objects.start(type);
  }

  interface Construction<T> {
    T make() throws Exception;
  }

  /** Makes something while no function of a UObject is called. */
  <T> T inTurn(String what, Construction<T> making) {
    var done = new CompletableFuture<T>();
    Runnable task =
        () -> {
          UContext before = UContext.enter(this);
          turn.begin(what);
          try {
            done.complete(making.make());
          } catch (Throwable e) {
            done.completeExceptionally(e);
          } finally {
            turn.end();
            UContext.enter(before);
          }
        };
    if (dispatcher.isExecuting()) {
      task.run();
    } else {
      dispatcher.run(task);
    }
    try {
      return done.join();
    } catch (CompletionException e) {
      throw e.getCause() instanceof RuntimeException known ? known : e;
    }
  }

  private void objectRemoved(String name) {
    if (objects.destroyed(name) && endsWithLastObject) {
      end(NO_OBJECT);
    }
  }

  @Override
  public String attach(UObject object, @Nullable String name) {
    return objects.add(object, name);
  }

  @Override
  public void detach(UObject object) {
    if (objects.remove(object)) {
      timers.end(object);
      send(out -> out.begin(Frame.DETACH).text(object.get__name()).end());
    }
  }

  @Override
  public @Nullable UObject getUObject(String name) {
    return objects.object(name);
  }

  @Override
  public @Nullable UObjectHub getUObjectHub(String name) {
    return objects.hub(name);
  }

  // ------------------------------------------------------------------ functions

  @Override
  public void bindFunction(UObject object, String name, UCallback function) {
    String owner = object.get__name();
    functions.bind(owner, name, function);
    send(out -> out.begin(Frame.BIND).text(owner).text(name).octet(function.arity()).end());
  }

  // ------------------------------------------------------------------ variables and events

  @Override
  public USlot variable(String name) {
    return open(name, 0);
  }

  @Override
  public USlot inputPort(String name) {
    return open(name, 1);
  }

  private USlot open(String name, int kind) {
    RemoteSlot slot = new RemoteSlot(this, lastSlot.incrementAndGet(), name);
    slots.put(slot.id(), slot);
    try {
      UValue value =
          ask((out, number) ->
              out.begin(Frame.OPEN).size(number).size(slot.id()).octet(kind).text(name).end());
      slot.setInitial(value);
      return slot;
    } catch (RuntimeException e) {
      slots.remove(slot.id());
      throw e;
    }
  }

  /** Whether this thread calls UObjects in turn just now. */
  boolean isInTurn() {
    return dispatcher.isExecuting();
  }

  /** Tells a callback of a value, in the middle of what is called or on its own thread. */
  void notifyNow(UCallback callback, UValue value) {
    functions.notifyNow(callback, value);
  }

  /** Tells a callback of a value, as a call of its own on the thread that calls UObjects. */
  void notifyInTurn(UCallback callback, UValue value) {
    functions.notifyInTurn(callback, value);
  }

  /** Tells a callback of a value, in turn or on its own thread. */
  void notify(UCallback callback, UValue value) {
    functions.notify(callback, value);
  }

  /** Sets a variable, by a datagram if that may be, and can. */
  void set(int variable, UValue value, RtpMode mode) {
    if (!mode.includes(value) || !datagrams.set(variable, value)) {
      send(out -> {
        datagrams.leave(variable, out);
        out.begin(Frame.SET).size(variable).value(value).end();
      });
    }
  }

  /**
   * Has binaries, and the variables for which {@link urbi.UVar#useRTP} asks, sent in datagrams, as
   * soon as the kernel takes them: {@code urbi/rtp} has to be loaded there, too. Until then, and
   * where datagrams do not get through, all goes over the connection.
   *
   * @return told whether datagrams get through, when that is known
   */
  public CompletableFuture<Boolean> useRtp(RtpOptions options) {
    dispatcher.expectTasks();
    return datagrams.use(options);
  }

  /** What became of the datagrams; null if there were none. */
  public @Nullable RtpStatistics rtpCounts() {
    return datagrams.counts();
  }

  void forget(RemoteSlot slot) {
    datagrams.forget(slot.id());
    if (slots.remove(slot.id()) != null) {
      send(out -> out.begin(Frame.CLOSE).size(slot.id()).end());
    }
  }

  @Override
  public UEmitter event(String name) {
    send(out -> out.begin(Frame.EVENT).text(name).end());
    return payload -> send(out -> out.begin(Frame.EMIT).text(name).values(payload).end());
  }

  @Override
  public Runnable every(Object owner, double milliseconds, UCallback function, boolean afterPass) {
    return timers.every(
        owner, milliseconds, () -> functions.callBackInTurn(function), this::execute);
  }

  // ------------------------------------------------------------------ urbiscript

  @Override
  public void send(String code) {
    byte[] bytes = SentCode.whole(code).getBytes(StandardCharsets.UTF_8);
    send(out -> out.begin(Frame.CODE).bytes(bytes, 0, bytes.length).end());
  }

  @Override
  public void call(String object, String method, UValue... arguments) {
    send(out -> out.begin(Frame.CALL_URBI).text(object).text(method).values(arguments).end());
  }

  @Override
  public void report(String message) {
    send(out -> out.begin(Frame.REPORT).text(message).end());
  }

  // ------------------------------------------------------------------ time and threads

  @Override
  public void yieldFor(Duration time) {
    // The job in the kernel that waits for a function waits anyway, and the kernel goes on.
    boolean own = dispatcher.isExecuting();
    if (own) {
      turn.pause();
      yields++;
    }
    try {
      dispatcher.letOthersRun(time.toNanos());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      if (own) {
        yields--;
        turn.resume();
      }
    }
  }

  /** How many functions let others run at the moment, one inside the other; asked in turn. */
  int yields() {
    return yields;
  }

  @Override
  public void lock() {
    dispatcher.hold();
  }

  @Override
  public void unlock() {
    dispatcher.release();
  }

  @Override
  public Executor threads() {
    return threads;
  }

  @Override
  public void setThreadLimit(int most) {
    threads.setLimit(most);
  }

  // ------------------------------------------------------------------ the end

  private void end(String why) {
    // Closing ends the reading as well, which has another reason then.
    String first = end.compareAndSet(null, why) ? why : requireNonNullElse(end.get(), why);
    link.close();
    watch.close();
    datagrams.close();
    timers.close();
    threads.close();
    requests.lost(first);
    closed.complete(first);
  }

  /** Ends the connection: the kernel forgets what was started here. */
  @Override
  public void close() {
    end("closed");
  }
}
