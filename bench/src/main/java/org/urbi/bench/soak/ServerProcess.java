package org.urbi.bench.soak;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.urbi.bench.JavaProcess;

/** A process of {@code ./urbi} that listens on a free port. */
final class ServerProcess implements AutoCloseable {
  private static final int TIMEOUT_MILLISECONDS = 60_000;

  private final Process process;
  private final JavaProcess java;
  private final Path log;
  private final int port;

  /** What a look at the server has shown. */
  record Sample(
      long heap,
      int threads,
      Map<String, Integer> threadNames,
      int jobs,
      int descriptors,
      int children,
      long resident) {
    @Override
    public String toString() {
      return "heap %6.1f MB   %d threads   %4d jobs   %3d descriptors   %d programs   resident %6.1f MB"
          .formatted(heap / 1e6, threads, jobs, descriptors, children, resident / 1e6);
    }
  }

  ServerProcess(Path root) throws IOException {
    Path folder = Files.createTempDirectory("urbi-soak");
    Path portFile = folder.resolve("port");
    log = folder.resolve("log");
    Path component = folder.resolve("adder.jar");
    make(root, component);
    ProcessBuilder builder =
        new ProcessBuilder(
            root.resolve("urbi").toString(),
            "-q",
            "-P",
            "0",
            "-w",
            portFile.toString(),
            "-e",
            "loadModule(\"" + component + "\");");
    builder.environment().put("TMPDIR", folder.toString());
    process = builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
    process.getOutputStream().close();
    java = new JavaProcess(process.pid());
    long end = System.nanoTime() + TIMEOUT_MILLISECONDS * 1_000_000L;
    while (!Files.exists(portFile)) {
      if (!process.isAlive() || System.nanoTime() > end) {
        process.destroyForcibly();
        throw new IOException("the server does not start: " + Files.readString(log));
      }
      Soak.pause(20);
    }
    port = Integer.parseInt(Files.readString(portFile).strip());
  }

  /** Makes the component that clients use. */
  private static void make(Path root, Path jar) throws IOException {
    Process umake =
        new ProcessBuilder(
                root.resolve("bin/umake-java").toString(),
                "-q",
                root.resolve("examples/uobjects/adder.uob").toString(),
                "-o",
                jar.toString())
            .inheritIO()
            .start();
    try {
      if (umake.waitFor() != 0) {
        throw new IOException("the component cannot be made");
      }
    } catch (InterruptedException e) {
      throw new IOException(e);
    }
  }

  int port() {
    return port;
  }

  boolean isAlive() {
    return process.isAlive();
  }

  /** What it has said of itself. */
  Path log() {
    return log;
  }

  /** Collects its garbage and looks at what is left. */
  Sample sample() throws IOException {
    int jobs;
    try (SoakConnection soakConnection = new SoakConnection(port)) {
      jobs = soakConnection.askNumber("Job.jobs.size");
    }
    long heap = java.usedHeap();
    TreeMap<String, Integer> names = java.threads();
    // These come and go with looking at them, and with the work of the compiler.
    names.keySet().removeIf(ServerProcess::comesAndGoes);
    int threads = names.values().stream().mapToInt(Integer::intValue).sum();
    return new Sample(
        heap,
        threads,
        names,
        jobs,
        descriptors(),
        (int) process.toHandle().children().count(),
        resident());
  }

  /** What its heap is full of: bytes by class. */
  Map<String, Long> classes() throws IOException {
    return java.classes();
  }

  private static boolean comesAndGoes(String thread) {
    return thread.startsWith("Attach Listener")
        || thread.contains("CompilerThread")
        || thread.startsWith("Cleaner-");
  }

  private int descriptors() throws IOException {
    Path folder = Path.of("/proc/" + process.pid() + "/fd");
    if (!Files.exists(folder)) {
      return 0;
    }
    try (Stream<Path> all = Files.list(folder)) {
      return (int) all.count();
    }
  }

  private long resident() throws IOException {
    Path status = Path.of("/proc/" + process.pid() + "/status");
    if (!Files.exists(status)) {
      return 0;
    }
    for (String line : Files.readAllLines(status)) {
      if (line.startsWith("VmRSS:")) {
        return Long.parseLong(line.replaceAll("\\D+", "")) << 10;
      }
    }
    return 0;
  }

  @Override
  public void close() {
    process.destroy();
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      process.destroyForcibly();
    }
  }
}
