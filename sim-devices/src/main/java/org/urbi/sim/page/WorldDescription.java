package org.urbi.sim.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.physics.Body;
import org.urbi.sim.physics.BodyDescription;
import org.urbi.sim.render.Appearance;
import org.urbi.sim.render.Colour;
import org.urbi.sim.render.Lens;
import org.urbi.sim.world.Drive;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.RobotDescription;
import org.urbi.sim.world.SimulatedWorld;

/**
 * The description of a world that a page gets once, before the snapshots: the objects and their
 * appearance.
 */
public final class WorldDescription {
  private WorldDescription() {}

  /**
   * Describes a world, as the page reads it.
   *
   * @param camera the one that is shown; null for none
   */
  public static String of(SimulatedWorld world, Mount.@Nullable Camera camera) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("type", "setting");
    all.put("title", title(world));
    all.put("engine", world.physics().engine().name());
    all.put("bodies", world.bodies().stream().map(body -> body(world, body)).toList());
    all.put("drives", world.drives().stream().map(WorldDescription::drive).toList());
    all.put("eyes", eyes(world));
    all.put("mobile", world.robot().map(RobotDescription::mobile).orElse(false));
    all.put("background", colour(world.background()));
    if (camera != null) {
      Lens lens = camera.lens();
      all.put(
          "camera",
          Map.of(
              "name",
              camera.name(),
              "width",
              lens.width(),
              "height",
              lens.height(),
              "xfov",
              lens.xfov()));
    }
    return Json.text(all);
  }

  /** What people call a world. */
  public static String title(SimulatedWorld world) {
    return world.robot().map(RobotDescription::name).orElse("Simulation");
  }

  /** For each camera its name, its angle of view and its width by its height. */
  private static List<Map<String, Object>> eyes(SimulatedWorld world) {
    List<Map<String, Object>> eyes = new ArrayList<>();
    for (Mount mount : world.mounts()) {
      if (mount instanceof Mount.Camera camera) {
        Lens lens = camera.lens();
        double aspect = (double) lens.width() / lens.height();
        eyes.add(Map.of("name", camera.name(), "xfov", lens.xfov(), "aspect", aspect));
      }
    }
    return eyes;
  }

  private static Map<String, Object> body(SimulatedWorld world, Body body) {
    List<Map<String, Object>> parts = new ArrayList<>();
    List<Appearance> looks = world.looks(body);
    for (int i = 0; i < body.parts().size(); i++) {
      BodyDescription.Part part = body.parts().get(i);
      Map<String, Object> described = shape(part.shape());
      described.put("at", Snapshot.numbers(part.pose()));
      Appearance look = looks.get(i);
      described.put("colour", colour(look.colour()));
      if (look.second() != null) {
        described.put("second", colour(look.second()));
        described.put("tile", look.tile());
      }
      parts.add(described);
    }
    return Map.of("name", body.name(), "fixed", body.isFixed(), "parts", parts);
  }

  private static Map<String, Object> shape(Shape shape) {
    Map<String, Object> described = new LinkedHashMap<>();
    switch (shape) {
      case Shape.Sphere sphere -> put(described, "sphere", sphere.radius());
      case Shape.Box box -> put(described, "box", box.x(), box.y(), box.z());
      case Shape.Cylinder rod -> put(described, "cylinder", rod.radius(), rod.length());
      case Shape.Capsule rod -> put(described, "capsule", rod.radius(), rod.length());
      case Shape.Plane plane -> put(described, "plane");
    }
    return described;
  }

  private static void put(Map<String, Object> described, String kind, double... size) {
    described.put("shape", kind);
    described.put("size", size);
  }

  private static Map<String, Object> drive(Drive drive) {
    boolean position = drive.control() == Drive.Control.POSITION;
    Map<String, Object> described = new LinkedHashMap<>();
    described.put("name", drive.name());
    described.put("control", position ? "position" : "speed");
    described.put("unit", drive.unit());
    described.put("low", position ? drive.joint().low() : -drive.maxSpeed());
    described.put("high", position ? drive.joint().high() : drive.maxSpeed());
    return described;
  }

  private static double[] colour(Colour colour) {
    return new double[] {colour.red(), colour.green(), colour.blue()};
  }
}
