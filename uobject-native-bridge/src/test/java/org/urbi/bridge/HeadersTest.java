package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.bridge.CxxCompiler.Run;

/** The headers by themselves, without a JVM. */
class HeadersTest {
  private static final Path UNIT = Path.of("src", "test", "native", "unit.cc").toAbsolutePath();

  /**
   * The code in them does what it should, with memory too if there is a Valgrind to tell. That of
   * modules is looked at by scripts/memory-check.
   */
  @Test
  void unitTests() throws IOException {
    CxxCompiler.assumeCompiler();
    Files.createDirectories(CxxCompiler.MADE);
    Path program = CxxCompiler.MADE.resolve("unit");
    // By itself, what is compiled can be kept by ccache.
    Path object = CxxCompiler.MADE.resolve("unit.o");
    CxxCompiler.compileProgram("g++", object, UNIT, "-std=c++20", "-g1", "-c");
    CxxCompiler.compileProgram("g++", program, object);
    List<String> command = new ArrayList<>();
    if (CxxCompiler.exists("valgrind")) {
      command.addAll(List.of("valgrind", "-q", "--error-exitcode=9", "--leak-check=full"));
      command.add("--errors-for-leak-kinds=definite,indirect");
    }
    command.add(program.toString());
    assertEquals(new Run(0, "0 failures\n"), CxxCompiler.run(command));
  }

  private static List<String> headers(String folder) throws IOException {
    try (Stream<Path> all = Files.walk(CxxCompiler.HEADERS.resolve(folder))) {
      return all.filter(Files::isRegularFile)
          .map(file -> CxxCompiler.HEADERS.relativize(file).toString())
          .sorted()
          .toList();
    }
  }

  /** What the headers need of Qt, which is the user's: it need not be there for these tests. */
  private static Path qt() throws IOException {
    Path qt = Files.createDirectories(CxxCompiler.MADE.resolve("qt"));
    Files.writeString(qt.resolve("QObject"), "");
    Files.writeString(
        qt.resolve("QApplication"),
        "struct QApplication { QApplication(int&, char**) {} int exec() { return 0; } };\n");
    return qt;
  }

  /**
   * Headers can be included in any order, without a warning, and the main of Qt is a program after
   * any.
   */
  @ParameterizedTest
  @CsvSource({"g++, 17", "clang++, 17"})
  void anyOrder(String compiler, String version) throws IOException {
    assumeTrue(CxxCompiler.exists(compiler), "no " + compiler);
    Files.createDirectories(CxxCompiler.MADE);
    List<String> libport = headers("libport");
    List<String> all = new ArrayList<>(libport);
    all.addAll(headers("serialize"));
    all.addAll(headers("urbi"));
    syntax(compiler, version, all, "UMAIN();\n");
    syntax(compiler, version, all.reversed(), "UMAIN();\n");
    syntax(compiler, version, libport.reversed(), "");
    // What is included by what it includes, and what is rarely included by others.
    for (String header : List.of("customuvar.hxx", "ucallbacks.hh", "ustarter.hxx", "utable.hh")) {
      syntax(compiler, version, List.of("urbi/" + header), "");
    }
  }

  private static void syntax(String compiler, String version, List<String> headers, String program)
      throws IOException {
    StringBuilder code = new StringBuilder();
    for (String header : headers) {
      code.append("#include <").append(header).append(">\n");
    }
    code.append(program);
    Path source = Files.writeString(CxxCompiler.MADE.resolve("header.cc"), code.toString());
    CxxCompiler.Run made =
        CxxCompiler.run(
            List.of(
                compiler,
                "-std=c++" + version,
                "-Wall",
                "-Wextra",
                "-Werror",
                "-fsyntax-only",
                "-I",
                CxxCompiler.HEADERS.toString(),
                "-I",
                qt().toString(),
                source.toString()));
    assertEquals(new Run(0, ""), made, code::toString);
  }

  /** All headers that components of 2.7 include are there. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "customuvar.hh customuvar.hxx exit.hh export.hh fwd.hh input-port.hh input-port.hxx",
        "kernel-version.hh package-info.hh qt_umain.hh socket.hh uabstractclient.hh",
        "uabstractclient.hxx ubinary.hh ubinary.hxx ublend-type.hh ucallbacks.hh uclient.hh",
        "ucontext-factory.hh ucontext-impl.hh ucontext-impl.hxx ucontext.hh ucontext.hxx",
        "uconversion.hh uevent.hh uevent.hxx uexternal.hh uimage.hh umessage.hh",
        "umessage.hxx uobject-hub.hh uobject.hh uobject.hxx uprop.hh uproperty.hh",
        "usound.hh ustarter.hh ustarter.hxx usyncclient.hh utable.hh utag.hh utimer-callback.hh",
        "uvalue-serialize.hh uvalue.hh uvalue.hxx uvar.hh uvar.hxx version-check.hh"
      })
  void exist(String names) {
    for (String name : names.split(" ")) {
      assertTrue(Files.exists(CxxCompiler.HEADERS.resolve("urbi").resolve(name)), name);
    }
  }

  /** Other compilers and versions of the language understand them, without a warning. */
  @ParameterizedTest
  @CsvSource({"g++, 2b", "clang++, 17", "clang++, 2b"})
  void compile(String compiler, String version) throws IOException {
    assumeTrue(CxxCompiler.exists(compiler), "no " + compiler);
    Files.createDirectories(CxxCompiler.MADE);
    CxxCompiler.compileProgram(
        compiler, CxxCompiler.MADE.resolve("none"), UNIT, "-fsyntax-only", "-std=c++" + version);
  }
}
