package org.urbi.kernel;

import static java.util.Objects.requireNonNull;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Interruptions;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.ErrorStyle;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Receiver;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/** A connection: what others ask of it are messages, the rest runs on the kernel thread. */
final class KernelConnection extends ConnectionParts
    implements Shell.Listener, Receiver, Evictable {
  /** With how many unread bytes a client is sent no more that users send to all. */
  private static final long MOST_FROM_OTHERS = 1 << 20;

  /** How much code of a client may put into the log in a second, in characters. */
  private static final int LOG_OF_CLIENT = 1 << 14;

  private final Client client;
  private final boolean holdsTime;
  private final AtomicInteger pending = new AtomicInteger();

  /**
   * Whether an interruption waits for the kernel behind all that was sent: another one would do
   * nothing more, and a client could fill the memory with them while the kernel is held.
   */
  private final AtomicBoolean interruptionWaits = new AtomicBoolean();

  private volatile boolean incomplete;
  private volatile @Nullable UrbiLobby lobby;
  private String limits = "";
  private volatile boolean program;
  private boolean awaited;
  private boolean holding;
  private boolean ended;
  private boolean finished;
  private volatile boolean gone;

  /** Whether it was asked to close, perhaps before it is open. */
  private volatile boolean closing;

  /** Whether its lobby has been left, and no message to it is taken any more. */
  private volatile boolean left;

  /** Its messages have a receiver of that number. */
  KernelConnection(Kernel kernel, int number, Client client, boolean holdsTime) {
    super(kernel, number);
    this.client = client;
    this.holdsTime = holdsTime;
  }

  // ------------------------------------------------------------------ from any thread

  @Override
  public void send(String bytes) {
    pending.addAndGet(bytes.length());
    interruptionWaits.set(false);
    try {
      kernel.inbox().post(new Message.ConsoleBytes(number, bytes));
    } catch (OutOfMemoryError e) {
      pending.addAndGet(-bytes.length());
      throw e;
    }
  }

  @Override
  public void end() {
    kernel.inbox().post(new Message.InputEnded(number));
  }

  @Override
  public void hangUp() {
    kernel.inbox().post(new Message.HungUp(number));
  }

  @Override
  public long runningTurn() {
    long turn = kernel.scheduler().turn();
    Job running = kernel.scheduler().running();
    boolean own = running != null && running.lobby() == lobby;
    return own && turn == kernel.scheduler().turn() ? turn : NO_TURN;
  }

  @Override
  public void close() {
    if (!gone) {
      closing = true;
      endWhatHolds();
      kernel.inbox().post(new Message.ConnectionClosed(number));
    }
  }

  @Override
  public void giveRole(Role role) {
    kernel.inbox().post(new Message.RoleGranted(number, role.name()));
  }

  @Override
  public void interrupt() {
    interruptRunning(Interruptions.EVERYTHING);
    if (interruptionWaits.compareAndSet(false, true)) {
      try {
        kernel.inbox().post(new Message.Interrupted(number));
      } catch (OutOfMemoryError e) {
        interruptionWaits.set(false);
        throw e;
      }
    }
  }

  @Override
  public String interrupt(String other) {
    UrbiLobby asking = lobby;
    if ((asking == null ? client.role() : asking.role()) != Role.OWNER) {
      return Problem.MAY_NOT_INTERRUPT.text();
    }
    return kernel.outOfBand().interrupt(other);
  }

  @Override
  public void failed(String where, Throwable failure) {
    FailureLog.internal(where, failure);
    kernel.inbox().post(new Message.ConnectionFailed(number, FailureLog.text(failure)));
  }

  @Override
  public Budget budget() {
    return lobby().budget();
  }

  @Override
  public String description() {
    return lobby().description();
  }

  @Override
  public void evict(String why) {
    evict(lastStatement(), why);
  }

  long lastStatement() {
    return lobby().shell().lastStatement();
  }

  /** Ends what statements up to that number do: those behind it are not to blame. */
  void evict(long last, String why) {
    interruptRunning(job -> !lobby().shell().isAfter(job, last));
    kernel.inbox().post(new Message.Evicted(number, last, why));
  }

  @Override
  public boolean isAtWork() {
    return budget().used(Resource.JOBS) > 0;
  }

  /**
   * Its client leaves: what runs for it is interrupted. That request is over with the first job
   * that obeys, and with the message; what begins later has a limit instead.
   */
  private void endWhatHolds() {
    UrbiLobby of = lobby;
    if (of != null && !program) {
      of.budget().abandon();
    }
    // A second interruption would never be cleared: one message clears only one.
    interruptRunning(Interruptions.EVERYTHING);
  }

  /**
   * Code that never lets others run cannot be reached by a message, so it is interrupted at once.
   */
  private void interruptRunning(Predicate<Job> which) {
    UrbiObject of = lobby;
    if (of != null) {
      kernel.scheduler().interruptions().request(of, which);
      if (left) {
        // The message behind it will not be taken any more.
        kernel.scheduler().interruptions().withdraw(of);
      }
    }
  }

  @Override
  public int pendingInput() {
    return pending.get();
  }

  @Override
  public boolean incomplete() {
    return incomplete;
  }

  // ------------------------------------------------------------------ on the kernel thread

  void open(Message.ConnectionOpened opened) {
    if (kernel.isStopping()) {
      finished = true;
      client.closed();
      return;
    }
    kernel.inbox().register(number, this);
    program = opened.program();
    awaited = opened.awaited();
    Budget budget = new Budget(this::limited);
    limits = opened.budget();
    budget.setLimits(limits);
    if (!program) {
      budget.limitLog(LOG_OF_CLIENT);
    }
    Output output =
        new Output(
            kernel.scheduler(),
            this::show,
            () -> isFull(budget),
            this::isBehind,
            ErrorStyle.valueOf(opened.errors()));
    Role role = Role.valueOf(opened.role());
    UrbiLobby made = UrbiLobby.start(kernel.interpreter(), output, this, role, budget);
    made.setRemoteAddress(opened.address());
    lobby = made;
    kernel.connections().add(this);
    made.shell().start();
    if (closing) {
      endWhatHolds();
    }
  }

  private void limited(Resource what, long limit) {
    if (what == Resource.DEPTH) {
      kernel.interpreter().budgetDepth(limit);
    } else {
      kernel.outOfBand().watchBudget(what, limit);
    }
  }

  private boolean isBehind() {
    return kernel.scheduler().time().attempt(() -> client.unread() > MOST_FROM_OTHERS);
  }

  private boolean isFull(Budget budget) {
    return budget.limit(Resource.OUTPUT) != Budget.UNLIMITED
        && kernel
            .scheduler()
            .time()
            .attempt(() -> !budget.allows(Resource.OUTPUT, client.unread()));
  }

  private void show(String bytes) {
    kernel.journal().sent(number, bytes.getBytes(StandardCharsets.ISO_8859_1));
    if (!kernel.journal().isOver()) {
      client.output(bytes);
    }
  }

  @Override
  public void take(Message message) {
    // No pattern switch: the JDK links one anew in each process, which would slow down short
    // scripts.
    if (message instanceof Message.ConsoleBytes sent) {
      received(sent.bytes());
    } else if (message instanceof Message.InputEnded) {
      inputEnded();
    } else if (message instanceof Message.HungUp) {
      hungUp();
    } else if (message instanceof Message.Interrupted) {
      interrupted();
    } else if (message instanceof Message.RoleGranted given) {
      roleGiven(Role.valueOf(given.role()));
    } else if (message instanceof Message.Ending ending) {
      end(ending);
    } else if (message instanceof Message.ConnectionFailed failed) {
      tell(failed.error());
    } else if (message instanceof Message.CompletionRequested asked) {
      takeCompletion(asked, finished ? null : lobby());
    } else if (finished) {
      closeParts();
    } else if (!takePart(message)) {
      throw new IllegalArgumentException(message.toString());
    }
  }

  private void end(Message.Ending ending) {
    kernel.scheduler().interruptions().clear(lobby());
    try {
      if (ending instanceof Message.Evicted evicted) {
        evicted(evicted.last(), evicted.reason());
      } else {
        closed();
      }
    } catch (OutOfMemoryError e) {
      // Until there is memory to end them, its jobs must not take more.
      interruptRunning(Interruptions.EVERYTHING);
      throw e;
    }
  }

  private void closed() {
    gone = true;
    finish();
    left = true;
    kernel.scheduler().interruptions().clear(lobby());
    closeCompletions();
    if (!kernel.departed().has(this)) {
      forget();
    }
  }

  /** Forgets the connection, if its client is gone: what that had left behind has ended. */
  void forget() {
    if (gone) {
      kernel.inbox().forget(number);
      client.forgotten();
    }
  }

  /** Takes messages again: jobs run for it although its client is gone. */
  void remember() {
    kernel.inbox().register(number, this);
  }

  private void received(String bytes) {
    if (finished) {
      pending.set(0);
    } else {
      lobby().shell().receive(bytes);
    }
  }

  private void inputEnded() {
    ended = true;
    releaseTime();
    if (!finished) {
      lobby().shell().end();
    }
  }

  private void hungUp() {
    inputEnded();
    if (!finished) {
      lobby().shell().hangUp();
    }
  }

  private void interrupted() {
    // First of all: a request from now on has a message of its own, which clears it.
    interruptionWaits.set(false);
    kernel.scheduler().interruptions().clear(lobby());
    if (!finished) {
      lobby().shell().interrupt();
      consumed();
    }
  }

  private void roleGiven(Role role) {
    if (!finished) {
      lobby().setRole(role, kernel.scheduler().jobs());
    }
  }

  private void evicted(long last, String reason) {
    if (finished) {
      kernel.departed().end(this, reason);
    } else {
      lobby().shell().evict(last);
      kernel.lobbies().evictAll(budget());
      tell(Problem.EVICTED.text(reason));
      consumed();
    }
  }

  /** Tells the client of an error; on the kernel thread. */
  void tell(String error) {
    UrbiLobby told = lobby;
    if (!finished && told != null) {
      Diagnostics.error(told.output(), error);
    }
  }

  @Override
  boolean isGone() {
    return gone;
  }

  @Override
  UrbiLobby lobby() {
    return requireNonNull(lobby, "its messages come when it is open");
  }

  /** The limits of its budget as options say them. */
  String limits() {
    return limits;
  }

  /** Simulated time stands still while the shell waits for input that is about to arrive. */
  @Override
  public void starving(boolean begins) {
    if (begins && holdsTime && !ended) {
      holding = true;
      kernel.scheduler().time().hold();
    } else {
      releaseTime();
    }
  }

  private void releaseTime() {
    if (holding) {
      holding = false;
      kernel.scheduler().time().release();
    }
  }

  @Override
  public void consumed() {
    pending.set(lobby().shell().pending());
    incomplete = lobby().shell().isIncomplete();
    client.inputConsumed();
  }

  @Override
  public void finished() {
    finish();
  }

  @Override
  public void failed() {
    client.failed();
  }

  @Override
  public void binary() {
    client.binary();
  }

  @Override
  public boolean stays() {
    return program || left;
  }

  /**
   * Whether more may happen because of it: its client may send input, or something besides its jobs
   * is active for it.
   */
  boolean isAwaited() {
    return awaited && !(program && ended);
  }

  /** The end of the program's connection, once nothing can wake the kernel. */
  void finishProgram() {
    if (program && ended && lobby().shell().isDaemon()) {
      finish();
    }
  }

  /** Closes the connection, whichever side has ended it. */
  void finish() {
    if (!finished) {
      finished = true;
      try {
        leave();
      } catch (OutOfMemoryError e) {
        // It is still to be left, when there is memory.
        finished = false;
        throw e;
      }
    }
  }

  private void leave() {
    releaseTime();
    closeParts();
    pending.set(0);
    UrbiLobby own = lobby;
    if (own != null) {
      own.shell().close();
      own.output().close();
    }
    kernel.connections().remove(this);
    if (own != null && !kernel.isStopping()) {
      own.disconnected(kernel.interpreter(), kernel.lobbies());
      if (!program) {
        own.budget().abandon();
        kernel.departed().left(this);
      }
    }
    client.closed();
  }
}
