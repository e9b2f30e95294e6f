package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.render.Lens;
import org.urbi.sim.render.Renderer;
import org.urbi.sim.time.ProcessTime;
import org.urbi.sim.world.Drive;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.PhysicsEngines;
import org.urbi.sim.world.SimulatedWorld;
import org.urbi.sim.world.WorldReader;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UObject;
import urbi.UStart;
import urbi.UVar;

/**
 * A simulated world, whose time is that of the kernel: it goes on in fixed steps until it has
 * caught up, whenever its timer is due and whenever somebody reads one of its sensors. With the
 * virtual clock it so takes as long as its arithmetic. Where the machine is too slow, simulated
 * time stays behind, and {@code late} grows. {@code paused} halts it, {@code speed} is how many
 * simulated seconds pass in one of the kernel.
 */
@UStart
public final class SimWorld extends UObject implements AutoCloseable {
  /** What it makes up for at a time, in seconds of simulated time, beyond two periods. */
  private static final double MAX_CATCH_UP = 0.5;

  /** Of a scan. */
  private static final int MOST_RAYS = 10_000;

  private static final double MICROSECONDS = 1e6;
  private static final double MILLISECONDS = 1e3;

  private final UVar time = new UVar();
  private final UVar late = new UVar();
  private final UVar period = new UVar();
  private final UVar engine = new UVar();

  /** Written to learn the kernel's time. */
  private final UVar beat = new UVar();

  private final UVar paused = new UVar();
  private final UVar speed = new UVar();

  private final List<SimDevice> devices = new ArrayList<>();
  private final List<SimPage> pages = new ArrayList<>();
  private final ProcessTime processTime = new ProcessTime();
  private final Renderer renderer = new Renderer();
  private @Nullable SimulatedWorld world;
  private @Nullable String timer;
  private long beats;
  private Pace pace = new Pace(0);
  private double usedPeriod = 0.02;
  private boolean advancing;
  private boolean diverged;

  public SimWorld(String name) {
    super(name);
    UBindFunction("init");
  }

  /**
   * Reads a world file and starts.
   *
   * @throws SimulationException if it has a mistake
   */
  public void init(String file) {
    SimulatedWorld read = WorldReader.read(Path.of(file), null);
    world = read;
    UBindVars(time, "time", late, "late", period, "period", engine, "engine", beat, "beat");
    UBindVars(paused, "paused", speed, "speed");
    UBindFunctions(
        "deviceList",
        "robotDescription",
        "bodies",
        "position",
        "orientation",
        "velocity",
        "place",
        "move",
        "push",
        "hit",
        "reset",
        "picture",
        "scan",
        "step",
        "whyNotNative");
    engine.setValue(read.physics().engine().description());
    late.setValue(0);
    period.setValue(usedPeriod);
    UNotifyChange(period, "periodChanged");
    pace = new Pace(now());
    paused.setValue(false);
    speed.setValue(pace.speed());
    UNotifyChange(paused, "pausedChanged");
    UNotifyChange(speed, "speedChanged");
    time.setValue(0);
    startTimer();
  }

  /** The world of that name, for its devices. */
  static SimWorld named(UObject asking, String name) {
    if (asking.getUContext().getUObject(name) instanceof SimWorld found && found.world != null) {
      return found;
    }
    throw new SimulationException("no simulated world '" + name + "'");
  }

  SimulatedWorld world() {
    return ready(world);
  }

  /** Has a device told about each step of time. */
  void add(SimDevice device) {
    devices.add(device);
  }

  void remove(SimDevice device) {
    devices.remove(device);
  }

  /** Has a page show what there is after each {@link #update}. */
  void add(SimPage page) {
    pages.add(page);
  }

  void remove(SimPage page) {
    pages.remove(page);
  }

  // ------------------------------------------------------------------ time

  private double now() {
    if (isRemoteMode()) {
      return processTime.seconds();
    }
    beat.setValue(++beats);
    return beat.timestamp() / MICROSECONDS;
  }

