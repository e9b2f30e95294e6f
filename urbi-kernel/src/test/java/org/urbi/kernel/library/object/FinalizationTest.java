package org.urbi.kernel.library.object;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.ref.Reference;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.VirtualClock;

/** A collection of all garbage stops everybody: only what an owner has made is worth it. */
class FinalizationTest {
  /** Code that is running, of nobody in particular. */
  static final class RunningCode implements Finalization.Running {
    private boolean owner;
    private boolean alone = true;

    @Override
    public boolean isOwner() {
      return owner;
    }

    @Override
    public @Nullable UrbiObject lobby() {
      return null;
    }

    @Override
    public boolean isAlone() {
      return alone;
    }
  }

  /** What a collection takes, in nanoseconds. */
  private static final long COLLECTION = 30_000_000;

  private final RunningCode running = new RunningCode();
  private int collections;
  private final VirtualClock machine = new VirtualClock();
  private final World world = new World();
  private final Finalization finalization =
      new Finalization(
          Journal.NONE,
          running,
          () -> {
            collections++;
            machine.advanceTo(machine.now() + COLLECTION);
            System.gc();
          },
          machine);
  private final UrbiObject prototype =
      UrbiFinalizable.prototype(world.values().object.cloneShape(), finalization);

  @Test
  void nobodyCollectsForWhatOthersHaveMade() {
    UrbiObject made = prototype.cloned();
    assertEquals(List.of(), finalization.found());
    running.owner = true;
    assertEquals(List.of(), finalization.found());
    assertEquals(0, collections);
    Reference.reachabilityFence(made);
  }

  @Test
  void othersDoNotCollectForWhatAnOwnerHasMade() {
    running.owner = true;
    UrbiObject made = prototype.cloned();
    running.owner = false;
    assertEquals(List.of(), finalization.found());
    assertEquals(0, collections);
    running.owner = true;
    assertEquals(List.of(), finalization.found());
    assertEquals(1, collections);
    Reference.reachabilityFence(made);
  }

  /** Those are the second one and the third one. */
  @Test
  void whatAnOwnerHasMadeIsFoundAtOnce() {
    running.owner = true;
    UrbiObject kept = prototype.cloned();
    drop(2);
    assertEquals(List.of(2L, 3L), finalization.found());
    Reference.reachabilityFence(kept);
  }

  @Test
  void whatOthersHaveMadeIsFoundWhenItHasBeenCollected() {
    drop(2);
    do {
      System.gc();
    } while (finalization.found().size() < 2);
    assertEquals(List.of(1L, 2L), finalization.found());
    assertEquals(0, collections);
  }

  /** Four times 30 ms in a row, and then once in 300 s. */
  @Test
  void othersAreHardlyKeptWaiting() {
    running.owner = true;
    running.alone = false;
    UrbiObject made = prototype.cloned();
    for (int i = 0; i < 10; i++) {
      finalization.found();
    }
    assertEquals(4, collections);
    for (int second = 0; second < 3000; second++) {
      machine.advanceTo(machine.now() + 1_000_000_000);
      finalization.found();
    }
    assertEquals(13, collections, 1);
    Reference.reachabilityFence(made);
  }

  /** What it has done alone need not be made up for when others come. */
  @Test
  void nobodyIsKeptWaitingByWhoIsAlone() {
    running.owner = true;
    UrbiObject made = prototype.cloned();
    for (int i = 0; i < 100; i++) {
      finalization.found();
    }
    assertEquals(100, collections);
    running.alone = false;
    finalization.found();
    assertEquals(101, collections);
    Reference.reachabilityFence(made);
  }

  private void drop(int count) {
    for (int i = 0; i < count; i++) {
      prototype.cloned();
    }
  }
}
