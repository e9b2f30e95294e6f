import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Plugs the component into urbi, in simulated time, and runs the script beside this class. */
class {{CLASS}}Test {
  @Test
  void theScriptHasNoError() throws Exception {
    List<String> command =
        List.of(
            System.getProperty("urbi.program"),
            "--quiet",
            "--fast",
            "--strict",
            "--module",
            System.getProperty("component"),
            "src/test/urbi/{{NAME}}.u");
    Process urbi = new ProcessBuilder(command).redirectErrorStream(true).start();
    urbi.getOutputStream().close();
    String output = new String(urbi.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, urbi.waitFor(), output);
  }
}