  /** Starts the timer anew when the period has been changed. */
  public void periodChanged() {
    double seconds = period.doubleValue();
    if (!(seconds > 0 && seconds <= 1)) {
      period.setValue(usedPeriod);
      throw new SimulationException("period: between 0 and 1 s expected, not " + seconds);
    }
    usedPeriod = seconds;
    removeTimer(ready(timer));
    startTimer();
  }

  /** The world is to halt, or to go on. */
  public void pausedChanged() {
    advance();
    pace.pause(now(), paused.booleanValue());
  }

  /** The world is to go on faster, or slower. */
  public void speedChanged() {
    advance();
    try {
      pace.go(now(), speed.doubleValue());
    } catch (SimulationException e) {
      speed.setValue(pace.speed());
      throw e;
    }
  }

  Pace pace() {
    return pace;
  }

  /** Halts, or goes on. */
  void pause(boolean wanted) {
    paused.setValue(wanted);
  }

  /**
   * Goes on at another speed.
   *
   * @throws SimulationException if it is none
   */
  void go(double wanted) {
    advance();
    pace.go(now(), wanted);
    speed.setValue(wanted);
  }

  private void startTimer() {
    timer = USetTimer(usedPeriod * MILLISECONDS, this, "update");
  }

  /** Catches up with the kernel's clock, and has all devices tell what they sense. */
  public int update() {
    advance();
    time.setValue(world().physics().time());
    for (SimDevice device : List.copyOf(devices)) {
      device.updateSensors();
    }
    for (SimPage page : List.copyOf(pages)) {
      page.show();
    }
    return 0;
  }

  /** Goes on until it has caught up with the kernel's clock. */
  void advance() {
    if (advancing || diverged) {
      return;
    }
    advancing = true;
    try {
      double step = world().physics().settings().step();
      double behind = pace.goal(now()) - world().physics().time();
      double most = Math.max(MAX_CATCH_UP, 2 * usedPeriod);
      if (behind > most) {
        late.setValue(pace.lose(behind - most));
        behind = most;
      }
      // A clock in microseconds meets the end of a step a little early or late.
      for (long steps = (long) Math.floor(behind / step + 1e-3); steps > 0; steps--) {
        world().step();
      }
    } catch (SimulationException e) {
      // Said once: it stands still from now on.
      diverged = true;
      throw e;
    } finally {
      advancing = false;
    }
  }

  /** Goes on by so many steps at once, whatever time it is. */
  public void step(int steps) {
    if (steps < 0) {
      throw new SimulationException("step: 0 or more expected, not " + steps);
    }
    for (int i = 0; i < steps; i++) {
      world().step();
    }
    pace.lose(-steps * world().physics().settings().step());
    update();
  }

  /**
   * Puts everything where the file has it, as fast as it is there; the targets of all motors are 0.
   * Time goes on.
   */
  public void reset() {
    advance();
    world().restart();
    diverged = false;
    update();
  }

  // ------------------------------------------------------------------ what there is

  /** For each device of the file: its kind and its name. */
  public List<List<String>> deviceList() {
    List<List<String>> all = new ArrayList<>();
    for (Drive drive : world().drives()) {
      all.add(
          List.of(
              drive.control() == Drive.Control.POSITION ? "SimServo" : "SimWheel", drive.name()));
    }
    for (Mount mount : world().mounts()) {
      all.add(
          List.of(
              switch (mount) {
                case Mount.Camera camera -> "SimCamera";
                case Mount.DistanceSensor sensor -> "SimDistanceSensor";
                case Mount.Bumper bumper -> "SimTouchSensor";
                case Mount.Accelerometer sensor -> "SimAccelerometer";
                case Mount.Gyrometer sensor -> "SimGyrometer";
                case Mount.Led led -> "SimLed";
              },
              mount.name()));
    }
    return all;
  }

  /** What the file says of the robot; empty without one. */
  public Map<String, Object> robotDescription() {
    Map<String, Object> all = new LinkedHashMap<>();
    world()
        .robot()
        .ifPresent(robot -> {
          all.put("name", robot.name());
          all.put("kind", robot.kind());
          all.put("model", robot.model());
          if (robot.mobile()) {
            all.put("left", robot.left().name());
            all.put("right", robot.right().name());
            all.put("radius", robot.radius());
            all.put("track", robot.track());
            Body base = robot.left().joint().first();
            all.put("base", base == null ? "" : base.name());
          }
        });
    return all;
  }

