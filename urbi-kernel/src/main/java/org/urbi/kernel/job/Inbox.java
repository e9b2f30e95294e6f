package org.urbi.kernel.job;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Receiver;

/**
 * The one way in: everything that comes from the outside is a {@link Message} that waits here until
 * the next tick begins, in the order in which it came.
 *
 * <p>Messages are for receivers, which have numbers. What is made on the kernel thread gets its
 * number there, {@link #register in order}; what appears outside (a connection, say) has a {@link
 * #reserve reserved} one, and its first message tells the kernel of it.
 */
public final class Inbox {
  /** How many messages one tick takes at most: a flood must not keep the jobs from running. */
  private static final int MOST_PER_TICK = 1 << 16;

  private final Journal journal;
  private final ConcurrentLinkedQueue<Message> messages = new ConcurrentLinkedQueue<>();
  private final AtomicInteger reserved = new AtomicInteger();
  private volatile boolean filled;
  private volatile @Nullable Thread waiting;
  private volatile KernelPoller.@Nullable Wait elsewhere;

  private final Map<Integer, Receiver> receivers = new ConcurrentHashMap<>();

  // These are the kernel thread's own.
  private int registered = Message.FIRST_FREE;
  private KernelPoller listening = KernelPoller.NONE;
  private BiConsumer<Message, Throwable> failures = (message, failure) -> {};

  public Inbox(Journal journal) {
    this.journal = journal;
  }

  // ------------------------------------------------------------------ from any thread

  /** Leaves a message. In a replay, only what was recorded is taken. */
  public void post(Message message) {
    if (journal.isReplay()) {
      return;
    }
    messages.add(message);
    filled = true;
    Thread sleeper = waiting;
    if (sleeper != null) {
      LockSupport.unpark(sleeper);
    }
    KernelPoller.Wait other = elsewhere;
    if (other != null) {
      other.wake();
    }
  }

  /** A number for a receiver of which the kernel does not know yet. */
  public int reserve() {
    return -reserved.incrementAndGet();
  }

  /** Takes in a receiver with a number that it has already. */
  public void register(int number, Receiver receiver) {
    receivers.put(number, receiver);
  }

  boolean isFilled() {
    return filled;
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Takes in a receiver; returns the number that it has from now on. */
  public int register(Receiver receiver) {
    receivers.put(registered, receiver);
    return registered++;
  }

  /** Nothing more is for that receiver: what comes all the same is dropped. */
  public void forget(int number) {
    receivers.remove(number);
  }

  /** Sets another way to hear from the outside; before the kernel starts. */
  public void listenTo(KernelPoller how) {
    listening = how;
  }

  /** Sets who is told when a receiver throws something; before the kernel starts. */
  public void setFailures(BiConsumer<Message, Throwable> told) {
    failures = told;
  }

  /** Gives the messages that are there to their receivers. */
  void take() {
    if (!filled && !journal.isReplay()) {
      return;
    }
    for (int left = MOST_PER_TICK; left > 0; left--) {
      Message message = journal.next(this::next);
      if (message == null) {
        return;
      }
      deliver(message);
    }
  }

  private @Nullable Message next() {
    Message message = messages.poll();
    if (message == null) {
      filled = false;
      // One may have come between the two.
      message = messages.poll();
      if (message != null) {
        filled = true;
      }
    }
    return message;
  }

  /** Whatever a message brings about, the others are taken all the same. */
  private void deliver(Message message) {
    Receiver receiver = receivers.get(message.to());
    if (receiver != null) {
      try {
        receiver.take(message);
      } catch (Throwable failure) {
        failures.accept(message, failure);
      }
    }
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

  /** The kernel has nothing to do: hears what there is, for at most so many nanoseconds. */
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

  /** The kernel is busy: hears what there is, if it has not listened for long. */
  void pollIfDue(long now) {
    listening.pollIfDue(now);
  }

  /** The kernel has ended. */
  void close() {
    listening.close();
  }
}
