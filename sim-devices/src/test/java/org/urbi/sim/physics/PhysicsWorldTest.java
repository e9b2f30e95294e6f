package org.urbi.sim.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.BodyDescription.Part;
import org.urbi.sim.physics.JointDescription.Kind;

/** Both engines, against what mechanics says. */
class PhysicsWorldTest {
  private static final PhysicsSettings DEFAULT = PhysicsSettings.DEFAULT;
  private static final double G = 9.81;

  @ParameterizedTest
  @EnumSource
  void bodyFallsWithConstantAcceleration(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body ball = Scenes.ball(world, "ball", 0.1, new Vec3(1, 2, 100), Material.DEFAULT);
      Scenes.run(world, 2000);
      // The velocity is changed before the place, hence half a step more than g t²/2.
      assertEquals(100 - G * 2 * 2.001 / 2, ball.pose().position().z(), 1e-9);
      assertEquals(-G * 2, ball.velocity().z(), 1e-9);
      assertEquals(1, ball.pose().position().x(), 0);
      assertEquals(2, world.time(), 1e-12);
    }
  }

  @ParameterizedTest
  @EnumSource
  void pendulumSwingsAsItsEquationSays(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Joint pivot = Scenes.pendulum(world, -1);
      // About the pivot a ball has m l² + 2/5 m r².
      double inertia = 1 + 0.4 * 0.05 * 0.05;
      double[] exact = {-1, 0};
      for (int i = 0; i < 3000; i++) {
        world.step();
        rungeKutta(exact, G / inertia, 0.001);
        assertEquals(exact[0], pivot.position() - 1, 0.004, "after " + i + " steps");
      }
      // It has swung through, to the other side and back.
      assertTrue(Math.abs(exact[0]) < 1);
    }
  }

  private static void rungeKutta(double[] y, double k, double h) {
    double k1 = y[1];
    double l1 = -k * Math.sin(y[0]);
    double k2 = y[1] + h / 2 * l1;
    double l2 = -k * Math.sin(y[0] + h / 2 * k1);
    double k3 = y[1] + h / 2 * l2;
    double l3 = -k * Math.sin(y[0] + h / 2 * k2);
    double k4 = y[1] + h * l3;
    double l4 = -k * Math.sin(y[0] + h * k3);
    y[0] += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    y[1] += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }

  @ParameterizedTest
  @EnumSource
  void fallenBoxesRestOnEachOther(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Scenes.stack(world, 4);
      Scenes.run(world, 3000);
      for (int i = 0; i < 4; i++) {
        Body box = world.bodies().get(i + 1);
        assertEquals(0.1 + 0.2 * i, box.pose().position().z(), 0.005, box.name());
        assertEquals(0, box.velocity().length(), 0.001, box.name());
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void bodySlidesWithCoulombFriction(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      world.add(
          new BodyDescription(
              "floor",
              Pose.ORIGIN,
              0,
              List.of(new Part(new Shape.Plane(), Pose.ORIGIN, new Material(0.4, 0, 0)))));
      Body box =
          world.add(
              BodyDescription.of(
                  "box",
                  Pose.at(0, 0, 0.05),
                  1,
                  new Shape.Box(0.4, 0.4, 0.1),
                  new Material(0.1, 0, 0)));
      box.move(new Vec3(2, 0, 0), Vec3.ZERO);
      Scenes.run(world, 1500);
      // The coefficient is √(0.4 · 0.1); it stops after v²/(2 µ g).
      assertEquals(4 / (2 * 0.2 * G), box.pose().position().x(), 0.02);
      assertEquals(0, box.velocity().length(), 0.001);
    }
  }

  @ParameterizedTest
  @EnumSource
  void bouncesBackToItsShareOfTheHeight(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Scenes.floor(world);
      Body ball = Scenes.ball(world, "ball", 0.1, new Vec3(0, 0, 1.1), new Material(0.5, 0.8, 0));
      while (ball.velocity().z() <= 0) {
        world.step();
      }
      while (ball.velocity().z() > 0) {
        world.step();
      }
      assertEquals(0.64, ball.pose().position().z() - 0.1, 0.02);
    }
  }

  @ParameterizedTest
  @EnumSource
  void motorReachesItsSpeedAndStopsAtTheLimit(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT.withStep(0.002))) {
      Body arm =
          world.add(
              BodyDescription.of(
                  "arm", Pose.at(0.25, 0, 0), 1, new Shape.Box(0.5, 0.05, 0.05), Material.DEFAULT));
      Joint joint =
          world.add(
              new JointDescription("joint", Kind.HINGE, null, arm, Vec3.ZERO, Vec3.Z, -0.5, 1.5));
      joint.drive(1, 100);
      world.step();
      assertEquals(1, joint.velocity(), 1e-4, "sensed after one step");
      Scenes.run(world, 499);
      assertEquals(1, joint.position(), 0.002);
      assertEquals(StrictMath.sin(1) * 0.25, arm.pose().position().y(), 0.002);
      Scenes.run(world, 1000);
      assertEquals(1.5, joint.position(), 0.005);
      joint.drive(-1, 10);
      Scenes.run(world, 2000);
      assertEquals(-0.5, joint.position(), 0.005);
    }
  }

  @ParameterizedTest
  @EnumSource
  void loadOfAHeldBodyIsMeasured(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body arm =
          world.add(
              BodyDescription.of(
                  "arm", Pose.at(0.25, 0, 0), 2, new Shape.Box(0.5, 0.05, 0.05), Material.DEFAULT));
      Joint hinge =
          world.add(new JointDescription("hinge", Kind.HINGE, null, arm, Vec3.ZERO, Vec3.Y));
      hinge.drive(0, 100);
      Scenes.run(world, 100);
      // Gravity would turn it about +y; the joint holds against that.
      assertEquals(-2 * G * 0.25, hinge.load(), 0.01);

      Body lift = Scenes.box(world, "lift", 0.1, new Vec3(5, 0, 1));
      Joint slider =
          world.add(new JointDescription("slider", Kind.SLIDER, null, lift, Vec3.ZERO, Vec3.Z));
      slider.drive(0.1, 100);
      Scenes.run(world, 1000);
      assertEquals(G, slider.load(), 0.01);
      assertEquals(0.1, slider.position(), 0.001);
      assertEquals(0.1, slider.velocity(), 0.001);
    }
  }

  @ParameterizedTest
  @EnumSource
  void hingeCountsItsTurns(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body wheel =
          world.add(
              BodyDescription.of(
                  "wheel", Pose.ORIGIN, 1, new Shape.Cylinder(0.1, 0.05), Material.DEFAULT));
      Joint axle =
          world.add(new JointDescription("axle", Kind.HINGE, null, wheel, Vec3.ZERO, Vec3.Z));
      axle.drive(10, 100);
      Scenes.run(world, 2000);
      assertEquals(20, axle.position(), 0.01);
      axle.drive(-10, 100);
      Scenes.run(world, 4000);
      assertEquals(-20, axle.position(), 0.02);
    }
  }

  @ParameterizedTest
  @EnumSource
  void centreOfMassMayBeElsewhereThanTheFrame(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Shape cube = new Shape.Box(0.2, 0.2, 0.2);
      List<Part> parts =
          List.of(
              new Part(cube, Pose.at(0, 0, 0), Material.DEFAULT),
              new Part(cube, Pose.at(1, 0, 0), Material.DEFAULT));
      Pose pose = new Pose(new Vec3(0, 0, 50), Rotation.about(Vec3.Z, Math.PI / 2));
      Body dumbbell = world.add(new BodyDescription("dumbbell", pose, 2, parts));
      assertEquals(0.5, dumbbell.centreOfMass().y(), 1e-12);
      assertEquals(0, dumbbell.pose().position().length() - 50, 1e-12);
      dumbbell.move(Vec3.ZERO, new Vec3(0, 0, Math.PI));
      Scenes.run(world, 1000);
      // After half a turn about its middle the frame is on the other side.
      assertEquals(1, dumbbell.pose().position().y(), 0.001);
      assertEquals(0, dumbbell.pose().position().x(), 0.003);
      assertEquals(0.5, dumbbell.centreOfMass().y(), 1e-9);
    }
  }

  @ParameterizedTest
  @EnumSource
  void raysMeetTheNearestShape(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body floor = Scenes.floor(world);
      Body near = Scenes.box(world, "near", 0.2, new Vec3(1, 0, 0.1));
      Body far = Scenes.ball(world, "far", 0.2, new Vec3(3, 0, 0.2), Material.DEFAULT);
      Vec3 from = new Vec3(0, 0, 0.1);
      RayHit hit = world.castRay(from, Vec3.X, 10, body -> true).orElseThrow();
      assertEquals(near, hit.body());
      assertEquals(0.9, hit.distance(), 1e-9);
      assertEquals(-1, hit.normal().x(), 1e-9);
      hit = world.castRay(from, Vec3.X, 10, body -> body != near).orElseThrow();
      assertEquals(far, hit.body());
      assertEquals(3 - Math.sqrt(0.03), hit.distance(), 1e-9);
      hit = world.castRay(from, new Vec3(1, 5, -0.1), 10, body -> true).orElseThrow();
      assertEquals(floor, hit.body());
      assertTrue(world.castRay(from, Vec3.X, 0.8, body -> true).isEmpty());
      assertTrue(world.castRay(from, Vec3.Z, 100, body -> true).isEmpty());
    }
  }

  @ParameterizedTest
  @EnumSource
  void contactsTellWhatTouches(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body floor = Scenes.floor(world);
      Body lower = Scenes.box(world, "lower", 0.2, new Vec3(0, 0, 0.1));
      Body upper = Scenes.box(world, "upper", 0.2, new Vec3(0, 0, 0.35));
      Scenes.run(world, 10);
      assertTrue(world.touch(lower, 0) > 0);
      assertEquals(0, world.touch(upper, -1));
      assertTrue(world.contacts().stream().allMatch(c -> c.involves(floor) && c.involves(lower)));
      Scenes.run(world, 500);
      assertTrue(world.touch(upper, 0) > 0);
      assertTrue(world.contacts().stream().anyMatch(c -> c.involves(lower) && c.involves(upper)));
      assertFalse(world.contacts().stream().anyMatch(c -> c.involves(floor) && c.involves(upper)));
    }
  }

  @ParameterizedTest
  @EnumSource
  void joinedBodiesDoNotCollide(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body a = Scenes.box(world, "a", 0.2, new Vec3(0, 0, 1));
      Body b = Scenes.box(world, "b", 0.2, new Vec3(0.1, 0, 1));
      Body c = Scenes.box(world, "c", 0.2, new Vec3(0.25, 0, 1));
      world.add(new JointDescription("glue", Kind.FIXED, a, b, Vec3.ZERO, Vec3.X));
      world.step();
      assertTrue(world.contacts().stream().allMatch(contact -> contact.involves(c)));
      assertTrue(world.touch(c, -1) > 0);
      Scenes.run(world, 300);
      Vec3 apart = b.pose().position().minus(a.pose().position());
      assertEquals(0.1, apart.length(), 1e-4, "glued");
    }
  }

  @ParameterizedTest
  @EnumSource
  void twoRunsGiveTheSameBits(TestedEngine engine) {
    for (PhysicsSettings settings :
        List.of(DEFAULT, DEFAULT.withSolver(PhysicsSettings.Solver.QUICK, 20))) {
      assertEquals(busyRun(engine, settings, false), busyRun(engine, settings, true));
    }
  }

  private static String busyRun(TestedEngine engine, PhysicsSettings settings, boolean disturbed) {
    try (PhysicsWorld world = engine.world(settings);
        PhysicsWorld other = engine.world(settings)) {
      Scenes.drivenWheel(world);
      Scenes.stack(other, 3);
      for (int i = 0; i < 12; i++) {
        Scenes.box(world, "box" + i, 0.1, new Vec3(0.5 + 0.03 * (i % 3), 0.02 * i, 0.1 + 0.12 * i));
      }
      for (int i = 0; i < 300; i++) {
        world.step();
        if (disturbed) {
          other.step();
        }
      }
      return Scenes.state(world);
    }
  }

  @ParameterizedTest
  @EnumSource
  void divergenceIsToldBeforeNumbersOverflow(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Scenes.floor(world);
      Body ball = Scenes.ball(world, "ball", 0.1, new Vec3(0, 0, 0.5), Material.DEFAULT);
      Body other = Scenes.ball(world, "other", 0.1, new Vec3(2, 0, 0.5), Material.DEFAULT);
      Scenes.run(world, 50);
      double height = ball.pose().position().z();
      for (int i = 0; i < 1000; i++) {
        ball.push(new Vec3(1e12, 0, 0), new Vec3(1e6, 1e6, 0));
      }
      String message = assertThrows(SimulationException.class, world::step).getMessage();
      assertTrue(message.startsWith("ball: moves or turns faster than 10000.0 m/s"), message);
      assertEquals(50, world.steps());
      assertEquals(height, ball.pose().position().z(), 1e-12, "where it was");
      assertEquals(Vec3.ZERO, ball.velocity(), "at rest");
      assertEquals(Vec3.ZERO, other.velocity());
      // Whoever looks or measures meets nothing that is not finite, and it can go on.
      assertEquals(
          1.9,
          world.castRay(new Vec3(0, 0, height), Vec3.X, 9, body -> body != ball).get().distance(),
          1e-6);
      Scenes.run(world, 1000);
      assertEquals(0.1, ball.pose().position().z(), 1e-3, "on the floor");
    }
  }

  /** Whatever is done to it, a world says what is wrong, and the process lives on. */
  @ParameterizedTest
  @EnumSource
  void extremeNumbersNeverEndTheProcess(TestedEngine engine) {
    double[] numbers = {
      0,
      1,
      -1,
      1e-3,
      1e3,
      1e-6,
      1e6,
      -1e6,
      1e-9,
      9999,
      1e12,
      1e-300,
      1e300,
      -1e308,
      Double.MIN_VALUE,
      Double.MAX_VALUE,
      Double.NaN,
      Double.POSITIVE_INFINITY
    };
    Random random = new Random(17);
    DoubleSupplier some = () -> numbers[random.nextInt(numbers.length)];
    Supplier<Vec3> vector =
        () -> new Vec3(some.getAsDouble(), some.getAsDouble(), some.getAsDouble());
    int refusals = 0;
    int steps = 0;
    for (int round = 0; round < 300; round++) {
      PhysicsSettings settings =
          random.nextBoolean() ? DEFAULT : DEFAULT.withSolver(PhysicsSettings.Solver.QUICK, 20);
      try (PhysicsWorld world = engine.world(settings)) {
        Scenes.floor(world);
        Joint pivot = Scenes.pendulum(world, 0.5);
        Body ball = Scenes.ball(world, "ball", 0.1, new Vec3(1, 0, 0.3), Material.DEFAULT);
        for (int i = 0; i < 30; i++) {
          Body body = random.nextBoolean() ? ball : pivot.second();
          int what = random.nextInt(9);
          try {
            switch (what) {
              case 0 -> body.place(Pose.at(vector.get()));
              case 1 -> body.move(vector.get(), vector.get());
              case 2 -> body.push(vector.get(), vector.get());
              case 3 -> pivot.drive(some.getAsDouble(), some.getAsDouble());
              case 4 -> pivot.push(some.getAsDouble());
              case 5 -> world.castRay(vector.get(), vector.get(), some.getAsDouble(), b -> true);
              case 6 ->
                  world.add(
                      new BodyDescription(
                          "made",
                          Pose.at(vector.get()),
                          some.getAsDouble(),
                          List.of(
                              new Part(
                                  new Shape.Box(
                                      some.getAsDouble(), some.getAsDouble(), some.getAsDouble()),
                                  new Pose(vector.get(), Rotation.about(new Vec3(1, 1, 1), 0.7)),
                                  Material.DEFAULT))));
              case 7 ->
                  world.add(
                      new JointDescription(
                          "joint", Kind.SLIDER, null, body, vector.get(), vector.get()));
              default -> {
                world.step();
                steps++;
              }
            }
          } catch (SimulationException e) {
            refusals++;
          }
          assertTrue(ball.pose().isFinite() && pivot.second().pose().isFinite());
        }
      }
    }
    assertTrue(refusals > 1000 && steps > 300, refusals + " refusals, " + steps + " steps");
  }

  @ParameterizedTest
  @EnumSource
  void nonsenseIsRefused(TestedEngine engine) {
    try (PhysicsWorld world = engine.world(DEFAULT)) {
      Body floor = Scenes.floor(world);
      Joint pivot = Scenes.pendulum(world, 0.5);
      Body bob = pivot.second();
      Vec3 nan = new Vec3(Double.NaN, 0, 0);
      refused("bob: the place is not finite", () -> bob.place(Pose.at(nan)));
      refused("bob: the spin is not finite", () -> bob.move(Vec3.ZERO, nan));
      refused("bob: the force is not finite", () -> bob.push(nan, Vec3.ZERO));
      refused("pivot: velocity: not a finite number: NaN", () -> pivot.drive(Double.NaN, 1));
      refused("pivot: force: 0 or more expected, not -1.0", () -> pivot.drive(0, -1));
      refused("floor: does not move: it has no mass", () -> floor.move(Vec3.X, Vec3.ZERO));
      refused(
          "joint: the second body has to be one that can move",
          () -> new JointDescription("joint", Kind.HINGE, bob, floor, Vec3.ZERO, Vec3.X));
      refused(
          "joint: limits: 2.0 is more than 1.0",
          () -> new JointDescription("joint", Kind.HINGE, null, bob, Vec3.ZERO, Vec3.X, 2, 1));
      refused(
          "ground: a plane has no mass: it cannot move",
          () ->
              new BodyDescription("ground", Pose.ORIGIN, 1, List.of(new Part(new Shape.Plane()))));
      Scenes.run(world, 10);
      assertTrue(bob.pose().isFinite());
      world.close();
      refused("this world has been closed", world::step);
    }
  }

  private static void refused(String message, org.junit.jupiter.api.function.Executable wrong) {
    assertEquals(message, assertThrows(SimulationException.class, wrong).getMessage());
  }
}
