package org.urbi.server.studio.mcap;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.observe.Bytes;
import org.urbi.kernel.observe.VariableKind;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Version;
import org.urbi.server.studio.messages.Form;
import org.urbi.server.studio.messages.RosType;
import org.urbi.server.studio.messages.Topic;

/**
 * Records all variables, the log, the jobs and their turns to an MCAP file, on a thread of its own.
 * When the disk is slower than the values come, some are left out, and the log tells how many; when
 * it is full, the recording ends, and what was written before can be read.
 */
public final class McapRecorder implements AutoCloseable {
  /** After how much time at the latest a value is in the file, in nanoseconds. */
  private static final long FLUSH = 1_000_000_000;

  /** How much may wait for the disk, roughly in bytes. */
  private static final long MOST_WAITING = 64 << 20;

  /** How long a disk that takes nothing is waited for at the end of the process. */
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  private static final int SMALL = 100;
  private static final int LOG = 0;

  /** Variables have numbers from 1 on. */
  private static final int JOBS = Integer.MAX_VALUE;

  private static final int TURNS = JOBS - 1;

  private sealed interface Event {
    record Appeared(int variable, Topic topic) implements Event {}

    record Value(int variable, long time, @Nullable Object value) implements Event {}

    /** What has become of the jobs until the end of the kernel. */
    record Seen(View view) implements Event {}

    /**
     * @param looks whether the jobs are looked at once more
     */
    record End(boolean looks) implements Event {}
  }

  private final Path path;
  private final McapFile file;
  private final Connection connection;
  private final Consumer<String> log;
  private final Runnable broken;
  private final BlockingQueue<Event> events = new LinkedBlockingQueue<>();
  private final AtomicLong waiting = new AtomicLong();
  private final AtomicLong lost = new AtomicLong();
  private final Map<Integer, Topic> topics = new HashMap<>();

  /** The numbers of the channels in the file; a variable without any value needs none. */
  private final Map<Integer, Integer> rosChannels = new HashMap<>();

  /** Likewise, of variables that have values for which ROS has no type: a number that is nil. */
  private final Map<Integer, Integer> jsonChannels = new HashMap<>();

  private final Clock clock = new SystemClock();
  private final JobsObserver jobs;
  private final Thread writer = FailureLog.THREADS.platform("urbi-mcap", this::run);
  private long flushAt;
  private volatile boolean failed;
  private volatile boolean abandoned;

  /**
   * Begins to record.
   *
   * @param connect opens a connection to the kernel
   * @param watched the paths of slots that are recorded besides the variables
   * @param withJobs whether to record jobs and turns, too. To look at them takes the kernel a
   *     moment at times that depend on the machine, so what is simulated would not do the same each
   *     time
   * @param log is told what goes wrong
   * @param broken is called when the recording ends before it is closed, on its own thread
   * @throws IOException if the file cannot be written
   */
  public McapRecorder(
      Path path,
      Function<Client, Connection> connect,
      List<String> watched,
      boolean withJobs,
      Consumer<String> log,
      Runnable broken)
      throws IOException {
    this(path, connect, watched, withJobs, log, broken, Thread::start);
  }

  /**
   * @param begin starts the thread that writes, or throws if there is none
   */
  McapRecorder(
      Path path,
      Function<Client, Connection> connect,
      List<String> watched,
      boolean withJobs,
      Consumer<String> log,
      Runnable broken,
      Consumer<Thread> begin)
      throws IOException {
    this.path = path;
    this.log = log;
    this.broken = broken;
    file = new McapFile(path, "Urbi " + Version.number());
    topics.put(LOG, Topic.LOG);
    connection = connect.apply(new Observer());
    connection.feed(new Feed(), true, watched);
    jobs = new JobsObserver(connection, this::write, withJobs ? clock.now() : JobsObserver.NEVER);
    if (withJobs) {
      connection.lookAtEnd(jobs::wanted, this::seen);
    }
    try {
      begin.accept(writer);
    } catch (OutOfMemoryError e) {
      // Nobody would take what the kernel tells.
      connection.close();
      file.close();
      throw e;
    }
  }

  /** Whether it still records, and has not been ended by the disk. */
  public boolean goesOn() {
    return !failed;
  }

  /** What the kernel knows of it: it never asks for anything, and keeps no kernel running. */
  private static final class Observer implements Client {
    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {}

    @Override
    public boolean isAwaited() {
      return false;
    }

    @Override
    public Role role() {
      return Role.OBSERVER;
    }
  }

  /** Takes what the kernel tells; on the kernel thread, but for the log. */
  private final class Feed implements VariableListener {
    @Override
    public void appeared(int variable, String of, VariableKind kind) {
      if (!failed) {
        events.add(new Event.Appeared(variable, new Topic(of, kind)));
      }
    }

    @Override
    public void gone(int variable) {}

    @Override
    public void value(int variable, long time, @Nullable Object value) {
      long size = size(value);
      if (failed || waiting.addAndGet(size) > MOST_WAITING) {
        waiting.addAndGet(failed ? 0 : -size);
        lost.incrementAndGet();
      } else {
        events.add(new Event.Value(variable, time, value));
      }
    }

