package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.observe.SlotRow;
import org.urbi.kernel.trust.Role;

/** Somebody looks at the slots of a running kernel, and assigns them. */
class VariableViewTest {
  private Kernel kernel;
  private TestClient program;
  private Viewer owner;

  @BeforeEach
  void start() {
    kernel = Kernel.builder().log(line -> {}).start();
    program = new TestClient(kernel, Role.OWNER);
    owner = new Viewer(kernel, Role.OWNER);
  }

  @AfterEach
  void stop() {
    assertEquals("3", program.say("1 + 2;"));
    kernel.close();
  }

  @Test
  void objectsAndTheirPrototypesAreBrowsed() {
    program.say(
        """
        class Global.Robot { var legs = 2; function walk() { 1 } }|;
        var Global.robot = Robot.new|; var Global.robot.name = "ro\\"by"|;
        var Global.list = [1, "two", [3, [4, [5]]]]|;
        var Global.one = ["a" => 1]|; var Global.two = ["a" => 1, "b" => 2]|;
        var Global.image = Binary.new("rgb 1 1", "abc")|; var Global.data = Binary.new("", "abc")|;
        """);
    SlotRow robot = owner.slot("Global", "robot");
    assertEquals(List.of("Robot", true), List.of(robot.type(), robot.opens()));
    assertTrue(
        owner.last.variables().roots().contains("Global"), owner.last.variables().toString());
    assertEquals("[1, \"two\", [3, […]]]", owner.slot("Global", "list").value());
    assertEquals("[1 entry]", owner.slot("Global", "one").value());
    assertEquals("[2 entries]", owner.slot("Global", "two").value());
    assertEquals("rgb 1 1, 3 bytes", owner.slot("Global", "image").value());
    assertEquals("3 bytes", owner.slot("Global", "data").value());
    assertFalse(owner.slots.containsKey("Float"), "what the system has put there");
    SlotRow name = owner.slot("Global\n.robot", "name");
    assertEquals("\"ro\\\"by\"", name.value());
    assertEquals(List.of("Robot"), owner.object.protos());
    assertEquals(2, owner.slot("Global\n.robot\n:0", "legs").number());
    assertFalse(owner.slots.containsKey("walk"), "functions are no variables");
    assertFalse(owner.lookAt("Global\n.robot\n:7").object.found());
    assertFalse(owner.lookAt("Global\n.nobody\n.x").object.found());
    assertFalse(owner.lookAt("").object.found());
  }

  /** Who took what is shown of a list for all of it would round its numbers, and lose objects. */
  @Test
  void whatIsNotAllOfAnElementIsTold() {
    program.say(
        """
        var Global.pi = 3.14159265358979|; var Global.half = [0.5, -1e-06, 1e20, inf, nan]|;
        var Global.angles = [3.14159265358979, (1234567.89, 2)]|;
        var Global.crew = [Object.new, Event.new, ["a" => 1], true, nil, "text"]|;
        """);
    SlotRow pi = owner.slot("Global", "pi");
    assertEquals("3.14159", pi.value());
    assertEquals(3.14159265358979, pi.number());
    assertEquals("[0.5, -1e-06, 1e+20, inf, nan]", owner.slot("Global", "half").value());
    assertEquals("[3.14159…, (1.23457e+06…, 2)]", owner.slot("Global", "angles").value());
    assertEquals(
        "[Object…, Event…, [1 entry]…, true, nil, \"text\"]", owner.slot("Global", "crew").value());
  }

  @Test
  void onlyChangesAreTold() {
    program.say("var Global.x = 1|; var Global.y = 2|;");
    owner.lookAt("Global");
    assertEquals(List.of(), owner.lookAt("Global").last.variables().objects());
    program.say("Global.x = 5 | Global.removeLocalSlot(\"y\");");
    owner.lookAt("Global");
    assertEquals(1, owner.last.variables().objects().size());
    assertEquals(List.of("x"), owner.object.slots().stream().map(SlotRow::name).toList());
    assertEquals(List.of("y"), owner.object.gone());
    assertFalse(owner.object.anew(), "what was told before is still true");
    owner.lookAt("");
    assertTrue(owner.lookAt("Global").object.anew(), "it was looked away meanwhile");
    assertTrue(owner.slots.containsKey("x"), owner.slots::toString);
  }

