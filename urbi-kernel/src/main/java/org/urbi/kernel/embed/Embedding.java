package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.tag.UrbiTag;

/**
 * The interface between a kernel and the Java program that embeds it. It may be used from any
 * thread: each request becomes a job of one shared lobby (manual, "Lobby"), and the caller waits
 * for the end of that job.
 *
 * <p>Simulated time passes only while a thread waits for the kernel: for an evaluation, a call, or
 * the end of the kernel. Between two evaluations it stands still.
 */
public final class Embedding {
  private final Interpreter interpreter;
  private final Scheduler scheduler;
  private final BooleanSupplier stopping;
  private final ListenerQueue<String> output;
  private final ProgramTasks tasks;
  private final ProgramEviction eviction;
  private final AtomicInteger last = new AtomicInteger();

  /** The number of threads that wait for the end of the kernel. */
  private final AtomicInteger waiters = new AtomicInteger();

  private volatile boolean used;

  /** Requests that have not been answered yet, by number. */
  private final Map<Integer, Request<?>> pending = new ConcurrentHashMap<>();

  /** The action that ends each registration of a listener, by number. Used on the kernel thread. */
  private final Map<Integer, Runnable> listenings = new HashMap<>();

  private volatile boolean closing;
  private volatile boolean over;
  private volatile @Nullable UrbiLobby lobby;
  private int waitingForEnd;
  private int running;
  private boolean holdsTime;
  private int lastHandle;

  /** In a replay there is no program whose handles keep their objects. */
  private final Map<Integer, UrbiObject> replayed = new HashMap<>();

  /**
   * @param output receives the output of the lobby, on a thread of its own
   * @param stopping whether the kernel is about to end; asked on the kernel thread
   */
  public Embedding(Interpreter interpreter, Consumer<String> output, BooleanSupplier stopping) {
    this.interpreter = interpreter;
    this.scheduler = interpreter.scheduler();
    this.stopping = stopping;
    this.tasks = new ProgramTasks(this);
    this.eviction = new ProgramEviction(scheduler, () -> lobby);
    this.output = new ListenerQueue<>(scheduler, bytes -> output.accept(Utf8Text.toJava(bytes)));
    scheduler.inbox().register(Message.EMBEDDING, this::take);
  }

  private void take(Message message) {
    switch (message) {
      case Message.OfProgram asked -> begin(asked);
      case Message.ProgramEvicted evicted ->
          eviction.obey(evicted, interpreter.values().voidObject);
      case Message.EmbeddingCancel cancel -> cancel(cancel.number());
      case Message.EmbeddingWaits waits -> {
        waitingForEnd = waits.threads();
        if (lobby != null) {
          reviewTime();
        }
      }
      default -> throw new IllegalArgumentException(message.toString());
    }
  }

  private void begin(Message.OfProgram asked) {
    Request<?> request = pending.get(asked.number());
    if (request != null) {
      request.begin();
    } else if (asked instanceof Message.FunctionDefined) {
      scheduler.journal().missing(asked);
    } else if (scheduler.journal().isReplay()) {
      request = new Request<>(this, asked, RequestAttachments.of(replayed));
      pending.put(asked.number(), request);
      request.begin();
    }
  }

  private void cancel(int number) {
    Request<?> request = pending.get(number);
    if (request != null) {
      request.cancelled();
    }
    Runnable end = listenings.remove(number);
    if (end != null) {
      end.run();
    }
  }

  /** The embedding program, as one of those who use the memory. */
  public Evictable evictable() {
    return eviction;
  }

  Interpreter interpreter() {
    return interpreter;
  }

  Scheduler scheduler() {
    return scheduler;
  }

  boolean isStopping() {
    return closing || stopping.getAsBoolean();
  }

  /** Whether a request that comes now is too late, as a replay is told; on the kernel thread. */
  boolean refuses() {
    return !scheduler.time().attempt(() -> !isStopping());
  }

  ProgramTasks tasks() {
    return tasks;
  }

  ProgramEviction eviction() {
    return eviction;
  }

  /** A handle for the program; on the kernel thread. */
  UrbiValue handle(UrbiObject object) {
    lastHandle++;
    if (scheduler.journal().isReplay()) {
      replayed.put(lastHandle, object);
    }
    return new UrbiValue(this, lastHandle, object);
  }

  static IllegalStateException ended() {
    return new IllegalStateException(Problem.KERNEL_ENDED.text());
  }

  // ------------------------------------------------------------------ evaluation

  /** Evaluates source text in the lobby of this program; see {@code Kernel.eval}. */
  public @Nullable Object eval(String source) {
    return eval(source, null, null, Object.class);
  }

