package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;

/** Libraries come and go with their objects, and leave nothing. */
class LifetimeTest {
  private static final String COUNTED =
      """
      class Hub : public urbi::UObjectHub
      {
      public:
        Hub(const std::string& s) : urbi::UObjectHub(s) {}
        ~Hub() override { send("Global.ended += \\"hub \\""); }
      };
      UStartHub(Hub);
      static int living = 0;
      class Counted : public urbi::UObject
      {
      public:
        Counted(const std::string& s) : urbi::UObject(s), version(VERSION)
        {
          UBindFunctions(Counted, ping, init);
          UBindVar(Counted, v);
        }
        ~Counted() override { v = version; --living; }
        int init() { ++living; return 0; }
        int ping() { return version; }
        int version;
        urbi::UVar v;
      };
      UStart(Counted);
      """;

  @TempDir Path folder;

  private static boolean isMapped(Path library) throws IOException {
    return Files.readString(Path.of("/proc/self/maps")).contains(library.getFileName().toString());
  }

  private static String counted(int version) {
    return "enum { VERSION = " + version + " };\n" + COUNTED;
  }

  private static Path byHand() {
    return CxxCompiler.libraryByHand("counted1", counted(1));
  }

  @Test
  void unloadedWithItsObjects() throws IOException {
    Path file = Files.copy(byHand(), folder.resolve("unloaded.so"));
    try (Kernel kernel = Kernel.builder().log(line -> {}).start()) {
      kernel.eval("loadModule(\"" + file + "\")");
      assertTrue(isMapped(file));
      assertEquals(1.0, kernel.eval("var c = Counted.new()| c.ping()"));
      kernel.eval("unloadModule(\"" + file + "\")");
      assertFalse(isMapped(file));
      assertEquals(true, kernel.eval("c.isA(UObject)"));
    }
  }

  @Test
  void unloadedWithTheKernel() throws IOException {
    Path file = Files.copy(byHand(), folder.resolve("ended.so"));
    try (Kernel kernel = Kernel.builder().log(line -> {}).start()) {
      kernel.eval("loadModule(\"" + file + "\")");
      kernel.eval("var c = Counted.new()|");
    }
    assertFalse(isMapped(file));
  }

  @Test
  void replacedWhileObjectsStay() throws IOException {
    Path file = Files.copy(byHand(), folder.resolve("replaced.so"));
    try (Kernel kernel = Kernel.builder().log(line -> {}).start()) {
      kernel.eval("loadModule(\"" + file + "\")");
      kernel.eval("var Global.c = Counted.new()| Global.c.v = 5|");
      Files.delete(file);
      Files.copy(CxxCompiler.libraryOf("counted2", counted(2)), file);
      kernel.eval("loadModule(\"" + file + "\")");
      assertEquals(2.0, kernel.eval("Global.c.ping()"));
      assertEquals(5.0, kernel.eval("Global.c.v"));
    }
    assertFalse(isMapped(file));
  }

  @Test
  void twoKernelsShareNothing() {
    Path file = byHand();
    try (Kernel one = Kernel.builder().log(line -> {}).start();
        Kernel other = Kernel.builder().log(line -> {}).start()) {
      one.eval("loadModule(\"" + file + "\")");
      other.eval("loadModule(\"" + file + "\")");
      one.eval("Counted.v = 1|");
      other.eval("Counted.v = 2|");
      assertEquals(1.0, one.eval("Counted.v"));
      assertEquals(2.0, other.eval("Counted.v"));
      one.close();
      assertEquals(1.0, other.eval("Counted.ping()"));
    }
  }
}
