package org.urbi.server.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ProgramTest {
  private final List<String> order = new ArrayList<>();
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private String seen;

  private Program program() {
    return new Program("tool", "A tool.")
        .flag("A flag.", "-q", "--quiet")
        .option("N", "A number.", "-n", "--number")
        .each("E", "An expression.", value -> order.add("e:" + value), "-e", "--expression")
        .each("F", "A file.", value -> order.add("f:" + value), "-f", "--file")
        .arguments("[FILE]", "A file.")
        .stopAtArgument();
  }

  private int run(String... args) {
    return program()
        .run(
            args,
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8),
            arguments -> {
              seen =
                  arguments.has("--quiet")
                      + " "
                      + arguments.number("--number", 7, -1, 10)
                      + " "
                      + arguments.rest();
              return 3;
            });
  }

  @Test
  void repeatedOptionsKeepTheirOrder() {
    assertEquals(3, run("-e", "1;", "--file=x", "-e2;", "-f", "-", "--expression", "-3;"));
    assertEquals(List.of("e:1;", "f:x", "e:2;", "f:-", "e:-3;"), order);
  }

  @Test
  void valuesComeInEveryForm() {
    run("-q", "-n", "-1");
    assertEquals("true -1 []", seen);
    run("--number=3");
    assertEquals("false 3 []", seen);
  }

  @ParameterizedTest
  @ValueSource(strings = {"--help", "--version", "--generate=man"})
  void answersThatAreLostAreAFailure(String question) {
    OutputStream full =
        new OutputStream() {
          @Override
          public void write(int b) throws IOException {
            throw new IOException("No space left on device");
          }
        };
    PrintStream told = new PrintStream(err, true, StandardCharsets.UTF_8);
    PrintStream lost = new PrintStream(full, false, StandardCharsets.UTF_8);
    assertEquals(74, program().run(new String[] {question}, lost, told, arguments -> 0));
    assertEquals("tool: cannot write the output\n", err.toString(StandardCharsets.UTF_8));
  }

  @Test
  void argumentsAfterTheScriptBelongToIt() {
    run("-n5", "script.u", "-q", "--bogus", "12");
    assertEquals("false 5 [script.u, -q, --bogus, 12]", seen);
  }

  @Test
  void descriptionsAreNoFormats() {
    Program program = new Program("tool", "A 5%n tool.").option("N", "So 50%% (or %d).", "-n");
    assertEquals(
        0,
        program.run(
            new String[] {"--help"}, new PrintStream(out), new PrintStream(err), arguments -> 1));
    String help = out.toString(StandardCharsets.UTF_8);
    assertTrue(help.contains("A 5%n tool.") && help.contains("So 50%% (or %d)."), help);
  }

  @ParameterizedTest
  @ValueSource(strings = {"--bogus", "-n", "--number=eleven", "--number=11", "-e"})
  void mistakesAreReportedInOneLineWithAHint(String mistake) {
    assertEquals(2, run(mistake));
    List<String> lines = err.toString(StandardCharsets.UTF_8).lines().toList();
    assertEquals(2, lines.size(), lines.toString());
    assertTrue(lines.get(0).startsWith("tool: "), lines.get(0));
    assertEquals("Try `tool --help' for more information.", lines.get(1));
  }

  @Test
  void anUnknownOptionIsInvalid() {
    assertEquals(2, run("--bogus"));
    assertEquals(
        List.of("tool: invalid option: --bogus", "Try `tool --help' for more information."),
        err.toString(StandardCharsets.UTF_8).lines().toList());
  }

  @ParameterizedTest
  @CsvSource({
    "--numbre, --number",
    "--numbr=5, --number",
    "--Quiet, --quiet",
    "--hlep, --help",
    "--verison, --version"
  })
  void aMistypedOptionIsRecognized(String typed, String meant) {
    assertEquals(2, run(typed));
    assertEquals(
        "tool: invalid option: %s; did you mean %s?".formatted(typed, meant),
        err.toString(StandardCharsets.UTF_8).lines().findFirst().orElseThrow());
  }

  @ParameterizedTest
  @ValueSource(strings = {"-x", "--", "--=", "-?", "--n=--number"})
  void nothingIsGuessedOfTooLittle(String typed) {
    run(typed);
    assertFalse(err.toString(StandardCharsets.UTF_8).contains("did you mean"));
  }

  @Test
  void nobodyMistypesAnEndlessOption() {
    assertEquals(2, run("--" + "n".repeat(100_000)));
    assertFalse(err.toString(StandardCharsets.UTF_8).contains("did you mean"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"-h", "--help"})
  void helpNamesEveryOption(String option) {
    assertEquals(0, run(option));
    String help = out.toString(StandardCharsets.UTF_8);
    for (String name : List.of("--help", "--version", "-q", "--number=N", "-e", "--file=F")) {
      assertTrue(help.contains(name), help);
    }
  }

  @Test
  void helpIsTheSameAmongOtherOptions() {
    run("--help");
    String alone = out.toString(StandardCharsets.UTF_8);
    out.reset();
    assertEquals(0, run("-q", "--help"));
    assertEquals(alone, out.toString(StandardCharsets.UTF_8));
  }

  @Test
  void helpHasNamesOnTheLeftAndMeaningsOnTheRight() {
    new Program("tool", "A tool of 100% of the words that are needed " + "to be long ".repeat(6))
        .flag("Only short.", "-x")
        .option("N", "A number, as a=50% (default: none), or " + "another ".repeat(10), "-n")
        .optional("TIME", "1s", "Waits.", "--wait")
        .option("DIRECTORY", "Files are there.", "-d", "--directory-of-files")
        .arguments("[FILE]", "A file.")
        .run(
            new String[] {"-h"},
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8),
            arguments -> 0);
    assertEquals(
        """
        Usage: tool [OPTIONS] [FILE]
        A tool of 100% of the words that are needed to be long to be long to be long to be long to be long
        to be long
              [FILE]          A file.
          -h, --help          Show this help and exit.
              --version       Show the version and exit.
          -x                  Only short.
          -n N                A number, as a=50% (default: none), or another another another another another
                                another another another another another
              --wait[=TIME]   Waits.
          -d, --directory-of-files=DIRECTORY
                              Files are there.
        """,
        out.toString(StandardCharsets.UTF_8));
    assertEquals("", err.toString(StandardCharsets.UTF_8));
  }

  @Test
  void versionNamesTheProgram() {
    assertEquals(0, run("--version"));
    assertTrue(out.toString(StandardCharsets.UTF_8).matches("(?s)tool version \\d+\\.\\d+.*"));
  }

  /** Whatever the quick reader understands it understands as picocli does. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "-q",
        "--quiet",
        "-n 3",
        "-n3",
        "-n=3",
        "-n -1",
        "-n-1",
        "--number=3",
        "--number 3",
        "--number=",
        "--number=a=b",
        "-e 1; -f x -e 2;",
        "-e=1;",
        "-e --help",
        "-e -q",
        "-q -q",
        "-n 1 -n 2",
        "x",
        "x -q",
        "-q x y z",
        "-q x -h --bogus -n",
        "-e1;",
        "-e"
      })
  void bothReadersAgree(String line) {
    String[] args = line.isEmpty() ? new String[0] : line.split(" ");
    Program program = program();
    Optional<ParsedCommandLine> quick = program.readQuickly(args);
    if (quick.isPresent()) {
      ParsedCommandLine full = program.readFully(args, System.out).orElseThrow();
      assertEquals(values(full), values(quick.get()));
      assertEquals(full.rest(), quick.get().rest());
    } else {
      assertTrue(line.equals("-e"), line);
    }
  }

  private static List<String> values(ParsedCommandLine reading) {
    return reading.options().stream()
        .filter(seen -> seen.option().hasValue())
        .map(seen -> seen.option().names() + seen.value())
        .toList();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"-qe", "--quiet=yes", "--bogus", "-x", "--", "-h", "--version", "--num=3", "-"})
  void unusualCommandLinesAreLeftToPicocli(String argument) {
    assertTrue(program().readQuickly(argument).isEmpty());
  }
}
