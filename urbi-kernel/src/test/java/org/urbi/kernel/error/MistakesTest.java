package org.urbi.kernel.error;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestTimeout;
import org.urbi.kernel.lobby.ErrorStyle;

/**
 * Ordinary mistakes, and what people at a terminal are told of them; {@code -Drenew=true} writes
 * the answers anew, which then have to be read.
 */
class MistakesTest {
  private static final Path FOLDER = Path.of("src/test/resources/org/urbi/kernel/mistakes");
  private static final String TITLE = "//// ";
  private static final String ANSWER = "----\n";

  /** A mistake: what it is called, what was typed, and what is told. */
  private record Mistake(String title, String code, String answer) {}

  private static Kernel kernel;

  @BeforeAll
  static void start() {
    kernel = Kernel.builder().virtualTime(true).start();
  }

  @AfterAll
  static void stop() {
    kernel.close();
  }

  private static List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files.sorted().toList();
    }
  }

  private static List<Mistake> read(Path file) throws IOException {
    List<Mistake> mistakes = new ArrayList<>();
    for (String part : ("\n" + Files.readString(file)).split("(?<=\n)" + TITLE)) {
      if (!part.isBlank()) {
        int code = part.indexOf('\n') + 1;
        int answer = part.indexOf(ANSWER);
        mistakes.add(
            new Mistake(
                part.substring(0, code - 1),
                part.substring(code, answer),
                part.substring(answer + ANSWER.length()).stripTrailing()));
      }
    }
    return mistakes;
  }

  @TestFactory
  Stream<DynamicTest> eachMistakeIsExplained() throws Exception {
    List<DynamicTest> tests = new ArrayList<>();
    for (Path file : files()) {
      if (Boolean.getBoolean("renew")) {
        renew(file);
      }
      for (Mistake mistake : read(file)) {
        tests.add(dynamicTest(mistake.title(), () -> check(mistake)));
      }
    }
    return tests.stream();
  }

  private static void check(Mistake mistake) throws Exception {
    String told = tell(mistake.code(), ErrorStyle.EXPLAINED);
    assertEquals(mistake.answer(), told);
    assertTrue(told.contains("^"), "a place");
    assertTrue(told.contains("hint: "), "what to do");
    // Programs are told the same, without what is for people, and of all errors.
    List<String> plain = tell(mistake.code(), ErrorStyle.PLAIN).lines().toList();
    List<String> messages = told.lines().filter(line -> !line.startsWith("  ")).toList();
    assertTrue(plain.containsAll(messages), plain + "\n" + messages);
  }

  @Test
  void thereAreEnoughOfThem() throws IOException {
    int count = 0;
    for (Path file : files()) {
      count += read(file).size();
    }
    assertTrue(count >= 80, count + " mistakes");
  }

  private static void renew(Path file) throws Exception {
    StringBuilder text = new StringBuilder();
    for (Mistake mistake : read(file)) {
      text.append(TITLE).append(mistake.title()).append('\n').append(mistake.code());
      text.append(ANSWER).append(tell(mistake.code(), ErrorStyle.EXPLAINED)).append("\n\n");
    }
    Files.writeString(file, text.toString().stripTrailing() + "\n");
  }

  private static String tell(String code, ErrorStyle style) throws Exception {
    StringBuilder told = new StringBuilder();
    CountDownLatch over = new CountDownLatch(1);
    Connection connection =
        kernel.connect(
            new Client() {
              @Override
              public void output(String bytes) {
                told.append(bytes);
              }

              @Override
              public ErrorStyle errors() {
                return style;
              }

              @Override
              public void closed() {
                over.countDown();
              }
            });
    byte[] bytes = code.getBytes(StandardCharsets.UTF_8);
    connection.send(new String(bytes, StandardCharsets.ISO_8859_1));
    connection.end();
    assertTrue(over.await(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS), code);
    String text =
        new String(told.toString().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    return text.lines()
        .map(line -> line.replaceFirst("^\\[\\d+", "["))
        .filter(line -> !line.contains("called from"))
        .collect(Collectors.joining("\n"))
        .stripTrailing();
  }
}
