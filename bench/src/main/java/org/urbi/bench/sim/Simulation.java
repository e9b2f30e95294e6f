package org.urbi.bench.sim;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint;
import org.opencv.core.Scalar;
import org.opencv.imgproc.Imgproc;
import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.PhysicsSettings;
import org.urbi.sim.physics.PhysicsSettings.Solver;
import org.urbi.sim.physics.PhysicsWorld;
import org.urbi.sim.vision.BlobFinder;
import org.urbi.sim.vision.ColourRange;
import org.urbi.sim.vision.OpenCv;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.PhysicsEngines;
import org.urbi.sim.world.SimulatedWorld;
import org.urbi.sim.world.WorldReader;

/**
 * Prints processor time per step, per frame and per detection, and what bare libode and OpenCV
 * take: {@code bench/sim}. The arguments are the world file of the frames, and a program that steps
 * the same crowd in C, if there is one.
 */
public final class Simulation {
  private static final int ROUNDS = 7;
  private static final int STEPS = 1000;
  private static final int IMAGES = 50;
  private static final double MICRO = 1e3;
  private static final double MILLI = 1e6;
  private static final double STEP_NANOSECONDS = 1e6;

  private static final PrintStream OUT = System.out;
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private Simulation() {}

  /** Runs it all. */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    Path file = Path.of(arguments[0]);
    String bare = arguments.length > 1 ? arguments[1] : null;
    OUT.println("Worlds of that size have the solver 'quick' unless they say otherwise.");
    for (Solver solver : Solver.values()) {
      steps(solver, bare);
    }
    images(file);
  }

  /** The median of what an action takes on the processor, warmed up, in nanoseconds. */
  private static double measure(int times, Runnable action) {
    double[] samples = new double[ROUNDS];
    for (int round = -3; round < ROUNDS; round++) {
      long start = THREADS.getCurrentThreadCpuTime();
      for (int i = 0; i < times; i++) {
        action.run();
      }
      if (round >= 0) {
        samples[round] = (double) (THREADS.getCurrentThreadCpuTime() - start) / times;
      }
    }
    Arrays.sort(samples);
    return samples[ROUNDS / 2];
  }

  private static void steps(Solver solver, @Nullable String bare)
      throws IOException, InterruptedException {
    double inC = bare == null ? Double.NaN : bareSteps(bare, solver);
    for (String engine : List.of("ode", "ode4j")) {
      try (PhysicsWorld world =
          new PhysicsWorld(
              PhysicsEngines.named(engine), PhysicsSettings.DEFAULT.withSolver(solver, 20))) {
        ManyBodies.fill(world);
        double step = measure(STEPS, world::step);
        OUT.printf(
            Locale.ROOT,
            "step, 100 bodies, 60 joints, %-5s %-5s  %7.1f µs  %5.2f x real time at 1 kHz  %s%n",
            solver.name().toLowerCase(Locale.ROOT),
            engine,
            step / MICRO,
            STEP_NANOSECONDS / step,
            ratio(step, inC, "libode in C"));
      } catch (SimulationException e) {
        OUT.println("step, " + engine + ": " + e.getMessage());
      }
    }
  }

  private static String ratio(double mine, double other, String what) {
    return Double.isNaN(other)
        ? "unknown to " + what
        : String.format(Locale.ROOT, "%.2f of %s (%.1f µs)", mine / other, what, other / MICRO);
  }

  private static double bareSteps(String program, Solver solver)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(
                program, solver.name().toLowerCase(Locale.ROOT), String.valueOf(ROUNDS * STEPS))
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return process.waitFor() == 0 ? Double.parseDouble(text.strip()) : Double.NaN;
  }

  private static void images(Path file) {
    try (SimulatedWorld world = WorldReader.read(file, "ode4j")) {
      Mount.Camera camera =
          (Mount.Camera)
              world.mounts().stream()
                  .filter(Mount.Camera.class::isInstance)
                  .findFirst()
                  .orElseThrow();
      // With the ball in the middle of the view.
      world.drive("neck.yaw").setTarget(0.2);
      for (int i = 0; i < 300; i++) {
        world.step();
      }
      int width = camera.lens().width();
      int height = camera.lens().height();
      double frame = measure(IMAGES, () -> world.render(camera));
      OUT.printf(Locale.ROOT, "frame, %dx%d  %.2f ms (at most 8)%n", width, height, frame / MILLI);
      byte[] rgb = world.render(camera);
      OpenCv.require();
      BlobFinder finder = new BlobFinder();
      double mine = measure(IMAGES, () -> finder.find(rgb, width, height, ColourRange.RED, 0));
      double bare = measure(IMAGES, () -> bareDetection(rgb, width, height));
      OUT.printf(
          Locale.ROOT,
          "detection, %dx%d  %.2f ms (at most 2)  %s%n",
          width,
          height,
          mine / MILLI,
          ratio(mine, bare, "bare OpenCV"));
    } catch (SimulationException e) {
      OUT.println("images: " + e.getMessage());
    }
  }

  /** The calls that a detection cannot do without. */
  private static void bareDetection(byte[] rgb, int width, int height) {
    Mat image = new Mat(height, width, CvType.CV_8UC3);
    image.put(0, 0, rgb);
    Mat hsv = new Mat();
    Mat low = new Mat();
    Mat high = new Mat();
    Imgproc.cvtColor(image, hsv, Imgproc.COLOR_RGB2HSV);
    Core.inRange(hsv, new Scalar(172.5, 127.5, 51), new Scalar(180, 255, 255), low);
    Core.inRange(hsv, new Scalar(0, 127.5, 51), new Scalar(7.5, 255, 255), high);
    Core.bitwise_or(low, high, low);
    List<MatOfPoint> contours = new ArrayList<>();
    Imgproc.findContours(low, contours, high, Imgproc.RETR_EXTERNAL, Imgproc.CHAIN_APPROX_NONE);
    contours.forEach(Imgproc::moments);
    contours.forEach(Mat::release);
    for (Mat each : List.of(image, hsv, low, high)) {
      each.release();
    }
  }
}
