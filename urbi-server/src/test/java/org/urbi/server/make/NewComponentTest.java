package org.urbi.server.make;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.server.cli.UrbiCommand;

class NewComponentTest {
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  @TempDir Path folder;

  private int make(String... args) {
    PrintStream errors = new PrintStream(err, true, StandardCharsets.UTF_8);
    return NewComponent.run(args, new PrintStream(new ByteArrayOutputStream()), errors);
  }

  private String error() {
    return err.toString(StandardCharsets.UTF_8);
  }

  private List<String> files() throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile)
          .map(file -> folder.relativize(file).toString())
          .sorted()
          .toList();
    }
  }

  @Test
  void aProjectInJavaHasNoPlaceholderLeft() throws Exception {
    Path project = folder.resolve("Tür a/thermo");
    assertEquals(0, make(project.toString()), this::error);
    assertEquals(
        List.of(
            "Tür a/thermo/.gitignore",
            "Tür a/thermo/README.md",
            "Tür a/thermo/pom.xml",
            "Tür a/thermo/src/main/java/Thermo.java",
            "Tür a/thermo/src/test/java/ThermoTest.java",
            "Tür a/thermo/src/test/urbi/thermo.u"),
        files());
    for (String file : files()) {
      assertFalse(Files.readString(folder.resolve(file)).contains("{{"), file);
    }
  }

  /** Maven reads it on any Java, and the compiler of an older one would tell of a release only. */
  @Test
  void anOlderJavaIsToldWhatIsMissing() throws Exception {
    assertEquals(0, make(folder.resolve("thermo").toString()), this::error);
    String pom = Files.readString(folder.resolve("thermo/pom.xml"));
    int java = Runtime.version().feature();
    assertTrue(pom.contains("<activation><jdk>(," + java + ")</jdk></activation>"), pom);
    assertTrue(pom.contains("takes JDK " + java + " or later, but Maven runs on Java"), pom);
  }

  @Test
  void urbiNewIsTheSameProgram() throws Exception {
    Path project = folder.resolve("motor");
    PrintStream errors = new PrintStream(err, true, StandardCharsets.UTF_8);
    String[] words = {"new", "--cxx", project.toString()};
    assertEquals(0, UrbiCommand.run(words, errors, errors), this::error);
    assertTrue(Files.readString(project.resolve("src/motor.cc")).contains("UStart(Motor);"));
    assertTrue(Files.exists(project.resolve("CMakeLists.txt")));
  }

  @Test
  void whatIsThereIsNotTouched() throws Exception {
    Path project = Files.writeString(folder.resolve("thermo"), "mine");
    assertEquals(1, make(project.toString()));
    assertTrue(error().contains("is there already; nothing was changed"), this::error);
    assertEquals(List.of("thermo"), files());
    assertEquals("mine", Files.readString(project));
  }

  @Test
  void halfAProjectOfAnotherRunIsNotTouchedEither() throws Exception {
    Files.createDirectory(folder.resolve(".thermo.part"));
    assertEquals(1, make(folder.resolve("thermo").toString()));
    assertTrue(error().contains("is in the way"), this::error);
    assertTrue(Files.exists(folder.resolve(".thermo.part")));
  }

  @Test
  void aFolderThatCannotBeMadeIsReported() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "");
    assertEquals(1, make(file.resolve("thermo").toString()));
    assertTrue(error().contains("cannot make "), this::error);
    assertEquals(List.of("file"), files());
  }

  @ParameterizedTest
  @ValueSource(strings = {"é", "1st", "a-b", "a b", "a;b", ".", "/", "x{{NAME}}"})
  void namesThatNoLanguageTakesAreRefused(String name) {
    assertEquals(2, make(folder.resolve(name) + (name.equals(".") ? "/é" : "")));
    assertTrue(error().contains("invalid NAME"), this::error);
  }

  @ParameterizedTest
  @ValueSource(strings = {"object", "String", "list", "uVar", "event", "thread"})
  void namesOfSomethingElseAreRefused(String name) throws Exception {
    assertEquals(2, make(folder.resolve(name).toString()));
    assertTrue(error().contains("is the name of something else"), this::error);
    assertEquals(List.of(), files());
  }

  @Test
  void oneNameAndOneLanguageAreWanted() {
    assertEquals(2, make());
    assertEquals(2, make("a", "b"));
    assertEquals(2, make("--java", "--cxx", folder.resolve("thermo").toString()));
  }
}
