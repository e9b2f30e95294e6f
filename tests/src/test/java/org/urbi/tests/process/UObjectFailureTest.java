package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.make.UmakeJava;

/** Modules that are broken, or replaced, in a server that goes on whatever they do. */
class UObjectFailureTest {
  private static final String COUNTER =
      """
      import urbi.UObject;
      import urbi.UVar;

      public class Counter extends UObject {
        static { UStart(Counter.class); }
        private UVar count = new UVar();

        public Counter(String name) {
          super(name);
          UBindFunction("init");
        }

        public void init(int start) {
          UBindVar(count, "count");
          count.setValue(start);
          UBindFunctions("add", "version");
        }

        public void add(int n) {
          count.setValue(count.intValue() + n * STEP);
        }

        public int version() {
          return STEP;
        }
      }
      """;

  private static final String STUBBORN =
      """
      import urbi.*;

      public class Stubborn extends UObject {
        static { UStart(Stubborn.class); }
        private UVar go = new UVar();

        public Stubborn(String name) {
          super(name);
          UBindVar(go, "go");
          go.setValue(0);
          UNotifyChange(go, "forever");
          UBindFunction("plain");
          UBindThreadedFunction("threaded", LockMode.LOCK_NONE);
          UBindThreadedFunction("never", LockMode.LOCK_NONE);
        }

        public void forever() {
          while (go.doubleValue() != -1) {
            java.util.concurrent.locks.LockSupport.parkNanos(1_000_000);
          }
        }

        public int plain() {
          return 1;
        }

        public int threaded() {
          return 2;
        }

        public void never() {
          while (true) {
            java.util.concurrent.locks.LockSupport.park();
          }
        }
      }
      """;

  private static final String THROWER =
      """
      public class Thrower extends urbi.UObject {
        static { UStart(Thrower.class); }

        public Thrower(String name) {
          super(name);
          throw new IllegalStateException("no device");
        }
      }
      """;

  @TempDir Path folder;
  private ServerProcess server;
  private ConsoleClient client;

  @BeforeEach
  void start() throws Exception {
    server = ServerProcess.in(folder);
    client = server.connect();
  }

  @AfterEach
  void stop() throws Exception {
    try (ServerProcess ending = server) {
      assertEquals("[] 3", answer("1 + 2;"), "the server goes on");
      client.close();
      assertEquals(0, ending.shutDown(), ending::text);
    }
  }

  private Path make(String name, String source) throws IOException {
    Path sources = Files.createTempDirectory(folder, "source");
    Path file = Files.writeString(sources.resolve(name + ".java"), source);
    Path jar = folder.resolve(name + ".jar");
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    PrintStream printer = new PrintStream(output, true, StandardCharsets.UTF_8);
    String[] words = {"-q", file.toString(), "-o", jar.toString()};
    int status = UmakeJava.run(words, printer, printer);
    assertEquals("0 ", status + " " + output.toString(StandardCharsets.UTF_8));
    return jar;
  }

  /** The answer, in one line, without time stamps and places. */
  private String answer(String code) throws IOException {
    return String.join("|", client.answers(code))
        .replaceAll("\\[\\d{8,}", "[")
        .replaceAll("\\d+\\.\\d+(-[\\d.]+)?: ", "");
  }

  private JavaProcess launch(String... modules) throws Exception {
    List<String> arguments = new ArrayList<>(List.of("--port", String.valueOf(server.port())));
    Collections.addAll(arguments, modules);
    JavaProcess launch =
        JavaProcess.start(
            JavaProcess.Setting.in(folder), "org.urbi.server.launch.UrbiLaunchJava", arguments);
    launch.awaitText("running on 127.0.0.1:" + server.port());
    return launch;
  }

