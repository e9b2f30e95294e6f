package org.urbi.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Another Java virtual machine on this computer, asked through {@code jcmd}. */
public final class JavaProcess {
  /** As in {@code tenured generation   total 174784K, used 2345K [0x…}; not the metaspace. */
  private static final Pattern GENERATION =
      Pattern.compile("(?m)^\\s*(?!Metaspace)\\S.*total\\D*\\d+K, used (\\d+)K");

  private static final Pattern THREAD = Pattern.compile("(?m)^\"([^\"]*)\"");

  /** As in {@code    1:   3406   397840  [B (java.base@25)}. */
  private static final Pattern CLASS =
      Pattern.compile("(?m)^\\s*\\d+:\\s+\\d+\\s+(\\d+)\\s+(\\S+)");

  private final long pid;

  public JavaProcess(long pid) {
    this.pid = pid;
  }

  /** How many bytes of its heap are in use after a full collection. */
  public long usedHeap() throws IOException {
    jcmd("GC.run");
    jcmd("GC.run");
    Matcher generation = GENERATION.matcher(jcmd("GC.heap_info"));
    long kibibytes = 0;
    while (generation.find()) {
      kibibytes += Long.parseLong(generation.group(1));
    }
    return kibibytes << 10;
  }

  /** The names of its platform threads with their numbers, in the order of the names. */
  public TreeMap<String, Integer> threads() throws IOException {
    TreeMap<String, Integer> names = new TreeMap<>();
    Matcher thread = THREAD.matcher(jcmd("Thread.print"));
    while (thread.find()) {
      names.merge(thread.group(1), 1, Integer::sum);
    }
    return names;
  }

  /** How many bytes the live objects of each class take; lists the classes that take most. */
  public Map<String, Long> classes() throws IOException {
    Map<String, Long> bytes = new TreeMap<>();
    Matcher line = CLASS.matcher(jcmd("GC.class_histogram"));
    while (line.find()) {
      bytes.merge(line.group(2), Long.valueOf(line.group(1)), Long::sum);
    }
    return bytes;
  }

  /** Sends a diagnostic command, and returns the answer. */
  public String jcmd(String... command) throws IOException {
    List<String> line = new ArrayList<>();
    line.add(Path.of(System.getProperty("java.home"), "bin", "jcmd").toString());
    line.add(Long.toString(pid));
    line.addAll(List.of(command));
    Process process = new ProcessBuilder(line).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String answer =
        new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    try {
      if (process.waitFor() != 0) {
        throw new IOException("jcmd " + String.join(" ", command) + ": " + answer.strip());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
    return answer;
  }
}
