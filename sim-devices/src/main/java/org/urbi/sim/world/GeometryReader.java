package org.urbi.sim.world;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;

/** Reads poses, shapes and references to bodies from blocks. */
final class GeometryReader {
  private GeometryReader() {}

  /** {@code at X Y Z}, and {@code turn ROLL PITCH YAW}. */
  static Pose pose(Block block) {
    double[] at = block.numbers("at", 3, Unit.LENGTH);
    double[] turn = block.numbers("turn", 3, Unit.ANGLE);
    return new Pose(
        at == null ? Vec3.ZERO : WorldReader.vector(at),
        turn == null ? Rotation.NONE : Rotation.rollPitchYaw(turn[0], turn[1], turn[2]));
  }

  static Shape shape(Block block) {
    block.requireNoBlocks();
    return switch (block.kind()) {
      case "sphere" -> new Shape.Sphere(size(block, "radius"));
      case "cylinder" -> new Shape.Cylinder(size(block, "radius"), size(block, "length"));
      case "capsule" -> new Shape.Capsule(size(block, "radius"), size(block, "length"));
      case "plane" -> new Shape.Plane();
      case "box" -> {
        double[] size = block.requiredNumbers("size", 3, Unit.LENGTH);
        for (double edge : size) {
          requirePositive(block, "size", edge);
        }
        yield new Shape.Box(size[0], size[1], size[2]);
      }
      default ->
          throw new WorldFileException(
              block.place(),
              "unknown shape '"
                  + block.kind()
                  + "'; there are box, sphere, cylinder, capsule and plane");
    };
  }

  private static double size(Block block, String property) {
    return requirePositive(block, property, block.requiredNumber(property, Unit.LENGTH));
  }

  private static double requirePositive(Block block, String property, double size) {
    if (!(size > 0)) {
      throw block.wrong(property, "more than 0 expected, not " + size);
    }
    return size;
  }

  /** The body that a property names, or null if it has none. */
  static @Nullable Body body(Block block, String property, SimulatedWorld world) {
    String name = block.word(property);
    return name == null ? null : known(block, property, name, world);
  }

  static Body known(Block block, String property, String name, SimulatedWorld world) {
    return world.bodies().stream()
        .filter(body -> body.name().equals(name))
        .findFirst()
        .orElseThrow(() -> block.wrong(property, "no body '" + name + "' before this line"));
  }
}