  @Test
  void aReplacedJarIsPutBehindTheObjects() throws Exception {
    make("Counter", COUNTER.replace("STEP", "1"));
    assertEquals(
        "[] 15",
        answer(
            "loadModule(\"Counter\"); var c = Counter.new(10)|; c.add(5); c.note = 7|; c.count;"
                .replace("c.note = 7", "var c.note = 7")));
    answer("at (c.count > 100) echo(\"many\");");
    make("Counter", COUNTER.replace("STEP", "100"));
    assertEquals("[] 1", answer("c.version;"), "it is replaced when it is loaded again");
    assertEquals(
        "[] 100|[] 15|[] 7", answer("loadModule(\"Counter\"); c.version; c.count; c.note;"));
    assertTrue(answer("c.add(1); sleep(100ms);").contains("*** many"));
    Files.writeString(folder.resolve("Counter.jar"), "half a jar");
    assertTrue(answer("loadModule(\"Counter\");").contains("not a jar file"));
    make("Counter", COUNTER.replace("STEP", "1").replace("count.setValue(start)", "add(1 / 0)"));
    assertTrue(answer("loadModule(\"Counter\");").contains("/ by zero"));
    assertEquals("[] 100|[] 115", answer("c.version; c.count;"), "the old version is still there");
    answer("unloadModule(\"Counter\");");
    assertTrue(answer("c.add(1);").contains("lookup failed: add"));
    assertEquals("[] 115", answer("c.count;"));
  }

  @Test
  void aProcessIsReplacedByAnotherVersion() throws Exception {
    make("Counter", COUNTER.replace("STEP", "1"));
    JavaProcess old = launch("Counter");
    assertEquals("[] 11", answer("var c = Counter.new(10)|; c.add(1); c.count;"));
    old.close();
    answer("while (uobjects.hasLocalSlot(\"Counter\")) sleep(5ms);");
    assertTrue(answer("c.add(1);").contains("the remote process has gone"));
    make("Counter", COUNTER.replace("STEP", "100"));
    try (JavaProcess ignored = launch("Counter")) {
      assertEquals("[] 110", answer("c = Counter.new(10)|; c.add(1); c.count;"));
    }
  }

  @Test
  void aMissingClassAndAConstructorThatThrows() throws Exception {
    make("Thrower", THROWER);
    assertTrue(answer("loadModule(\"Thrower\");").contains("constructing Thrower: no device"));
    make(
        "Counter",
        COUNTER
                .replace("STEP", "part(new Part())")
                .replace(
                    "public int version()", "int part(Part p) { return 1; } public int version()")
            + "class Part {}");
    Path half = Files.move(folder.resolve("Counter.jar"), folder.resolve("half.jar"));
    try (FileSystem content = FileSystems.newFileSystem(half)) {
      Files.delete(content.getPath("Part.class"));
    }
    String plugged = answer("loadModule(\"half\"); Counter.new(1).version;");
    assertTrue(plugged.contains("Part") && !plugged.contains("\tat "), plugged);
    answer("unloadModule(\"half\");");
    try (JavaProcess process =
        JavaProcess.start(
            JavaProcess.Setting.in(folder),
            "org.urbi.server.launch.UrbiLaunchJava",
            List.of("--port", String.valueOf(server.port()), "half"))) {
      String line = process.awaitLine(said -> said.contains("Part") || said.contains("running on"));
      if (line.contains("running on")) {
        String remote = answer("Counter.new(1).version;");
        assertTrue(remote.contains("Part") && !remote.contains("\tat "), remote);
      }
    }
  }

  @Test
  void callbackNeverReturns() throws Exception {
    make("Stubborn", STUBBORN);
    try (JavaProcess process = launch("Stubborn")) {
      assertEquals("[] 1|[] 2", answer("Stubborn.plain; Stubborn.threaded;"));
      answer("Stubborn.go = 1|;");
      assertEquals("[] 3", answer("1 + 2;"));
      assertEquals(
          "[] 0", answer("var r = 0|; timeout (300ms) { r = Stubborn.plain }; r;"), "given up");
      assertEquals("[] 2", answer("Stubborn.threaded;"), "another thread");
      answer("Stubborn.never, Stubborn.plain,");
      String told = "Stubborn.forever has not returned for 10 s";
      server.awaitText(told);
      process.close();
      answer("while (uobjects.hasLocalSlot(\"Stubborn\")) sleep(5ms);");
    }
  }

  @Test
  void aThreadedFunctionOfAPluggedModuleThatNeverReturns() throws Exception {
    make("Stubborn", STUBBORN);
    assertEquals("[] 2", answer("loadModule(\"Stubborn\"); Stubborn.threaded;"));
    answer("var t = Tag.new|; t: Stubborn.never,");
    assertEquals("[] 1", answer("t.stop; Stubborn.plain;"));
  }
}
