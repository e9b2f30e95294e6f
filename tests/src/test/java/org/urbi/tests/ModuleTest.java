package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;

/** Modules that are loaded, replaced and unloaded while the kernel runs (manual, "loadModule"). */
class ModuleTest {
  private static final String COUNTER =
      """
      import urbi.UObject;
      import urbi.UVar;

      public class Counter extends UObject implements AutoCloseable {
        static { UStart(Counter.class); }
        private UVar count = new UVar();
        public Counter(String name) {
          super(name);
          UBindFunction("init");
        }
        public void init(int start) {
          UBindVar(count, "count");
          count.setValue(start);
          UNotifyChange(count, "changed");
          UBindFunctions("add", "version");
        }
        public void add(int n) { count.setValue(count.intValue() + n * STEP); }
        public int version() { return STEP; }
        public void changed() { call("Global", "changed", STEP); }
        public void close() { call("Global", "closed", STEP); }
      }
      """;

  @TempDir Path folder;
  private final List<String> log = new ArrayList<>();
  private Kernel kernel;

  @BeforeEach
  void start() {
    kernel = start(folder);
    kernel.eval(
        "var Global.heard = []|; function Global.changed(n) { heard << \"changed%s\" % n }|;");
    kernel.eval("function Global.closed(n) { heard << \"closed%s\" % n }|;");
  }

  private Kernel start(Path modules) {
    return Kernel.builder()
        .output(text -> {})
        .log(line -> {
          synchronized (log) {
            log.add(line);
          }
        })
        .moduleSearchPath(List.of(modules))
        .start();
  }

  @AfterEach
  void stop() {
    kernel.close();
  }

  private void counter(int step) throws IOException {
    UObjectJars.make("Counter", COUNTER.replace("STEP", "" + step), folder.resolve("counter.jar"));
  }

  private String failure(String code) {
    return assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
  }

  @Test
  void aReplacedJarIsPutBehindTheObjects() throws Exception {
    counter(1);
    kernel.eval("loadModule(\"counter\"); var Global.c = Counter.new(10)|; c.add(5);");
    counter(100);
    kernel.eval("loadModule(\"counter\");");
    assertEquals(15.0, kernel.eval("c.count;"));
    assertEquals(100.0, kernel.eval("c.version;"));
    kernel.eval("c.add(1); sleep(10ms);");
    assertEquals(115.0, kernel.eval("c.count;"));
    assertEquals(List.of("changed1", "closed1", "closed1", "changed100"), heard());
    assertEquals(
        100.0, kernel.eval("Counter.new(0).version;"), "new objects are of the new version");
  }

  @Test
  void theSameFileIsLoadedOnce() throws Exception {
    counter(1);
    kernel.eval(
        "loadModule(\"counter\"); var Global.c = Counter.new(10)|; loadModule(\"counter\");");
    assertEquals(List.of(), heard().stream().filter(text -> text.startsWith("closed")).toList());
  }

  @Test
  void aVersionThatFailsLeavesTheOldOne() throws Exception {
    counter(1);
    kernel.eval("loadModule(\"counter\"); var Global.c = Counter.new(10)|;");
    String broken =
        COUNTER
            .replace("STEP", "2")
            .replace("count.setValue(start);", "count.setValue(9); add(1/0);");
    UObjectJars.make("Counter", broken, folder.resolve("counter.jar"));
    assertTrue(failure("loadModule(\"counter\");").contains("/ by zero"));
    assertEquals(1.0, kernel.eval("c.version;"));
    kernel.eval("c.add(1);");
    assertEquals(11.0, kernel.eval("c.count;"));
    counter(3);
    kernel.eval("loadModule(\"counter\");");
    assertEquals(3.0, kernel.eval("c.version;"));
  }

  @Test
  void anUnloadedModuleLeavesItsObjectsWithoutFunctions() throws Exception {
    counter(1);
    kernel.eval(
        "loadModule(\"counter\"); var Global.c = Counter.new(10)|; unloadModule(\"counter\");");
    kernel.eval("sleep(10ms);");
    assertEquals(List.of("changed1", "closed1"), withChange());
    assertTrue(failure("c.add(1);").contains("lookup failed: add"));
    assertEquals(10.0, kernel.eval("c.count;"));
    assertTrue(failure("Counter;").contains("lookup failed: Counter"));
    assertTrue(failure("unloadModule(\"counter\");").contains("not loaded: counter"));
    kernel.eval("loadModule(\"counter\");");
    assertEquals(4.0, kernel.eval("Counter.new(4).count;"));
  }

  private List<String> withChange() {
    List<String> heard = new ArrayList<>(List.of("changed1"));
    heard.addAll(heard().stream().filter(text -> text.startsWith("closed")).distinct().toList());
    return heard;
  }

  @SuppressWarnings("unchecked")
  private List<String> heard() {
    return (List<String>) kernel.eval("sleep(20ms); heard;");
  }

