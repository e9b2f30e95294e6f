package org.urbi.kernel.remote;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.lobby.RemoteObjects;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.outside.SocketSelector;
import org.urbi.kernel.uobject.ObjectAccess;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UClass;
import urbi.UContext;
import urbi.UEmitter;
import urbi.UModule;
import urbi.UObject;
import urbi.UValue;
import urbi.wire.Frame;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/**
 * One remote process: its classes, objects and variables.
 *
 * <p>One job executes its requests in order. Results for waiting jobs do not pass through that job,
 * so it may itself wait for one.
 */
public final class RemotePeer implements RemoteProcess, RemoteObjects {
  /** How long an access waits for the process to set the value. */
  private static final Duration ACCESS_TIMEOUT = Duration.ofSeconds(2);

  private final int number;
  private final Scheduler scheduler;
  private final PluggedContext context;
  private final ObjectAccess access;
  private volatile RemoteTransport wire;
  private final AnswerPoller reading;
  private volatile SocketSelector.@Nullable Socket socket;
  private boolean wanting;
  private final UModule module;
  private final RemoteTasks tasks;
  private final PendingCalls calls;
  private final RemoteDatagrams datagrams = new RemoteDatagrams(this);
  private final RemoteRequests requests;
  private final Function<RuntimeException, String> describe;
  private final Map<String, UClass> classes = new LinkedHashMap<>();

  /** Actions that publish the classes which are being constructed. */
  private final List<Runnable> unseen = new ArrayList<>();

  private final Map<String, RemoteObject> objects = new LinkedHashMap<>();
  private final RemoteVariables variables = new RemoteVariables(this);
  private final Map<String, UEmitter> events = new HashMap<>();
  private final WireOutput out = new WireOutput(1 << 12);
  private boolean flushing;
  private boolean making;
  private boolean behind;
  private boolean greeted;
  private boolean broken;
  private @Nullable String lost;
  private @Nullable UrbiLobby lobby;
  private @Nullable Runnable rtpEnd;
  private volatile @Nullable Supervisor supervisor;

  /**
   * @param number of the receiver of its messages
   * @param name of the process, for people
   * @param describe gives the text of a failure, and logs a bug of ours; called in a job
   * @param reading polls for answers on the kernel thread
   */
  public RemotePeer(
      int number,
      String name,
      Scheduler scheduler,
      PluggedContext context,
      Function<RuntimeException, String> describe,
      AnswerPoller reading,
      RemoteTransport wire) {
    this.number = number;
    this.reading = reading;
    this.scheduler = scheduler;
    this.context = context;
    this.describe = describe;
    this.wire = wire;
    this.access = new ObjectAccess(context);
    this.module = new UModule(name);
    this.requests = new RemoteRequests(this, describe);
    this.tasks = new RemoteTasks(scheduler, context::lobby, this::consumed, this::failed);
    this.calls = new PendingCalls(tasks);
  }

  // ------------------------------------------------------------------ from any thread

  /** Receives a frame, without its length. */
  public void receive(byte[] frame) {
    scheduler.inbox().post(new Message.RemoteFrame(number, frame));
  }

  /**
   * The connection is lost: waiting calls fail, and the objects of the process end. Where the
   * kernel has started the process, its end is waited for first: that tells more.
   */
  public void lost(String why) {
    Supervisor told = supervisor;
    if (told == null) {
      ended(why);
    } else {
      told.disconnected(why);
    }
  }

  /**
   * The process has ended.
   *
   * @param why the first line is shown to code that needs the process; the others tell people more
   */
  public void ended(String why) {
    scheduler.inbox().post(new Message.RemoteLost(number, why));
  }

  /** The process that the kernel has started has connected. */
  public void connected(RemoteTransport way) {
    wire = way;
  }

  /** The process sends urbiscript, and has no lobby of its own. */
  public void code(String text) {
    context.send(text);
  }

  /** So much output is waiting that new values of variables are held back. */
  public void behind() {
    scheduler.inbox().post(new Message.RemoteCongested(number));
  }

  /** The waiting output has been sent. */
  public void drained() {
    scheduler.inbox().post(new Message.RemoteDrained(number));
  }

  /** The network thread hands the connection, with this socket, over to the kernel thread. */
  public void mayRead(SocketSelector.Socket left) {
    socket = left;
    scheduler.inbox().post(new Message.RemoteReadable(number));
  }

  PluggedContext context() {
    return context;
  }

  RemoteTransport wire() {
    return wire;
  }

  /** The variables that the process uses. */
  RemoteVariables variables() {
    return variables;
  }

  /** The values that go in datagrams. */
  RemoteDatagrams datagrams() {
    return datagrams;
  }

  SocketSelector.@Nullable Socket socket() {
    return socket;
  }

  /** Asks the kernel thread whether it is idle, so that it can read. */
  public void askForAttention() {
    scheduler.inbox().post(new Message.PollingRequested(number));
  }

  // ------------------------------------------------------------------ messages

