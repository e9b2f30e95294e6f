package org.urbi.sim.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.render.Colour;

class SimulatedWorldTest {
  private static final String CART =
      """
      world { step 1 ms }
      body floor { plane {} }
      body wall { at 2 0 0.5; box { size 0.2 4 1 } }
      body body {
        at 0 0 0.1; mass 2
        box front { size 0.4 0.2 0.1 }
        sphere lamp { at 0.1 0 0.1; radius 8 cm }
      }
      body mast { from body; at 0 0 0.2; mass 0.1; colour 1 0 0; box { size 0.05 0.15 0.2 } }
      hinge mast { of body mast; axis 0 0 1; limits -1 1; drive position; force 5; speed 5 }
      distance ahead { on body; at 0.2 0 0; range 0.1 1.5 }
      bumper touch { on body; part front }
      accelerometer accel[z] { on body; axis z }
      accelerometer accel[x] { on body; axis x }
      gyrometer gyro[z] { on body; axis z }
      camera top { at 0 0 3; turn 0 90 0 deg; size 80 60 }
      led led { on body; part lamp }
      """;

  private static SimulatedWorld cart() {
    // Bodies and joints have different names here.
    return WorldReader.read("cart.world", CART.replace("hinge mast", "hinge yaw"), "ode4j");
  }

  private static void run(SimulatedWorld world, int steps) {
    for (int i = 0; i < steps; i++) {
      world.step();
    }
  }

  @Test
  void scannerSeesWhatIsNotOfItsRobot() {
    String text =
        """
        body base { at 0 0 1; mass 1; box { size 0.4 0.4 0.4 } }
        body arm { at 0.5 0 1; mass 1; box { size 0.2 0.2 0.2 } }
        hinge shoulder { of base arm; axis 0 0 1 }
        body wall { at 2.1 0 1; box { size 0.2 9 2 } }
        """;
    try (SimulatedWorld world = WorldReader.read("scan.world", text, "ode4j")) {
      double quarter = Math.PI / 2;
      double[] seen = world.scan(world.body("base"), new Vec3(0, 0, 0), -quarter, quarter, 3, 5);
      assertArrayEquals(
          new double[] {Double.POSITIVE_INFINITY, 2, Double.POSITIVE_INFINITY}, seen, 1e-6);
      assertEquals(2, world.scan(world.body("base"), new Vec3(0, 0, 0), 0, 9, 1, 5)[0], 1e-6);
    }
  }

  @Test
  void driveGoesToItsPositionWithinItsSpeed() {
    try (SimulatedWorld world = cart()) {
      Drive yaw = world.drive("yaw");
      yaw.setTarget(0.8);
      yaw.setMaxSpeed(2);
      world.step();
      assertTrue(yaw.joint().velocity() > 0.5, "moves after one step");
      for (int i = 0; i < 1000; i++) {
        world.step();
        assertTrue(Math.abs(yaw.joint().velocity()) < 2.01);
      }
      assertEquals(0.8, yaw.joint().position(), 1e-3);
      assertEquals(1, yaw.setTarget(17), "the limit");
      assertEquals(1, yaw.target());
      run(world, 1000);
      assertEquals(1, yaw.joint().position(), 1e-2);
      assertEquals(
          "yaw: target: not a finite number: NaN",
          assertThrows(SimulationException.class, () -> yaw.setTarget(Double.NaN)).getMessage());
      assertThrows(SimulationException.class, () -> yaw.setGains(-1, 0, 0));
      assertThrows(SimulationException.class, () -> yaw.setMaxSpeed(Double.POSITIVE_INFINITY));
    }
  }

