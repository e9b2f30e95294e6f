package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.bridge.CxxCompiler.Run;

/**
 * What umake compiles once and keeps, and what can go wrong with it. The headers here are small,
 * and a program tells by its status where the code comes from that it was linked with.
 */
class UmakeKeptTest {
  private static final Path UMAKE = Path.of("..", "bin", "umake").toAbsolutePath().normalize();
  private static final int KEPT = 7;
  private static final int OWN = 8;

  @TempDir Path folder;
  private Path kept;
  private Path source;

  @BeforeEach
  void headers() throws IOException {
    CxxCompiler.assumeCompiler();
    kept = folder.resolve("kept");
    Path code = Files.createDirectories(folder.resolve("include/urbi/detail/code"));
    Files.writeString(
        folder.resolve("include/urbi/uobject.hh"),
        """
        #ifdef URBI_SEPARATE
        int answer();
        #else
        inline int answer() { return 8; }
        #endif
        """);
    Files.writeString(
        code.resolve("answer.cc"), "#include <urbi/uobject.hh>\nint answer() { return 7; }\n");
    source = source("#include <urbi/uobject.hh>\nint main() { return answer(); }\n");
  }

  private Path source(String text) throws IOException {
    return Files.writeString(folder.resolve("program.cc"), text);
  }

  private Run umake(String setting, String... options) {
    List<String> words = new ArrayList<>(List.of("env", "URBI_UMAKE_KEPT=" + kept, "CPATH="));
    if (!setting.isEmpty()) {
      words.add(setting);
    }
    words.addAll(List.of(UMAKE.toString(), "-v", "-m", "--prefix=" + folder));
    words.addAll(List.of(options));
    words.addAll(List.of(source.toString(), "-o", folder.resolve("program").toString()));
    return CxxCompiler.run(words);
  }

  /** The status of the program. */
  private int answer(Run made) {
    assertEquals(0, made.status(), made.output());
    return CxxCompiler.run(List.of(folder.resolve("program").toString())).status();
  }

  private List<Path> all() throws IOException {
    try (Stream<Path> found = Files.list(kept)) {
      return found.filter(Files::isDirectory).sorted().toList();
    }
  }

  private static Path compiled(Path one) {
    return one.resolve("uobject.hh.gch");
  }

  /** A compiler that does something before it compiles the program. */
  private String compiler(String before) throws IOException {
    Path script = folder.resolve("cxx");
    Files.writeString(script, "#!/bin/sh\n" + before + "\nexec g++ \"$@\"\n");
    assertTrue(script.toFile().setExecutable(true));
    return "CXX=" + script;
  }

  @Test
  void madeOnceAndUsedFromThenOn() throws IOException {
    assertEquals(KEPT, answer(umake("")));
    List<Path> first = all();
    assertEquals(1, first.size());
    Run second = umake("", "--clean");
    assertEquals(KEPT, answer(second));
    assertTrue(second.output().contains("-include " + first.getFirst()), second.output());
    assertEquals(first, all());
  }

