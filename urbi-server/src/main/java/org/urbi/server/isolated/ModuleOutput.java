package org.urbi.server.isolated;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * What the process of a module writes to its standard streams: it goes to the log, and the last
 * lines are remembered. Where the JVM of the process says what has crashed, that is understood.
 */
final class ModuleOutput {
  /** Longer lines are cut into pieces. */
  private static final int MAX_LINE = 1000;

  private static final int LAST_LINES = 5;
  private static final Pattern SIGNAL = Pattern.compile("#\\s+(SIG[A-Z]+) \\(.*");
  private static final Pattern FRAME = Pattern.compile("# C\\s+\\[([^\\]]+)\\](?:\\s+(.*))?");
  private static final Pattern OFFSET = Pattern.compile("\\+0x[0-9a-f]+$");

  private final Consumer<String> log;
  private final ArrayDeque<String> last = new ArrayDeque<>();
  private final StringBuilder line = new StringBuilder();
  private @Nullable String signal;
  private @Nullable String place;

  /**
   * @param log is given each line
   */
  ModuleOutput(Consumer<String> log) {
    this.log = log;
  }

  /** Reads to the end. */
  void read(InputStream in) {
    byte[] bytes = new byte[1 << 13];
    try {
      for (int size = in.read(bytes); size >= 0; size = in.read(bytes)) {
        String text = new String(bytes, 0, size, StandardCharsets.ISO_8859_1);
        text.chars().forEach(c -> add((char) c));
      }
    } catch (IOException e) {
      // The process has ended.
    }
    end();
  }

  private void add(char c) {
    if (c == '\n' || line.length() == MAX_LINE) {
      end();
    }
    if (c != '\n') {
      line.append(c);
    }
  }

  private void end() {
    if (!line.isEmpty()) {
      byte[] bytes = line.toString().getBytes(StandardCharsets.ISO_8859_1);
      line.setLength(0);
      // Terminals obey control characters.
      String text = new String(bytes, StandardCharsets.UTF_8).replaceAll("\\p{Cntrl}", "?");
      if (text.startsWith("#")) {
        crash(text);
      } else {
        remember(text);
        log.accept(text);
      }
    }
  }

  private synchronized void remember(String text) {
    last.add(text);
    if (last.size() > LAST_LINES) {
      last.remove();
    }
  }

  /** A line of the JVM's report of a crash, which is for developers of Java. */
  private synchronized void crash(String text) {
    Matcher ofSignal = SIGNAL.matcher(text);
    Matcher ofFrame = FRAME.matcher(text);
    if (ofSignal.matches()) {
      signal = ofSignal.group(1);
    } else if (ofFrame.matches()) {
      String function = ofFrame.group(2);
      place =
          function == null || function.isBlank()
              ? ofFrame.group(1)
              : OFFSET.matcher(function.strip()).replaceFirst("");
    }
  }

  /** The crash of which the JVM has told, as {@code SIGSEGV in Arm::move()}; or null. */
  synchronized @Nullable String crash() {
    return signal == null || place == null ? signal : signal + " in " + place;
  }

  /** The last lines that were not part of a report. */
  synchronized List<String> lastWords() {
    return List.copyOf(last);
  }
}
