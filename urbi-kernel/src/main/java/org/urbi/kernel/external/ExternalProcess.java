package org.urbi.kernel.external;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.RemoteObjects;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.remote.RemoteObject;
import org.urbi.kernel.remote.RemoteProcess;
import org.urbi.kernel.uobject.ObjectAccess;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UClass;
import urbi.UModule;
import urbi.UObject;
import urbi.UValue;

/**
 * A process that declared its UObjects by statements in its lobby ({@code external object}, and so
 * on). Its requests are executed in that lobby, and it receives messages on a channel of that
 * lobby. Used on the kernel thread.
 */
public final class ExternalProcess implements RemoteProcess, RemoteObjects {
  private static final String CHANNEL = "__ExternalMessage__";
  private static final int CALL = 0;
  private static final int NEW = 4;
  private static final int DELETE = 5;

  /** How long the process may take to create an object. */
  private static final Duration CREATION_TIMEOUT = Duration.ofSeconds(10);

  private final UrbiLobby lobby;
  private final Scheduler scheduler;
  private final PluggedContext context;
  private final ObjectAccess access;
  private final ExternalVariables variables;
  private final ExternalEvents events;
  private final UModule module;
  private final List<UClass> classes = new ArrayList<>();
  private final Map<String, RemoteObject> objects = new LinkedHashMap<>();

  /** Names that already belong to objects of others: requests about them are ignored. */
  private final Set<String> refused = new HashSet<>();

  /** Objects that the process was asked to create. */
  private final Map<String, CompletableFuture<Void>> wanted = new HashMap<>();

  /** The names of the objects that it has declared. */
  private final Set<String> declared = new HashSet<>();

  private final Map<String, CompletableFuture<UValue>> calls = new HashMap<>();
  private long lastCall;
  private boolean declaring;
  private @Nullable String lost;

  private ExternalProcess(UrbiLobby lobby, Scheduler scheduler, PluggedContext context) {
    this.lobby = lobby;
    this.scheduler = scheduler;
    this.context = context;
    this.access = new ObjectAccess(context);
    this.module = new UModule(lobby.name());
    this.variables = new ExternalVariables(this, scheduler, context);
    this.events = new ExternalEvents(this, access);
  }

  /** The process of the lobby of the running code. */
  public static ExternalProcess of(Frame frame, PluggedContext context) {
    UrbiLobby lobby = (UrbiLobby) frame.job().lobby();
    if (lobby.remoteObjects() instanceof ExternalProcess known) {
      return known;
    }
    var made = new ExternalProcess(lobby, frame.job().scheduler(), context);
    lobby.attach(made);
    return made;
  }

  /** The variables that the process uses. */
  public ExternalVariables variables() {
    return variables;
  }

  /** The events that the process listens to. */
  public ExternalEvents events() {
    return events;
  }

  /** From now on the process sends messages. */
  public void beginBinaryMode() {
    lobby.shell().switchTo(new BinaryMode(this, this::broken));
  }

  private void broken(String why) {
    Diagnostics.error(lobby.output(), Problem.PROTOCOL_BROKEN.text(why));
    lobby.shell().close();
  }

  // ------------------------------------------------------------------ what it declares

  /**
   * {@code external object}: the process has an object, which replaces the slot of that name in the
   * lobby.
   *
   * @throws IllegalArgumentException if an object of another process has that name, or there is no
   *     slot
   */
  public void declareObject(String name) {
    Symbol slot = lobby.world().symbol(Utf8Text.toUrbi(name));
    if (objects.containsKey(name)) {
      lobby.removeSlot(slot);
      access.show(name);
      declared.add(name);
      return;
    }
    if (access.find(name) != null) {
      refused.add(name);
      throw new IllegalArgumentException(Problem.NAME_TAKEN.text(name));
    }
    if (lobby.localSlot(slot) == null) {
      throw new IllegalArgumentException(Problem.NO_OBJECT.text(name));
    }
    lobby.removeSlot(slot);
    UClass type = new UClass(name, module, this::make);
    declaring = true;
    try {
      context.start(type);
    } finally {
      declaring = false;
    }
    classes.add(type);
  }

  /**
   * {@code external function}: one of its objects has a function, which replaces one of the same
   * name.
   *
   * @throws IllegalArgumentException if the object does not belong to the process
   */
  public void declareFunction(int arity, String name) {
    int dot = name.lastIndexOf('.');
    String object = name.substring(0, Math.max(dot, 0));
    if (refused.contains(object)) {
      return;
    }
    RemoteObject known = objects.get(object);
    if (known == null) {
      throw new IllegalArgumentException(Problem.NOT_ITS_OBJECT.text(object));
    }
    String function = name.substring(dot + 1);
    known.bindRemote(function, arity);
    if (function.equals("init")) {
      made(object);
    }
  }

  /** Whether a variable or an event has the name of an object that belongs to somebody else. */
  boolean isRefused(String name) {
    return refused.contains(name.substring(0, Math.max(name.lastIndexOf('.'), 0)));
  }

  @Override
  public void unnotify(String variable, double times) {
    variables.unuse(variable, times);
  }

  @Override
  public void statementOver() {
    if (!declared.isEmpty()) {
      List.copyOf(declared).forEach(this::made);
    }
  }

  private void made(String object) {
    declared.remove(object);
    CompletableFuture<Void> waiting = wanted.remove(object);
    if (waiting != null) {
      waiting.complete(null);
    }
  }