  @Test
  void loadingErrorsAreExplained() throws Exception {
    Files.writeString(folder.resolve("text.jar"), "this is no jar");
    assertTrue(
        failure("loadModule(\"text\");").contains("not a jar"), failure("loadModule(\"text\");"));
    assertTrue(failure("loadModule(\"nothing\");").contains("file not found: nothing"));
    UObjectJars.make("Plain", "public class Plain {}", folder.resolve("plain.jar"));
    assertTrue(failure("loadModule(\"plain\");").contains("no UObject in"));
    Path machine = Files.createDirectory(folder.resolve("classes"));
    UObjectJars.compile(Path.of("src", "test", "resources", "uobjects", "machine"), machine);
    UObjectJars.pack(machine, folder.resolve("half.jar"), "Machine");
    assertTrue(
        failure("loadModule(\"half\");").contains("missing class Machine"),
        failure("loadModule(\"half\");"));
    String thrower =
        """
        public class Thrower extends urbi.UObject {
          static { UStart(Thrower.class); }
          public Thrower(String name) { super(name); throw new IllegalStateException("no power"); }
        }
        """;
    UObjectJars.make("Thrower", thrower, folder.resolve("thrower.jar"));
    assertTrue(
        failure("loadModule(\"thrower\");")
            .contains("exception caught while constructing Thrower: no power"));
    assertTrue(failure("Thrower;").contains("lookup failed: Thrower"));
    assertEquals(2.0, kernel.eval("1 + 1;"));
  }

  @Test
  void classesOfALibraryCanBeUsedByModules() throws Exception {
    Path machine = Files.createDirectory(folder.resolve("classes"));
    UObjectJars.compile(Path.of("src", "test", "resources", "uobjects", "machine"), machine);
    UObjectJars.pack(machine, folder.resolve("wrapper.jar"), "Machine");
    UObjectJars.pack(machine, folder.resolve("base.jar"), "UMachine");
    assertTrue(failure("loadModule(\"base\");").contains("no UObject in"));
    kernel.eval("loadLibrary(\"base\"); loadModule(\"wrapper\");");
    assertEquals("ab", kernel.eval("UMachine.assemble([\"a\", \"b\"]);"));
  }

  @Test
  void aConfinedKernelLoadsNoModules() throws Exception {
    counter(1);
    try (Kernel confined =
        Kernel.builder()
            .output(text -> {})
            .moduleSearchPath(List.of(folder))
            .confinedTo(folder)
            .start()) {
      String message =
          assertThrows(UrbiError.class, () -> confined.eval("loadModule(\"counter\");"))
              .getMessage();
      assertTrue(message.contains("modules are not allowed in this kernel"), message);
    }
  }

  @Test
  void twoKernelsShareNothing() throws Exception {
    String lonely =
        """
        public class Lonely extends urbi.UObject {
          static { UStart(Lonely.class); }
          static int made;
          public Lonely(String name) { super(name); made++; UBindFunction("made"); }
          public int made() { return made; }
        }
        """;
    UObjectJars.make("Lonely", lonely, folder.resolve("lonely.jar"));
    kernel.eval("loadModule(\"lonely\"); Lonely.new|; Lonely.new|;");
    try (Kernel other = start(folder)) {
      other.eval("loadModule(\"lonely\");");
      assertEquals(1.0, other.eval("Lonely.made;"));
      assertEquals(3.0, kernel.eval("Lonely.made;"));
    }
  }

