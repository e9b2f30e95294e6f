package org.urbi.kernel.uobject;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.variable.ConnectionList;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.UClass;
import urbi.UContext;
import urbi.UEmitter;
import urbi.UHubClass;
import urbi.UObject;
import urbi.UObjectHub;
import urbi.UObjectMode;
import urbi.USlot;
import urbi.UValue;
import urbi.spi.SentCode;
import urbi.spi.ThreadPool;

/**
 * The UObjects that live in the process of a kernel.
 *
 * <p>Their code runs in jobs and pins them to the kernel thread: it blocks everything else (manual,
 * "Asynchronous binding"). Its requests to the kernel are executed at once, and may let other jobs
 * run like any urbiscript code. Requests of other threads are executed by a job, for which the
 * thread waits. Native code that yields runs on a thread of its own, see {@link NativeThread}.
 */
public final class PluggedContext implements UContext {
  private final Interpreter interpreter;
  private final Scheduler scheduler;
  private final KernelLog log;
  private final KernelRequests requests;
  private final Instances objects;
  private final InstanceLifecycle creation;
  private final VariableLookup variables;
  private final ValueConversion conversion;
  private @Nullable Converters converters;
  private final CallStatistics statistics;
  private final ConnectionList connections;
  private final PendingNotifications notifications = new PendingNotifications();
  private final RtpSwitch rtp = new RtpSwitch();
  private final PeriodicCalls periods;
  private final Modules modules;
  private final SystemLobby systemLobby;
  private final NativeThread nativeThread = new NativeThread(this);
  private final ThreadPool threads = new ThreadPool("urbi-uobject-");
  private final KernelCrossing crossing;
  private final ComponentJobs jobs;
  private final ComponentTasks tasks;
  private final Map<String, UObjectHub> hubs = new LinkedHashMap<>();

  /**
   * @param moduleSearchPath the folders in which modules are searched, in order
   */
  public PluggedContext(
      Interpreter interpreter, List<Path> moduleSearchPath, Outside outside, KernelLog log) {
    this.interpreter = interpreter;
    this.scheduler = interpreter.scheduler();
    this.log = log;
    this.tasks = new ComponentTasks(this);
    this.requests = new KernelRequests(interpreter, tasks);
    this.crossing = new KernelCrossing(this, interpreter, requests, nativeThread);
    Journal journal = scheduler.journal();
    this.objects = new Instances(interpreter.world(), scheduler.inbox(), journal, this::gone);
    this.variables = new VariableLookup(interpreter.world(), objects, journal);
    this.conversion = new ValueConversion(this);
    this.connections = new ConnectionList(scheduler);
    this.statistics = new CallStatistics(scheduler::measure);
    this.periods = new PeriodicCalls(this);
    this.creation = new InstanceLifecycle(this);
    this.modules = new Modules(this, moduleSearchPath, outside);
    this.systemLobby = new SystemLobby(interpreter, log);
    this.jobs = new ComponentJobs(this);
    scheduler.inbox().register(Message.COMPONENTS, this::take);
  }

  // ------------------------------------------------------------------ its parts

  Interpreter interpreter() {
    return interpreter;
  }

  /** Whether urbiscript code listens to variables or events of UObjects. */
  public boolean isListenedTo() {
    for (Instance instance : objects.all()) {
      if (instance.isListenedTo()) {
        return true;
      }
    }
    return false;
  }

  Instances objects() {
    return objects;
  }

  /** The way between the kernel and the code of components. */
  KernelCrossing crossing() {
    return crossing;
  }

  /** The jobs in which components are called. */
  ComponentJobs jobs() {
    return jobs;
  }

  VariableLookup variables() {
    return variables;
  }

  /** What the threads of components ask for. */
  ComponentTasks tasks() {
    return tasks;
  }

  ValueConversion conversion() {
    return conversion;
  }

  /** Used on the kernel thread; created on first use, since most kernels have no UObjects. */
  Converters converters() {
    Converters known = converters;
    if (known == null) {
      known = new Converters(this, conversion);
      converters = known;
    }
    return known;
  }

  PendingNotifications notifications() {
    return notifications;
  }

  PeriodicCalls periods() {
    return periods;
  }

  /** Creates and ends UObjects. */
  public InstanceLifecycle creation() {
    return creation;
  }

  /** Loads and unloads modules. */
  public Modules modules() {
    return modules;
  }