  @Test
  void severalAtTheSameTime() throws IOException {
    List<CompletableFuture<Run>> running = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      String[] words = {
        "env",
        "URBI_UMAKE_KEPT=" + kept,
        UMAKE.toString(),
        "-q",
        "-m",
        "--prefix=" + folder,
        source.toString(),
        "-o",
        folder.resolve("program" + i).toString()
      };
      running.add(CompletableFuture.supplyAsync(() -> CxxCompiler.run(List.of(words))));
    }
    for (int i = 0; i < 4; i++) {
      Run made = running.get(i).join();
      assertEquals(0, made.status(), made.output());
      Path program = folder.resolve("program" + i);
      assertEquals(KEPT, CxxCompiler.run(List.of(program.toString())).status());
    }
    for (Path each : all()) {
      assertFalse(each.getFileName().toString().startsWith("new."), each::toString);
    }
  }

  /** The machine has stopped before everything was on the disk. */
  @Test
  void whatIsNotWholeIsMadeAnew() throws IOException {
    answer(umake(""));
    Path broken = compiled(all().getFirst());
    try (FileChannel file = FileChannel.open(broken, StandardOpenOption.WRITE)) {
      file.truncate(Files.size(broken) / 2);
    }
    assertEquals(KEPT, answer(umake("", "--clean")));
    assertEquals(2, all().size());
  }

  @Test
  void aDiskThatIsFull() throws IOException {
    Run made =
        CxxCompiler.run(
            List.of(
                "env",
                "URBI_UMAKE_KEPT=" + kept,
                "bash",
                "-c",
                "ulimit -f 512; exec \"$@\"",
                "bash",
                UMAKE.toString(),
                "-q",
                "-m",
                "--prefix=" + folder,
                source.toString(),
                "-o",
                folder.resolve("program").toString()));
    assertEquals("umake: running to build program.\n", made.output());
    assertEquals(OWN, answer(made));
    assertEquals(List.of(), all());
  }

  @Test
  void nowhereToKeepIt() {
    kept = Path.of("/dev/null/kept");
    assertEquals(OWN, answer(umake("")));
  }

  @Test
  void keptForOneCompilerItsOptionsAndHeaders() throws IOException {
    answer(umake(""));
    answer(umake("", "-DOTHER"));
    assertEquals(2, all().size());
    answer(umake(compiler("[ \"$1\" != --version ] || { echo another; exit; }")));
    assertEquals(3, all().size());
    Path code = folder.resolve("include/urbi/detail/code/answer.cc");
    Files.writeString(code, Files.readString(code).replace("7", "9"));
    assertEquals(9, answer(umake("")));
    assertEquals(4, all().size());
  }

  /** A header of the system that it was made of has changed. */
  @Test
  void whatIsOlderThanTheSystemIsMadeAnew() throws IOException {
    Path header = Files.writeString(folder.resolve("system.hh"), "int one();\n");
    Path uobject = folder.resolve("include/urbi/uobject.hh");
    Files.writeString(uobject, Files.readString(uobject) + "#include \"" + header + "\"\n");
    answer(umake(""));
    Files.setLastModifiedTime(header, FileTime.fromMillis(System.currentTimeMillis()));
    assertEquals(KEPT, answer(umake("")));
    assertEquals(2, all().size());
  }

  @Test
  void removedWhileItIsUsed() throws IOException {
    String removes = "case \"$*\" in *program.cc*) rm -rf '" + kept + "' ;; esac";
    assertEquals(OWN, answer(umake(compiler(removes))));
  }

  /** What others have compiled may have its own code of the header, with its own state. */
  @Test
  void objectsAndLibrariesOfOthers() throws IOException {
    Path other = Files.writeString(folder.resolve("other.cc"), "int other() { return 0; }\n");
    Path object = folder.resolve("other.o");
    List<String> compile = List.of("g++", "-c", other.toString(), "-o", object.toString());
    assertEquals(new Run(0, ""), CxxCompiler.run(compile));
    assertEquals(OWN, answer(umake("", object.toString())));
    assertEquals(KEPT, answer(umake("", "-lm")));
  }

  @Test
  void errorsAreToldOnce() throws IOException {
    source("#include <urbi/uobject.hh>\nint main() { return nothing; }\n");
    Run made = umake("");
    assertEquals(1, made.status());
    assertEquals(2, made.output().split("program.cc:2:21: error:", -1).length, made.output());
    assertEquals(1, all().size());
  }

  /** What stands before the header may change what that is: it does not come first then. */
  @Test
  void theOrderOfIncludesIsKeptWhereItMatters() throws IOException {
    String end = "#include <urbi/uobject.hh>\nint main() { return answer(); }\n";
    for (String before :
        List.of("// a comment\n/* one\n more */\n", "#include <vector>\n#include <math.h>\n")) {
      source(before + end);
      assertTrue(umake("").output().contains("-include "), before);
    }
    Files.writeString(
        folder.resolve("own.hh"), "#ifndef OWN_HH\n#define OWN_HH\n" + end + "#endif\n");
    source("#include \"own.hh\"\n");
    assertTrue(umake("").output().contains("-include "));
    for (String before :
        List.of(
            "#define NDEBUG\n", "int one;\n", "#include <mine/other.hh>\n", "#if 1\n#endif\n")) {
      Files.createDirectories(folder.resolve("mine"));
      Files.writeString(folder.resolve("mine/other.hh"), "enum { OTHER };\n");
      source(before + end);
      Run made = umake("", "-I" + folder);
      assertFalse(made.output().contains("-include "), before);
      assertEquals(OWN, answer(made), before);
    }
    source("int main() { return 3; }\n");
    Run made = umake("");
    assertNotEquals(KEPT, answer(made));
    assertFalse(made.output().contains("-include "), made.output());
  }
}
