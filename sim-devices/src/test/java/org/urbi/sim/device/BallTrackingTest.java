package org.urbi.sim.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.sim.vision.OpenCv;

/** The demonstration, in virtual time. */
class BallTrackingTest {
  @TempDir static Path folder;

  @Test
  void ballStaysInViewAndIsFoundAgain() throws Exception {
    assumeTrue(OpenCv.isAvailable(), "skipped: OpenCV has no native library for this machine");
    SimJar.writeTo(folder);
    try (Kernel kernel =
        Kernel.builder()
            .virtualTime(true)
            .searchPath(List.of(Path.of("../share"), Path.of("..")))
            .moduleSearchPath(List.of(folder))
            .output(line -> {})
            .log(line -> {})
            .start()) {
      kernel.eval("load(\"examples/ball-tracking/demo.u\"); sleep(1s); var seen = 0");
      kernel.eval("for| (var i: 60) { sleep(100ms)| if (ball.visible) seen++ }");
      assertEquals(60, kernel.eval("seen", double.class), 2, "of 60 looks");
      assertTrue(kernel.eval("yaw.val.abs", double.class) > 0.05, "the head has moved");
      kernel.eval(
          """
          playing.stop;
          simulation.world.move("ball", 0, 0, 0);
          simulation.world.place("ball", 0, 1.2, 0.06);
          sleep(200ms);
          """);
      assertEquals(0, kernel.eval("ball.visible", double.class), "beside it");
      kernel.eval("sleep(8s)");
      assertEquals(1, kernel.eval("ball.visible", double.class), "found again");
      assertEquals(0, kernel.eval("ball.x", double.class), 0.05, "in the middle");
    }
  }
}