  /**
   * Evaluates source text.
   *
   * @param file the name by which errors call it, or null
   * @param target {@code this} of the text; null for the lobby
   * @param type what to return the value of the last statement as, see {@link JavaValues#as}
   */
  public <T> @Nullable T eval(
      String source, @Nullable String file, @Nullable UrbiValue target, Class<T> type) {
    GivenValues given = new GivenValues(this);
    int object = target == null ? 0 : given.number(target);
    Object value =
        await(
            number -> evaluation(number, object, source, file, type),
            RequestAttachments.of(given.objects()));
    return JavaValues.as(value, type);
  }

  private static Message.OfProgram evaluation(
      int number, int object, String source, @Nullable String file, Class<?> type) {
    return new Message.SourceEvaluated(
        number,
        object,
        Utf8Text.toUrbi(source),
        file == null ? null : Utf8Text.toUrbi(file),
        JavaValues.form(type));
  }

  /** Evaluates source text, without waiting; see {@code Kernel.evalAsync}. */
  public CompletableFuture<Object> evalAsync(String source) {
    Request<Object> request =
        begin(
            number -> evaluation(number, 0, source, null, Object.class),
            RequestAttachments.of(Map.of()));
    CompletableFuture<Object> result = new CompletableFuture<>();
    // Actions that depend on the result must not run on the kernel thread.
    request
        .future()
        .whenCompleteAsync(
            (value, failure) -> {
              if (failure == null) {
                result.complete(value);
              } else {
                result.completeExceptionally(failure);
              }
            },
            ListenerQueue.THREADS);
    result.whenComplete((value, failure) -> {
      if (result.isCancelled()) {
        request.cancel();
      }
    });
    return result;
  }

  /** Calls a function of the lobby or, by a dotted name, of another object. */
  public @Nullable Object call(String function, Object... arguments) {
    GivenValues given = new GivenValues(this);
    Data read = given.list(arguments);
    return await(
        number -> new Message.MethodCalled(number, 0, Utf8Text.toUrbi(function), read),
        RequestAttachments.of(given.objects()));
  }

  /** Gives urbiscript a function written in Java; see {@code Kernel.define}. */
  public void define(String name, Function<? super List<Object>, ?> function) {
    String bytes = Utf8Text.toUrbi(name);
    var body = new JavaFunction(this, bytes.substring(bytes.lastIndexOf('.') + 1), function);
    await(number -> new Message.FunctionDefined(number, bytes), RequestAttachments.of(body));
  }

  // ------------------------------------------------------------------ listening

  /** Listens to an event; see {@code Kernel.onEvent}. */
  public ListenerRegistration onEvent(String expression, Consumer<? super List<Object>> listener) {
    String bytes = Utf8Text.toUrbi(expression);
    return known(
        number -> new Message.Listened(number, bytes, false), RequestAttachments.of(listener));
  }

  /** Listens to the changes of an expression; see {@code Kernel.onChange}. */
  public ListenerRegistration onChange(String expression, Consumer<Object> listener) {
    String bytes = Utf8Text.toUrbi(expression);
    return known(
        number -> new Message.Listened(number, bytes, true),
        RequestAttachments.of((List<Object> payload) -> listener.accept(payload.getFirst())));
  }

  // ------------------------------------------------------------------ the lobby

  /** The lobby in which the program's code is evaluated. */
  public UrbiValue lobby() {
    return known(number -> new Message.ScopeWanted(number, false), RequestAttachments.of(Map.of()));
  }

  /**
   * A new object on which code can be evaluated. It inherits from the lobby and, like a lobby,
   * allows its slots to be redefined.
   */
  public UrbiValue newScope() {
    return known(number -> new Message.ScopeWanted(number, true), RequestAttachments.of(Map.of()));
  }

  /** A request begins; on the kernel thread. */
  UrbiLobby began() {
    UrbiLobby known = lobby;
    if (known == null) {
      UrbiTag tag = UrbiTag.named(interpreter, "Lobby_" + scheduler.nextNumber());
      known = new UrbiLobby(interpreter.world().prototype("Lobby").cloneShape(), tag);
      known.attach(new Output(scheduler, this::send));
      lobby = known;
    }
    running++;
    reviewTime();
    return known;
  }

  private void send(String bytes) {
    scheduler.journal().sent(Message.EMBEDDING, bytes.getBytes(StandardCharsets.ISO_8859_1));
    output.post(bytes);
  }

  /** The lobby; on the kernel thread. */
  UrbiLobby own() {
    return requireNonNull(lobby, "made when the first request began");
  }

  /** A request has been completed; on the kernel thread. */
  void finished() {
    running--;
    reviewTime();
  }

  private void reviewTime() {
    boolean hold = running == 0 && waitingForEnd == 0;
    if (hold && !holdsTime) {
      scheduler.time().hold();
    } else if (!hold && holdsTime) {
      scheduler.time().release();
    }
    holdsTime = hold;
  }

