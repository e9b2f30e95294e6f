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
  private final SoakTotals totals;
  private volatile boolean leaving;

  /** What all clients have done. */
  static final class SoakTotals {
    final AtomicLong soakConnections = new AtomicLong();
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
              soakConnections.get(),
              acts.get(),
              bytes.get() / 1e6,
              failures.get(),
              lastFailure.isEmpty() ? "" : " (last: " + lastFailure + ")");
    }
  }

  SoakClient(int port, long seed, SoakTotals totals) {
    this.port = port;
    this.random = new Random(seed);
    this.totals = totals;
  }

  /** Has it come to an end after what it is doing now. */
  void leave() {
    leaving = true;
  }

  @Override
  public void run() {
    while (!leaving) {
      Behaviour behaviour = null;
      totals.soakConnections.incrementAndGet();
      try (SoakConnection soakConnection = new SoakConnection(port)) {
        for (int left = 1 + random.nextInt(MAX_STAY); left > 0 && !leaving; left--) {
          behaviour = Behaviour.values()[random.nextInt(Behaviour.values().length)];
          totals.acts.incrementAndGet();
          behaviour.act(soakConnection, random);
          if (behaviour.ordinal() >= Behaviour.DEAF.ordinal()) {
            break;
          }
        }
        goodbye(soakConnection, behaviour);
        totals.bytes.addAndGet(soakConnection.received());
      } catch (IOException e) {
        totals.failed(behaviour, e);
      }
      Soak.pause(random.nextInt(MAX_PAUSE));
    }
  }

  private void goodbye(SoakConnection soakConnection, @Nullable Behaviour last) throws IOException {
    switch (random.nextInt(4)) {
      case 0 -> soakConnection.vanish();
      case 1 -> {
        // Only a lobby without jobs that go on for ever ends with its input.
        if (last == Behaviour.UNFINISHED || last == Behaviour.NOISE) {
          soakConnection.glance();
        } else {
          soakConnection.send("quit;\n");
          soakConnection.endInput();
        }
      }
      case 2 -> soakConnection.send("quit;\n");
      default -> {}
    }
  }
}
