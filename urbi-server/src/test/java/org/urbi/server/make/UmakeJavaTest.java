package org.urbi.server.make;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.tools.ToolResult;
import urbi.UClass;
import urbi.spi.ModuleFiles;

class UmakeJavaTest {
  private static final String UOBJECT =
      """
      import urbi.UObject;
      public class %1$s extends UObject {
        static { UStart(%1$s.class); }
        public %1$s(String name) { super(name); }
      }
      """;

  @TempDir Path folder;
  private Path sources;
  private Path jar;

  @BeforeEach
  void writeSources() throws IOException {
    jar = folder.resolve("machine.jar");
    sources = Files.createDirectories(folder.resolve("machine.uob"));
    write("UMachine.java", UOBJECT.formatted("UMachine"));
    write("parts/Machine.java", "package parts; public class Machine { class Inside {} }");
  }

  private Path write(String name, String text) throws IOException {
    Path file = sources.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private static ToolResult make(Object... words) {
    String[] args = new String[words.length];
    for (int i = 0; i < words.length; i++) {
      args[i] = words[i].toString();
    }
    return ToolResult.of(UmakeJava::run, args);
  }

  private static List<String> entries(Path file) throws IOException {
    try (JarFile made = new JarFile(file.toFile())) {
      return made.stream().map(ZipEntry::getName).toList();
    }
  }

  @Test
  void aFolderBecomesAJarThatCanBeLoaded() throws Exception {
    ToolResult run = make(sources, "-o", jar);
    assertEquals(
        new ToolResult(
            0,
            "umake-java: compiling 2 files\numake-java: made %s: 3 classes, UObjects: UMachine\n"
                .formatted(jar),
            ""),
        run);
    assertEquals(
        List.of(
            "META-INF/MANIFEST.MF",
            "UMachine.class",
            "parts/Machine$Inside.class",
            "parts/Machine.class"),
        entries(jar));
    assertEquals(
        List.of("UMachine"), ModuleFiles.load(jar).classes().stream().map(UClass::name).toList());
  }

  @Test
  void quietSaysNothing() {
    assertEquals(new ToolResult(0, "", ""), make("-q", "--output", jar, sources));
  }

  @Test
  void filesAreTakenAsTheyAreNamed() throws Exception {
    assertEquals(
        new ToolResult(0, "", ""), make("-q", sources.resolve("UMachine.java"), "-o", jar));
    assertEquals(List.of("META-INF/MANIFEST.MF", "UMachine.class"), entries(jar));
  }

  @Test
  void theSuffixIsAdded() {
    assertEquals(0, make("-q", sources, "-o", folder.resolve("machine")).status());
    assertTrue(Files.exists(jar));
  }

  @Test
  void theSameSourcesGiveTheSameBytes() throws Exception {
    make("-q", sources, "-o", jar);
    byte[] first = Files.readAllBytes(jar);
    make("-q", sources, "-o", jar);
    assertArrayEquals(first, Files.readAllBytes(jar));
  }

  @Test
  void earlierResultIsNotPackedAgain() throws Exception {
    Path inside = sources.resolve("machine.jar");
    make("-q", sources, "-o", inside);
    List<String> first = entries(inside);
    Files.delete(sources.resolve("parts/Machine.java"));
    make("-q", sources, "-o", inside);
    assertEquals(4, first.size());
    assertEquals(List.of("META-INF/MANIFEST.MF", "UMachine.class"), entries(inside));
  }

  @Test
  void classesAndJarsBecomeAPart() throws Exception {
    Path library = folder.resolve("library.jar");
    Path both = Files.createDirectories(folder.resolve("both"));
    make("-q", sources.resolve("parts"), "-o", library);
    try (JarFile made = new JarFile(library.toFile())) {
      byte[] bytes = made.getInputStream(made.getEntry("parts/Machine.class")).readAllBytes();
      Files.write(both.resolve("whatever.class"), bytes);
    }
    Files.writeString(both.resolve("UOther.java"), UOBJECT.formatted("UOther"));
    assertEquals(0, make("-q", both, library, "-o", jar).status());
    assertEquals(
        List.of(
            "META-INF/MANIFEST.MF",
            "UOther.class",
            "parts/Machine$Inside.class",
            "parts/Machine.class"),
        entries(jar));
  }

  @Test
  void whatTheClassesOfAFolderReadComesWithThem() throws Exception {
    Path classes = Files.createDirectories(folder.resolve("classes"));
    assertEquals(0, make(sources, "-q", "-o", jar).status());
    try (JarFile made = new JarFile(jar.toFile())) {
      Path inside = Files.createDirectories(classes.resolve("parts"));
      Files.write(
          inside.resolve("Machine.class"),
          made.getInputStream(made.getEntry("parts/Machine.class")).readAllBytes());
    }
    Files.writeString(classes.resolve("parts/page.html"), "<p>");
    Files.writeString(Files.createDirectories(classes.resolve("icons")).resolve("a.svg"), "<svg/>");
    Files.writeString(Files.createDirectories(classes.resolve("META-INF")).resolve("INDEX"), "");
    Files.writeString(classes.resolve(".hidden"), "");
    // Beside sources lies what is nobody's resource.
    write("notes.txt", "to do");
    Path both = folder.resolve("both.jar");
    assertEquals(0, make(classes, sources, "-q", "-o", both).status());
    assertEquals(
        List.of(
            "META-INF/MANIFEST.MF",
            "UMachine.class",
            "icons/a.svg",
            "parts/Machine$Inside.class",
            "parts/Machine.class",
            "parts/page.html"),
        entries(both));
  }

  @Test
  void sourcesMayReferToALibraryThatIsNotPacked() throws Exception {
    Path library = folder.resolve("library.jar");
    make("-q", sources.resolve("parts"), "-o", library);
    Path user = write("User.java", "class User { parts.Machine machine; }");
    assertEquals(0, make("-q", user, "--classpath", library, "-o", jar).status());
    assertEquals(List.of("META-INF/MANIFEST.MF", "User.class"), entries(jar));
  }

  @Test
  void errorsTellFileAndLine() throws Exception {
    Path wrong = write("Wrong.java", "class Wrong {\n  int x = \"a\";\n}\n");
    ToolResult run = make("-q", wrong, "-o", jar);
    assertEquals(1, run.status());
    assertTrue(run.err().startsWith(wrong + ":2: error: incompatible types"), run.err());
    assertTrue(run.err().endsWith("umake-java: compilation failed: 1 error\n"), run.err());
    assertFalse(Files.exists(jar));
  }

  @Test
  void moduleWithoutUObjectCausesAWarning() throws Exception {
    ToolResult run = make("-q", sources.resolve("parts"), "-o", jar);
    assertEquals(0, run.status());
    assertTrue(run.err().contains("warning: no class in " + jar + " calls UStart"), run.err());
  }

  @Test
  void variablesMayBeGiven() throws Exception {
    write("User.java", "class User { java.util.List raw; }");
    String where = "VPATH=" + sources;
    assertEquals(0, make("-q", where, "-o", jar, "User.java").status());
    ToolResult run = make("EXTRA_JAVACFLAGS=-Xlint:all -Werror", where, "-o", jar, "User.java");
    assertEquals(1, run.status(), run.err());
    assertTrue(run.err().contains("[rawtypes]"), run.err());
    assertEquals(2, make("OTHER=1", sources).status());
  }

  @Test
  void nonsenseIsReported() throws Exception {
    Path empty = Files.createDirectory(folder.resolve("empty"));
    assertEquals(
        new ToolResult(1, "", "umake-java: no Java sources in %s\n".formatted(empty)), make(empty));
    assertEquals(
        new ToolResult(1, "", "umake-java: no such file: no/such.java\n"), make("no/such.java"));
    Path text = Files.createFile(folder.resolve("notes.txt"));
    assertEquals(2, make(text).status());
    assertEquals(2, make("--bogus").status());
    assertTrue(make("--help").out().contains("--output"));
    assertTrue(make("-V").out().startsWith("umake-java version "));
    assertTrue(make("--version").out().startsWith("umake-java version "));
    assertEquals(new ToolResult(0, "", ""), make("--deep-clean"));
  }

  @Test
  void unwritableOutputIsReported() {
    ToolResult run = make("-q", sources, "-o", folder.resolve("none/machine.jar"));
    assertEquals(1, run.status());
    assertTrue(run.err().startsWith("umake-java: cannot write "), run.err());
  }
}
