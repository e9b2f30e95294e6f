package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.bridge.CxxCompiler.Run;

/** The programs umake, umake-shared and umake-deepclean. */
class UmakeTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  @TempDir Path folder;

  @BeforeEach
  void assumeTools() {
    CxxCompiler.assumeCompiler();
    assumeTrue(CxxCompiler.exists("make"), "no make: apt-get install make");
  }

  private static Run umake(String program, String... words) {
    List<String> command =
        new ArrayList<>(List.of(ROOT.resolve("bin").resolve(program).toString()));
    command.addAll(List.of(words));
    return CxxCompiler.run(command);
  }

  /** A header, and two sources of which one includes it. */
  private Path sources() throws IOException {
    Path sources = Files.createDirectory(folder.resolve("small.uob"));
    Files.writeString(sources.resolve("value.hh"), "inline int value() { return 1; }\n");
    Files.writeString(
        sources.resolve("one.cc"), "#include \"value.hh\"\nint one() { return value(); }\n");
    Files.writeString(sources.resolve("two.cc"), "int two() { return SECOND; }\n");
    return sources;
  }

  @Test
  void compilesWhatHasChanged() throws IOException {
    Path sources = sources();
    String output = folder.resolve("small").toString();
    String[] words = {"-v", "-DSECOND=2", sources.toString(), "-o", output};
    Run first = umake("umake-shared", words);
    assertEquals(0, first.status(), first.output());
    assertTrue(Files.exists(folder.resolve("small.so")));
    assertTrue(
        first.output().contains("one.cc") && first.output().contains("two.cc"), first.output());

    Run second = umake("umake-shared", words);
    assertFalse(second.output().contains("-c -o"), second.output());

    Path header = sources.resolve("value.hh");
    Files.writeString(header, "inline int value() { return 3; }\n");
    Files.setLastModifiedTime(
        header, java.nio.file.attribute.FileTime.fromMillis(System.currentTimeMillis() + 2000));
    Run third = umake("umake-shared", words);
    assertTrue(third.output().contains("one.cc"), third.output());
    assertFalse(third.output().contains("two.cc -"), third.output());
    assertFalse(third.output().contains(" " + sources.resolve("two.cc")), third.output());

    assertEquals(0, umake("umake-deepclean", folder.toString()).status());
    assertFalse(Files.exists(folder.resolve("_ubuild-small.so")));
  }

  /** Whoever comes second waits, is told so, and finds all of it made. */
  @Test
  void twiceAtTheSameTime() throws Exception {
    Path source = Files.writeString(folder.resolve("once.cc"), "int once() { return 1; }\n");
    Path compiler = folder.resolve("cxx");
    Path compiled = folder.resolve("compiled");
    Path begun = folder.resolve("begun");
    Path go = folder.resolve("go");
    assertEquals(0, CxxCompiler.run(List.of("mkfifo", begun.toString(), go.toString())).status());
    // The first one to compile waits until it is told to.
    Files.writeString(
        compiler,
        """
        #!/bin/sh
        case " $* " in *" -c "*)
          if [ ! -e %1$s ]; then echo >>%1$s; echo >%2$s; read -r word <%3$s; else echo >>%1$s; fi
        esac
        exec g++ "$@"
        """
            .formatted(compiled, begun, go));
    assertTrue(compiler.toFile().setExecutable(true));
    String[] words = {
      "env",
      "CXX=" + compiler,
      ROOT.resolve("bin").resolve("umake-shared").toString(),
      source.toString(),
      "-o",
      folder.resolve("once.so").toString()
    };
    CompletableFuture<Run> first =
        CompletableFuture.supplyAsync(() -> CxxCompiler.run(List.of(words)));
    Files.readString(begun);
    Process second = new ProcessBuilder(words).redirectErrorStream(true).start();
    String said;
    try (BufferedReader output = second.inputReader()) {
      said = output.readLine();
      Files.writeString(go, "\n");
      assertEquals(
          "umake: waiting for another umake, which makes " + folder.resolve("once.so"), said);
      while (said != null) {
        said = output.readLine();
      }
    }
    assertEquals(0, second.waitFor());
    succeeds(first.join());
    assertEquals("\n", Files.readString(compiled));
    assertTrue(Files.exists(folder.resolve("once.so")));
  }

  @Test
  void errorsAreThoseOfTheCompiler() throws IOException {
    Path source = Files.writeString(folder.resolve("wrong.cc"), "int f() { return nothing; }\n");
    Run run = umake("umake", "-q", "-s", source.toString(), "-o", folder.resolve("w").toString());
    assertEquals(1, run.status());
    assertTrue(run.output().contains("wrong.cc:1:18: error:"), run.output());
    assertTrue(run.output().endsWith("umake: compilation failed\n"), run.output());
  }

  @Test
  void misuse() {
    assertEquals(2, umake("umake", "--nonsense").status());
    assertEquals("umake: no such file: missing.cc\n", umake("umake", "-s", "missing.cc").output());
    assertEquals(1, umake("umake", "--package=no-such-package-at-all", ".").status());
    assertEquals(2, umake("umake", "-j", "0").status());
  }

  /** A source whose function returns what a macro says. */
  private Path answer(String name) throws IOException {
    Path source = folder.resolve(name + ".cc");
    return Files.writeString(source, "extern \"C\" int " + name + "() { return ANSWER; }\n");
  }

  /** A program whose status is what the function answer says. */
  private Path program() throws IOException {
    Path source = folder.resolve("main.cc");
    return Files.writeString(
        source, "extern \"C\" int answer();\nint main() { return answer(); }\n");
  }

  private static void succeeds(Run run) {
    assertEquals(0, run.status(), run.output());
  }

  @Test
  void requestedInformationIsPrinted() {
    assertTrue(umake("umake", "--help").output().contains("--disable-automain"));
    assertTrue(umake("umake", "-V").output().contains("version"));
  }

  @Test
  void programsOfTheirOwn() throws IOException {
    String made = folder.resolve("seven").toString();
    succeeds(
        umake(
            "umake",
            "-m",
            "-DANSWER=7",
            answer("answer").toString(),
            program().toString(),
            "-o",
            made));
    assertEquals(7, CxxCompiler.run(List.of(made)).status());
    // Other options are a reason to compile again.
    succeeds(
        umake("umake", "-qm", "EXTRA_CPPFLAGS=-DANSWER=8", folder.toString(), "--output=" + made));
    assertEquals(8, CxxCompiler.run(List.of(made)).status());
  }

  @Test
  void archivesObjectsAndLibraries() throws IOException {
    String archive = folder.resolve("libanswer").toString();
    succeeds(umake("umake", "--library", "-DANSWER=5", answer("answer").toString(), "-o", archive));
    String made = folder.resolve("five").toString();
    succeeds(umake("umake", "-m", program().toString(), archive + ".a", "-o", made));
    assertEquals(5, CxxCompiler.run(List.of(made)).status());
    succeeds(
        umake("umake", "-m", program().toString(), "-L" + folder, "-lanswer", "-o", made + "l"));
    assertEquals(5, CxxCompiler.run(List.of(made + "l")).status());
    Path object = folder.resolve("answer.o");
    succeeds(
        CxxCompiler.run(
            List.of(
                "g++",
                "-DANSWER=6",
                "-c",
                folder.resolve("answer.cc").toString(),
                "-o",
                object.toString())));
    succeeds(umake("umake", "-m", program().toString(), object.toString(), "-o", made + "o"));
    assertEquals(6, CxxCompiler.run(List.of(made + "o")).status());
  }

  @Test
  void headersAndSourcesElsewhere() throws IOException {
    Path headers = Files.createDirectory(folder.resolve("headers"));
    Files.writeString(headers.resolve("four.hh"), "#define ANSWER 4\n");
    Path source = answer("answer");
    Files.writeString(source, "#include <four.hh>\n" + Files.readString(source));
    program();
    String made = folder.resolve("four").toString();
    succeeds(
        umake(
            "umake", "-m", "-I" + headers, "VPATH=" + folder, "answer.cc", "main.cc", "-o", made));
    assertEquals(4, CxxCompiler.run(List.of(made)).status());
  }

  @Test
  void makefilesOfOthersAndVariables() throws IOException {
    Path mine =
        Files.writeString(folder.resolve("mine.mk"), "URBI_CPPFLAGS += -DANSWER=$(WANTED)\n");
    String made = folder.resolve("three").toString();
    succeeds(
        umake(
            "umake",
            "-m",
            "--param-mk=" + mine,
            "WANTED=3",
            answer("answer").toString(),
            program().toString(),
            "-o",
            made));
    assertEquals(3, CxxCompiler.run(List.of(made)).status());
  }

  @Test
  void compiledAnewAndCleaned() throws IOException {
    String made = folder.resolve("clean").toString();
    String[] words = {"-vs", "-DANSWER=1", answer("answer").toString(), "-o", made};
    succeeds(umake("umake", words));
    assertFalse(umake("umake", words).output().contains("-c -o"));
    List<String> again = new ArrayList<>(List.of(words));
    again.add("--clean");
    assertTrue(umake("umake", again.toArray(String[]::new)).output().contains("-c -o"));
    assertTrue(Files.exists(folder.resolve("_ubuild-clean.so")));
    succeeds(umake("umake", "--deep-clean", folder.toString()));
    assertFalse(Files.exists(folder.resolve("_ubuild-clean.so")));
    assertTrue(Files.exists(Path.of(made + ".so")));
  }

  /** Two at a time take less long than their sum: each waits for the other to have begun. */
  @Test
  void severalAtATime() throws IOException {
    Path compiler =
        Files.writeString(
            folder.resolve("c++"),
            """
            #!/bin/sh
            case "$*" in
            *-c\\ *)
              : >"%1$s/begun.$$"
              for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
                [ "$(ls "%1$s" | grep -c begun)" -ge 2 ] && exec g++ "$@"
                sleep 0.5
              done
              exit 1 ;;
            *) exec g++ "$@" ;;
            esac
            """
                .replace("%1$s", folder.toString()));
    assertTrue(compiler.toFile().setExecutable(true));
    Path sources = Files.createDirectory(folder.resolve("two.uob"));
    Files.writeString(sources.resolve("one.cc"), "int one() { return 1; }\n");
    Files.writeString(sources.resolve("two.cc"), "int two() { return 2; }\n");
    Run run =
        CxxCompiler.run(
            List.of(
                "env",
                "CXX=" + compiler,
                ROOT.resolve("bin/umake-shared").toString(),
                "--jobs=2",
                sources.toString(),
                "-o",
                folder.resolve("two").toString()));
    succeeds(run);
  }

  @Test
  void otherHostsAndPlaces() throws IOException {
    String source = answer("answer").toString();
    Run run = umake("umake", "-s", "-H", "sparc-sun-solaris", source, "-o", folder + "/x");
    assertEquals(1, run.status());
    assertTrue(run.output().contains("no C++ compiler sparc-sun-solaris-g++"), run.output());
    run = umake("umake", "-s", "--prefix=" + folder, source, "-o", folder + "/x");
    assertEquals("umake: no headers in " + folder + "/include\n", run.output());
    assertEquals(2, umake("umake", "--core=nonsense", source).status());
    String made = folder.resolve("remote").toString();
    succeeds(
        umake("umake", "-DANSWER=1", "-k", folder.toString(), "-C", "engine", source, "-o", made));
    Path launch = Files.createDirectory(folder.resolve("bin")).resolve("urbi-launch");
    Files.writeString(launch, "#!/bin/sh\necho \"$@\"\n");
    assertTrue(launch.toFile().setExecutable(true));
    assertEquals(
        new Run(0, "--start --port 1 " + folder.toRealPath() + "/remote.so\n"),
        CxxCompiler.run(List.of(made, "--port", "1")));
    succeeds(umake("umake", "-DANSWER=1", "-k", folder.toString(), source, "-o", made));
    assertTrue(CxxCompiler.run(List.of(made)).output().startsWith("--remote "));
  }
}
