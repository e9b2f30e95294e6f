package org.urbi.sim.physics;

import java.util.List;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.BodyDescription.Part;
import org.urbi.sim.physics.JointDescription.Kind;

/** What tests put into worlds. */
final class Scenes {
  private Scenes() {}

  static Body floor(PhysicsWorld world) {
    return world.add(
        new BodyDescription("floor", Pose.ORIGIN, 0, List.of(new Part(new Shape.Plane()))));
  }

  static Body ball(PhysicsWorld world, String name, double radius, Vec3 place, Material material) {
    return world.add(
        BodyDescription.of(name, Pose.at(place), 0.2, new Shape.Sphere(radius), material));
  }

  static Body box(PhysicsWorld world, String name, double edge, Vec3 place) {
    return world.add(
        BodyDescription.of(
            name, Pose.at(place), 1, new Shape.Box(edge, edge, edge), Material.DEFAULT));
  }

  /** A ball of 5 cm at 1 m below the origin, which swings about the y axis. */
  static Joint pendulum(PhysicsWorld world, double angle) {
    Rotation turned = Rotation.about(Vec3.Y, angle);
    Vec3 place = turned.apply(new Vec3(0, 0, -1));
    Body bob =
        world.add(
            BodyDescription.of(
                "bob", new Pose(place, turned), 1, new Shape.Sphere(0.05), Material.DEFAULT));
    return world.add(new JointDescription("pivot", Kind.HINGE, null, bob, Vec3.ZERO, Vec3.Y));
  }

  /** Boxes that fall onto each other, each turned a little. */
  static void stack(PhysicsWorld world, int count) {
    floor(world);
    for (int i = 0; i < count; i++) {
      Pose pose =
          new Pose(new Vec3(0.01 * (i % 2), 0, 0.11 + 0.25 * i), Rotation.about(Vec3.Z, 0.1 * i));
      world.add(
          BodyDescription.of("box" + i, pose, 1, new Shape.Box(0.2, 0.2, 0.2), Material.DEFAULT));
    }
  }

  /** A cart whose wheel is driven. */
  static Joint drivenWheel(PhysicsWorld world) {
    floor(world);
    Body chassis =
        world.add(
            BodyDescription.of(
                "chassis", Pose.at(0, 0, 0.2), 2, new Shape.Box(0.6, 0.3, 0.1), Material.DEFAULT));
    Joint driven = null;
    for (int i = 0; i < 4; i++) {
      Vec3 place = new Vec3(i < 2 ? 0.2 : -0.2, i % 2 == 0 ? 0.2 : -0.2, 0.1);
      Body wheel =
          world.add(
              BodyDescription.of(
                  "wheel" + i,
                  new Pose(place, Rotation.about(Vec3.X, Math.PI / 2)),
                  0.2,
                  new Shape.Cylinder(0.1, 0.05),
                  new Material(1, 0, 0)));
      Joint axle =
          world.add(new JointDescription("axle" + i, Kind.HINGE, chassis, wheel, place, Vec3.Y));
      if (i == 0) {
        driven = axle;
      }
      axle.drive(2, 1);
    }
    return driven;
  }

  static void run(PhysicsWorld world, int steps) {
    for (int i = 0; i < steps; i++) {
      world.step();
    }
  }

  /** All that can be seen of a world, to the last bit. */
  static String state(PhysicsWorld world) {
    StringBuilder text = new StringBuilder();
    for (Body body : world.bodies()) {
      text.append(body.name())
          .append(' ')
          .append(body.pose())
          .append(' ')
          .append(body.velocity())
          .append(' ')
          .append(body.spin())
          .append('\n');
    }
    for (Joint joint : world.joints()) {
      text.append(joint.name()).append(' ').append(joint.position()).append('\n');
    }
    return text.append(world.contacts()).toString();
  }
}
