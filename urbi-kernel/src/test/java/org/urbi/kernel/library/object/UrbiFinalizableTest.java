package org.urbi.kernel.library.object;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.PhantomReference;
import java.lang.ref.ReferenceQueue;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.SystemClock;

class UrbiFinalizableTest {
  private final ReferenceQueue<World> gone = new ReferenceQueue<>();

  private PhantomReference<World> worldThatIsGone() {
    World world = new World();
    UrbiFinalizable.prototype(
        world.values().object.cloneShape(),
        new Finalization(
            Journal.NONE, new FinalizationTest.RunningCode(), System::gc, new SystemClock()));
    return new PhantomReference<>(world, gone);
  }

  /** What has a finalizer is there, with all that it refers to, until the next collection. */
  @Test
  void thePrototypeKeepsNothingOfAKernelThatIsGone() {
    PhantomReference<World> world = worldThatIsGone();
    System.gc();
    assertTrue(world.refersTo(null));
  }
}
