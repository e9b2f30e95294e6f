package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.embed.UrbiError;

/** What a confined kernel refuses, and what it does all the same. */
class ConfinedKernelTest {
  private static final String ELSEWHERE = ": outside of the directory of this kernel: ";

  @TempDir Path temporary;
  private Path inside;
  private Path secret;
  private Kernel kernel;

  @BeforeEach
  void start() throws IOException {
    Path real = temporary.toRealPath();
    inside = Files.createDirectory(real.resolve("inside"));
    secret = Files.createDirectories(real.resolve("secret/folder")).getParent();
    Files.writeString(secret.resolve("file"), "var leaked = 1|\n");
    Files.writeString(inside.resolve("file"), "one\ntwo\n");
    Files.createDirectories(inside.resolve("folder/deep"));
    Files.createSymbolicLink(inside.resolve("link"), secret);
    Files.createSymbolicLink(inside.resolve("new"), secret.resolve("new"));
    kernel =
        Kernel.builder()
            .virtualTime(true)
            .confinedTo(inside)
            .searchPath(List.of(secret, Path.of("folder")))
            .output(text -> {})
            .start();
    assertTrue(kernel.isConfined());
  }

  @AfterEach
  void stop() throws IOException {
    kernel.close();
    // Whatever was tried, nothing has come of it.
    assertEquals("var leaked = 1|\n", Files.readString(secret.resolve("file")));
    try (var names = Files.list(secret)) {
      assertEquals(2, names.count());
    }
    Files.deleteIfExists(inside.resolve("link"));
    Files.deleteIfExists(inside.resolve("new"));
  }

  private void assertRefused(String code, String message) {
    UrbiError error = assertThrows(UrbiError.class, () -> kernel.eval(code), code);
    assertTrue(error.getMessage().contains(message), error.getMessage());
    assertEquals(
        true,
        kernel.eval(
            "try { " + code + " | false } catch (var e if e.isA(Exception.Primitive)) { true }"));
  }

  // What looks, first: this much has to hold before anything is changed.

  @ParameterizedTest
  @ValueSource(strings = {"exists", "isDir", "isReg", "readable", "writable", "open", "cd"})
  void pathsElsewhereAreRefused(String slot) {
    for (String path :
        new String[] {"/", "/etc", "/etc/passwd", "..", "../secret/file", "link", "link/file"}) {
      assertRefused("Path.new(\"%s\").%s".formatted(path, slot), slot + ELSEWHERE);
    }
  }

