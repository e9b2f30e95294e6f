package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
    List<String> command = new ArrayList<>(List.of(ROOT.resolve(program).toString()));
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
}
