package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.process.JavaProcess.Setting;

/** What jobs do in the last moment of a run is in its recording, however the run ends. */
class McapEndTest {
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final Pattern TOTAL = Pattern.compile("\"total\":([0-9.]+)");

  /** A magic number, at the beginning and at the end of each whole file. */
  private static final String MAGIC = "\u0089MCAP0\r\n";

  @TempDir Path folder;

  private JavaProcess start(String... more) throws Exception {
    List<String> words = new ArrayList<>(List.of("-q", "--mcap", "run.mcap"));
    words.addAll(List.of(more));
    return JavaProcess.start(Setting.in(folder), URBI, words);
  }

  private String recorded() throws Exception {
    String file = Files.readString(folder.resolve("run.mcap"), StandardCharsets.ISO_8859_1);
    assertTrue(file.startsWith(MAGIC) && file.endsWith(MAGIC), "it is whole");
    return file;
  }

  /** The jobs have long been looked at when another one begins, which at once ends the run. */
  @ParameterizedTest
  @ValueSource(strings = {"shutdown", "System._exit(0)", "System._exit(3)"})
  void whoEndsTheRunIsInItsRecording(String end) throws Exception {
    String program = "sleep(1s); spawn(function () { echo(Job.current.name) | %s }, true);";
    try (JavaProcess urbi = start("-i", "-e", program.formatted(end))) {
      String name = urbi.awaitText("shell_").replaceAll(".*(shell_\\d+).*", "$1");
      assertEquals(end.contains("3") ? 3 : 0, urbi.awaitEnd(), urbi::text);
      assertTrue(recorded().contains("\"name\":\"" + name + "\""), name);
    }
  }

  @Test
  void whatRanWhenTheSystemEndedItIsInTheRecording() throws Exception {
    String program = "sleep(1s); spawn(function () { echo(Job.current.name) | sleep(inf) }, true);";
    try (JavaProcess urbi = start("-i", "-e", program)) {
      String name = urbi.awaitText("shell_").replaceAll(".*(shell_\\d+).*", "$1");
      urbi.terminate();
      urbi.awaitEnd();
      assertTrue(recorded().contains("\"name\":\"" + name + "\""), name);
    }
  }

  /** Of fifty jobs none is left when nothing can happen any more. */
  @Test
  void whatHasEndedBeforeTheRunDidIsNotAmongItsLastJobs() throws Exception {
    try (JavaProcess urbi = start("-e", "for& (50) sleep(1s);")) {
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
    List<Double> totals = TOTAL.matcher(recorded()).results().map(McapEndTest::number).toList();
    assertTrue(totals.stream().anyMatch(total -> total > 50), totals::toString);
    assertTrue(totals.getLast() < 20, totals::toString);
  }

  private static double number(MatchResult found) {
    return Double.parseDouble(found.group(1));
  }
}
