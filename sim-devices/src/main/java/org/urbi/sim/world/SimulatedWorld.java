package org.urbi.sim.world;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.physics.Joint;
import org.urbi.sim.physics.PhysicsWorld;
import org.urbi.sim.physics.RayHit;
import org.urbi.sim.render.Appearance;
import org.urbi.sim.render.Colour;
import org.urbi.sim.render.Light;
import org.urbi.sim.render.Renderer;
import org.urbi.sim.render.Scene;
import org.urbi.sim.render.SceneObject;

/**
 * The world of a world file: moving, visible bodies, drives, and mounted devices. One thread at a
 * time uses it.
 */
public final class SimulatedWorld implements AutoCloseable {
  /** Of worlds without lights of their own. */
  private static final List<Light> DAYLIGHT =
      List.of(new Light.Sun(new Vec3(0.3, 0.5, -1), Colour.WHITE.times(0.6)));

  private final PhysicsWorld physics;
  private final Map<String, Body> bodies = new LinkedHashMap<>();
  private final Map<String, Joint> joints = new LinkedHashMap<>();
  private final Map<String, Drive> drives = new LinkedHashMap<>();
  private final Map<String, Mount> mounts = new LinkedHashMap<>();
  private final Map<String, AccelerationEstimate> motions = new LinkedHashMap<>();
  private final Map<Body, List<Appearance>> appearances = new LinkedHashMap<>();
  private final List<Light> lights = new ArrayList<>();
  private double ambient = 0.4;
  private Colour background = new Colour(0.55, 0.7, 0.9);
  private @Nullable RobotDescription robot;
  private final Renderer renderer = new Renderer();

  SimulatedWorld(PhysicsWorld physics) {
    this.physics = physics;
  }

  // ------------------------------------------------------------------ how it is built

  void setLook(double newAmbient, Colour newBackground) {
    ambient = newAmbient;
    background = newBackground;
  }

  void addBody(Body body, List<Appearance> looks) {
    bodies.put(body.name(), body);
    appearances.put(body, new ArrayList<>(looks));
  }

  void addJoint(Joint joint) {
    joints.put(joint.name(), joint);
  }

  void addDrive(Drive drive) {
    drives.put(drive.name(), drive);
  }

  void addMount(Mount mount) {
    mounts.put(mount.name(), mount);
    if (mount instanceof Mount.Accelerometer sensor) {
      motions.put(mount.name(), new AccelerationEstimate(sensor, physics.settings()));
    }
  }

  void addLight(Light light) {
    lights.add(light);
  }

  void setRobot(RobotDescription description) {
    robot = description;
  }

  /** Whether something is called like that. */
  boolean has(String name) {
    return bodies.containsKey(name) || joints.containsKey(name) || mounts.containsKey(name);
  }

  // ------------------------------------------------------------------ what there is

  public PhysicsWorld physics() {
    return physics;
  }

  /** The drives in the order of the file. */
  public List<Drive> drives() {
    return List.copyOf(drives.values());
  }

  /** What is mounted, in the order of the file. */
  public List<Mount> mounts() {
    return List.copyOf(mounts.values());
  }

  public Optional<RobotDescription> robot() {
    return Optional.ofNullable(robot);
  }

  /**
   * The body of that name.
   *
   * @throws SimulationException if there is none
   */
  public Body body(String name) {
    return named("body", bodies, name);
  }

  /**
   * The drive of the joint of that name.
   *
   * @throws SimulationException if there is none
   */
  public Drive drive(String name) {
    return named("drive", drives, name);
  }

  /**
   * What is mounted under that name.
   *
   * @throws SimulationException if there is none, or if it is something else
   */
  public <T extends Mount> T mount(Class<T> type, String name) {
    String what =
        Character.toLowerCase(type.getSimpleName().charAt(0)) + type.getSimpleName().substring(1);
    Map<String, T> ofType = new LinkedHashMap<>();
    for (Mount mount : mounts.values()) {
      if (type.isInstance(mount)) {
        ofType.put(mount.name(), type.cast(mount));
      }
    }
    return named(what, ofType, name);
  }

  private static <T> T named(String what, Map<String, T> all, String name) {
    T found = all.get(name);
    if (found == null) {
      throw new SimulationException(
          "no "
              + what
              + " '"
              + name
              + "' in this world"
              + (all.isEmpty() ? "" : "; it has " + String.join(", ", all.keySet())));
    }
    return found;
  }

  // ------------------------------------------------------------------ time

  /** Goes on by one step. */
  public void step() {
    double step = physics.settings().step();
    for (Drive drive : drives.values()) {
      drive.beforeStep(step);
    }
    physics.step();
    for (AccelerationEstimate motion : motions.values()) {
      motion.afterStep();
    }
  }