  /** Whether values may travel in datagrams. */
  public RtpSwitch rtp() {
    return rtp;
  }

  /** The variable behind a slot that {@link #variable} or {@link #inputPort} has returned. */
  public static UrbiUVar behind(USlot slot) {
    return ((PluggedSlot) slot).behind();
  }

  /** The links between variables. */
  public ConnectionList connections() {
    return connections;
  }

  /** The statistics of function calls. */
  public CallStatistics statistics() {
    return statistics;
  }

  /** The lobby in which code runs that belongs to no connection. */
  public UrbiLobby lobby() {
    return systemLobby.get();
  }

  /** The name by which an object can be found, or at least recognized. */
  public String nameOf(Frame frame, UrbiObject object) {
    return variables.nameOf(frame, object);
  }

  // ------------------------------------------------------------------ reports

  /** Reports a failure on another thread, unless the kernel is ending. */
  void reportUnlessOver(String message) {
    if (!crossing.isClosed()) {
      report(message);
    }
  }

  /** Puts a warning into the log. */
  void warn(String message) {
    if (log.shows(LogLevel.LOG)) {
      log.write("warning: " + message);
    }
  }

  // ------------------------------------------------------------------ messages

  private void take(Message message) {
    switch (message) {
      case Message.ComponentCode sent -> lobby().shell().receive(Utf8Text.toUrbi(sent.code()));
      case Message.ComponentCall wish -> jobs.start(frame -> tasks.call(frame, wish));
      case Message.ComponentEvent event ->
          jobs.start(frame -> tasks.emit(frame, event.name(), event.payload()));
      case Message.OfComponent asked -> requests.start(asked, lobby());
      case Message.ComponentDone done -> scheduler.pace().end();
      case Message.ComponentGone object -> objects.gone(object.name());
      default -> throw new IllegalArgumentException(message.toString());
    }
  }

  // ------------------------------------------------------------------ UContext

  @Override
  public UObjectMode getRunningMode() {
    return UObjectMode.MODE_PLUGIN;
  }

  @Override
  public void start(UClass type) {
    crossing.inKernel(frame -> start(frame, type));
  }

  /** Starts a class of this process, as {@link #start(UClass)} does. */
  public void start(Class<? extends UObject> type) {
    tasks.offer(type);
    crossing.inKernel(
        frame -> start(frame, UClass.of(type)),
        number -> new Message.ClassStarted(number, type.getName()));
  }

  @Nullable Void start(Frame frame, UClass type) {
    // Publish at once: code sent by a constructor may refer to the object.
    creation.start(frame, type).run();
    return null;
  }

  /**
   * Registers a class as {@link #start} does, but does not publish it yet.
   *
   * @return the action that makes its object a slot of {@code uobjects}
   */
  public Runnable startUnseen(UClass type) {
    return crossing.fromKernel(frame -> creation.start(frame, type));
  }

  /** Ends a class with all its objects, which stay in urbiscript without their functions. */
  public void stop(UClass type) {
    crossing.inKernel(frame -> {
      creation.endClass(frame, type);
      return null;
    });
  }

  /**
   * Returns an action that makes the objects of these names visible again after their end: code
   * that uses them is told why they have ended, and not that there are none.
   */
  public Runnable keepVisible(Collection<String> names) {
    Map<String, UrbiObject> shown = new LinkedHashMap<>();
    for (String name : names) {
      UrbiObject object = objects.find(name);
      if (object != null) {
        shown.put(name, object);
      }
    }
    return () -> shown.forEach(objects::showEnded);
  }

  @Override
  public void startHub(UHubClass type) {
    crossing.inKernel(frame -> {
      UObjectHub before = hubs.remove(type.name());
      if (before != null) {
        periods.end(before);
      }
      UObjectHub hub = creation.construct(frame, null, type.name(), type::create);
      hubs.put(type.name(), hub);
      return null;
    });
  }

  /** A hub has ended with its module; on the kernel thread. */
  void endHub(String name) {
    UObjectHub hub = hubs.remove(name);
    if (hub != null) {
      periods.end(hub);
    }
  }

  @Override
  public String attach(UObject object, @Nullable String name) {
    return crossing.fromKernel(frame -> creation.attach(frame, object, name));
  }

  @Override
  public void detach(UObject object) {
    crossing.inKernel(frame -> {
      creation.detach(object);
      return null;
    });
  }