  // ------------------------------------------------------------------ objects

  /**
   * Creates the counterpart of an urbiscript object: one that the process has declared, or one that
   * it is asked to create.
   */
  private UObject make(String name) {
    if (lost != null) {
      throw new IllegalStateException(lost);
    }
    RemoteObject object = new RemoteObject(this, name);
    objects.put(name, object);
    access.markRemote(name, lobby);
    if (!declaring) {
      makeThere(name);
    }
    return object;
  }

  private void makeThere(String name) {
    String parent = access.parentOf(name);
    if (parent == null) {
      throw new IllegalStateException(Problem.WITHOUT_PROTOTYPE.text(name));
    }
    var made = new CompletableFuture<Void>();
    wanted.put(name, made);
    StringBuilder text = message(NEW, name);
    ValueText.quote(text.append(", "), parent);
    send(text);
    try {
      context.await(made, CREATION_TIMEOUT);
    } finally {
      wanted.remove(name);
    }
    if (lost != null) {
      throw new IllegalStateException(lost);
    }
    if (made.isCancelled()) {
      throw new IllegalStateException(Problem.NOT_MADE_IN_TIME.text(CREATION_TIMEOUT.toSeconds()));
    }
  }

  @Override
  public void gone(RemoteObject object) {
    String name = object.get__name();
    if (objects.remove(name, object) && lost == null) {
      declared.remove(name);
      variables.forget(name);
      events.forget(name);
      send(message(DELETE, name));
    }
  }

  // ------------------------------------------------------------------ calls

  @Override
  public CompletionStage<UValue> call(String object, String function, UValue... arguments) {
    var result = new CompletableFuture<UValue>();
    if (lost != null) {
      result.completeExceptionally(new IllegalStateException(lost));
      return result;
    }
    String id = "_" + ++lastCall;
    StringBuilder text = message(CALL, object + "." + function + "__" + arguments.length);
    ValueText.quote(text.append(", "), id);
    for (UValue argument : arguments) {
      ValueText.append(text.append(", "), argument);
    }
    calls.put(id, result);
    send(text);
    return result;
  }

  /** The prefix that the SDK puts before the text of an exception thrown by a function. */
  private static final Pattern THROWN =
      Pattern.compile(
          "(Exception while calling remote bound method|"
              + "exception caught while calling remote method): ");

  /**
   * The result of a call; if nobody waits for it, nothing happens.
   *
   * @param error the text of the exception, or null
   */
  public void reply(String call, @Nullable UValue value, @Nullable String error) {
    CompletableFuture<UValue> waiting = calls.remove(call);
    if (waiting == null) {
      return;
    }
    if (error == null) {
      waiting.complete(value);
    } else {
      RuntimeException thrown = new RuntimeException(THROWN.matcher(error).replaceFirst(""));
      thrown.setStackTrace(new StackTraceElement[0]);
      waiting.completeExceptionally(thrown);
    }
  }

  // ------------------------------------------------------------------ messages

  /** Sets a variable on behalf of the process. */
  void assign(Frame frame, String variable, UValue value) {
    if (!isRefused(variable)) {
      attempt(frame, variable, () -> variables.assign(frame, variable, value));
    }
  }

  /** Emits an event on behalf of the process. */
  void emit(Frame frame, String event, List<UValue> payload) {
    if (!isRefused(event)) {
      UValue[] arguments = payload.toArray(UValue[]::new);
      attempt(frame, event, () -> context.event(event).emit(arguments));
    }
  }

  /**
   * Executes a request of the process; a failure becomes an urbiscript error.
   *
   * @param subject the beginning of the error text
   */
  public static void attempt(Frame frame, String subject, Runnable task) {
    try {
      task.run();
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw frame
          .interpreter()
          .errors()
          .primitive(
              Utf8Text.toUrbi(subject),
              Problem.REASON,
              Utf8Text.toUrbi(String.valueOf(e.getMessage())));
    }
  }

  /** Starts a message with a code and a name. */
  StringBuilder message(int code, String name) {
    StringBuilder text = new StringBuilder().append('[').append(code).append(", ");
    ValueText.quote(text, name);
    return text;
  }

  /** Access to the UObjects of the kernel. */
  ObjectAccess access() {
    return access;
  }

  /** Completes a message and sends it. */
  void send(StringBuilder text) {
    if (lost == null) {
      lobby.output().send(CHANNEL, text.append(']').toString());
    }
  }

  // ------------------------------------------------------------------ the end

  @Override
  public @Nullable String lost() {
    return lost;
  }

  @Override
  public void disconnected() {
    if (lost != null) {
      return;
    }
    lost = Problem.PROCESS_GONE.text();
    List<CompletableFuture<UValue>> waiting = List.copyOf(calls.values());
    calls.clear();
    waiting.forEach(call -> call.completeExceptionally(new IllegalStateException(lost)));
    List.copyOf(wanted.values()).forEach(object -> object.complete(null));
    scheduler.startDetached(context.lobby(), scheduler.rootScope(), "remote", job -> clear());
  }

  private void clear() {
    variables.clear();
    events.clear();
    List<RemoteObject> all = List.copyOf(objects.values());
    objects.clear();
    all.forEach(UObject::clean);
    classes.forEach(context::stop);
    module.leave(context);
  }
}
