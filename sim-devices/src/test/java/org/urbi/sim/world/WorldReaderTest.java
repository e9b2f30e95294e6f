package org.urbi.sim.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.PhysicsSettings;

class WorldReaderTest {
  private static SimulatedWorld read(String text) {
    return WorldReader.read("a.world", text, "ode4j");
  }

  @Test
  void readsWhatIsWritten() {
    String text =
        """
        # A comment.
        world { gravity 0, 0, -1.6; step 5 ms; solver quick; iterations 30 }
        material ice { friction 0.01 }
        body table { at 0 0 50 cm; material ice; box top { size 1 1 0.1 } }
        body arm {
          from table; at 10 0 0 cm; turn 0 0 90 deg
          mass 200 g
          cylinder { radius 5 cm; length 0.3 }
          sphere tip { at 0 0 0.2; radius 30 mm; material ice }
        }
        hinge joint { of table arm; axis 0 0 1; limits -90 90 deg; drive position; force 2; speed 45 deg; gains 5 1 0.1 }
        camera eye { on arm; size 64 48; xfov 90 deg }
        bumper tip { on arm; part tip }
        robot R2 { kind "industrial arm" }
        """;
    try (SimulatedWorld world = read(text)) {
      PhysicsSettings settings = world.physics().settings();
      assertEquals(new Vec3(0, 0, -1.6), settings.gravity());
      assertEquals(0.005, settings.step());
      assertEquals(PhysicsSettings.Solver.QUICK, settings.solver());
      assertEquals(30, settings.iterations());
      assertEquals(0.01, world.body("table").parts().getFirst().material().friction());
      assertTrue(world.body("table").isFixed());
      assertEquals(0.2, world.body("arm").mass(), 1e-12);
      assertEquals(0.1, world.body("arm").pose().position().x(), 1e-12);
      assertEquals(0.5, world.body("arm").pose().position().z(), 1e-12);
      assertEquals(Math.PI / 2, world.body("arm").pose().rotation().yaw(), 1e-12);
      assertEquals(new Shape.Sphere(0.03), world.body("arm").parts().get(1).shape());
      Drive drive = world.drive("joint");
      assertEquals(Math.PI / 2, drive.joint().high(), 1e-12);
      assertEquals(Math.PI / 4, drive.maxSpeed(), 1e-12);
      assertEquals(5, drive.p());
      assertEquals(0.1, drive.d());
      assertEquals(64, world.mount(Mount.Camera.class, "eye").lens().width());
      assertEquals(1, world.mount(Mount.Bumper.class, "tip").part());
      assertEquals("industrial arm", world.robot().orElseThrow().kind());
      assertEquals(
          "no drive 'elbow' in this world; it has joint",
          assertThrows(SimulationException.class, () -> world.drive("elbow")).getMessage());
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          body | a.world:1.5: '{' expected, not the end of the file
          body x { | a.world:1.8: this '{' has no '}'
          body { } | a.world:1.1: body has no name
          bodi x { } | a.world:1.1: unknown kind of block 'bodi'; there are world, material, body, hinge, slider, ball, fixed, sun, lamp, robot, camera, distance, bumper, accelerometer, gyrometer, led
          body x { mass 1 } | a.world:1.1: x: has a mass, but no shape
          body x { mass -1; sphere { radius 1 } } | a.world:1.1: x: mass: 0 or more expected, not -1.0
          body x { mass 1; plane { } } | a.world:1.1: x: a plane has no mass: it cannot move
          body x { mass 1 2; sphere { radius 1 } } | a.world:1.10: mass: 1 number expected, not 2
          body x { mass much } | a.world:1.15: mass: unknown unit 'much'; it is in kg or g
          body x { mass 1 cm } | a.world:1.17: mass: unknown unit 'cm'; it is in kg or g
          body x { mass NaN } | a.world:1.15: mass: unknown unit 'NaN'; it is in kg or g
          body x { mass 1e999 } | a.world:1.15: mass: number expected, not '1e999'
          body x { mass 1; mass 2 } | a.world:1.18: mass is given twice
          body x { weight 1 } | a.world:1.10: a body has no weight; it has at, checker, colour, from, mass, material, shine, spin, tile, turn, velocity
          body x { ball { radius 1 } } | a.world:1.10: unknown shape 'ball'; there are box, sphere, cylinder, capsule and plane
          body x { sphere { } } | a.world:1.10: sphere: radius is missing
          body x { sphere { radius 0 } } | a.world:1.19: radius: more than 0 expected, not 0.0
          body x { sphere { radius 1 } material steel } | a.world:1.30: material: no material 'steel' before this line
          body x { colour 1 2 3 } | a.world:1.10: colour: numbers between 0 and 1 expected, not 2.0
          body x { velocity 1 0 0 } | a.world:1.1: x: does not move: it has no mass
          body x { from y } | a.world:1.10: from: no body 'y' before this line
          body x { } body x { } | a.world:1.12: body x: there is something else of that name
          body x { at 1 2 } | a.world:1.10: at: 3 numbers expected, not 2
          body x y { } | a.world:1.8: one name expected before '{', not 'y'
          world { step 2 } | a.world:1.1: step: between 0 and 0.1 s expected, not 2.0
          world { } world { } | a.world:1.11: world: is given twice
          world { engine magic } | a.world:1.1: unknown engine 'magic'; there are auto, ode and ode4j
          material m { friction -1 } | a.world:1.1: friction: between 0 and 100 expected, not -1.0
          hinge h { } | a.world:1.1: hinge h: of is missing: the two bodies that it joins
          hinge h { of world world } | a.world:1.11: of: no body 'world' before this line
          camera c { size 1.5 2 } | a.world:1.12: size: whole numbers of pixels expected
          distance d { range 0 1 } | a.world:1.1: distance d: on is missing: the body that carries it
          sun { direction 0 0 0 } | a.world:1.1: no direction: (0.0, 0.0, 0.0)
          robot r { wheels a b } | a.world:1.11: wheels: the names of two hinges with 'drive speed' expected
          body x { name "a } | a.world:1.15: the string does not end on its line
          body § { } | a.world:1.6: unexpected character '§'
          body x { mass 1.2.3 } | a.world:1.15: neither a number nor a name: '1.2.3'
          """)
  void refusesMistakesWithTheirPlace(String text, String message) {
    String asked = text.contains("engine") ? null : "ode4j";
    SimulationException refusal =
        assertThrows(
            SimulationException.class, () -> WorldReader.read("a.world", text, asked).close());
    assertEquals(message, refusal.getMessage());
    assertEquals(0, refusal.getStackTrace().length, "it is for people, and not logged");
  }

  @Test
  void linesAndJointsAreChecked() {
    String bodies = "body a { box { size 1 1 1 } }\nbody b { mass 1; sphere { radius 1 } }\n";
    String[][] cases = {
      {"hinge h { of b a; axis 0 0 1 }", "3.1: h: the second body has to be one that can move"},
      {"hinge h { of a b }", "3.1: hinge h: axis is missing"},
      {"hinge h {\n of a b\n axis 0 0 0 }", "5.2: axis: has no direction"},
      {
        "hinge h { of a b; axis 0 0 1; limits 1 2 }",
        "3.31: limits: 0, where it stands, is not between them"
      },
      {"hinge h { of a b; axis 0 0 1; drive fast }", "3.31: drive: position or speed expected"},
      {"hinge h { of a b; axis 0 0 1; drive speed }", "3.1: hinge h: force is missing"},
      {"fixed f { of a b; axis 0 0 1 }", "3.19: a fixed has no axis; it has of"},
      {"bumper t { on b; part nose }", "3.18: part: body b has no part 'nose'"},
      {"accelerometer a1 { on b; axis q }", "3.26: axis: x, y or z expected"},
    };
    for (String[] one : cases) {
      SimulationException refusal =
          assertThrows(SimulationException.class, () -> read(bodies + one[0]).close(), one[0]);
      assertEquals("a.world:" + one[1], refusal.getMessage());
    }
  }

  @Test
  void filesThatCannotBeReadAreNamed(@TempDir Path folder) throws Exception {
    Path missing = folder.resolve("none.world");
    assertEquals(
        missing + ": no such file",
        assertThrows(SimulationException.class, () -> WorldReader.read(missing, null))
            .getMessage());
    Path pipe = folder.resolve("pipe.world");
    assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
    for (Path odd : List.of(pipe, folder)) {
      assertEquals(
          odd + ": not a regular file",
          assertThrows(SimulationException.class, () -> WorldReader.read(odd, null)).getMessage());
    }
    Path binary = folder.resolve("binary.world");
    Files.write(binary, new byte[] {(byte) 0xff, (byte) 0xfe, 0});
    assertEquals(
        binary + ": not a text in UTF-8",
        assertThrows(SimulationException.class, () -> WorldReader.read(binary, null)).getMessage());
  }

  /** Carts with four driven wheels each, side by side. */
  private static String carts(int count, String solver) {
    StringBuilder text = new StringBuilder("world { " + solver + " }\nbody floor { plane {} }\n");
    for (int cart = 0; cart < count; cart++) {
      text.append(
          "body c%d { at 0 %d 0.2; mass 2; box { size 0.5 0.3 0.1 } }\n".formatted(cart, cart));
      for (int wheel = 0; wheel < 4; wheel++) {
        text.append(
            """
            body w%1$d%2$d { from c%1$d; at %3$s %4$s -0.1; turn 90 0 0 deg; mass 0.2; cylinder { radius 0.1; length 0.05 } }
            hinge a%1$d%2$d { of c%1$d w%1$d%2$d; axis 0 0 -1; drive speed; force 1; speed 20 }
            """
                .formatted(
                    cart, wheel, wheel < 2 ? "0.2" : "-0.2", wheel % 2 == 0 ? "0.2" : "-0.2"));
      }
    }
    return text.toString();
  }

  @Test
  void solverIsChosenBySizeUnlessGiven() {
    String[][] cases = {
      {"8", "", "EXACT"},
      {"9", "", "QUICK"},
      {"9", "solver auto", "QUICK"},
      {"9", "solver exact", "EXACT"},
      {"1", "solver quick", "QUICK"}
    };
    for (String[] one : cases) {
      try (SimulatedWorld world = read(carts(Integer.parseInt(one[0]), one[1]))) {
        assertEquals(one[2], world.physics().settings().solver().toString(), String.join(" ", one));
      }
    }
    assertEquals(
        "a.world:1.9: solver: auto, exact or quick expected, not 'good'",
        assertThrows(SimulationException.class, () -> read("world { solver good }")).getMessage());
  }

  @Test
  void manyCartsDriveAsTheyShouldWithTheirUsualSolver() {
    try (SimulatedWorld world = read(carts(9, ""))) {
      world.drives().forEach(drive -> drive.setTarget(5));
      for (int i = 0; i < 2000; i++) {
        world.step();
      }
      for (Drive drive : world.drives()) {
        assertEquals(5, drive.sensed(), 0.05, drive.name());
        Vec3 axle =
            drive
                .joint()
                .first()
                .pose()
                .rotation()
                .inverse()
                .apply(
                    drive
                        .joint()
                        .second()
                        .pose()
                        .position()
                        .minus(drive.joint().first().pose().position()));
        assertEquals(0.2, Math.abs(axle.x()), 1e-3, drive.name());
        assertEquals(0.2, Math.abs(axle.y()), 1e-3, drive.name());
        assertEquals(-0.1, axle.z(), 1e-3, drive.name());
      }
      assertEquals(1, world.body("c4").pose().position().x(), 0.1, "2 s at 0.5 m/s");
    }
  }
}
