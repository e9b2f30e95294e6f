package org.urbi.kernel.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.ReplayedRun;
import urbi.UContext;
import urbi.UObject;

/** What a component finds in the environment, it finds in a replay that has another one, too. */
class ReplayedEnvironmentTest {
  private static final String VARIABLE = "URBI_TEST_PLACE";

  @TempDir Path folder;

  /** Depends on where it is. */
  public static final class Settler extends UObject {
    private final String born = UContext.current().environment().getOrDefault(VARIABLE, "nowhere");

    public Settler(String name) {
      super(name);
      UBindFunctions("born", "now");
    }

    public String born() {
      return born;
    }

    public String now() {
      return getUContext().environment().getOrDefault(VARIABLE, "nowhere");
    }
  }

  /** What runs in a process of its own, which alone can have another environment. */
  public static final class Program {
    private Program() {}

    /** Records, or replays, a run in a file. */
    public static void main(String[] arguments) {
      Path run = Path.of(arguments[1]);
      System.out.print(
          arguments[0].equals("record")
              ? ReplayedRun.recorded(
                  run,
                  kernel -> {
                    kernel.start(Settler.class);
                    kernel.eval("echo(Settler.born + \" and \" + Settler.now)");
                  })
              : ReplayedRun.replayed(run));
      System.exit(0);
    }
  }

  private String shown(String what, String place) throws Exception {
    ProcessBuilder program =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Program.class.getName(),
                what,
                folder.resolve("run").toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT);
    program.environment().put(VARIABLE, place);
    Process process = program.start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor());
    return text;
  }

  @Test
  void aReplayIsWhereTheRunWas() throws Exception {
    String there = shown("record", "here");
    assertEquals("*** here and here", there.substring(there.indexOf('*')).strip());
    assertEquals(there, shown("replay", "there"));
  }
}