  /** Registers the process with the kernel. */
  public void open() {
    scheduler.inbox().register(number, this::take);
    rtpEnd = context.rtp().onTurn(datagrams::turned);
  }

  /** The lobby executes what the process sends; once, before its first request. */
  public void belongTo(UrbiLobby own) {
    lobby = own;
    own.attach(this);
  }

  private void take(Message message) {
    switch (message) {
      case Message.RemoteFrame received -> received(received.frame());
      case Message.RemoteCongested news -> behind = true;
      case Message.RemoteDrained news -> later(this::refresh);
      case Message.RemoteLost loss -> {
        lose(loss.reason());
        later(() -> clear(loss.reason()));
      }
      case Message.RemoteReadable news -> reading.begin(this);
      case Message.PollingRequested question -> wire.attended();
      default -> throw new IllegalArgumentException(message.toString());
    }
  }

  private void lose(String why) {
    scheduler.inbox().forget(number);
    lost = why.lines().findFirst().orElse(why);
  }

  private void received(byte[] frame) {
    if (broken) {
      return;
    }
    if (!greeted) {
      greeted = true;
      later(this::tellTime);
    }
    WireInput in = new WireInput(frame, 0, frame.length);
    try {
      int type = in.octet();
      switch (type) {
        case Frame.RESULT, Frame.ERROR, Frame.ARGUMENT_ERROR, Frame.ACCESSED -> {
          calls.answer(type, in);
          wire.consumed(frame.length);
        }
        default -> tasks.add(requests.of(type, in), frame.length);
      }
    } catch (RuntimeException e) {
      // Invalid input of a process must not affect anybody else.
      broken = true;
      wire.close(InputFailure.text(e));
    }
  }

  // ------------------------------------------------------------------ in the job

  /** Sends the kernel's time, by which the process dates its own assignments. */
  private void tellTime() {
    write(o -> o.begin(Frame.TIME).number(scheduler.measure() / 1000).end());
  }

  /** Adds a task, which is executed in turn. */
  void later(Runnable task) {
    tasks.add(task, 0);
  }

  /** From now on somebody looks after the process; before it can be lost. */
  void superviseBy(Supervisor who) {
    supervisor = who;
  }

  /** The process tells of its module. */
  void tellOfModule(String problem) {
    Supervisor told = supervisor;
    if (told != null) {
      told.told(problem);
    }
  }

  private void consumed(int bytes) {
    wire.consumed(bytes);
  }

  private void failed(RuntimeException e) {
    context.report(module.name() + ": " + describe.apply(e));
  }

  /** Registers a class of the process. */
  UValue startClass(String name) {
    UClass type = new UClass(name, module, objectName -> make(name, objectName));
    classes.put(name, type);
    making = true;
    try {
      unseen.add(context.startUnseen(type));
    } finally {
      making = false;
    }
    return new UValue();
  }

  /** Publishes the started classes: their constructors have bound all functions. */
  UValue showClasses() {
    unseen.forEach(Runnable::run);
    unseen.clear();
    return new UValue();
  }

  /** Creates the counterpart of a new urbiscript object. */
  private RemoteObject make(String className, String name) {
    if (lost != null) {
      throw new IllegalStateException(lost);
    }
    RemoteObject object = new RemoteObject(this, name);
    objects.put(object.get__name(), object);
    if (lobby != null) {
      access.markRemote(object.get__name(), lobby);
    }
    if (!making) {
      RemoteObject prototype = objects.get(className);
      if (prototype != null) {
        object.bindLike(prototype);
      }
      constructThere(className, name);
    }
    return object;
  }

  /**
   * Makes the process create the object, and waits for it, so that the functions bound by its
   * constructor exist when the caller gets the object. A failure is reported by later calls of the
   * object.
   */
  private void constructThere(String className, String name) {
    PendingCalls.Call made = calls.begin();
    write(o -> o.begin(Frame.NEW).text(className).text(name).size(made.number()).end());
    if (!tasks.areRunning()) {
      reading.asked(this);
      context.await(made.result());
    }
  }

  /** Registers an object that the process has created by itself. */
  UValue attach(String className) {
    UClass type =
        classes.getOrDefault(
            className, new UClass(className, module, objectName -> make(className, objectName)));
    UContext before = UContext.enter(context);
    making = true;
    try {
      // The context chooses the name; the name given here only tells the class.
      return new UValue(type.create(className).get__name());
    } catch (RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new IllegalStateException(e);
    } finally {
      making = false;
      UContext.enter(before);
    }
  }

  /** Binds a function, unless the object has ended meanwhile. */
  void bind(String name, String function, int arity) {
    RemoteObject object = objects.get(name);
    if (object != null) {
      object.bindRemote(function, arity);
    }
  }

  /** Removes an object that the process has destroyed. */
  void detach(String name) {
    RemoteObject object = objects.remove(name);
    if (object != null) {
      object.clean();
    }
  }

