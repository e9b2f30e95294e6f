package org.urbi.server.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;

/** What is made of the declarations of options: manual pages, and completion of shells. */
class GeneratedTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private String generate(String what) {
    int status =
        new Program("a-tool", "'Does' C:\\it.")
            .flag(".begins with [a dot]: it's quoted", "-q", "--quiet")
            .option("FILE", "A file.", "-o", "--output")
            .option("NUMBER", "A number.", "-n", "--number")
            .optional("TIME", "30s", "A time.", "--wait")
            .arguments("[FILE]...", "Files … (or a word that is longer than a line has room for).")
            .run(
                new String[] {"--generate=" + what},
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8),
                arguments -> 7);
    assertEquals(err.size() == 0 ? 0 : 2, status);
    return out.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aManualPageHasEveryOptionAndNoRequestOfItsText() {
    String page = generate("man");
    assertTrue(page.startsWith(".TH \"A\\-TOOL\" 1 "), page);
    assertTrue(page.contains("a\\-tool \\- \\(aqDoes\\(aq C:\\eit."), page);
    assertTrue(
        page.contains("\n.TP\n\\fB\\-q\\fR, \\fB\\-\\-quiet\\fR\n\\&.begins with [a dot]"), page);
    assertTrue(
        page.contains("\\fB\\-o\\fR\\fIFILE\\fR, \\fB\\-\\-output\\fR=\\fIFILE\\fR\n"), page);
    assertTrue(page.contains("\\fB\\-\\-wait\\fR[=\\fITIME\\fR]\n"), page);
    assertTrue(page.contains("\\fB\\-\\-version\\fR\n"), page);
    assertTrue(page.contains("\n.ad l\n"), "no stretched lines: a warning of troff");
    assertTrue(page.contains("Files \\[u2026] (or"), page);
  }

  @Test
  void bashCompletesOptionsAndNamesOfFiles() throws Exception {
    String script = generate("bash");
    assertEquals("--quiet", complete(script, 1, "a-tool", "--q"));
    assertEquals("--wait", complete(script, 2, "a-tool", "-q", "--w"));
    assertEquals("pom.xml", complete(script, 2, "a-tool", "-o", "pom.x"));
    assertEquals("pom.xml", complete(script, 3, "a-tool", "--output", "=", "pom.x"));
    assertEquals("pom.xml", complete(script, 1, "a-tool", "pom.x"));
    assertEquals("", complete(script, 2, "a-tool", "-n", "pom.x"));
  }

  /** What bash offers for the word with that number. */
  private static String complete(String script, int word, String... words) throws Exception {
    String ask =
        script
            + "compopt() { :; }; COMP_CWORD=%d COMP_WORDS=(%s); COMPREPLY=(); _a_tool; echo \"${COMPREPLY[*]}\""
                .formatted(word, String.join(" ", words));
    Process bash = new ProcessBuilder("bash", "-c", ask).redirectErrorStream(true).start();
    String answer = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(bash.waitFor(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
    return answer.strip();
  }

  @Test
  void zshIsToldOfOptionsWithTheirText() {
    List<String> lines = generate("zsh").lines().toList();
    assertEquals("#compdef a-tool", lines.getFirst());
    assertTrue(
        lines.contains("  '*-q[.begins with \\[a dot\\]\\: it’s quoted]' \\"), lines::toString);
    assertTrue(lines.contains("  '*--output=[A file.]:file:_files' \\"), lines::toString);
    assertTrue(lines.contains("  '*--wait=[A time.]::time: ' \\"), lines::toString);
    assertEquals("  '*:argument:_files'", lines.getLast());
  }

  @Test
  void nothingElseIsGenerated() {
    assertEquals("", generate("fish"));
    assertTrue(err.toString(StandardCharsets.UTF_8).contains("invalid --generate: fish"));
    assertFalse(err.toString(StandardCharsets.UTF_8).contains("Exception"));
  }
}
