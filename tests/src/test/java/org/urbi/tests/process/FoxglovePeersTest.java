package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.TestTimeout;
import org.urbi.tests.process.JavaProcess.Setting;

/** What others make of variables: Foxglove's own client, and the reader of MCAP files. */
class FoxglovePeersTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
  private static final Path PEERS = ROOT.resolve(".build/foxglove-peers");
  private static final Path SCRIPTS = Path.of("src/test/resources/foxglove").toAbsolutePath();
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final String ADDRESS = "studio: http";
  private static final Path CLIENT = PEERS.resolve("protocol/node_modules");
  private static final String NO_CLIENT = "no client: scripts/foxglove-peers.sh gets it";

  private static final String PROGRAM =
      """
      var Global.ball = Object.new|;
      UVar.new(ball, "x")|; ball.x = 1|;
      UVar.new(ball, "path")|; ball.path = [[1, 2], [3, 4]]|;
      UVar.new(ball, "picture")|; ball.picture = Binary.new("rgb 1 1", "abc")|;
      var Global.seen = Event.new|;
      var counter = 0|;
      """;

  /** What a program says until it ends. */
  private static List<String> run(Map<String, String> environment, String... command)
      throws IOException, InterruptedException {
    Path said = Files.createTempFile("peer", ".txt");
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.redirectOutput(said.toFile()).environment().putAll(environment);
    Process process = builder.start();
    try {
      boolean ended = process.waitFor(TestTimeout.LONG.toMillis(), TimeUnit.MILLISECONDS);
      // What one that waits for more has heard tells for what it waits.
      assertEquals(0, ended ? process.exitValue() : null, () -> text(said));
      return text(said).lines().toList();
    } finally {
      process.destroyForcibly();
      Files.delete(said);
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What Foxglove's own client hears of a server whose program is ready by then. */
  private static List<String> heard(JavaProcess urbi, String script, String query, String... words)
      throws Exception {
    String line = urbi.awaitText(ADDRESS);
    urbi.send("echo(\"rea\" + \"dy\");\n");
    urbi.awaitText("ready");
    List<String> command = new ArrayList<>();
    command.add("node");
    command.add(SCRIPTS.resolve(script).toString());
    command.add("ws" + line.substring(line.indexOf(ADDRESS) + ADDRESS.length()) + query);
    command.addAll(List.of(words));
    return run(Map.of("NODE_PATH", CLIENT.toString()), command.toArray(String[]::new));
  }

  private static List<String> read(Path file, String... how)
      throws IOException, InterruptedException {
    Path python = PEERS.resolve("mcap/bin/python");
    assumeTrue(Files.exists(python), "no reader of MCAP: scripts/foxglove-peers.sh gets it");
    List<String> command = new ArrayList<>();
    command.addAll(
        List.of(python.toString(), SCRIPTS.resolve("read.py").toString(), file.toString()));
    command.addAll(List.of(how));
    return run(Map.of(), command.toArray(String[]::new));
  }

  private static void has(List<String> lines, String... wanted) {
    for (String line : wanted) {
      assertTrue(lines.contains(line), () -> line + " in " + String.join("\n", lines));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"foxglove.websocket.v1", "foxglove.sdk.v1"})
  void foxglovesClientLooks(String subprotocol, @TempDir Path folder) throws Exception {
    assumeTrue(Files.exists(CLIENT), NO_CLIENT);
    String reaction =
        """
        at (seen?(var what)) { Logger.log(what); ball.x = 5; };
        function ball.plus(n) { 10 + n }|;
        counting: every (1h) {},
        """;
    Path program = Files.writeString(folder.resolve("program.u"), PROGRAM + reaction);
    List<String> words =
        List.of("-q", "--studio=0", "--watch", "counter", "-i", "-f", program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      List<String> heard = heard(urbi, "look.cjs", "", subprotocol);
      has(
          heard,
          "server clientPublish parameters parametersSubscribe services time",
          "service /call urbi.Call json urbi.CallResponse",
          "response 1 json {\"value\":14.0}",
          "jobs true",
          "channel /jobs json urbi.Jobs object",
          "channel /log json foxglove.Log object",
          "channel /counter json urbi.Number object",
          "channel /ball/x json urbi.Number object",
          "channel /ball/path json urbi.List object",
          "channel /ball/picture json foxglove.CompressedImage object",
          "message /counter now 0",
          "message /ball/x now 1",
          "message /ball/x now 5",
          "message /ball/picture now ffd8ff",
          "parameter asked ball.x 1",
          "closed");
      assertTrue(
          heard.stream().anyMatch(each -> each.startsWith("failure 2 no such slot")),
          heard::toString);
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
      assertTrue(!urbi.text().contains("internal error"), urbi::text);
    }
  }

  /**
   * Foxglove's client takes them, and a library of ROS 2 reads them by the types that came along.
   */
  @ParameterizedTest
  @ValueSource(strings = {"foxglove.websocket.v1", "foxglove.sdk.v1"})
  void messagesOfRosAreReadLive(String subprotocol, @TempDir Path folder) throws Exception {
    assumeTrue(Files.exists(CLIENT), NO_CLIENT);
    Path program =
        Files.writeString(folder.resolve("program.u"), PROGRAM + "waiting: every (1h) {},\n");
    List<String> words = List.of("-q", "--studio=0", "-i", "-f", program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      List<String> heard =
          heard(urbi, "look-ros.cjs", "?messages=ros2", subprotocol, "/ball/x", "/ball/picture");
      Path messages = Files.write(folder.resolve("messages"), heard);
      List<String> content = read(messages, "live");
      has(content, "/ball/x urbi/msg/Number {\"value\":1.0}");
      String image = "\"frame_id\":\"ball.picture\"},\"format\":\"jpeg\",\"data\":\"ffd8ff\"}";
      assertTrue(content.stream().anyMatch(each -> each.endsWith(image)), content::toString);
    }
  }

  @Test
  void recordingOfSimulatedTimeIsComplete(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.mcap");
    Path program =
        Files.writeString(
            folder.resolve("program.u"),
            PROGRAM
                + "for (var i: 1000) { ball.x = i; counter = i; sleep(10ms) };\n"
                + "Logger.log(\"done\");\n");
    List<String> words =
        List.of(
            "-q",
            "--fast",
            "--mcap",
            file.toString(),
            "--watch",
            "counter",
            "-f",
            program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
    List<String> content = read(file, "whole");
    has(
        content,
        "summary 2003 5 4",
        "channel /log cdr rcl_interfaces/msg/Log ros2msg",
        "channel /ball/picture cdr sensor_msgs/msg/CompressedImage ros2msg",
        "messages /ball/x 1000 {\"value\":999.0}",
        "messages /counter 1000 {\"value\":999.0}",
        "messages /ball/path 1 {\"value\":[[1.0,2.0],[3.0,4.0]]}",
        "of ROS 2002");
  }

  /** Values that are hard to write: what ROS has no type for is JSON, all else is kept. */
  @Test
  void recordingOfOddValuesIsReadAsMessagesOfRos(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.mcap");
    Path program =
        Files.writeString(
            folder.resolve("program.u"),
            """
            var Global.o = Object.new|;
            for (var name: ["n", "infinite", "on", "text", "none", "many", "map", "image", "broken", "lost"])
              UVar.new(o, name)|;
            o.n = nan| o.infinite = -inf| o.on = true| o.text = "é \\0 😀"| o.none = ""| o.many = []|
            o.map = ["a" => 1]| o.image = Binary.new("rgb 1 1", "abc")| o.broken = Binary.new("jpeg", "")|
            o.lost = 1|;
            sleep(1s);
            o.many = [1, inf]| o.lost = nil|;
            Logger.log("one")|;
            sleep(40000d);
            Logger.log("two")|;
            """);
    List<String> words =
        List.of("-q", "--fast", "--mcap", file.toString(), "-f", program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      assertEquals(0, urbi.awaitEnd(), urbi::text);
      assertTrue(!urbi.text().contains("internal error"), urbi::text);
    }
    List<String> content = read(file, "whole");
    has(
        content,
        "messages /o/n 1 {\"value\":NaN}",
        "messages /o/infinite 1 {\"value\":-Infinity}",
        "messages /o/on 1 {\"value\":true}",
        "messages /o/text 1 {\"value\":\"é \\u0000 😀\"}",
        "messages /o/none 1 {\"value\":\"\"}",
        "messages /o/many 2 {\"value\":[1.0,Infinity]}",
        "messages /o/map 1 {\"value\":{\"a\":1.0}}",
        "messages /o/image 1 {\"header\":{\"stamp\":{\"sec\":1262304000,\"nanosec\":0},"
            + "\"frame_id\":\"o.image\"},\"format\":\"jpeg\",\"data\":\"ffd8ff\"}",
        "channel /o/lost cdr urbi/msg/Number ros2msg",
        "channel /o/lost json urbi.Number jsonschema",
        "messages /o/lost 1 {\"value\":1.0}",
        "messages /o/lost 1 {\"value\":null}",
        "messages /log 2 {\"stamp\":{\"sec\":2147483647,\"nanosec\":0},\"level\":20,\"name\":\"urbi\","
            + "\"msg\":\"[        Logger         ] two\",\"file\":\"\",\"function\":\"\",\"line\":0}");
  }

  @Test
  void recordingOfKilledServerCanBeRead(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.mcap");
    Path program = Files.writeString(folder.resolve("program.u"), PROGRAM);
    List<String> words = List.of("-q", "--mcap", file.toString(), "-i", "-f", program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      urbi.send("every (100ms) ball.x++,\necho(\"rea\" + \"dy\");\n");
      urbi.awaitText("ready");
      // Not after a certain time: a busy machine may stop the server at any point of it.
      while (!hasManyValues(read(file))) {
        Thread.sleep(100);
      }
    }
    List<String> content = read(file);
    has(content, "ends early");
    assertTrue(hasManyValues(content), () -> String.join("\n", content));
  }

  /** Who ran, what had been waited for, and who had woken it. */
  @Test
  void recordingHasJobsAndTheirTurns(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.mcap");
    Path program =
        Files.writeString(
            folder.resolve("program.u"),
            """
            var Global.e = Event.new|;
            mine: { waituntil (false); 1 },
            detach({ loop { e!; sleep(50ms) } })|;
            detach({ loop { waituntil (e?); sleep(1ms) } })|;
            """);
    List<String> words = List.of("-q", "--mcap", file.toString(), "-i", "-f", program.toString());
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      urbi.send("echo(\"rea\" + \"dy\");\n");
      urbi.awaitText("ready");
      String woken = "turn of shell_\\d+ after event by shell_\\d+";
      while (read(file).stream().noneMatch(line -> line.matches(woken))) {
        Thread.sleep(100);
      }
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
    List<String> content = read(file, "whole");
    has(
        content,
        "channel /jobs json urbi.Jobs jsonschema",
        "channel /turns json urbi.Turns jsonschema");
    for (String told :
        List.of(
            "turn of shell_\\d+ after time by .*", "job \\S+ waits for condition under .*mine.*")) {
      assertTrue(
          content.stream().anyMatch(each -> each.matches(told)), () -> String.join("\n", content));
    }
  }

  private static boolean hasManyValues(List<String> content) {
    return content.stream().anyMatch(line -> line.matches("messages /ball/x \\d{2,} .*"));
  }

  @Test
  void fullDiskIsToldAndEndsTheRecordingAlone(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("run.mcap");
    Path program =
        Files.writeString(
            folder.resolve("program.u"),
            PROGRAM + "for (var i: 200000) { ball.x = i }; sleep(1s); echo(\"still here\");\n");
    List<String> words = List.of("-q", "--mcap", file.toString(), "-f", program.toString());
    // No file may have more than 4 MiB: as on a full disk, a part of the next chunk has no room.
    Setting setting = Setting.in(ROOT).after("ulimit -f 8192");
    try (JavaProcess urbi = JavaProcess.start(setting, URBI, words)) {
      urbi.awaitText("the recording ends here");
      urbi.awaitText("still here");
      urbi.awaitText("values were left out");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
    List<String> content = read(file);
    has(content, "ends early");
    assertTrue(
        content.stream().anyMatch(line -> line.matches("messages /ball/x \\d{4,} .*")),
        content::toString);
  }

  @Test
  void fileThatCannotBeWrittenIsNamed() throws Exception {
    List<String> words = List.of("-q", "--mcap", "/nowhere/run.mcap", "-e", "echo(1);");
    try (JavaProcess urbi = JavaProcess.start(Setting.in(ROOT), URBI, words)) {
      assertTrue(urbi.awaitEnd() != 0, urbi::text);
      assertTrue(urbi.text().contains("cannot write the recording /nowhere/run.mcap"), urbi::text);
    }
  }
}
