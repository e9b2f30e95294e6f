package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Which paths a confined kernel may use, and where they lead; nothing is changed. */
class ConfinementTest {
  @TempDir Path temporary;
  private Path inside;
  private Confinement confinement;

  @BeforeEach
  void makeDirectories() throws IOException {
    Path real = temporary.toRealPath();
    inside = Files.createDirectories(real.resolve("inside"));
    Files.createDirectories(inside.resolve("folder/deep"));
    Files.writeString(inside.resolve("file"), "inside");
    Files.createDirectories(real.resolve("inside-too"));
    Path secret = Files.writeString(real.resolve("secret"), "secret");
    link("near", "folder");
    link("out", "..");
    link("out-absolute", real.toString());
    link("out-file", secret.toString());
    link("to-be", real.resolve("new").toString());
    link("folder/deep/back", "../../file");
    link("folder/deep/chain", "../../out");
    link("loop", "loop");
    link("root", "/");
    confinement = Confinement.to(inside);
  }

  @AfterEach
  void removeLinks() throws IOException {
    try (var entries = Files.walk(temporary)) {
      for (Path link : entries.filter(Files::isSymbolicLink).toList()) {
        Files.delete(link);
      }
    }
  }

  private void link(String name, String target) throws IOException {
    Files.createSymbolicLink(inside.resolve(name), Path.of(target));
  }

  @ParameterizedTest
  @CsvSource({
    "., ''",
    "file, file",
    "missing, missing",
    "missing/too, missing/too",
    "folder/../file, file",
    "near/deep, folder/deep",
    "near/deep/back, file",
    "folder/deep/../../file, file",
    "near/../file, file"
  })
  void whatIsInsideMayBeUsed(String path, String real) throws IOException {
    assertEquals(inside.resolve(real), confinement.followed(inside.resolve(path)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "..",
        "../secret",
        "../inside-too",
        "/",
        "/etc/passwd",
        "out",
        "out/secret",
        "out-absolute/secret",
        "out-file",
        "to-be",
        "root",
        "root/etc",
        "near/../../secret",
        "folder/deep/chain/secret",
        "missing/../../secret"
      })
  void whatIsElsewhereMayNot(String path) {
    assertThrows(ConfinedException.class, () -> confinement.followed(inside.resolve(path)), path);
  }

  @Test
  void aLinkItselfIsInsideWhereverItLeads() throws IOException {
    assertEquals(inside.resolve("out"), confinement.entry(inside.resolve("out")));
    assertEquals(
        inside.resolve("folder/deep/chain"),
        confinement.changed(inside.resolve("near/deep/chain")));
    assertThrows(ConfinedException.class, () -> confinement.entry(inside.resolve("out/secret")));
    assertThrows(ConfinedException.class, () -> confinement.changed(inside.resolve("root/etc")));
  }

  @Test
  void theDirectoryItselfStays() throws IOException {
    assertEquals(inside, confinement.entry(inside));
    for (String self : new String[] {".", "folder/..", "out/inside", "folder/../../inside"}) {
      assertThrows(
          IOException.class, () -> confinement.changed(inside.resolve(self).normalize()), self);
    }
    assertThrows(ConfinedException.class, () -> confinement.changed(Path.of("/")));
  }

  @Test
  void loopsAreNoWayOut() {
    assertThrows(
        FileSystemLoopException.class, () -> confinement.followed(inside.resolve("loop/x")));
  }

  @Test
  void thereHasToBeADirectory() {
    assertThrows(IOException.class, () -> Confinement.to(inside.resolve("missing")));
    assertThrows(IOException.class, () -> Confinement.to(inside.resolve("file")));
  }

  @Test
  void aLinkToTheDirectoryLeadsThere() throws IOException {
    Confinement same = Confinement.to(inside.resolve("near"));
    assertEquals(inside.resolve("folder"), same.workingDirectory());
    assertEquals(inside.resolve("folder/deep"), same.followed(inside.resolve("near/deep")));
    assertThrows(ConfinedException.class, () -> same.followed(inside.resolve("file")));
  }

  @Test
  void processesAndConnectionsAreRefused() {
    assertThrows(ConfinedException.class, confinement::checkProcesses);
    assertThrows(ConfinedException.class, confinement::checkConnections);
    assertTrue(confinement.isConfined());
  }

  @Test
  void withoutConfinementPathsStayAsTheyAre() throws IOException {
    Confinement none = Confinement.none();
    assertFalse(none.isConfined());
    assertEquals(Path.of("").toAbsolutePath(), none.workingDirectory());
    for (String path : new String[] {"/", "/etc", "/tmp/../x", inside + "/out/secret"}) {
      assertEquals(Path.of(path), none.followed(Path.of(path)));
      assertEquals(Path.of(path), none.entry(Path.of(path)));
      assertEquals(Path.of(path), none.changed(Path.of(path)));
    }
    none.checkProcesses();
    none.checkConnections();
  }
}
