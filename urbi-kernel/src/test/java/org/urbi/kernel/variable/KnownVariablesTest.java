package org.urbi.kernel.variable;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.World;

/** All variables of a kernel are known, as long as somebody uses them. */
class KnownVariablesTest {
  private final World world = new World();
  private final KnownVariables known = new KnownVariables(Journal.NONE);
  private final List<UrbiUVar> kept = new ArrayList<>();

  private UrbiUVar make() {
    UrbiUVar made = new UrbiUVar(world.values().object.cloneShape());
    known.add(made);
    return made;
  }

  @Test
  void thoseThatAreUsedAreKnownInTheirOrder() {
    for (int i = 0; i < 200; i++) {
      kept.add(make());
    }
    assertEquals(kept, known.all());
  }

  /** Twice as many as are used at most, however many there were. */
  @Test
  void thoseThatNobodyUsesAreForgotten() {
    for (int i = 0; i < 10; i++) {
      kept.add(make());
    }
    for (int i = 0; i < 60; i++) {
      make();
    }
    System.gc();
    for (int i = 0; i < 60; i++) {
      kept.add(make());
    }
    assertTrue(known.all().containsAll(kept));
    assertEquals(kept, known.all().stream().filter(kept::contains).toList());
  }

  @Test
  void newOnesAreToldUntilNobodyWantsToKnow() {
    List<UrbiUVar> told = new ArrayList<>();
    Runnable end = known.listen(told::add);
    UrbiUVar first = make();
    assertEquals(List.of(first), told);
    end.run();
    make();
    assertEquals(List.of(first), told);
  }
}
