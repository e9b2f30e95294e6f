package org.urbi.tests.process;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.tests.TestTimeout;

/**
 * A Java program in a process of its own, whose output can be waited for. {@code ./check} has it
 * run from the distribution, with the start-up cache ({@code -Durbi.distribution.flags} and {@code
 * -Durbi.distribution.jars}); otherwise it is run from the classes of this build.
 */
final class JavaProcess implements AutoCloseable {
  private static final String SERIAL = "-XX:+UseSerialGC";

  /** The only program that is a server; to the others {@code --port} is where to connect to. */
  private static final String SERVER = "org.urbi.server.cli.UrbiCommand";

  private static final List<String> COLLECTOR_OF_SERVERS = collectorOfServers();

  private static final List<String> FLAGS =
      List.of(SERIAL, "-XX:TieredStopAtLevel=1", "-Durbi.stdin.terminal=false");

  private static final String[] DISTRIBUTION_FLAGS =
      System.getProperty(
              "urbi.distribution.flags",
              "--add-opens=java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED")
          .split(" ");

  private final String name;
  private final Process process;
  private final List<String> lines = new ArrayList<>();
  private final List<Thread> readers = new ArrayList<>();
  private int open = 2;

  /** What the launcher gives a server instead of the serial one. */
  private static List<String> collectorOfServers() {
    try {
      String launcher = Files.readString(Path.of("..", "scripts", "launch.sh"));
      Matcher flags = Pattern.compile("collector=\"(.*?)\"").matcher(launcher);
      if (!flags.find()) {
        throw new IllegalStateException("scripts/launch.sh names no collector for servers");
      }
      return List.of(flags.group(1).split(" "));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Whether the classes are in the jars of the distribution, and not in folders. */
  static boolean isDistribution() {
    return System.getProperty("urbi.distribution.jars") != null;
  }

  private JavaProcess(String name, ProcessBuilder builder) throws IOException {
    this.name = name;
    process = builder.start();
    Guardian.ofThisJvm().guard(process);
    readers.add(read(process.getInputStream()));
    readers.add(read(process.getErrorStream()));
  }

  /** Says how a program is to be run. */
  record Setting(
      Path folder, Map<String, String> environment, String classPath, List<String> before) {
    /** In a folder, with all the classes of the project. */
    static Setting in(Path folder) {
      // Surefire hides the class path of the tests in a jar.
      String classes =
          System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
      return new Setting(
          folder, Map.of(), System.getProperty("urbi.distribution.jars", classes), List.of());
    }

    /** With one more variable in its environment. */
    Setting with(String variable, String value) {
      Map<String, String> more = new HashMap<>(environment);
      more.put(variable, value);
      return new Setting(folder, more, classPath, before);
    }

    /** Whether its memory is too little for the collector of servers. */
    boolean hasLittleMemory() {
      return environment
          .getOrDefault("JAVA_TOOL_OPTIONS", "")
          .matches(".*-Xmx(\\d|\\d\\d|1\\d\\d)m.*");
    }

    /** With other classes. */
    Setting withClassPath(String other) {
      return new Setting(folder, environment, other, before);
    }

    /** By a shell that first limits what the process may have: {@code ulimit -n 100}. */
    Setting after(String shellCommand) {
      return new Setting(
          folder,
          environment,
          classPath,
          List.of("/bin/sh", "-c", shellCommand + "; exec \"$@\"", "sh"));
    }
  }

  static JavaProcess start(Setting setting, String mainClass, List<String> arguments)
      throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(command(setting, mainClass, arguments))
            .directory(setting.folder.toFile());
    builder.environment().keySet().removeIf(variable -> variable.startsWith("URBI_"));
    builder.environment().putAll(setting.environment);
    return new JavaProcess(mainClass.substring(mainClass.lastIndexOf('.') + 1), builder);
  }

  /** The words of the command that starts a program. */
  static List<String> command(Setting setting, String mainClass, List<String> arguments) {
    List<String> command = new ArrayList<>(setting.before);
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(DISTRIBUTION_FLAGS));
    command.addAll(FLAGS);
    if (mainClass.equals(SERVER)
        && arguments.contains("--port")
        && !setting.hasLittleMemory()
        && command.removeIf(SERIAL::equals)) {
      command.addAll(COLLECTOR_OF_SERVERS);
    }
    command.addAll(List.of("-Durbi.root=" + setting.folder, "-cp", setting.classPath, mainClass));
    command.addAll(arguments);
    return command;
  }

  private Thread read(InputStream stream) {
    return Thread.ofPlatform()
        .daemon()
        .start(() -> {
          try (BufferedReader reader =
              new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
              add(line);
            }
          } catch (IOException e) {
            add(e.toString());
          } finally {
            closeOne();
          }
        });
  }

  private synchronized void add(String line) {
    lines.add(line);
    notifyAll();
  }

  private synchronized void closeOne() {
    open--;
    notifyAll();
  }

  /** Sends to its standard input. */
  void send(String text) {
    try {
      process.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
      process.getOutputStream().flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Waits for a line, from either of its outputs, and returns it. */
  synchronized String awaitLine(Predicate<String> wanted) throws InterruptedException {
    long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
    for (int seen = 0; ; seen++) {
      while (seen == lines.size()) {
        long left = TimeUnit.NANOSECONDS.toMillis(deadline - System.nanoTime());
        if (open == 0 || left <= 0) {
          throw new AssertionError(
              name + (open == 0 ? " has ended" : " did not say it") + ":\n" + text());
        }
        wait(left);
      }
      if (wanted.test(lines.get(seen))) {
        return lines.get(seen);
      }
    }
  }

  /** Waits for a line that contains a text. */
  String awaitText(String text) throws InterruptedException {
    return awaitLine(line -> line.contains(text));
  }

  /** All that it has said so far, on both outputs. */
  synchronized String text() {
    return String.join("\n", lines);
  }

  /** Waits for its end, and returns its exit status. */
  int awaitEnd() throws InterruptedException {
    if (!process.waitFor(TestTimeout.LONG)) {
      throw new AssertionError(name + " does not end:\n" + text());
    }
    for (Thread reader : readers) {
      reader.join(TestTimeout.LONG);
    }
    return process.exitValue();
  }

  /** Waits for its end, but not longer than that; returns whether it has ended. */
  boolean endsWithin(Duration limit) throws InterruptedException {
    return process.waitFor(limit);
  }

  long pid() {
    return process.pid();
  }

  /** Asks it to end, as the system does. */
  void terminate() {
    process.destroy();
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
