package org.urbi.sim.world;

import java.util.Map;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.render.Lens;

/** Reads the blocks of what is mounted on bodies. */
final class MountReader {
  static final String KINDS = "camera, distance, bumper, accelerometer, gyrometer, led";

  private final SimulatedWorld world;
  private final Map<String, Map<String, Integer>> partNames;

  MountReader(SimulatedWorld world, Map<String, Map<String, Integer>> partNames) {
    this.world = world;
    this.partNames = partNames;
  }

  /** Adds what a block describes; false if it is of another kind. */
  boolean add(Block block) {
    switch (block.kind()) {
      case "camera", "distance", "bumper", "accelerometer", "gyrometer", "led" -> {}
      default -> {
        return false;
      }
    }
    block.requireNoBlocks();
    if (world.has(block.name())) {
      throw block.wrong("there is something else of that name");
    }
    Body body = GeometryReader.body(block, "on", world);
    if (block.kind().equals("camera")) {
      world.addMount(new Mount.Camera(block.name(), body, GeometryReader.pose(block), lens(block)));
    } else if (body == null) {
      throw block.wrong("on is missing: the body that carries it");
    } else {
      world.addMount(carried(block, body));
    }
    block.finish();
    return true;
  }

  private Mount carried(Block block, Body body) {
    String name = block.name();
    return switch (block.kind()) {
      case "distance" -> distance(block, body);
      case "bumper" -> new Mount.Bumper(name, body, part(block, body, -1));
      case "accelerometer" ->
          new Mount.Accelerometer(name, body, GeometryReader.pose(block), axis(block));
      case "gyrometer" -> new Mount.Gyrometer(name, body, GeometryReader.pose(block), axis(block));
      default -> new Mount.Led(name, body, part(block, body, 0));
    };
  }

  private static Lens lens(Block block) {
    double[] size = block.numbers("size", 2, Unit.NONE);
    if (size == null) {
      size = new double[] {320, 240};
    }
    if (size[0] != Math.rint(size[0]) || size[1] != Math.rint(size[1])) {
      throw block.wrong("size", "whole numbers of pixels expected");
    }
    double xfov = block.number("xfov", Unit.ANGLE, Math.PI / 3);
    double near = block.number("near", Unit.LENGTH, 0.02);
    double far = block.number("far", Unit.LENGTH, 100);
    return new Lens((int) size[0], (int) size[1], xfov, near, far);
  }

  private static Mount distance(Block block, Body body) {
    double[] range = block.requiredNumbers("range", 2, Unit.LENGTH);
    if (!(range[0] >= 0 && range[0] < range[1])) {
      throw block.wrong("range", "the nearest and the farthest distance expected");
    }
    return new Mount.DistanceSensor(
        block.name(), body, GeometryReader.pose(block), range[0], range[1]);
  }

  private static Vec3 axis(Block block) {
    return switch (block.requiredWord("axis")) {
      case "x" -> Vec3.X;
      case "y" -> Vec3.Y;
      case "z" -> Vec3.Z;
      default -> throw block.wrong("axis", "x, y or z expected");
    };
  }

  private int part(Block block, Body body, int otherwise) {
    if (!block.has("part")) {
      return otherwise;
    }
    String name = block.requiredWord("part");
    Integer part = partNames.getOrDefault(body.name(), Map.of()).get(name);
    if (part == null) {
      throw block.wrong("part", "body " + body.name() + " has no part '" + name + "'");
    }
    return part;
  }
}
