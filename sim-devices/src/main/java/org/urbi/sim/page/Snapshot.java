package org.urbi.sim.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.vision.Blob;
import org.urbi.sim.world.Drive;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UImage;

/**
 * The state of the world that a page shows at one moment. It is taken on the simulation's thread
 * and never changes.
 *
 * @param time of the simulation, in seconds
 * @param bodies where each is, in the order of the world
 * @param drives for each its sensed position or speed, and its target
 * @param eyes where each camera is, in the order of the world
 * @param rays for each distance sensor, in that order, where it is and what it measures
 * @param clock how time goes
 * @param sight what the camera that is shown sees; null without one
 */
public record Snapshot(
    double time,
    List<Pose> bodies,
    List<double[]> drives,
    List<Pose> eyes,
    List<Ray> rays,
    Clock clock,
    @Nullable CameraView sight) {
  /** What a distance sensor measures, in metres. */
  public record Ray(Pose sensor, double distance) {}

  /** How time goes: not at all, or how many simulated seconds in one of the kernel. */
  public record Clock(boolean paused, double speed) {}

  /**
   * The view of a camera.
   *
   * @param camera where it is
   * @param image its last image; null if there is none yet
   * @param number of the image, from 1
   * @param detector whether there is one
   * @param blob what the detector has found in that image; null if nothing
   */
  public record CameraView(
      Pose camera, @Nullable UImage image, long number, boolean detector, @Nullable Blob blob) {}

  /** The moment at which a world is now. */
  public static Snapshot of(SimulatedWorld world, Clock clock, @Nullable CameraView sight) {
    List<Pose> bodies = new ArrayList<>();
    world.bodies().forEach(body -> bodies.add(body.pose()));
    List<double[]> drives = new ArrayList<>();
    for (Drive drive : world.drives()) {
      drives.add(new double[] {drive.sensed(), drive.target()});
    }
    List<Pose> eyes = new ArrayList<>();
    List<Ray> rays = new ArrayList<>();
    for (Mount mount : world.mounts()) {
      if (mount instanceof Mount.Camera camera) {
        eyes.add(camera.worldPose());
      } else if (mount instanceof Mount.DistanceSensor sensor) {
        rays.add(new Ray(sensor.worldPose(), world.distance(sensor)));
      }
    }
    return new Snapshot(world.physics().time(), bodies, drives, eyes, rays, clock, sight);
  }

  String json() {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("type", "moment");
    all.put("time", time);
    all.put("bodies", bodies.stream().map(Snapshot::numbers).toList());
    all.put("drives", drives);
    all.put("eyes", eyes.stream().map(Snapshot::numbers).toList());
    all.put("rays", rays.stream().map(ray -> numbers(ray.sensor())).toList());
    all.put("distances", rays.stream().map(Ray::distance).toList());
    all.put("paused", clock.paused());
    all.put("speed", clock.speed());
    if (sight != null) {
      Map<String, Object> seen = new LinkedHashMap<>();
      seen.put("camera", numbers(sight.camera()));
      seen.put("image", sight.number());
      seen.put("detector", sight.detector());
      if (sight.blob() != null) {
        Blob blob = sight.blob();
        seen.put("blob", new double[] {blob.x(), blob.y(), blob.ratio()});
      }
      all.put("sight", seen);
    }
    return Json.text(all);
  }

  static double[] numbers(Pose pose) {
    return new double[] {
      pose.position().x(),
      pose.position().y(),
      pose.position().z(),
      pose.rotation().w(),
      pose.rotation().x(),
      pose.rotation().y(),
      pose.rotation().z()
    };
  }
}
