package org.urbi.server.studio.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.trust.Role;

/** Files that people edit in a browser, and what may happen to them meanwhile. */
class SourceFilesTest {
  @TempDir Path outside;
  private Path folder;
  private SourceFiles files;

  @BeforeEach
  void makeFolder() throws Exception {
    folder = Files.createDirectory(outside.resolve("programs"));
    files = new Folders(folder, null).of(Role.OWNER);
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private static void refused(String why, Executable executable) {
    String told = assertThrows(FileRefused.class, executable).getMessage();
    assertTrue(told.contains(why), told);
  }

  @Test
  void filesOfUrbiscriptAreListed() throws Exception {
    write("walk.u", "");
    write("legs/left.u", "");
    write("notes.txt", "");
    write(".git/hidden.u", "");
    Files.createSymbolicLink(folder.resolve("link.u"), folder.resolve("walk.u"));
    assertEquals(List.of("legs/left.u", "walk.u"), files.list());
    assertEquals(List.of("left.u"), new Folders(null, folder.resolve("legs")).of(Role.USER).list());
    refused(
        "no such directory", () -> new Folders(folder.resolve("no"), null).of(Role.OWNER).list());
  }

  @Test
  void ofVeryManyFilesSomeAreListed() throws Exception {
    for (int i = 0; i < 1100; i++) {
      write(i + ".u", "");
    }
    assertEquals(1000, files.list().size());
  }

  @Test
  void theyAreReadAndWrittenAsTheyAre() throws Exception {
    Path file = write("legs/left.u", "// grün\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-----"));
    SourceFiles.Content content = files.open("legs/left.u");
    assertEquals("// grün\n", content.text());
    String version = files.save("legs/left.u", "// blöd\n", content.version());
    assertEquals("// blöd\n", Files.readString(file));
    assertEquals("rwxr-----", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    assertEquals(version, files.open("legs/left.u").version());
    assertNotEquals(version, content.version());
    assertEquals(List.of(file), filesIn(file.getParent()), "nothing else is left there");
    files.save("new.u", "1;", "");
    assertEquals("1;", files.open("new.u").text());
  }

  private static List<Path> filesIn(Path directory) throws IOException {
    try (var all = Files.list(directory)) {
      return all.toList();
    }
  }

  @Test
  void nothingOutsideIsReachedAlsoByLinks() throws Exception {
    Path secret = Files.writeString(outside.resolve("secret.u"), "secret");
    Files.createSymbolicLink(folder.resolve("link.u"), secret);
    Files.createSymbolicLink(folder.resolve("up"), outside);
    write("notes.txt", "");
    for (String name :
        List.of(
            "../secret.u",
            "x/../../secret.u",
            secret.toString(),
            "link.u",
            "up/secret.u",
            "notes.txt",
            "",
            ".",
            "a\0b.u")) {
      assertThrows(FileRefused.class, () -> files.open(name), name);
      assertThrows(FileRefused.class, () -> files.save(name, "mine", ""), name);
    }
    assertEquals("secret", Files.readString(secret));
    refused("give the file a name that ends in .u", () -> files.save(" ", "mine", ""));
  }

  @Test
  void whatIsNoTextOfThatSizeIsRefused() throws Exception {
    Files.write(folder.resolve("binary.u"), new byte[] {1, 0, 2});
    Files.write(folder.resolve("latin.u"), new byte[] {'g', (byte) 0xfc});
    write("huge.u", "x".repeat(SourceFiles.LONGEST + 1));
    Files.createDirectory(folder.resolve("folder.u"));
    refused("binary.u is no text in UTF-8", () -> files.open("binary.u"));
    refused("latin.u is no text in UTF-8", () -> files.open("latin.u"));
    refused("huge.u is too large: 131073 bytes", () -> files.open("huge.u"));
    refused("folder.u is no file", () -> files.open("folder.u"));
    refused("no such file any more", () -> files.open("gone.u"));
    refused("is too large", () -> files.save("new.u", "ü".repeat(1 << 16) + "x", ""));
    refused("cannot be written: no such directory", () -> files.save("no/new.u", "1", ""));
  }

  @Test
  void whatOthersHaveDoneIsNotOverwritten() throws Exception {
    Path file = write("walk.u", "1");
    String version = files.open("walk.u").version();
    refused("is there already", () -> files.save("walk.u", "2", ""));
    write("walk.u", "changed");
    refused("has been changed meanwhile", () -> files.save("walk.u", "2", version));
    write("walk.u", "x".repeat(SourceFiles.LONGEST + 1));
    refused("is too large", () -> files.save("walk.u", "2", version));
    Files.delete(file);
    refused("has been deleted meanwhile", () -> files.save("walk.u", "2", version));
    files.save("walk.u", "2", "");
    assertEquals("2", Files.readString(file));
  }

  @Test
  void observersHaveNone() {
    Folders all = new Folders(folder, folder);
    refused("the role observer has no files", () -> all.of(Role.OBSERVER));
    refused("the role user has no files", () -> Folders.NONE.of(Role.USER));
  }
}
