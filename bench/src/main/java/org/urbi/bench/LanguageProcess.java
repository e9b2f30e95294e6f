package org.urbi.bench;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * A running program in one of the languages, which executes its task as often as requested. This
 * class measures the time, in the same way for all languages.
 */
final class LanguageProcess implements AutoCloseable {
  private static final int TIMEOUT_SECONDS = 300;
  private static final int END_SECONDS = 30;
  private static final String OVER = "the program has ended";

  private final Language language;
  private final Process process;
  private final Writer input;
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
  private String result = "";

  /** Whether it records where its time goes. */
  private boolean recording;

  /** The program could not execute its task. */
  static final class Failure extends Exception {
    private static final long serialVersionUID = 1L;

    Failure(String message) {
      super(message, null, false, false);
    }
  }

  private LanguageProcess(Language language, ProcessBuilder builder) throws IOException, Failure {
    this.language = language;
    process = builder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
    input = process.outputWriter(StandardCharsets.ISO_8859_1);
    Thread.ofPlatform().daemon().name("guest-" + language).start(this::read);
    String line = take();
    while (!line.contains("ready")) {
      line = take();
    }
  }

  /**
   * Starts a program, unless it does not exist in that language or the language is not installed.
   *
   * @param options for the Java virtual machine that runs urbiscript
   * @param arguments more of them for {@code ./urbi}
   * @throws Failure if it does not get ready
   */
  static Optional<LanguageProcess> start(
      Installation machine, Language language, String program, String options, String... arguments)
      throws IOException, Failure {
    if (language == Language.BARE) {
      return Optional.of(
          new LanguageProcess(
              language,
              new ProcessBuilder(machine.javaCommand(PlainVirtualThreads.class, program))));
    }
    Path source = machine.program(language, program);
    if (!Files.exists(source)) {
      return Optional.empty();
    }
    Path driver = machine.program(language, "driver");
    if (language == Language.URBISCRIPT) {
      List<String> command = new ArrayList<>(List.of(machine.urbi(), "-q"));
      command.addAll(List.of(arguments));
      command.addAll(List.of("-f", source.toString(), "-f", driver.toString(), "-i"));
      ProcessBuilder builder = new ProcessBuilder(command);
      if (!options.isEmpty()) {
        builder.environment().put("URBI_JAVA_OPTS", options);
      }
      LanguageProcess started = new LanguageProcess(language, builder);
      started.recording = options.contains(FlightRecording.OPTION);
      return Optional.of(started);
    }
    Optional<String> interpreter = machine.interpreter(language);
    if (interpreter.isEmpty()) {
      return Optional.empty();
    }
    List<String> command = List.of(interpreter.get(), driver.toString(), source.toString());
    return Optional.of(new LanguageProcess(language, new ProcessBuilder(command)));
  }

  Language language() {
    return language;
  }

  long pid() {
    return process.pid();
  }

  /** What the last call has returned. */
  String result() {
    return result;
  }

  /** Calls a function so many times, and returns how many nanoseconds all of that took. */
  long call(String function, int times) throws Failure {
    String request =
        language == Language.URBISCRIPT
            ? function + "Times(" + times + ");\n"
            : function + " " + times + "\n";
    long start = System.nanoTime();
    send(request);
    String answer = take();
    long taken = System.nanoTime() - start;
    result = value(answer);
    return taken;
  }

  /** Sends a line of the language itself, and waits for what it prints. */
  String evaluate(String code) throws Failure {
    send(code + "\n");
    return value(take());
  }

  private void send(String text) throws Failure {
    try {
      input.write(text);
      input.flush();
    } catch (IOException e) {
      throw new Failure(OVER);
    }
  }

  private static String value(String answer) {
    // Without the time stamp and the quotes of urbiscript.
    return answer.replaceFirst("^\\[\\d+\\] ", "").replaceFirst("^\"(.*)\"$", "$1");
  }

  private String take() throws Failure {
    try {
      String line = lines.poll(TIMEOUT_SECONDS, TimeUnit.SECONDS);
      if (line == null) {
        throw new Failure("no answer within " + TIMEOUT_SECONDS + " s");
      }
      if (line.equals(OVER)) {
        throw new Failure(OVER);
      }
      if (line.contains("!!!")) {
        throw new Failure(line);
      }
      return line;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new Failure("interrupted");
    }
  }

  private void read() {
    try (BufferedReader reader = process.inputReader(StandardCharsets.ISO_8859_1)) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        lines.add(line);
      }
    } catch (IOException e) {
      // The process was ended: there is nothing more to read.
    }
    lines.add(OVER);
  }

  /** How many bytes of memory it occupies, or -1 where the system does not tell. */
  long residentBytes() {
    File status = new File("/proc/" + pid() + "/status");
    try {
      for (String line : Files.readAllLines(status.toPath())) {
        if (line.startsWith("VmRSS:")) {
          return Long.parseLong(line.replaceAll("\\D+", "")) << 10;
        }
      }
    } catch (IOException e) {
      // Not a Linux: the answer below.
    }
    return -1;
  }

  /** Ends the process: in peace if that does not take long. */
  @Override
  public void close() {
    try {
      if (recording) {
        // It ends without waiting for anything, a recording that is being written included.
        new JavaProcess(pid()).jcmd("JFR.dump", FlightRecording.DUMPED);
      }
      if (language == Language.URBISCRIPT) {
        send("shutdown;\n");
      }
      input.close();
      if (process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
        return;
      }
    } catch (IOException | Failure e) {
      // It has gone, or does not listen.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    process.destroyForcibly();
  }
}