  @Override
  public @Nullable String lost() {
    return lost;
  }

  @Override
  public void gone(RemoteObject object) {
    if (objects.remove(object.get__name(), object) && lost == null) {
      write(o -> o.begin(Frame.GONE).text(object.get__name()).end());
    }
  }

  @Override
  public void unnotify(String name, double times) {
    variables.unnotify(name, times);
  }

  @Override
  public void statementOver() {
    // Its objects come in frames, each of which is a whole.
  }

  @Override
  public void disconnected() {
    // The transport tells of that.
  }

  /** Emits an event; without a payload, only creates it. */
  void emit(String name, UValue @Nullable [] payload) {
    UEmitter emitter = events.computeIfAbsent(name, context::event);
    if (payload != null) {
      emitter.emit(payload);
    }
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Whether the kernel waits for an answer. */
  boolean isAsked() {
    return !calls.isEmpty();
  }

  /** Asks to let the kernel thread read the answers. */
  void wantToRead() {
    if (!wanting) {
      wanting = true;
      wire.wantToRead();
    }
  }

  /** Reads what has arrived; false if the network thread reads again. */
  boolean read(ByteBuffer space) {
    boolean more = wire.read(space);
    wanting = more;
    return more;
  }

  /** Lets the network thread read again. */
  void stopReading() {
    wanting = false;
    wire.stopReading();
  }

  @Override
  public CompletionStage<UValue> call(String object, String function, UValue... arguments) {
    if (lost != null) {
      return CompletableFuture.failedFuture(PendingCalls.lost(lost));
    }
    PendingCalls.Call call = calls.begin();
    try {
      write(o ->
          o.begin(Frame.CALL)
              .size(call.number())
              .text(object)
              .text(function)
              .values(arguments)
              .end());
      reading.asked(this);
    } catch (RuntimeException e) {
      calls.forget(call);
      throw e;
    }
    return call.result();
  }

  /** Sends the process a new value; false if it is too far behind to get it now. */
  boolean tell(RemoteVariable variable, UValue value) {
    if (lost != null) {
      return true;
    }
    if (behind) {
      return false;
    }
    long time = scheduler.now() / 1000;
    if (!datagrams.send(variable, value, time)) {
      write(o -> {
        datagrams.leave(variable, o);
        o.begin(Frame.CHANGED).size(variable.id()).number(time).value(value).end();
      });
    }
    return true;
  }

  private void refresh() {
    if (behind) {
      behind = false;
      variables.refresh();
    }
  }

  /** Changes the number of processes that only keep a copy of a variable. */
  void countMirror(UrbiUVar variable, boolean one) {
    context.countMirror(variable, one);
  }

  /**
   * A variable is about to be read: lets the process set it before. This is skipped while a request
   * of the process is executed, because the process may wait for that, and no other request is
   * executed meanwhile.
   */
  void announceAccess(RemoteVariable variable) {
    if (lost != null || tasks.areRunning()) {
      return;
    }
    PendingCalls.Call asked = calls.begin();
    write(o -> o.begin(Frame.ACCESS).size(variable.id()).size(asked.number()).end());
    reading.asked(this);
    context.await(asked.result(), ACCESS_TIMEOUT);
    calls.forget(asked);
    if (asked.result().isCancelled()) {
      context.report(
          module.name()
              + ": "
              + Problem.NOT_ACCESSED_IN_TIME.text(
                  variable.slot().name(), ACCESS_TIMEOUT.toSeconds()));
    }
  }

  /** Queues frames, which are sent at the end of the tick. */
  void write(Consumer<WireOutput> frame) {
    try {
      frame.accept(out);
    } catch (RuntimeException e) {
      out.abandon();
      throw e;
    }
    if (!flushing) {
      scheduler.atEndOfTick(this::flush);
      flushing = true;
    }
  }

  private void flush() {
    byte[] frames = out.toBytes();
    out.reset();
    flushing = false;
    if (lost == null) {
      if (!context.rtp().isOn()) {
        // Only frames are recorded: what is sent in datagrams depends on the network.
        scheduler.journal().sent(number, frames);
      }
      wire.send(frames);
    }
  }

  // ------------------------------------------------------------------ the end

  /** Ends its objects at once, whatever becomes of the process. */
  void end(String why) {
    if (lost == null) {
      lose(why);
      clear(why);
    }
  }

  private void clear(String why) {
    Supervisor told = supervisor;
    Runnable show =
        told == null || !told.isMissed() ? () -> {} : context.keepVisible(classes.keySet());
    calls.lose(why.lines().findFirst().orElse(why));
    variables.end();
    List<RemoteObject> all = new ArrayList<>(objects.values());
    objects.clear();
    all.forEach(UObject::clean);
    classes.values().forEach(context::stop);
    module.leave(context);
    if (rtpEnd != null) {
      rtpEnd.run();
    }
    tasks.end();
    reading.forget(this);
    show.run();
    if (told != null) {
      told.ended(why);
    }
  }
}
