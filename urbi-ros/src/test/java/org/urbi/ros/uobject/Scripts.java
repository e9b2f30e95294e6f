package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.ros.Awaited;
import org.urbi.ros.rtps.Neighbourhood;

/** A kernel with the module, and what it says. */
final class Scripts implements AutoCloseable {
  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();
  private final Kernel kernel;

  /**
   * Starts it with ROS 2.
   *
   * @param folder where the module is
   * @param types where test_msgs are
   */
  Scripts(Path folder, Neighbourhood domain, String types) {
    kernel =
        Kernel.builder()
            .searchPath(List.of(Path.of("../share")))
            .moduleSearchPath(List.of(folder))
            .output(text -> text.lines().forEach(output::add))
            .start();
    kernel.eval(
        """
        requireFile("urbi/ros.u");
        Ros.version = 2; Ros.domain = %d; Ros.packagePath = "%s";
        """
            .formatted(domain.domain(), types));
  }

  void run(String code) {
    kernel.eval(code);
  }

  boolean holds(String condition) {
    return kernel.eval(condition, boolean.class);
  }

  void refused(String code, String message) {
    String text = assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
    assertTrue(text.contains(message), text);
  }

  /** Waits until a line with that text is said. */
  void says(String text) throws InterruptedException {
    List<String> seen = new ArrayList<>(List.of(""));
    while (!seen.getLast().contains(text)) {
      seen.add(Awaited.next(output, seen));
    }
  }

  @Override
  public void close() {
    kernel.close();
    assertFalse(output.toString().contains("internal error"), output::toString);
  }
}
