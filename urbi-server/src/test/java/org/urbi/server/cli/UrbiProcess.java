package org.urbi.server.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;

/**
 * The program {@code urbi} in a process of its own, as the launcher starts it: in {@code ./check}
 * from the distribution, with its start-up cache, otherwise from the classes of this build.
 */
final class UrbiProcess implements AutoCloseable {
  private static final String[] FLAGS =
      System.getProperty(
              "urbi.distribution.flags",
              "--add-opens=java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED")
          .split(" ");

  private static final String CLASS_PATH =
      System.getProperty("urbi.distribution.jars", System.getProperty("java.class.path"));

  /** What is left of a process: its exit status and its output without time stamps. */
  record Result(int status, String out, String err) {}

  private final Process process;
  private final BufferedReader out;

  UrbiProcess(Path folder, Map<String, String> environment, String... args) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(FLAGS));
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of("-Durbi.root=" + folder, "-Durbi.stdin.terminal=false"));
    command.addAll(List.of("-cp", CLASS_PATH));
    command.add(UrbiCommand.class.getName());
    Collections.addAll(command, args);
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().keySet().removeIf(name -> name.startsWith("URBI_"));
    builder.environment().putAll(environment);
    process = builder.start();
    out = process.inputReader(StandardCharsets.UTF_8);
  }

  static Result run(Path folder, String... args) throws IOException, InterruptedException {
    try (UrbiProcess urbi = new UrbiProcess(folder, Map.of(), args)) {
      return urbi.result();
    }
  }

  /** Sends to its standard input. */
  void send(String text) throws IOException {
    process.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
    process.getOutputStream().flush();
  }

  /** The next line of its output. */
  String line() throws IOException {
    return plain(out.readLine());
  }

  /** Hits the interrupt key. */
  void interrupt() throws IOException, InterruptedException {
    new ProcessBuilder("kill", "-INT", String.valueOf(process.pid())).start().waitFor();
  }

  /** Asks it to terminate, and waits until it has. */
  void terminate() throws InterruptedException {
    process.destroy();
    process.waitFor();
  }

  /** Ends it without asking. */
  void kill() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }

  boolean isAlive() {
    return process.isAlive();
  }

  /** Ends its input and waits for its end. */
  Result result() throws IOException, InterruptedException {
    process.getOutputStream().close();
    List<String> lines = new ArrayList<>();
    for (String line = out.readLine(); line != null; line = out.readLine()) {
      lines.add(plain(line));
    }
    String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Result(process.waitFor(), String.join("\n", lines), err.strip());
  }

  private static String plain(String line) {
    return line == null ? null : line.replaceFirst("^\\[\\d+(:?[^]]*)] ?", "[$1] ").stripTrailing();
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