  // ------------------------------------------------------------------ requests

  /**
   * Asks the kernel, and waits for the answer.
   *
   * @param what makes the message with that number
   * @throws UrbiError if it fails
   * @throws IllegalStateException on the kernel thread, or when the kernel has ended
   * @throws CancellationException if the job was stopped, or the waiting thread interrupted
   */
  private <T> @Nullable T await(IntFunction<Message.OfProgram> what, RequestAttachments attached) {
    if (scheduler.isKernelThread()) {
      throw new IllegalStateException(
          "the kernel thread cannot wait for an evaluation: use another thread, or evalAsync");
    }
    Request<T> request = begin(what, attached);
    try {
      return request.future().get();
    } catch (InterruptedException e) {
      request.cancel();
      Thread.currentThread().interrupt();
      throw new CancellationException("interrupted while the kernel evaluated");
    } catch (CancellationException e) {
      // The future would tell that it was asked for its result, and no more.
      throw Request.stopped();
    } catch (ExecutionException e) {
      throw switch (e.getCause()) {
        case UrbiError error -> error.here();
        case OutOfMemoryError none ->
            UrbiErrorConverter.simple(Problem.MEMORY_EXHAUSTED.text(), none);
        case IllegalStateException over -> new IllegalStateException(over.getMessage(), over);
        case Throwable other -> new IllegalStateException(other);
      };
    } finally {
      flushOutput();
    }
  }

  /** Like {@link #await}, for what is never nil. */
  private <T> T known(IntFunction<Message.OfProgram> what, RequestAttachments attached) {
    return requireNonNull(this.<T>await(what, attached), "what is asked for is there");
  }

  /**
   * Like {@link #await}, but runs the task at once when called within a Java function that
   * urbiscript code has called.
   */
  // Who asks knows what comes of it.
  @SuppressWarnings("unchecked")
  <T> @Nullable T ask(IntFunction<Message.OfProgram> what, GivenValues given) {
    RequestAttachments attached = RequestAttachments.of(given.objects());
    Frame caller = JavaFunction.caller();
    if (caller == null || caller.interpreter() != interpreter) {
      return await(what, attached);
    }
    try {
      return (T) tasks.run(caller, what.apply(0), attached);
    } catch (UrbiException e) {
      throw UrbiErrorConverter.of(this, caller, e);
    }
  }

  private <T> Request<T> begin(IntFunction<Message.OfProgram> what, RequestAttachments attached) {
    if (!used) {
      used = true;
      postWaiters();
    }
    Message.OfProgram asked = what.apply(last.incrementAndGet());
    Request<T> request = new Request<>(this, asked, attached);
    pending.put(request.number(), request);
    scheduler.inbox().post(asked);
    if (over) {
      // The kernel no longer reads its inbox.
      request.fail(ended());
    }
    return request;
  }

  void forget(Request<?> request) {
    pending.remove(request.number());
  }

  /**
   * Registers a listener of the program; on the kernel thread.
   *
   * @param number of the request
   * @param atOnce called at once when the registration is closed, on any thread
   * @param then called after that on the kernel thread
   */
  ListenerRegistration listening(int number, Runnable atOnce, Runnable then) {
    listenings.put(number, then);
    return () -> {
      atOnce.run();
      scheduler.inbox().post(new Message.EmbeddingCancel(number));
    };
  }

  // ------------------------------------------------------------------ the end

  /** Runs an action that waits for the end of the kernel. Meanwhile simulated time may pass. */
  public void awaitEnd(Runnable wait) {
    if (scheduler.isKernelThread()) {
      throw new IllegalStateException("the kernel thread cannot wait for its own end");
    }
    waiters.incrementAndGet();
    postWaiters();
    try {
      wait.run();
    } finally {
      waiters.decrementAndGet();
      postWaiters();
    }
    flushOutput();
  }

  /** Without any request there is no lobby yet, whose input could hold back simulated time. */
  private void postWaiters() {
    if (used) {
      scheduler.inbox().post(new Message.EmbeddingWaits(waiters.get()));
    }
  }

  /**
   * Interrupts the program's code, so that the kernel can end even if that code never lets others
   * run.
   */
  public void close() {
    closing = true;
    UrbiLobby of = lobby;
    if (of != null) {
      scheduler.interruptions().request(of);
    }
  }

  /** The kernel has ended: fails all requests that are still waiting. On the kernel thread. */
  public void kernelEnded() {
    over = true;
    UrbiLobby of = lobby;
    if (of != null) {
      of.output().close();
    }
    output.start();
    pending.values().forEach(request -> request.fail(ended()));
  }

  private void flushOutput() {
    try {
      output.flush();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
