package org.urbi.bench.sim;

import java.util.List;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.physics.BodyDescription;
import org.urbi.sim.physics.BodyDescription.Part;
import org.urbi.sim.physics.JointDescription;
import org.urbi.sim.physics.JointDescription.Kind;
import org.urbi.sim.physics.Material;
import org.urbi.sim.physics.PhysicsWorld;

/** 100 bodies with 60 driven joints on a floor: 15 carts, 13 balls and 12 boxes. */
final class ManyBodies {
  private ManyBodies() {}

  static void fill(PhysicsWorld world) {
    world.add(new BodyDescription("floor", Pose.ORIGIN, 0, List.of(new Part(new Shape.Plane()))));
    for (int i = 0; i < 15; i++) {
      addCart(world, i % 4, i / 4, i % 2 == 0 ? 1 : -1);
    }
    for (int i = 0; i < 25; i++) {
      Shape shape = i % 2 == 0 ? new Shape.Sphere(0.1) : new Shape.Box(0.2, 0.2, 0.2);
      Pose place = Pose.at(-1 - 0.4 * (i % 5), 0.4 * (i / 5), 0.3);
      world.add(BodyDescription.of("body" + i, place, 1, shape, Material.DEFAULT));
    }
  }

  private static void addCart(PhysicsWorld world, double x, double y, double speed) {
    Body chassis =
        world.add(
            BodyDescription.of(
                "chassis", Pose.at(x, y, 0.2), 2, new Shape.Box(0.5, 0.3, 0.1), Material.DEFAULT));
    Rotation lying = Rotation.about(Vec3.X, Math.PI / 2);
    for (int i = 0; i < 4; i++) {
      Vec3 place = new Vec3(x + (i < 2 ? 0.2 : -0.2), y + (i % 2 == 0 ? 0.2 : -0.2), 0.1);
      Body wheel =
          world.add(
              BodyDescription.of(
                  "wheel",
                  new Pose(place, lying),
                  0.2,
                  new Shape.Cylinder(0.1, 0.05),
                  Material.DEFAULT));
      world
          .add(new JointDescription("axle", Kind.HINGE, chassis, wheel, place, Vec3.Y))
          .drive(speed, 1);
    }
  }
}