  @Test
  void unreferencedObjectsAreClosed() throws Exception {
    counter(1);
    kernel.eval("loadModule(\"counter\"); for (200) { Counter.new(1)|; };");
    for (int i = 0; i < 100 && closed() < 200; i++) {
      System.gc();
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(20));
    }
    assertTrue(closed() >= 190, closed() + " of 200 closed");
    assertTrue((double) kernel.eval("uobjects.localSlotNames.size;") < 40);
  }

  @Test
  void objectsOfConnectionsThatHaveGoneAreClosed() throws Exception {
    UObjectJars.make(
        "Counter",
        COUNTER
            .replace("STEP", "1")
            .replace("private UVar count", "private UVar lobbys;\nprivate UVar count")
            .replace("init(int start)", "init(urbi.UValue start, UVar lobbys)")
            .replace("count.setValue(start)", "this.lobbys = lobbys;\ncount.setValue(0)"),
        folder.resolve("counter.jar"));
    kernel.eval("loadModule(\"counter\"); var Global.made = 0|;");
    for (int i = 0; i < 50; i++) {
      Connection connection = kernel.connect(new DeafClient());
      // It is a slot of its lobby, has got the lobby as argument and value, uses a variable of it,
      // and is watched.
      connection.send(
          "UVar.new(this, \"own\")|; var c = Counter.new([this], this.&own)|; at (c.count > 5) {}; c.add(1)|;"
              + " var n = c.count| c.count = this| Global.made += n;");
      kernel.eval("waituntil (made > %d);".formatted(i));
      connection.close();
    }
    for (int i = 0; i < 100 && closed() < 50; i++) {
      System.gc();
      kernel.eval("sleep(10ms);");
    }
    assertTrue(closed() >= 45, closed() + " of 50 closed");
  }

  /** Its own collector may not have come, or come earlier. */
  @Test
  void aReplayEndsTheObjectsThatWereReclaimed() throws Exception {
    UObjectJars.make(
        "Leaf",
        """
        public class Leaf extends urbi.UObject {
          static { UStart(Leaf.class); }
          public Leaf(String name) { super(name); }
        }
        """,
        folder.resolve("leaf.jar"));
    Path recording = folder.resolve("run");
    CompletableFuture<Void> looked = new CompletableFuture<>();
    try (Kernel recorded =
        Kernel.builder().moduleSearchPath(List.of(folder)).record(recording).start()) {
      recorded
          .connect(listener(() -> looked.complete(null), "found"), false)
          .send(
              """
              loadModule("leaf");
              var before = uobjects.localSlotNames.size|;
              for (20) { Leaf.new|; };
              echo("made");
              sleep(1ms);
              var names = uobjects.localSlotNames|;
              echo("found " + names.filter(function(n) { uobjects.findUObject(n) !== nil }).size);
              while (uobjects.localSlotNames.size - before > 5) { sleep(20ms) };
              echo("left " + (uobjects.localSlotNames.size - before));
              shutdown;
              """);
      looked.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
      for (int i = 0; i < 300 && recorded.isRunning(); i++) {
        System.gc();
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(20));
      }
      assertFalse(recorded.isRunning(), "they are reclaimed");
    }
    Kernel replayed =
        Kernel.builder().replay(recording, number -> listener(System::gc, "made")).start();
    replayed.awaitTermination();
    assertNull(replayed.replayDifference());
  }

  private static Client listener(Runnable action, String word) {
    return new Client() {
      @Override
      public void output(String bytes) {
        if (bytes.contains(word)) {
          action.run();
        }
      }

      @Override
      public void closed() {}
    };
  }

  private long closed() {
    return heard().stream().filter("closed1"::equals).count();
  }

  /** A client that does not listen. */
  private static final class DeafClient implements Client {
    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {}
  }

  @Test
  void anUnloadedModuleIsForgottenByTheMachine() throws Exception {
    String anchored =
        """
        public class Anchored extends urbi.UObject {
          static { UStart(Anchored.class); }
          public Anchored(String name) {
            super(name);
            UBindThreadedFunction("loader", urbi.LockMode.LOCK_CLASS);
            USetTimer(10, this, "tick");
          }
          public String loader() {
            System.getProperties().put("anchored", new java.lang.ref.WeakReference<>(getClass().getClassLoader()));
            return "";
          }
          public int tick() { return 0; }
        }
        """;
    UObjectJars.make("Anchored", anchored, folder.resolve("anchored.jar"));
    kernel.eval(
        "loadModule(\"anchored\"); var Global.a = Anchored.new|; a.loader; Anchored.loader;");
    WeakReference<?> loader = (WeakReference<?>) System.getProperties().remove("anchored");
    kernel.eval("sleep(50ms); unloadModule(\"anchored\");");
    for (int i = 0; i < 100 && !loader.refersTo(null); i++) {
      System.gc();
      kernel.eval("sleep(10ms);");
    }
    assertTrue(loader.refersTo(null), "the classes of the module are still there");
  }

  private static final String MORTAL =
      """
      public class Mortal extends urbi.UObject {
        static { UStart(Mortal.class); }
        private static int destroyed;
        private static int ticks;
        public Mortal(String name) {
          super(name);
          UBindFunctions("destroyed", "ticks", "set", "unset");
        }
        @Override
        protected void finalize() {
          ++destroyed;
          super.finalize();
        }
        public int destroyed() { return destroyed; }
        public int ticks() { return ticks; }
        public String set() { return USetTimer(10, this, "tick"); }
        public boolean unset(String timer) { return removeTimer(urbi.TimerHandle.create(timer)); }
        public int tick() { return ++ticks; }
      }
      """;

  @Test
  void destroyedObjectIsFinalizedOnce() throws Exception {
    UObjectJars.make("Mortal", MORTAL, folder.resolve("mortal.jar"));
    kernel.eval("loadModule(\"mortal\"); var Global.m = Mortal.new|;");
    assertEquals(0.0, kernel.eval("Mortal.destroyed;"));
    kernel.eval("m.destroy|; m = nil|;");
    assertEquals(1.0, kernel.eval("Mortal.destroyed;"));
  }

  @Test
  void aTimerIsRemovedByItsName() throws Exception {
    UObjectJars.make("Mortal", MORTAL, folder.resolve("mortal.jar"));
    kernel.eval("loadModule(\"mortal\"); var Global.t = Mortal.set|;");
    kernel.eval("while (Mortal.ticks < 3) sleep(5ms);");
    assertEquals(true, kernel.eval("Mortal.unset(t);"));
    assertEquals(false, kernel.eval("Mortal.unset(t);"));
    Object ticks = kernel.eval("Mortal.ticks;");
    kernel.eval("sleep(50ms);");
    assertEquals(ticks, kernel.eval("Mortal.ticks;"));
  }
}
