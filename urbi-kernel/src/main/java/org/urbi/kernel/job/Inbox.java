package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Receiver;
import org.urbi.kernel.time.Clock;

/**
 * The only way into the kernel: everything from outside is a {@link Message} that waits here, in
 * order of arrival, until the next tick begins.
 *
 * <p>Messages are addressed to receivers by number. A receiver created on the kernel thread is
 * given the {@link #register next number} there; one that appears outside (a connection, say)
 * {@link #reserve reserves} a number, and its first message announces it to the kernel.
 */
public final class Inbox {
  /** How many messages one tick takes at most: a flood must not keep the jobs from running. */
  private static final int MOST_PER_TICK = 1 << 16;

  /**
   * For how long a tick takes messages at most, in nanoseconds: a crowd that connects must not keep
   * the timers from firing.
   */
  private static final long SLICE = 2_000_000;

  /** How many ticks in a row wait for the memory to take what a client has sent. */
  private static final int LONGEST_WANT = 50;

  private final Journal journal;
  private final ConcurrentLinkedQueue<Message> messages = new ConcurrentLinkedQueue<>();

  /** What is for those for whom everything else waits, by their numbers. */
  private final Map<Integer, Queue<Message>> exclusive = new ConcurrentHashMap<>();

  private final AtomicInteger reserved = new AtomicInteger();
  private volatile boolean filled;
  private volatile @Nullable Thread waiting;
  private volatile KernelPoller.@Nullable Wait elsewhere;

  private final Map<Integer, Receiver> receivers = new ConcurrentHashMap<>();

  // These are the kernel thread's own.
  private int registered = Message.FIRST_FREE;
  private KernelPoller listening = KernelPoller.NONE;
  private BiConsumer<Message, Throwable> failures = (message, failure) -> {};
  private final List<Message.Lasting> unfinished = new ArrayList<>();

  /** How many ticks in a row have left messages unfinished. */
  private int wanting;

  public Inbox(Journal journal) {
    this.journal = journal;
  }

  // ------------------------------------------------------------------ from any thread

  /** Adds a message. In a replay only recorded messages are taken. */
  public void post(Message message) {
    if (journal.isReplay()) {
      return;
    }
    Queue<Message> own = exclusive.isEmpty() ? null : exclusive.get(message.to());
    if (own == null) {
      messages.add(message);
      filled = true;
    } else {
      own.add(message);
      if (exclusive.get(message.to()) != own && own.remove(message)) {
        // Nobody takes it there any more.
        post(message);
        return;
      }
    }
    Thread sleeper = waiting;
    if (sleeper != null) {
      LockSupport.unpark(sleeper);
    }
    KernelPoller.Wait other = elsewhere;
    if (other != null) {
      other.wake();
    }
  }

  /** Reserves a number for a receiver that the kernel does not know yet. */
  public int reserve() {
    return -reserved.incrementAndGet();
  }

  /** Registers a receiver under a reserved number. */
  public void register(int number, Receiver receiver) {
    receivers.put(number, receiver);
  }

  boolean isFilled() {
    return filled;
  }

