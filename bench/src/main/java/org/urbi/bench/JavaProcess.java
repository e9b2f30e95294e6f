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
  private static final int COLLECTIONS = 4;
  private static final String FILLER = "FillerElement";

  private static final Pattern THREAD = Pattern.compile("(?m)^\"([^\"]*)\"");

  /** As in {@code 1: 3406 397840 [B (java.base@25)}. */
  private static final Pattern CLASS =
      Pattern.compile("(?m)^\\s*\\d+:\\s+\\d+\\s+(\\d+)\\s+(\\S+)");

  private final long pid;

  public JavaProcess(long pid) {
    this.pid = pid;
  }

  /**
   * How many bytes of its heap live objects take: what a collection reports as used has the gaps
   * between them in it, too.
   */
  public long usedHeap() throws IOException {
    collect();
    return classes().values().stream().mapToLong(Long::longValue).sum();
  }

  /** Collects garbage, all of it: only one in four collections moves everything together. */
  public void collect() throws IOException {
    for (int i = 0; i < COLLECTIONS; i++) {
      jcmd("GC.run");
    }
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
      if (!line.group(2).contains(FILLER)) {
        bytes.merge(line.group(2), Long.valueOf(line.group(1)), Long::sum);
      }
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
    String answer = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
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
