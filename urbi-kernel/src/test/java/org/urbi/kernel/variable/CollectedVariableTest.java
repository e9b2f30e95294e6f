package org.urbi.kernel.variable;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.ReplayedRun;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** What the garbage collector does to variables and their objects shows in no replay. */
class CollectedVariableTest {
  /** Whether objects that nobody refers to are to be reclaimed now. */
  private static volatile boolean collects;

  private static void collect() {
    for (int i = 0; i < 3 && collects; i++) {
      System.gc();
    }
  }

  /** Has a variable. */
  public static final class Leaf extends UObject {
    private final UVar value = new UVar();

    public Leaf(String name) {
      super(name);
      UBindVar(value, "value");
      value.setValue(7);
    }
  }

  /** Looks at variables of others while the kernel waits for it, and cannot be told anything. */
  public static final class Watcher extends UObject {
    private UVar followed = new UVar();
    private String kept = "";

    public Watcher(String name) {
      super(name);
      UBindFunctions("follow", "keep", "take", "look", "reclaim");
    }

    public void follow(String name) {
      followed = new UVar(name);
    }

    /** Keeps the name of a variable. */
    public void keep(UValue variable) {
      kept = variable.stringValue();
    }

    /** Uses the variable of which it has kept the name. */
    public double take() {
      return new UVar(kept).doubleValue();
    }

    public UValue look() {
      return followed.getUValue();
    }

    public void reclaim() {
      collect();
    }
  }

  @TempDir Path folder;

  private String recorded(String code) {
    return ReplayedRun.recorded(
        folder.resolve("run"),
        kernel -> {
          kernel.start(Leaf.class);
          kernel.start(Watcher.class);
          for (String statement : code.split("\n")) {
            kernel.eval(statement);
          }
        });
  }

  private void check(boolean recorded, String code, String shownThen) {
    collects = recorded;
    String shown = recorded(code);
    assertTrue(!recorded || shown.contains(shownThen), shown);
    collects = !recorded;
    assertEquals(shown, ReplayedRun.replayed(folder.resolve("run")));
  }

  /** Until the kernel hears that the object is gone, a look at it is one of the run. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void anObjectThatIsLookedFor(boolean collectedThen) {
    check(
        collectedThen,
        """
        var Global.leaf = Leaf.new.__uobjectName|;
        Watcher.follow(leaf + ".value")|;
        { Watcher.reclaim() | try { echo(uobjects.getSlotValue(leaf).value) } catch { echo("gone") } |\
         echo(Watcher.look().isVoid) };
        """,
        "*** gone");
  }

  /** A component has kept the name of a variable of an object that has none. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aNameThatWasHandedOut(boolean collectedThen) {
    check(
        collectedThen,
        """
        { var o = Object.clone | UVar.new(o, "x") | o.x = 3 | Watcher.keep(o.&x) };
        { Watcher.reclaim() | try { echo(Watcher.take()) } catch { echo("gone") } };
        """,
        "*** gone");
  }

  /** Whoever has a variable can write it, and handlers of its slot run. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theObjectOfAVariableStays(boolean collected) {
    collects = collected;
    try (Kernel kernel = Kernel.builder().virtualTime(true).output(text -> {}).start()) {
      kernel.eval("var Global.heard = []|; UVar.new(Global, \"source\")|; Global.source = 0|;");
      kernel.eval(
          "{ var o = Object.clone | UVar.new(o, \"x\") | o.x = 0 | Global.&source >> o.&x |"
              + " at (o.x > 3) heard << \"high\" };");
      collect();
      kernel.eval("Global.source = 5|; sleep(10ms);");
      assertEquals("[\"high\"]", kernel.eval("heard.asString;"));
    }
  }
}