  @Override
  public @Nullable UObject getUObject(String name) {
    return crossing.inKernel(
        frame -> object(name), number -> new Message.ObjectWanted(number, name, false));
  }

  /** The UObject of that name; on the kernel thread. */
  @Nullable UObject object(String name) {
    Instance instance = objects.named(name);
    return instance == null ? null : instance.java();
  }

  @Override
  public @Nullable UObjectHub getUObjectHub(String name) {
    return crossing.inKernel(
        frame -> hub(name), number -> new Message.ObjectWanted(number, name, true));
  }

  /** The hub of that name; on the kernel thread. */
  @Nullable UObjectHub hub(String name) {
    return hubs.get(name);
  }

  @Override
  public Map<String, String> environment() {
    return crossing.fromKernel(frame -> Outside.environment(scheduler.journal()));
  }

  @Override
  public void bindFunction(UObject object, String name, UCallback function) {
    crossing.inKernel(frame -> {
      creation.bind(object, name, function);
      return null;
    });
  }

  @Override
  public USlot variable(String name) {
    return slot(name, false);
  }

  @Override
  public USlot inputPort(String name) {
    return slot(name, true);
  }

  private USlot slot(String name, boolean input) {
    return crossing.fromKernel(
        frame -> tasks.variable(frame, name, input),
        number -> new Message.VariableWanted(number, name, input));
  }

  @Override
  public UEmitter event(String name) {
    return crossing.fromKernel(
        frame -> tasks.event(frame, name), number -> new Message.EventWanted(number, name));
  }

  void emit(String name, UValue... payload) {
    if (isInTurn()) {
      crossing.inKernel(frame -> {
        tasks.emit(frame, name, payload);
        return null;
      });
    } else {
      scheduler.inbox().post(new Message.ComponentEvent(name, payload));
    }
  }

  @Override
  public Runnable every(Object owner, double milliseconds, UCallback function, boolean afterPass) {
    return crossing.fromKernel(frame -> {
      PeriodicCall call = periods.begin(frame, owner, milliseconds, function, afterPass);
      return () ->
          crossing.inKernel(later -> {
            periods.end(owner, call);
            return null;
          });
    });
  }

  @Override
  public void send(String code) {
    scheduler.inbox().post(new Message.ComponentCode(SentCode.whole(code)));
  }

  @Override
  public void call(String object, String method, UValue... arguments) {
    scheduler.inbox().post(new Message.ComponentCall(object, method, arguments));
  }

  @Override
  public void report(String message) {
    log.write(message);
  }

  /** Changes the number of subscribers that only keep a copy of a variable. */
  public void countMirror(UrbiUVar variable, boolean one) {
    variable.countMirror(interpreter, one);
  }

  /**
   * Makes the running job wait until a stage is complete, normally or not. After the time limit the
   * stage is cancelled.
   */
  public void await(CompletableFuture<?> stage, Duration most) {
    crossing.inKernel(frame -> jobs.awaitEnd(frame, stage, most));
  }

  /** Makes the running job wait until a stage is complete, normally or not. */
  public void await(CompletableFuture<?> stage) {
    crossing.inKernel(frame -> jobs.awaitEnd(frame, stage));
  }

  @Override
  public void yieldFor(Duration time) {
    if (!isInTurn()) {
      LockSupport.parkNanos(time.toNanos());
      return;
    }
    crossing.inKernel(frame -> {
      if (time.isPositive()) {
        frame.job().sleepUntil(scheduler.deadline(time.toNanos()));
      } else {
        frame.job().yieldNow();
      }
      return null;
    });
  }

  @Override
  public void lock() {
    if (!isInTurn()) {
      requests.lock();
    }
  }

  @Override
  public void unlock() {
    if (!isInTurn()) {
      requests.unlock();
    }
  }

  @Override
  public <T> T executeNative(Supplier<T> code) {
    return scheduler.isKernelThread() ? nativeThread.execute(code) : code.get();
  }

  /** Whether this thread executes code of a component for which the kernel waits. */
  private boolean isInTurn() {
    return scheduler.isKernelThread() || nativeThread.isCurrent();
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

  /** The urbiscript object was garbage collected; called between the jobs. */
  private void gone(Instance instance) {
    jobs.start(frame -> creation.end(frame, instance));
  }

  /** The kernel has ended; on its thread. */
  public void close() {
    crossing.close();
    requests.close();
    modules.close();
    creation.close();
    nativeThread.close();
    threads.close();
  }
}