  @Test
  void filesElsewhereAreRefused() {
    for (String path : new String[] {secret + "/file", "../secret/file", "link/file", "new"}) {
      assertRefused("File.new(\"" + path + "\")", "new" + ELSEWHERE + "\"" + path + "\"");
    }
    assertRefused("Directory.new(\"/\")", "new" + ELSEWHERE + "\"/\"");
    assertRefused("Directory.new(\"link\")", "new" + ELSEWHERE + "\"link\"");
    assertRefused("Directory.new(\"folder\") / \"../../secret\"", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.content", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.asList", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.size", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.empty", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.exists", ELSEWHERE);
    assertRefused("Directory.new(\".\").parent.lastModifiedDate", ELSEWHERE);
    assertRefused(
        "{ var up = Directory.new(\".\").parent | at (up.fileCreated?(var name)) {} }",
        "fileCreated: cannot watch directory: outside of the directory of this kernel");
  }

  @Test
  void sourcesElsewhereAreNotLoaded() {
    assertRefused("loadFile(\"link/file\")", ELSEWHERE);
    assertRefused("load(\"" + secret + "/file\")", ELSEWHERE);
    assertRefused("requireFile(\"../secret/file\")", ELSEWHERE);
    assertRefused("System.searchFile(\"../secret/file\")", ELSEWHERE);
    assertRefused("System.maybeLoad(\"link/file\")", ELSEWHERE);
    // The search path leads to a file of that name, which is not looked at.
    assertEquals(inside + "/file", kernel.eval("System.searchFile(\"file\").asString"));
    assertEquals(false, kernel.eval("hasSlot(\"leaked\")"));
  }

  @Test
  void processesAreRefused() {
    assertRefused(
        "Process.new(\"true\", []).run",
        "run: cannot run true: processes are not allowed in this kernel");
    assertRefused("System.system(\"true\")", "processes are not allowed in this kernel");
    assertRefused("Process.new(\"/bin/sh\", []).runTo(function (x) {})", "processes are not");
  }

  @Test
  void connectionsAreRefused() {
    String refusal = "connections are not allowed in this kernel";
    assertRefused("Socket.new.connect(\"localhost\", 1)", "connect: " + refusal);
    assertRefused("Server.new.listen(\"localhost\", 0)", "listen: " + refusal);
    assertRefused("Socket.new.connectSerial(\"file\", 9600)", "connectSerial: " + refusal);
    assertEquals("localhost", kernel.eval("System.hostName"));
  }

  @Test
  void theEnvironmentIsItsOwn() {
    kernel.eval("System.setenv(\"CONFINED\", 1)");
    assertEquals("1", kernel.eval("System.getenv(\"CONFINED\")"));
    assertNull(System.getenv("CONFINED"));
  }

  @Test
  void theWorkingDirectoryIsItsDirectory() {
    assertEquals(inside.toString(), kernel.eval("Path.cwd.asString"));
    assertEquals(List.of("one", "two"), kernel.eval("File.new(\"file\").asList"));
    kernel.eval("Path.new(\"folder\").cd");
    assertEquals(inside + "/folder", kernel.eval("Path.cwd.asString"));
    assertEquals(true, kernel.eval("Path.new(\"../file\").exists"));
    assertRefused("Path.new(\"../..\").exists", ELSEWHERE);
  }

  @Test
  void pathsThatGoAndComeBackAreFine() {
    assertEquals(true, kernel.eval("Path.new(\"folder/../file\").isReg"));
    assertEquals(true, kernel.eval("Path.new(\"" + inside + "/folder\").isDir"));
    assertEquals(List.of("one", "two"), kernel.eval("InputStream.new(File.new(\"file\")).asList"));
  }

  @Test
  void prototypesStayWhatTheyAre() {
    for (String type : new String[] {"File", "Directory", "Path"}) {
      assertRefused(
          type + ".init(\"file\")", "init: " + type + " is a prototype: use " + type + ".new");
    }
    assertRefused("Directory.new(Path)", "new: not a path");
    assertRefused("Directory.content", "content: not a directory");
  }

  // What changes something.

  @Test
  void nothingIsCreatedElsewhere() {
    for (String path : new String[] {secret + "/made", "../secret/made", "link/made", "new"}) {
      assertRefused("File.create(\"" + path + "\")", ELSEWHERE);
      assertRefused("File.save(\"" + path + "\", \"x\")", ELSEWHERE);
      assertRefused("Directory.createAll(\"" + path + "\")", ELSEWHERE);
      assertRefused("File.new(\"file\").copy(\"" + path + "/x\")", ELSEWHERE);
      assertRefused("File.new(\"file\").rename(\"" + path + "/x\")", ELSEWHERE);
      assertRefused("Directory.new(\"folder\").copy(\"" + path + "/x\")", ELSEWHERE);
      assertRefused("Directory.new(\"folder\").rename(\"" + path + "/x\")", ELSEWHERE);
    }
    assertRefused("Directory.create(\"../secret/made\")", ELSEWHERE);
    assertRefused("Directory.create(\"link/made\")", ELSEWHERE);
    assertRefused("File.new(\"file\").copyInto(\"link\")", ELSEWHERE);
    assertRefused("File.new(\"file\").moveInto(\"../secret\")", ELSEWHERE);
    assertRefused("Directory.new(\"folder\").copyInto(\"link\")", ELSEWHERE);
    assertRefused("Directory.new(\"folder\").moveInto(\"../secret\")", ELSEWHERE);
    assertTrue(Files.exists(inside.resolve("file")));
    assertTrue(Files.exists(inside.resolve("folder/deep")));
  }

  @Test
  void nothingIsRemovedElsewhere() {
    for (String slot : new String[] {"clear", "remove", "removeAll"}) {
      assertRefused("Directory.new(\".\").parent." + slot, ELSEWHERE);
      assertRefused("Directory.new(\"folder\").parent.parent." + slot, ELSEWHERE);
    }
    assertRefused("Directory.new(\".\").removeAll", "is the directory of this kernel");
    assertRefused("Directory.new(\".\").rename(\"folder/x\")", "is the directory of this kernel");
  }

  @Test
  void aFileThatBecomesALinkIsALink() throws IOException {
    kernel.eval("File.create(\"later\"); var later = File.new(\"later\")");
    Files.delete(inside.resolve("later"));
    Files.createSymbolicLink(inside.resolve("later"), secret.resolve("file"));
    assertRefused("later.content", ELSEWHERE);
    assertRefused("OutputStream.new(later) << \"x\"", ELSEWHERE);
    assertRefused("later.copy(\"copy\")", ELSEWHERE);
    // Only the link goes.
    kernel.eval("later.rename(\"moved\"); Directory.new(\"folder\").clear");
    assertTrue(Files.isSymbolicLink(inside.resolve("moved")));
    Files.delete(inside.resolve("moved"));
  }

  @Test
  void allGoesOnInside() {
    kernel.eval(
        "File.save(\"folder/a\", \"x\"); Directory.new(\"folder\").copy(\"copy\");"
            + "File.new(\"copy/a\").rename(\"copy/b\");"
            + "{ var out = OutputStream.new(File.new(\"copy/b\")) | out << \"y\" | out.close };"
            + "Directory.createAll(\"copy/c/d\")");
    assertEquals(List.of("b", "c", "deep"), kernel.eval("Directory.new(\"copy\").content"));
    assertEquals(List.of("xy"), kernel.eval("File.new(\"copy/b\").asList"));
    kernel.eval("Directory.new(\"copy\").clear");
    assertEquals(List.of(), kernel.eval("Directory.new(\"copy\").content"));
    kernel.eval("Directory.new(\"copy\").remove; Directory.new(\"folder\").removeAll");
    assertFalse(Files.exists(inside.resolve("folder")));
    kernel.eval("Directory.new(\".\").clear");
    assertTrue(Files.isDirectory(inside));
    assertFalse(Files.exists(inside.resolve("file")));
  }

  @Test
  void thereHasToBeADirectory() {
    assertThrows(
        UncheckedIOException.class, () -> Kernel.builder().confinedTo(inside.resolve("missing")));
    assertFalse(inside.resolve("missing").toFile().exists());
  }
}
