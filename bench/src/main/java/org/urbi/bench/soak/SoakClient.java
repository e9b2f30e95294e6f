package org.urbi.bench.soak;

import java.io.IOException;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/** Connects, does something, leaves in one way or another, and comes again; seeded. */
final class SoakClient implements Runnable {
  private static final int MAX_STAY = 4;
  private static final int MAX_PAUSE = 300;

  private final int port;
  private final Random random;
  private final SoakTotals tally;
  private volatile boolean leaving;

  /** What all clients have done. */
  static final class SoakTotals {
    final AtomicLong visits = new AtomicLong();
    final AtomicLong acts = new AtomicLong();
    final AtomicLong bytes = new AtomicLong();
    final AtomicLong failures = new AtomicLong();
    private volatile String lastFailure = "";

    void failed(@Nullable Behaviour behaviour, IOException e) {
      failures.incrementAndGet();
      lastFailure = behaviour + ": " + e.getMessage();
    }

    @Override
    public String toString() {
      return "%d visits, %d acts, %.1f MB received, %d failures%s"
          .formatted(
              visits.get(),
              acts.get(),
              bytes.get() / 1e6,
              failures.get(),
              lastFailure.isEmpty() ? "" : " (last: " + lastFailure + ")");
    }
  }

  SoakClient(int port, long seed, SoakTotals tally) {
    this.port = port;
    this.random = new Random(seed);
    this.tally = tally;
  }

  /** Has it come to an end after what it is doing now. */
  void leave() {
    leaving = true;
  }

  @Override
  public void run() {
    while (!leaving) {
      Behaviour behaviour = null;
      tally.visits.incrementAndGet();
      try (SoakConnection visit = new SoakConnection(port)) {
        for (int left = 1 + random.nextInt(MAX_STAY); left > 0 && !leaving; left--) {
          behaviour = Behaviour.values()[random.nextInt(Behaviour.values().length)];
          tally.acts.incrementAndGet();
          behaviour.act(visit, random);
          if (behaviour.ordinal() >= Behaviour.DEAF.ordinal()) {
            break;
          }
        }
        goodbye(visit, behaviour);
        tally.bytes.addAndGet(visit.received());
      } catch (IOException e) {
        tally.failed(behaviour, e);
      }
      Soak.pause(random.nextInt(MAX_PAUSE));
    }
  }

  private void goodbye(SoakConnection visit, @Nullable Behaviour last) throws IOException {
    switch (random.nextInt(4)) {
      case 0 -> visit.vanish();
      case 1 -> {
        // Only a lobby without jobs that go on for ever ends with its input.
        if (last == Behaviour.UNFINISHED || last == Behaviour.NOISE) {
          visit.glance();
        } else {
          visit.send("quit;\n");
          visit.endInput();
        }
      }
      case 2 -> visit.send("quit;\n");
      default -> {}
    }
  }
}
