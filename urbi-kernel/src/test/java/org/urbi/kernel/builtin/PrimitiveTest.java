package org.urbi.kernel.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestClient;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.trust.Role;

/** Functions of the library: what is known of them, and who may call them. */
class PrimitiveTest {
  /** Two functions of which nothing is the same; they return their target. */
  private static final class Table extends BuiltinTable {
    Table(String... protos) {
      super(
          "Thing",
          "A thing.",
          protos.length == 0 ? null : protos,
          new Entry[] {
            new Entry("one", 0, 2, false, false, Role.OBSERVER, false, "", "", "First."),
            new Entry("two", 1, 3, true, true, Role.OWNER, true, "(a: Float)", "void", "Second.")
          });
    }

    @Override
    public UrbiObject call(
        int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
      return self;
    }
  }

  private final World world = new World();

  private Primitive primitive(int index) {
    return new Primitive(world.values().object.cloneShape(), new Table("Object"), index);
  }

  @Test
  void eachKnowsWhatItsEntrySays() {
    Primitive one = primitive(0);
    assertEquals("one", one.name());
    assertEquals("one", one.signature());
    assertEquals("", one.result());
    assertEquals("First.", one.doc());
    assertEquals(0, one.minArguments());
    assertEquals(2, one.maxArguments());
    assertFalse(one.isLazy());
    Primitive two = primitive(1);
    assertEquals("two", two.name());
    assertEquals("two(a: Float) -> void", two.signature());
    assertEquals("void", two.result());
    assertEquals("Second.", two.doc());
    assertEquals(1, two.minArguments());
    assertEquals(3, two.maxArguments());
    assertTrue(two.isLazy());
  }

  @Test
  void aTableKnowsItsTypeAndItsFunctions() {
    Table table = new Table("Object", "Orderable");
    assertEquals("Thing", table.type());
    assertEquals("A thing.", table.doc());
    assertEquals(2, table.size());
    assertFalse(table.isPart());
    assertEquals("Orderable", table.protos()[1]);
    table.protos()[1] = "Float";
    assertEquals("Orderable", table.protos()[1], "nobody else changes it");
    assertNull(table.newPrototype(world));
    assertFalse(table.isSetter(0));
    assertTrue(table.isSetter(1));
    assertSame(Role.OBSERVER, table.leastRole(0));
    assertSame(Role.OWNER, table.leastRole(1));
    assertFalse(table.changesTarget(0));
    assertTrue(table.changesTarget(1));
    Table part = new Table();
    assertTrue(part.isPart());
    assertThrows(NullPointerException.class, part::protos);
  }

  @Test
  void aCloneIsAFunctionOfItsOwn() {
    Primitive two = primitive(1);
    UrbiObject clone = two.cloned();
    assertNotSame(two, clone);
    assertEquals(two.signature(), ((Primitive) clone).signature());
  }

  @Test
  void itBelongsToTheSystemUntilSomebodyOwnsIt() {
    assertSame(world.values().object, primitive(0).ownerLobby());
  }

  @Test
  void theNumberOfArgumentsIsChecked() {
    ConsoleTranscript.check(
        """
        "abc".replace("a");
        [00000000:error] !!! 1.1-18: replace: expected 2 arguments, given 1
        "abc".replace("a", "b", "c");
        [00000000:error] !!! 2.1-28: replace: expected 2 arguments, given 3
        "abc".replace("a", "b");
        [00000000] "bbc"
        """);
  }

  @Test
  void lobbiesWithALesserRoleMayNotCallAll() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).start()) {
      TestClient observer = new TestClient(kernel, Role.OBSERVER);
      String refused = observer.say("uobjects.clearStats;");
      assertTrue(refused.contains("clearStats: "), refused);
      assertFalse(observer.say("uobjects.getStats;").contains("!!!"));
      TestClient owner = new TestClient(kernel, Role.OWNER);
      assertFalse(owner.say("uobjects.clearStats;").contains("!!!"));
    }
  }
}
