package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestClient;
import org.urbi.kernel.trust.Role;

/**
 * Files at whose other end nobody is: whoever opens, reads or writes them waits, perhaps for ever,
 * alone, and leaves nothing behind when it is stopped.
 */
class PipeFilesTest {
  @TempDir Path folder;
  private Kernel kernel;
  private TestClient client;
  private TestClient other;

  @BeforeEach
  void start() throws IOException, InterruptedException {
    Path pipe = folder.resolve("pipe");
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "there is no mkfifo");
    assertEquals(0, new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).start().waitFor());
    kernel = Kernel.builder().log(line -> {}).start();
    client = new TestClient(kernel, Role.OWNER);
    other = new TestClient(kernel, Role.OWNER);
    client.say("var pipe = \"" + pipe + "\"|; var t = Tag.new|;");
  }

  @AfterEach
  void end() {
    kernel.close();
  }

  /** Whether a thread works on a file. */
  private static boolean isAtWork() {
    return Thread.getAllStackTraces().values().stream()
        .flatMap(Arrays::stream)
        .anyMatch(frame -> frame.getClassName().equals(OutsideWork.class.getName()));
  }

  private void beginsAndIsLetGo(String code) {
    client.connection().send(code);
    while (!isAtWork()) {
      assertEquals("1", other.say("1;"));
    }
    client.say("t.stop;");
    assertEquals("2", other.say("2;"));
    while (isAtWork()) {
      assertEquals("3", other.say("3;"));
    }
  }

  @Test
  void whatIsLetGoBeforeItBeginsDoesNotBegin() throws Exception {
    OutsideWork<Integer> work =
        new OutsideWork<>(Confinement.none(), folder.resolve("pipe"), () -> 1);
    work.letGo();
    assertThrows(InterruptedIOException.class, work::call);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "File.save(pipe, \"x\")",
        "File.save(pipe, \"x\" * 1000000)",
        "File.create(pipe)",
        "OutputStream.new(File.new(pipe)) << \"x\"",
        "File.new(pipe).content",
        "File.new(pipe).asList",
        "InputStream.new(File.new(pipe)).getLine",
      })
  void whoWaitsAtAPipeHoldsNobody(String code) {
    beginsAndIsLetGo("t: { " + code + " },\n");
  }

  @Test
  void whoReadsAPipeWhoseWriterIsSilentIsLetGo() throws Exception {
    isLetGoBeside("sleep inf >", "File.new(pipe).content");
  }

  @Test
  void whoWritesMoreThanAPipeHoldsIsLetGo() throws Exception {
    isLetGoBeside("sleep inf <", "File.save(pipe, \"x\" * 1000000)");
  }

  /** Somebody is at the other end, and is silent. */
  private void isLetGoBeside(String other, String code) throws Exception {
    beside(other, () -> beginsAndIsLetGo("t: " + code + ",\n"));
  }

  private void beside(String other, Runnable test) throws Exception {
    Process silent =
        new ProcessBuilder("sh", "-c", "exec " + other + folder.resolve("pipe")).start();
    try {
      test.run();
    } finally {
      silent.destroy();
      silent.waitFor();
    }
  }

  /** Whether a thread reads ahead of a stream. */
  private static boolean isReading() {
    return Thread.getAllStackTraces().values().stream()
        .flatMap(Arrays::stream)
        .anyMatch(frame -> frame.getClassName().equals(PipeSource.class.getName()));
  }

  @Test
  void aStreamThatIsClosedBesideASilentWriterLeavesNothing() throws Exception {
    beside(
        "sleep inf >",
        () -> {
          client.say("var stream = InputStream.new(File.new(pipe))|;");
          client.connection().send("stream.getLine,\n");
          while (!isReading()) {
            Thread.onSpinWait();
          }
          client.say("stream.close;");
          while (isReading()) {
            assertEquals("1", other.say("1;"));
          }
        });
  }

  /** Somebody else might read on, so the stop of the job is not the end of the stream. */
  @Test
  void aStreamThatIsForgottenBesideASilentWriterLeavesNothing() throws Exception {
    beside(
        "sleep inf >",
        () -> {
          client.connection().send("t: InputStream.new(File.new(pipe)).getLine,\n");
          while (!isReading()) {
            Thread.onSpinWait();
          }
          client.say("t.stop;");
          while (isReading()) {
            System.gc();
            assertEquals("1", other.say("1;"));
          }
        });
  }

  @Test
  void aPipeIsReadAndWritten() {
    String answer =
        client.say("{ File.save(pipe, \"hello\") } & { echo(File.new(pipe).content.data) };");
    assertTrue(answer.contains("*** hello"), answer);
  }

  @Test
  void anEmptyFileIsReadToItsEnd() {
    String file = "\"" + folder.resolve("empty") + "\"";
    client.say(
        "File.create(" + file + ")|; var stream = InputStream.new(File.new(" + file + "))|;");
    assertEquals("\"\"", client.say("File.new(" + file + ").content.data;"));
    assertEquals("", client.say("stream.getLine;"));
    client.say("File.save(" + file + ", \"more\");");
    assertEquals("\"more\"", client.say("stream.getLine;"));
  }
}