  @Test
  void variablesWithHooksTellWhoWritesAndReadsThem() {
    program.say(
        """
        class Global.Motor : UObject { function init() { UVar.new(this, "speed") } }|;
        var Global.motor = Motor.new|;
        motor.speed = 0|;
        motor.speed->rangemin = -10|; motor.speed->rangemax = 10|;
        at (motor.speed > 5) echo("fast");
        motor.speed = 3|; motor.speed = 4|;
        """);
    SlotRow speed = owner.slot("Global\n.motor", "speed");
    assertTrue(speed.variable(), speed.toString());
    assertEquals(4, speed.number());
    assertEquals(-10, speed.least());
    assertEquals(10, speed.most());
    assertEquals(3, speed.times());
    assertTrue(speed.last() >= 0, speed.toString());
    assertTrue(speed.readers().contains("motor.speed > 5"), speed.toString());
  }

  @Test
  void slotsAreAssignedAsUrbiscriptDoes() {
    program.say("var Global.x = 1|; Global.x->rangemax = 10|; var Global.o = Object.new|;");
    program.say("const var Global.c = 3|; at (x > 5) echo(\"far\");");
    assertEquals("", owner.assign("Global\n.x", "3 * 2"));
    assertEquals("6", program.say("sleep(1ms)|; x;").replaceFirst("(?s).*far\\s*", "").strip());
    assertEquals("", owner.assign("Global\n.x", "100"));
    assertEquals("10", program.say("x;"));
    assertEquals("studio:1.1-6: lookup failed: nobody", owner.assign("Global\n.x", "nobody"));
    assertEquals(
        "studio:1.4: syntax error: unexpected end of file", owner.assign("Global\n.x", "1 +"));
    assertTrue(owner.assign("Global\n.x", "").contains("void"), owner.assign("Global\n.x", ""));
    assertTrue(owner.assign("Global\n.c", "4").contains("const"));
    assertEquals("no such slot any more: Global.o.x", owner.assign("Global\n.o\n.x", "1"));
    assertEquals("no such slot any more: nonsense", owner.assign("nonsense", "1"));
    assertEquals("10", program.say("x;"));
  }

  @Test
  void observersSeeAndCannotAssign() {
    program.say("var Global.x = 1|;");
    Viewer observer = new Viewer(kernel, Role.OBSERVER);
    assertEquals(1, observer.slot("Global", "x").number());
    String refused = observer.assign("Global\n.x", "2");
    assertTrue(refused.contains("needs the role owner"), refused);
    assertEquals("1", program.say("x;"));
  }

  @Test
  void numbersAreSampledAndPicturesHad() {
    program.say("var Global.x = 1.5|; var Global.s = \"text\"|;");
    program.say("var Global.p = Binary.new(\"jpeg 2 1\", \"abc\")|;");
    List<String> ways = List.of("Global\n.x", "Global\n.s", "Global\n.gone");
    assertEquals(
        List.of(1.5, Double.NaN, Double.NaN),
        owner.client.connection().sample(ways).join().values());
    assertEquals("image", owner.slot("Global", "p").media());
    assertEquals("abc", owner.client.connection().media("Global\n.p").join().get().bytes());
    assertTrue(owner.client.connection().media("Global\n.x").join().isEmpty());
  }

  @Test
  void ofVeryManySlotsAPartIsTold() {
    program.say("var Global.o = Object.new|; for (var i : 3000) o.setSlot(\"x\" + i, i);");
    owner.lookAt("Global\n.o");
    assertEquals(List.of(3000, 500), List.of(owner.object.total(), owner.slots.size()));
    assertTrue(owner.views > 5, () -> "only " + owner.views + " looks at thousands");
  }

  @Test
  void recordedRunContainsWhatWasAssigned(@TempDir Path folder) {
    Path recording = folder.resolve("run");
    try (Kernel recorded = Kernel.builder().log(line -> {}).record(recording).start()) {
      TestClient coder = new TestClient(recorded, Role.OWNER);
      coder.say("var Global.x = 1|; at (x > 5) echo(\"far\");");
      assertEquals("", new Viewer(recorded, Role.OWNER).assign("Global\n.x", "7"));
      assertTrue(coder.say("echo(x);").contains("7"));
    }
    ReplayedRun.check(recording);
  }
}
