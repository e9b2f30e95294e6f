package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.urbi.server.make.UmakeJava;
import org.urbi.tests.process.JavaProcess.Setting;

/** Servers that have the devices of a simulated robot. */
final class SimulatedRobot {
  static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  private SimulatedRobot() {}

  /**
   * For programs that find the devices, and begin in the project's folder.
   *
   * @param built the folder into which their module is made
   */
  static Setting setting(Path built) {
    Path classes = ROOT.resolve(Path.of("sim-devices", "target", "classes"));
    assertTrue(Files.isDirectory(classes), classes + " is built before");
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    PrintStream printer = new PrintStream(output, true, StandardCharsets.UTF_8);
    String[] words = {"-q", classes.toString(), "-o", built.resolve("sim.jar").toString()};
    int status = UmakeJava.run(words, printer, printer);
    assertEquals("0 ", status + " " + output.toString(StandardCharsets.UTF_8));
    return Setting.in(ROOT).with("URBI_UOBJECT_PATH", built.toString());
  }

  /** Waits until a condition holds in the simulation, which tells of nothing by itself. */
  static void awaitTruth(JavaProcess urbi, String mark, String condition) throws Exception {
    urbi.send("{ while (!(" + condition + ")) sleep(20ms); echo(\"" + mark + "\") },\n");
    urbi.awaitLine(said -> said.endsWith("*** " + mark));
  }
}
