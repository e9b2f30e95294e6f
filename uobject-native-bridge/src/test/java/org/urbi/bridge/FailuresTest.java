package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import urbi.UModuleException;

/** What is wrong with a library, or goes wrong in it, is told to whoever uses it. */
class FailuresTest {
  private static final int MACHINE_OFFSET = 18;
  private static final int AARCH64 = 183;

  @TempDir Path folder;

  private static String refusal(Path file) {
    return assertThrows(UModuleException.class, () -> NativeModule.load(file)).getMessage();
  }

  @Test
  void missingFile() {
    Path file = folder.resolve("missing.so");
    assertEquals("cannot load " + file + ": there is no such file", refusal(file));
  }

  @Test
  void noLibrary() throws IOException {
    Path file = Files.writeString(folder.resolve("text.so"), "Once upon a time in a far land\n");
    assertEquals("cannot load " + file + ": it is no shared library", refusal(file));
  }

  @Test
  void otherArchitecture() throws IOException {
    Path library = CxxCompiler.libraryOf("plain", "");
    byte[] bytes = Files.readAllBytes(library);
    bytes[MACHINE_OFFSET] = (byte) AARCH64;
    Path file = Files.write(folder.resolve("other.so"), bytes);
    String message = refusal(file);
    assertTrue(
        message.startsWith("cannot load " + file + ": it is for aarch64, and this is "), message);
  }

  @Test
  void undefinedSymbol() {
    Path file =
        CxxCompiler.libraryOf(
            "undefined",
            """
            int missing_function(int);
            class Lacking : public urbi::UObject
            {
            public:
              Lacking(const std::string& s) : urbi::UObject(s) { missing_function(1); }
            };
            UStart(Lacking);
            """);
    String message = refusal(file);
    assertTrue(message.startsWith("cannot load " + file + ": undefined symbol: "), message);
    assertTrue(message.contains("missing_function"), message);
  }

  @Test
  void missingEntryPoint() throws IOException {
    Path source = Files.writeString(folder.resolve("c.cc"), "extern \"C\" int f() { return 1; }\n");
    Path file = CxxCompiler.library(source, "entryless");
    assertEquals(
        "no UObject in "
            + file
            + ": it has no symbol urbi_module_version, which urbi/uobject.hh defines",
        refusal(file));
  }

  @Test
  void nothingDeclared() {
    Path file = CxxCompiler.libraryOf("plain", "");
    assertEquals("no UObject in " + file + ": nothing is declared by UStart", refusal(file));
  }

  @Test
  void constructorThatThrows() {
    Path file =
        CxxCompiler.libraryOf(
            "throwing",
            """
            class Throwing : public urbi::UObject
            {
            public:
              Throwing(const std::string& s) : urbi::UObject(s)
              {
                throw std::runtime_error("not today");
              }
            };
            UStart(Throwing);
            """);
    RuntimeException e = assertThrows(RuntimeException.class, () -> Dialogue.run("1;", file));
    assertTrue(
        e.getMessage().endsWith("exception caught while constructing Throwing: not today"),
        e.getMessage());
  }

  private static final String FAILING =
      """
      struct Strange {};
      class Failing : public urbi::UObject
      {
      public:
        Failing(const std::string& s) : urbi::UObject(s)
        {
          UBindFunctions(Failing, runtime, memory, strange, text, elsewhere, thread);
          UBindThreadedFunctionRename(Failing, runtime, "later", urbi::LOCK_NONE);
          UBindVar(Failing, v);
          UBindVar(Failing, w);
          UNotifyChange(v, &Failing::changed);
          UNotifyAccess(w, &Failing::accessed);
          w = 1;
        }
        void runtime() { throw std::runtime_error("bad weather"); }
        void memory() { std::vector<char> all(1ULL << 60); }
        void strange() { throw Strange(); }
        void text() { throw "just text"; }
        double elsewhere() { urbi::UVar x("nowhere", "x"); return x; }
        void changed(int n) { if (n > 1) throw std::runtime_error("too much"); }
        void accessed() { throw std::runtime_error("not yours"); }
        // A constructor on a thread of C++ that nobody else knows of.
        std::string thread()
        {
          std::string result;
          std::thread([&] {
            try { urbi::UVar x("nowhere", "x"); } catch (std::exception& e) { result = e.what(); }
          }).join();
          return result;
        }
        urbi::UVar v, w;
      };
      UStart(Failing);
      """;

  @Test
  void callbacksThatThrow() {
    Path file = CxxCompiler.libraryOf("failing", FAILING);
    String output =
        Dialogue.run(
            """
            function told(f) { try { f.apply([Failing]) } catch (var e) { echo(e.message) } };
            told(Failing.getSlotValue("runtime"));
            told(Failing.getSlotValue("memory"));
            told(Failing.getSlotValue("strange"));
            told(Failing.getSlotValue("text"));
            told(Failing.getSlotValue("elsewhere"));
            told(Failing.getSlotValue("later"));
            Failing.v = 1;
            try { Failing.v = 2 } catch (var e) { echo(e.message) };
            try { Failing.w } catch (var e) { echo(e.message) };
            try { Failing.v = "x" } catch (var e) { echo(e.message) };
            echo("alive");
            """,
            file);
    String call = "exception caught while calling Failing.";
    for (String expected :
        List.of(
            call + "runtime: bad weather",
            call + "memory: std::bad_alloc",
            call + "strange: invalid exception",
            call + "text: invalid exception",
            "*** UVar creation on non existing object: nowhere",
            call + "later: Exception in threaded call: bad weather",
            call + "onChange(Failing.v): too much",
            call + "onAccess(Failing.w): not yours",
            call + "onChange(Failing.v): invalid cast to double from \"x\"",
            "*** alive")) {
      assertTrue(output.contains(expected), () -> expected + " is not in\n" + output);
    }
    assertFalse(output.contains("java."), output);
  }
}
