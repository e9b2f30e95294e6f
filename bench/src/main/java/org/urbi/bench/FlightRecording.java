package org.urbi.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordedFrame;
import jdk.jfr.consumer.RecordingFile;

/** Shows where a Java virtual machine spends its time, according to the JDK's flight recorder. */
final class FlightRecording {
  private static final int SHOWN = 15;
  private static final Duration SETTLED = Duration.ofSeconds(4);

  /** By which a process that records itself is known. */
  static final String OPTION = "-XX:StartFlightRecording=";

  private static final String NAME = "bench";

  /** Names the recording when it is written. */
  static final String DUMPED = "name=" + NAME;

  private final Path file;
  private final Path settings;

  FlightRecording(Installation machine, String name) throws IOException {
    Path folder = Files.createDirectories(machine.results());
    file = folder.resolve(name + ".jfr");
    settings = folder.resolve("sampling.jfc");
    Files.deleteIfExists(file);
    Files.writeString(
        settings,
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <configuration version="2.0">
          <event name="jdk.ExecutionSample">
            <setting name="enabled">true</setting>
            <setting name="period">10 ms</setting>
          </event>
          <event name="jdk.ObjectAllocationSample">
            <setting name="enabled">true</setting>
            <setting name="throttle">200/s</setting>
            <setting name="stackTrace">true</setting>
          </event>
          <event name="jdk.GarbageCollection"><setting name="enabled">true</setting></event>
        </configuration>
        """);
  }

  /** What makes a Java virtual machine record itself. */
  String options() {
    return OPTION
        + "name="
        + NAME
        + ",filename="
        + file
        + ",settings="
        + settings
        + " -XX:FlightRecorderOptions=stackdepth=64";
  }

  /**
   * Prints the methods that were seen most often at the top of the stack, and what is allocated.
   */
  void print(PrintStream out) throws IOException {
    Map<String, Long> methods = new HashMap<>();
    Map<String, Long> lines = new HashMap<>();
    Map<String, Long> classes = new HashMap<>();
    long collecting = 0;
    long first = 0;
    try (RecordingFile recording = new RecordingFile(file)) {
      while (recording.hasMoreEvents()) {
        RecordedEvent event = recording.readEvent();
        first = first == 0 ? event.getStartTime().toEpochMilli() : first;
        if (event.getStartTime().toEpochMilli() < first + SETTLED.toMillis()) {
          continue;
        }
        switch (event.getEventType().getName()) {
          case "jdk.ExecutionSample" -> {
            RecordedFrame top = event.getStackTrace().getFrames().getFirst();
            methods.merge(name(top), 1L, Long::sum);
            lines.merge(name(top) + ":" + top.getLineNumber(), 1L, Long::sum);
          }
          case "jdk.ObjectAllocationSample" ->
              classes.merge(
                  event.getClass("objectClass").getName(), event.getLong("weight"), Long::sum);
          case "jdk.GarbageCollection" -> collecting += event.getDuration("sumOfPauses").toMillis();
          default -> {}
        }
      }
    }
    out.println("-- %d samples".formatted(methods.values().stream().mapToLong(n -> n).sum()));
    print(out, "methods", methods);
    print(out, "lines", lines);
    print(out, "allocation, bytes", classes);
    out.println("-- collecting garbage: " + collecting + " ms");
  }

  private static String name(RecordedFrame frame) {
    String type = frame.getMethod().getType().getName();
    return type.replaceFirst("^org\\.urbi\\.", "") + "." + frame.getMethod().getName();
  }

  private static void print(PrintStream out, String title, Map<String, Long> counts) {
    long total = counts.values().stream().mapToLong(Long::longValue).sum();
    out.println("-- " + title);
    counts.entrySet().stream()
        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
        .limit(SHOWN)
        .forEach(entry ->
            out.printf("%5.1f %%  %s%n", 100.0 * entry.getValue() / total, entry.getKey()));
  }
}
