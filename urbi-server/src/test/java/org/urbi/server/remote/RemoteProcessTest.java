package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClientException;
import urbi.UObject;
import urbi.USyncClient;

/** Jars that {@code urbi.UMain} runs in a process of its own. */
class RemoteProcessTest {

  private static final String SOURCE =
      """
      import urbi.UObject;
      import urbi.UVar;

      public class Adder extends UObject {
        static { UStart(Adder.class); }

        private UVar v = new UVar();

        public Adder(String s) {
          super(s);
          UBindVar(v, "v");
          v.setValue(42);
          UBindFunctions("add", "hang");
        }

        public double add(double rhs) {
          return v.doubleValue() + rhs;
        }

        public void hang() throws InterruptedException {
          v.setValue(-1);
          Thread.sleep(60000);
        }
      }
      """;

  private static final String WITH_MAIN =
      """
      import urbi.UObject;

      public class Main {
        public static class Own extends UObject {
          public Own(String s) {
            super(s);
            UBindFunction("twice");
          }

          public double twice(double x) {
            return 2 * x;
          }
        }

        public static void main(String[] arguments) {
          UObject.UStart(Own.class);
          UObject.main(arguments);
        }
      }
      """;

  @TempDir Path folder;
  private final List<Process> processes = new ArrayList<>();
  private Kernel kernel;
  private ConsoleServer server;
  private USyncClient client;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    server = listen(0);
    client = USyncClient.connect("127.0.0.1", server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
  }

  private ConsoleServer listen(int port) throws IOException {
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    return new ConsoleServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
        each -> kernel.connect(each, false),
        kernel::connectRemote,
        Limits.DEFAULT,
        new Trace(Trace.Level.NONE, nowhere));
  }

  @AfterEach
  void stop() {
    processes.forEach(Process::destroyForcibly);
    client.close();
    kernel.close();
    server.close();
  }

  private static String sdk() {
    return Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().getPath())
        .toString();
  }

  private void compile(String name, String source) throws IOException {
    Path file = Files.writeString(folder.resolve(name + ".java"), source);
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-cp", sdk(), "-d", folder.toString(), file.toString());
    assertEquals(0, status);
  }

  private Path jar() throws IOException {
    compile("Adder", SOURCE);
    Path jar = folder.resolve("adder.jar");
    try (var out = new JarOutputStream(Files.newOutputStream(jar))) {
      out.putNextEntry(new JarEntry("Adder.class"));
      out.write(Files.readAllBytes(folder.resolve("Adder.class")));
    }
    return jar;
  }

  private Process java(String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(System.getProperty("java.home") + "/bin/java");
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("URBI_UOBJECT_PATH", folder.toString());
    Process process = builder.start();
    processes.add(process);
    return process;
  }

  private Process umain(String... arguments) throws IOException {
    List<String> all = new ArrayList<>(List.of("-cp", sdk(), "urbi.UMain"));
    all.addAll(List.of(arguments));
    return java(all.toArray(String[]::new));
  }

  /** Reads what a process says up to a line; one that hangs is ended, so that this ends, too. */
  private static void await(Process process, String expected) throws IOException {
    Thread.ofVirtual()
        .start(() -> {
          try {
            Thread.sleep(TestTimeout.LONG);
            process.destroyForcibly();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
    var lines =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    List<String> said = new ArrayList<>();
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      said.add(line);
      if (line.startsWith(expected)) {
        return;
      }
    }
    throw new AssertionError(expected + " is not in " + said);
  }

  private double eval(String expression) {
    return client.syncEval(expression).doubleValue();
  }

  @Test
  void processIsKilledDuringACall() throws Exception {
    jar();
    Process process = umain("adder.jar", "--port", String.valueOf(server.port()));
    await(process, "running on ");
    assertEquals(42, eval("Adder.v"));
    assertEquals(39.4, eval("Adder.add(-2.6)"), 1e-9);
    CompletableFuture<String> error =
        CompletableFuture.supplyAsync(() -> {
          try (USyncClient other =
              USyncClient.connect("127.0.0.1", server.port(), TestTimeout.LONG)) {
            return assertThrows(
                    UClientException.class, () -> other.syncEval("Adder.hang", TestTimeout.LONG))
                .getMessage();
          }
        });
    eval("{ while (Adder.v != -1) sleep(5ms); 0 }");
    process.destroyForcibly();
    assertTrue(error.get().endsWith("the remote process has gone"));
    assertEquals(3, eval("1 + 2"));
    await(umain("adder", "-P", String.valueOf(server.port())), "running on ");
    assertEquals(43, eval("Adder.add(1)"));
  }

  @Test
  void aProgramWithItsOwnMain() throws Exception {
    compile("Main", WITH_MAIN);
    Path portFile = Files.writeString(folder.resolve("port"), server.port() + "\n");
    String classPath = sdk() + System.getProperty("path.separator") + folder;
    Process process = java("-cp", classPath, "Main", "--port-file", portFile.toString());
    await(process, "running on ");
    assertEquals(42, eval("Own.twice(21)"));
    kernel.close();
    assertEquals(0, process.waitFor());
  }

  @Test
  void aProcessConnectsAgain() throws Exception {
    jar();
    int port = server.port();
    Process process = umain("adder.jar", "--reconnect", "--port", String.valueOf(port));
    await(process, "running on ");
    server.close();
    client.close();
    server = listen(port);
    client = USyncClient.connect("127.0.0.1", port, TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
    await(process, "running on ");
    assertEquals(43, eval("Adder.add(1)"));
  }

  @Test
  void mistakesAreReported() throws Exception {
    await(umain("--help"), "usage: ");
    await(umain(), "urbi.UMain: no jar given");
    await(umain("missing.jar"), "urbi.UMain: JAR archive missing.jar not found");
    await(umain("--nonsense"), "urbi.UMain: unknown option --nonsense");
    await(umain("--port", "x"), "urbi.UMain: no port: x");
    jar();
    kernel.close();
    server.close();
    String port = String.valueOf(server.port());
    await(
        umain("adder.jar", "--port", port),
        "urbi.UMain: cannot connect to 127.0.0.1:"
            + port
            + ": Connection refused (is a server running there? urbi --port "
            + port
            + " starts one)");
    Files.writeString(folder.resolve("broken.jar"), "nothing");
    Process broken = umain("broken.jar");
    await(broken, "urbi.UMain: ");
    assertEquals(1, broken.waitFor());
  }
}
