package org.urbi.sim.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The native engine against ode4j: same scene, same steps, same places. */
class EngineAgreementTest {
  @Test
  void agreeOnAPendulum() {
    agree(2000, 1e-9, PhysicsSettings.DEFAULT, world -> Scenes.pendulum(world, 1.2));
  }

  /** Impacts of boxes amplify the last bit; within this time they amplify it little. */
  @Test
  void agreeOnAFallingStack() {
    agree(1500, 1e-3, PhysicsSettings.DEFAULT, world -> Scenes.stack(world, 4));
  }

  @Test
  void agreeOnADrivenJoint() {
    agree(2000, 1e-3, PhysicsSettings.DEFAULT, Scenes::drivenWheel);
  }

  @Test
  void agreeWithTheQuickSolver() {
    agree(
        1000,
        1e-3,
        PhysicsSettings.DEFAULT.withSolver(PhysicsSettings.Solver.QUICK, 40),
        Scenes::drivenWheel);
  }

  private static void agree(
      int steps, double tolerance, PhysicsSettings settings, Consumer<PhysicsWorld> scene) {
    try (PhysicsWorld nativeWorld = TestedEngine.ODE.world(settings);
        PhysicsWorld javaWorld = TestedEngine.ODE4J.world(settings)) {
      scene.accept(nativeWorld);
      scene.accept(javaWorld);
      for (int step = 1; step <= steps; step++) {
        nativeWorld.step();
        javaWorld.step();
        for (int i = 0; i < nativeWorld.bodies().size(); i++) {
          Body mine = nativeWorld.bodies().get(i);
          Body other = javaWorld.bodies().get(i);
          double distance = mine.pose().position().minus(other.pose().position()).length();
          assertEquals(0, distance, tolerance, mine.name() + " after " + step + " steps");
        }
      }
      for (int i = 0; i < nativeWorld.joints().size(); i++) {
        double mine = nativeWorld.joints().get(i).position();
        assertEquals(mine, javaWorld.joints().get(i).position(), 2 * tolerance);
      }
    }
  }
}