  /** The names of the bodies. */
  public List<String> bodies() {
    return world().bodies().stream().map(Body::name).toList();
  }

  /** Where a body is: x, y, z, in metres. */
  public List<Double> position(String body) {
    advance();
    return list(world().body(body).pose().position());
  }

  /** How a body is turned about the z axis, in radians. */
  public double orientation(String body) {
    advance();
    return world().body(body).pose().rotation().yaw();
  }

  /** How fast it moves: along x, y, z, in m/s. */
  public List<Double> velocity(String body) {
    advance();
    return list(world().body(body).velocity());
  }

  private static List<Double> list(Vec3 v) {
    return List.of(v.x(), v.y(), v.z());
  }

  /** Puts a body somewhere else; it stays turned as it is. */
  public void place(String body, double x, double y, double z) {
    advance();
    Body found = world().body(body);
    found.place(new Pose(new Vec3(x, y, z), found.pose().rotation()));
  }

  /** Gives a body a velocity, in m/s. */
  public void move(String body, double x, double y, double z) {
    advance();
    world().body(body).move(new Vec3(x, y, z), Vec3.ZERO);
  }

  /** Has a force, in newtons, act on the middle of a body during the next step. */
  public void push(String body, double x, double y, double z) {
    advance();
    Body found = world().body(body);
    found.push(new Vec3(x, y, z), found.centreOfMass());
  }

  /**
   * Hits a body at a point of the world, so that the next step makes it faster.
   *
   * @param vx along x, by how many m/s it would be faster if nothing held it; vy, vz: along y, z
   */
  public void hit(String body, double x, double y, double z, double vx, double vy, double vz) {
    advance();
    Body found = world().body(body);
    double force = found.mass() / world().physics().settings().step();
    found.push(new Vec3(vx, vy, vz).times(force), new Vec3(x, y, z));
  }

  /**
   * What could be seen from a place, without a camera there.
   *
   * @param pitch how far the view is turned downwards, in radians; yaw: to the left
   * @param xfov the angle of view, in radians
   */
  public UImage picture(
      double x, double y, double z, double pitch, double yaw, double xfov, int width, int height) {
    advance();
    Lens lens = new Lens(width, height, xfov, 0.02, 200);
    Pose eye = new Pose(new Vec3(x, y, z), Rotation.rollPitchYaw(0, pitch, yaw));
    SimulationException.finite(x + y + z + pitch + yaw, "picture");
    return new UImage(
        UImageFormat.IMAGE_RGB, width, height, renderer.render(world().scene(), eye, lens));
  }

  /**
   * What a laser scanner measures: the distances in metres, ray by ray, infinite where there is
   * nothing. It is mounted at a place of a body, and does not see the robot to which that belongs.
   *
   * @param from the angle of the first ray, to the left of the x axis, in radians
   * @param to the angle of the last ray
   * @throws SimulationException if the numbers make no sense
   */
  public List<Double> scan(
      String body,
      double x,
      double y,
      double z,
      double from,
      double to,
      int count,
      double farthest) {
    if (count < 1 || count > MOST_RAYS) {
      throw new SimulationException("scan: 1 to " + MOST_RAYS + " rays expected, not " + count);
    }
    if (!(farthest > 0)) {
      throw new SimulationException("scan: a range above 0 m expected, not " + farthest);
    }
    SimulationException.finite(x + y + z + from + to + farthest, "scan");
    advance();
    double[] distances =
        world().scan(world().body(body), new Vec3(x, y, z), from, to, count, farthest);
    return Arrays.stream(distances).boxed().toList();
  }

  /** Why the native engine cannot be used; empty if it can. */
  public String whyNotNative() {
    String reason = PhysicsEngines.whyNotNative();
    return reason == null ? "" : reason;
  }

  /** There is nothing to be seen any more: its pages end, too. */
  @Override
  public void close() {
    List.copyOf(pages).forEach(SimPage::close);
    if (world != null) {
      world.close();
    }
  }
}