  /** All is there; to this {@link #restart} goes back. */
  void begin() {
    physics.keepStart();
  }

  /**
   * Puts everything where the file has it, as fast as it is there; the targets of all drives are 0.
   * Time goes on.
   */
  public void restart() {
    physics.restart();
    drives.values().forEach(Drive::restart);
    motions.values().forEach(AccelerationEstimate::restart);
  }

  // ------------------------------------------------------------------ what sensors measure

  /** In metres; the farthest that it can measure if there is nothing. */
  public double distance(Mount.DistanceSensor sensor) {
    Pose pose = sensor.worldPose();
    return physics
        .castRay(
            pose.position(),
            pose.rotation().apply(Vec3.X),
            sensor.farthest(),
            body -> body != sensor.body())
        .map(RayHit::distance)
        .map(distance -> Math.max(distance, sensor.nearest()))
        .orElse(sensor.farthest());
  }

  /**
   * What a scanner that turns about the z axis of a body measures: the distances, in metres, of
   * what is not joined to that body; infinite where there is nothing.
   *
   * @param from the angle of the first ray, from the x axis, in radians; to: of the last one
   */
  public double[] scan(Body body, Vec3 place, double from, double to, int count, double farthest) {
    Set<Body> own = joinedTo(body);
    Pose pose = body.pose();
    Vec3 start = pose.apply(place);
    double[] distances = new double[count];
    for (int i = 0; i < count; i++) {
      double angle = count == 1 ? from : from + (to - from) * i / (count - 1);
      Vec3 direction = pose.rotation().apply(new Vec3(Math.cos(angle), Math.sin(angle), 0));
      distances[i] =
          physics
              .castRay(start, direction, farthest, seen -> !own.contains(seen))
              .map(RayHit::distance)
              .orElse(Double.POSITIVE_INFINITY);
    }
    return distances;
  }

  /** A body, and all that joints connect with it. */
  private Set<Body> joinedTo(Body body) {
    Set<Body> all = new LinkedHashSet<>(List.of(body));
    boolean grows = true;
    while (grows) {
      grows = false;
      for (Joint joint : joints.values()) {
        Body first = joint.first();
        if (first != null && (all.contains(first) || all.contains(joint.second()))) {
          grows |= all.add(first) | all.add(joint.second());
        }
      }
    }
    return all;
  }

  /** Whether it touches something. */
  public boolean touches(Mount.Bumper bumper) {
    return physics.touch(bumper.body(), bumper.part()) > 0;
  }

  /** In m/s²; at rest an accelerometer measures what holds it against gravity. */
  public double acceleration(Mount.Accelerometer sensor) {
    return requireNonNull(motions.get(sensor.name()), "made with the sensor")
        .acceleration()
        .dot(sensor.axis());
  }

  /** In rad/s. */
  public double angularVelocity(Mount.Gyrometer sensor) {
    return sensor.worldPose().rotation().inverse().apply(sensor.body().spin()).dot(sensor.axis());
  }

  /** Has a part of a body shine. */
  public void light(Mount.Led led, Colour colour, double strength) {
    List<Appearance> looks = looksOf(led.body());
    looks.set(led.part(), looks.get(led.part()).glowing(colour, strength));
  }

  // ------------------------------------------------------------------ what can be seen

  /** What there is to be seen, now. */
  public Scene scene() {
    List<SceneObject> things = new ArrayList<>();
    for (Body body : bodies.values()) {
      Pose pose = body.pose();
      List<Appearance> looks = looksOf(body);
      for (int part = 0; part < looks.size(); part++) {
        things.add(
            new SceneObject(
                body.parts().get(part).shape(),
                pose.apply(body.parts().get(part).pose()),
                looks.get(part)));
      }
    }
    return new Scene(things, lights.isEmpty() ? DAYLIGHT : lights, ambient, background);
  }

  /** What there is where nothing is. */
  public Colour background() {
    return background;
  }

  private List<Appearance> looksOf(Body body) {
    return requireNonNull(appearances.get(body), "added with the body");
  }

  /** What the parts of a body look like, in their order. */
  public List<Appearance> looks(Body body) {
    return List.copyOf(looksOf(body));
  }

  /** What a camera sees now: red, green and blue of each pixel. */
  public byte[] render(Mount.Camera camera) {
    return renderer.render(scene(), camera.worldPose(), camera.lens());
  }

  /** All bodies, in the order of the file. */
  public List<Body> bodies() {
    return Collections.unmodifiableList(physics.bodies());
  }

  @Override
  public void close() {
    physics.close();
  }
}