    @Override
    public void logged(long time, String line) {
      value(LOG, time, line);
    }

    @Override
    public void refused(String reason) {
      log.accept("mcap: " + reason);
    }
  }

  private void seen(View view) {
    if (!failed) {
      events.add(new Event.Seen(view));
    }
  }

  private static long size(@Nullable Object value) {
    return SMALL
        + switch (value) {
          case Bytes binary -> binary.content().length();
          case String text -> text.length();
          case List<?> list -> (long) SMALL * list.size();
          case Map<?, ?> map -> (long) SMALL * map.size();
          case null, default -> 0;
        };
  }

  // ------------------------------------------------------------------ on its own thread

  private void run() {
    try {
      Event event = null;
      while (!(event instanceof Event.End)) {
        event = next();
        if (!file.isPending()) {
          flushAt = clock.now() + FLUSH;
        }
        if (event != null) {
          take(event);
        }
        long now = clock.now();
        if (now >= jobs.due()) {
          jobs.goOn(now);
        }
        if (file.isPending() && now >= flushAt) {
          file.flush();
        }
      }
      if (((Event.End) event).looks()) {
        jobs.finish();
      } else {
        jobs.answered();
      }
      file.close();
    } catch (IOException e) {
      fail(String.valueOf(e.getMessage()));
    } catch (ExecutionException e) {
      FailureLog.internal("the jobs that are recorded to " + path, e);
      fail(FailureLog.text(e));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      FailureLog.internal("recording to " + path, e);
      fail(FailureLog.text(e));
    } finally {
      file.release();
    }
  }

  private void fail(String reason) {
    if (abandoned) {
      return;
    }
    failed = true;
    connection.lookNoMore();
    lost.addAndGet(file.unwritten() + values());
    events.clear();
    log.accept("mcap: " + path + ": " + reason + "; the recording ends here");
    broken.run();
  }

  /** The next event; null if it is time to write what there is, or to look at the jobs. */
  private @Nullable Event next() throws InterruptedException {
    long due = file.isPending() ? Math.min(flushAt, jobs.due()) : jobs.due();
    return events.poll(due - clock.now(), TimeUnit.NANOSECONDS);
  }

  private void take(Event event) throws IOException, ExecutionException, InterruptedException {
    switch (event) {
      case Event.Appeared one -> topics.put(one.variable(), one.topic());
      case Event.Value value -> {
        waiting.addAndGet(-size(value.value()));
        Topic topic = topics.get(value.variable());
        if (topic != null) {
          write(value, topic);
        }
      }
      case Event.Seen last -> jobs.takeLast(last.view());
      case Event.End end -> {}
    }
  }

  private void write(Event.Value event, Topic topic) throws IOException {
    RosType type = RosType.of(topic);
    byte[] ros = type == null ? null : type.message(topic, event.time(), event.value());
    if (type != null && ros != null) {
      int channel =
          rosChannels.computeIfAbsent(
              event.variable(), any -> file.channel(topic.name(), type.form()));
      write(channel, event.time(), ros);
    } else {
      int channel =
          jsonChannels.computeIfAbsent(
              event.variable(), any -> file.channel(topic.name(), Form.json(topic)));
      write(channel, event.time(), topic.message(event.time(), event.value()));
    }
  }

  private void write(Topic topic, long time, Map<String, Object> content) throws IOException {
    write(new Event.Value(topic.equals(Topic.JOBS) ? JOBS : TURNS, time, content), topic);
  }

  private void write(int channel, long time, byte[] message) throws IOException {
    if (channel >= 0) {
      file.message(channel, time, message);
    }
  }

  /**
   * Writes what has happened until now, and closes. May wait for the disk, and for a moment for the
   * kernel, so not on its thread.
   */
  public void stop() {
    events.add(new Event.End(true));
    await();
    close();
  }

  /**
   * Writes what is left, and the summary; may wait for the disk. If the kernel has ended, it has
   * told before what jobs have done since the last look; if not, that is not in the file.
   */
  @Override
  public void close() {
    finish();
    await();
    tellLost();
  }

  private void await() {
    try {
      writer.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Like {@link #close}, as long as the disk takes something: one that hangs must not keep who ends
   * the process, perhaps the kernel's thread.
   */
  public void closeOrAbandon() {
    closeOrAbandon(PATIENCE);
  }

  /**
   * @param patience for how long a disk may take nothing
   */
  void closeOrAbandon(Duration patience) {
    finish();
    try {
      long before;
      do {
        before = file.written();
      } while (!writer.join(patience) && file.written() != before);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (writer.isAlive()) {
      abandoned = true;
      // As long as it stands still.
      lost.addAndGet(file.unwritten() + values());
      writer.interrupt();
      log.accept("mcap: " + path + ": the disk takes nothing; the recording is not complete");
    }
    tellLost();
  }

  private void finish() {
    connection.close();
    events.add(new Event.End(false));
  }

  private long values() {
    return events.stream().filter(Event.Value.class::isInstance).count();
  }

  private void tellLost() {
    long count = lost.getAndSet(0);
    if (count > 0) {
      log.accept("mcap: " + path + ": " + count + " values were left out");
    }
  }
}
