package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.urbi.kernel.job.JobThreads;
import urbi.UObject;

/**
 * A dialogue with a kernel of its own in virtual time, written as the manual prints it: lines that
 * begin with a time stamp, and those that begin with {@code [:]} and go on with the one before, are
 * what the kernel has to answer, all others are what it is fed. Everything counts: times, places,
 * numbers.
 */
public final class ConsoleTranscript {
  private static final Pattern OUTPUT = Pattern.compile("\\[(\\d{8,}(:[^]]*)?|:)].*");

  /** What a dialogue ends with; the moment is for what its last line has set off. */
  private static final String EPILOGUE = "sleep(1ms)|;\nshutdown;\n";

  /** Collects what a client is sent. */
  private record Listener(StringBuilder to, CompletableFuture<Void> end) implements Client {
    @Override
    public void output(String bytes) {
      to.append(bytes);
    }

    @Override
    public void closed() {
      end.complete(null);
    }
  }

  private ConsoleTranscript() {}

  /** Feeds the input and compares the answers, on the faster back end. */
  public static void check(String text) {
    check(JobThreads.AUTO, text);
  }

  /** Feeds the input to a kernel that has these components, and compares the answers. */
  public static void checkWith(List<Class<? extends UObject>> components, String text) {
    check(JobThreads.AUTO, components, text);
  }

  /** Feeds the input and compares the answers. */
  public static void check(JobThreads jobThreads, String text) {
    check(jobThreads, List.of(), text);
  }

  private static void check(
      JobThreads jobThreads, List<Class<? extends UObject>> components, String text) {
    String expected =
        text.lines().filter(ConsoleTranscript::isOutput).collect(Collectors.joining("\n"));
    String input =
        text.lines().filter(line -> !isOutput(line)).collect(Collectors.joining("\n", "", "\n"));
    assertEquals(expected, run(jobThreads, components, "", input));
  }

  /** Whether a line of a dialogue is an answer. */
  public static boolean isOutput(String line) {
    return OUTPUT.matcher(line).matches();
  }

  /** Feeds a program to a fresh kernel; returns what it answers. */
  public static String run(String program) {
    return run(JobThreads.AUTO, List.of(), "", program);
  }

  /** Feeds a program to a fresh kernel whose working directory is that one. */
  public static String runIn(Path directory, String program) {
    String move = "Path.new(\"%s\").cd|; quit;\n".formatted(directory);
    return run(JobThreads.AUTO, List.of(), move, program);
  }

  private static String run(
      JobThreads jobThreads,
      List<Class<? extends UObject>> components,
      String preparation,
      String program) {
    StringBuilder output = new StringBuilder();
    CompletableFuture<Void> closed = new CompletableFuture<>();
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).jobThreads(jobThreads).log(line -> {}).start()) {
      components.forEach(kernel::start);
      // Another client's, so that it does not move the places in the program.
      if (!preparation.isEmpty()) {
        kernel
            .connect(new Listener(new StringBuilder(), new CompletableFuture<>()))
            .send(preparation);
      }
      kernel.connect(new Listener(output, closed)).send(program + EPILOGUE);
      closed.get();
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
    return output
        .toString()
        .stripTrailing()
        .lines()
        .map(line -> isOutput(line) ? line : "[:]" + line)
        .collect(Collectors.joining("\n"));
  }
}