  /**
   * Whether there was no memory for a message, which is to be taken again; on the kernel thread.
   */
  boolean isWanting() {
    return !unfinished.isEmpty();
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Registers a receiver and returns its new number. */
  public int register(Receiver receiver) {
    receivers.put(registered, receiver);
    return registered++;
  }

  /** Removes a receiver: later messages to it are dropped. */
  public void forget(int number) {
    receivers.remove(number);
  }

  /**
   * A job holds the kernel thread from now on, and takes itself what comes for that number, in the
   * middle of a tick; all other messages wait.
   */
  public void takeAtOnce(int number) {
    exclusive.put(number, new ConcurrentLinkedQueue<>());
  }

  /** Ends {@link #takeAtOnce}: what has not been taken waits like all other messages. */
  public void endTakingAtOnce(int number) {
    Queue<Message> own = requireNonNull(exclusive.remove(number), "it was taken at once");
    for (Message left = own.poll(); left != null; left = own.poll()) {
      post(left);
    }
  }

  /**
   * Waits for the next message to a number for which {@link #takeAtOnce} was called; in that job,
   * which must stay on the kernel thread.
   *
   * @return null if there will be none: the thread was interrupted, or the recording says so
   */
  public @Nullable Message awaitAtOnce(int number) {
    Queue<Message> own = requireNonNull(exclusive.get(number), "it is taken at once");
    Message message = journal.nextAtOnce(own::poll);
    if (message == null && !journal.isReplay()) {
      journal.idle();
      waiting = Thread.currentThread();
      message = journal.nextAtOnce(own::poll);
      while (message == null && !Thread.currentThread().isInterrupted()) {
        LockSupport.park(this);
        message = journal.nextAtOnce(own::poll);
      }
      waiting = null;
    }
    return message;
  }

  /** Sets a poller, which the kernel thread asks for messages itself; before the kernel starts. */
  public void listenTo(KernelPoller how) {
    listening = how;
  }

  /** Sets who is told when a receiver throws something; before the kernel starts. */
  public void setFailures(BiConsumer<Message, Throwable> told) {
    failures = told;
  }

  /**
   * Delivers the waiting messages to their receivers; the rest in the next tick, if that takes
   * long.
   *
   * @param now the time of that clock
   */
  void take(Clock clock, long now) {
    takeUnfinished();
    if (!filled && !journal.isReplay()) {
      return;
    }
    // In a replay the recording says how many.
    boolean limited = clock.isReal() && !journal.isReplay();
    for (int left = MOST_PER_TICK; left > 0; left--) {
      Message message = journal.next(this::next);
      if (message == null) {
        return;
      }
      if (isBehindUnfinished(message, unfinished.size()) || !deliver(message)) {
        unfinished.add((Message.Lasting) message);
      }
      if (limited && clock.now() - now >= SLICE) {
        return;
      }
    }
  }

  private void takeUnfinished() {
    int kept = 0;
    for (Message.Lasting message : unfinished) {
      if (isBehindUnfinished(message, kept) || !deliver(message)) {
        unfinished.set(kept++, message);
      }
    }
    while (unfinished.size() > kept) {
      unfinished.removeLast();
    }
    wanting = kept == 0 ? 0 : wanting + 1;
  }

  /** Whether its receiver must first take another one, of so many unfinished messages. */
  private boolean isBehindUnfinished(Message message, int among) {
    if (!(message instanceof Message.Lasting) || message instanceof Message.Ending) {
      return false;
    }
    for (int i = 0; i < among; i++) {
      if (unfinished.get(i).to() == message.to()) {
        return true;
      }
    }
    return false;
  }

  private @Nullable Message next() {
    Message message = messages.poll();
    if (message == null) {
      filled = !unfinished.isEmpty();
      // One may have come between the two.
      message = messages.poll();
      if (message != null) {
        filled = true;
      }
    }
    return message;
  }

  /**
   * A failure in handling one message must not stop the others from being taken.
   *
   * @return whether that is all; if not, the message is to be delivered again
   */
  private boolean deliver(Message message) {
    Receiver receiver = receivers.get(message.to());
    if (receiver == null) {
      return true;
    }
    try {
      receiver.take(message);
    } catch (OutOfMemoryError failure) {
      if (message instanceof Message.Ending
          || message instanceof Message.Lasting && wanting < LONGEST_WANT) {
        return false;
      }
      failures.accept(message, failure);
    } catch (Throwable failure) {
      failures.accept(message, failure);
    }
    return true;
  }

  /** Waits for a message, for at most so many nanoseconds. */
  void await(long nanoseconds) {
    waiting = Thread.currentThread();
    try {
      if (!filled) {
        LockSupport.parkNanos(this, nanoseconds);
      }
    } finally {
      waiting = null;
    }
  }

  /** The kernel has nothing to do: waits for messages, for at most that many nanoseconds. */
  void listen(long nanoseconds) {
    KernelPoller.Wait wait = listening.begin(nanoseconds);
    if (wait == null) {
      await(nanoseconds);
      return;
    }
    elsewhere = wait;
    try {
      if (!filled) {
        wait.await();
      }
    } finally {
      elsewhere = null;
    }
    listening.poll();
  }

  /** The kernel is busy: polls if it has not done so for some time. */
  void pollIfDue(long now) {
    listening.pollIfDue(now);
  }

  /** The kernel has ended. */
  void close() {
    listening.close();
  }
}