  @Test
  void integralOvercomesWhatHolds() {
    // The arm hangs down at first; its P alone leaves an error, since gravity pulls it back.
    String arm =
        """
        body arm { at 0 0 -0.25; mass 1; box { size 0.05 0.05 0.5 } }
        hinge up { of world arm; anchor 0 0 0.25; axis 0 1 0; drive position; force 1.5; gains 8 GAIN 0 }
        """;
    try (SimulatedWorld weak = WorldReader.read("a", arm.replace("GAIN", "0"), "ode4j");
        SimulatedWorld strong = WorldReader.read("a", arm.replace("GAIN", "20"), "ode4j")) {
      weak.drive("up").setTarget(0.5);
      strong.drive("up").setTarget(0.5);
      run(weak, 3000);
      run(strong, 3000);
      assertEquals(0.5, strong.drive("up").joint().position(), 0.01);
      assertEquals(0.5, weak.drive("up").joint().position(), 0.05);
      assertEquals(9.81 * 0.25 * Math.sin(0.5), Math.abs(strong.drive("up").joint().load()), 0.05);
    }
  }

  @Test
  void sensorsMeasure() {
    try (SimulatedWorld world = cart()) {
      Mount.DistanceSensor ahead = world.mount(Mount.DistanceSensor.class, "ahead");
      assertEquals(1.5, world.distance(ahead), "nothing that near");
      world.body("body").place(Pose.at(1, 0, 0.1));
      assertEquals(0.7, world.distance(ahead), 1e-9);
      world.body("body").place(Pose.at(1.68, 0, 0.1));
      assertEquals(0.1, world.distance(ahead), "nearer than it can");
    }
    try (SimulatedWorld world = cart()) {
      run(world, 500);
      Mount.Accelerometer z = world.mount(Mount.Accelerometer.class, "accel[z]");
      assertEquals(9.81, world.acceleration(z), 0.05, "at rest");
      assertTrue(world.touches(world.mount(Mount.Bumper.class, "touch")), "it lies on the floor");
      Mount.Accelerometer x = world.mount(Mount.Accelerometer.class, "accel[x]");
      for (String name : new String[] {"body", "mast"}) {
        world
            .body(name)
            .place(
                new Pose(
                    world.body(name).pose().position().plus(new Vec3(0, 0, 5)),
                    world.body(name).pose().rotation()));
      }
      world.step();
      world.step();
      assertEquals(0, world.acceleration(z), 1e-6, "in free fall");
      assertEquals(0, world.acceleration(x), 1e-6);
      assertFalse(world.touches(world.mount(Mount.Bumper.class, "touch")));
      world.body("body").move(Vec3.ZERO, new Vec3(0, 0, 3));
      assertEquals(3, world.angularVelocity(world.mount(Mount.Gyrometer.class, "gyro[z]")), 1e-9);
    }
  }

  @Test
  void lampShines() {
    try (SimulatedWorld world = cart()) {
      Mount.Camera top = world.mount(Mount.Camera.class, "top");
      byte[] dark = world.render(top);
      world.light(world.mount(Mount.Led.class, "led"), new Colour(0, 1, 0), 1);
      byte[] lit = world.render(top);
      assertFalse(Arrays.equals(dark, lit));
      int brightest = 0;
      for (int i = 0; i < lit.length; i += 3) {
        brightest = Math.max(brightest, (lit[i + 1] & 255) - (lit[i] & 255));
      }
      assertEquals(255, brightest, "pure green");
    }
  }

  @Test
  void twoRunsGiveTheSamePictures() {
    byte[][] pictures = new byte[2][];
    for (int i = 0; i < 2; i++) {
      try (SimulatedWorld world = cart()) {
        world.drive("yaw").setTarget(0.3);
        run(world, 400);
        pictures[i] = world.render(world.mount(Mount.Camera.class, "top"));
      }
    }
    assertArrayEquals(pictures[0], pictures[1]);
    try (SimulatedWorld world = cart()) {
      assertNotEquals(
          Arrays.hashCode(pictures[0]),
          Arrays.hashCode(world.render(world.mount(Mount.Camera.class, "top"))));
    }
  }

  @Test
  void unknownNamesAreReported() {
    try (SimulatedWorld world = cart()) {
      assertEquals(
          "no camera 'led' in this world; it has top",
          assertThrows(SimulationException.class, () -> world.mount(Mount.Camera.class, "led"))
              .getMessage());
      assertEquals(
          "no body 'x' in this world; it has floor, wall, body, mast",
          assertThrows(SimulationException.class, () -> world.body("x")).getMessage());
    }
  }
}
