package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The manual's examples of {@code URBI_PATH}, section 21.1.1. */
class SearchPathTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '=',
      value = {
        "/home/jessie:/usr/local = /home/jessie /usr/local",
        "/home/jessie:/usr/local: = /home/jessie /usr/local STANDARD",
        "/home/jessie::/usr/local = /home/jessie STANDARD /usr/local",
        ":/home/jessie:/usr/local = STANDARD /home/jessie /usr/local",
        "'' = STANDARD",
        ": = STANDARD",
        "a::b::c = a STANDARD b c"
      })
  void loneColonIsTheStandardPath(String value, String expected) {
    SearchPath path = SearchPath.of(value, List.of(Path.of("STANDARD")));
    assertEquals(
        expected, path.directories().stream().map(Path::toString).collect(Collectors.joining(" ")));
  }

  @Test
  void unsetIsTheStandardPath() {
    assertEquals(List.of(Path.of("s")), SearchPath.of(null, List.of(Path.of("s"))).directories());
  }

  @Test
  void theStandardPathHasTheLibraryWithAndWithoutItsName(@TempDir Path root) {
    Path share = root.resolve("share");
    assertEquals(List.of(Path.of("."), share, share.resolve("urbi")), SearchPath.standard(root));
  }

  @Test
  void theFirstFolderThatHasTheFileWins(@TempDir Path folder) throws IOException {
    Path first = Files.createDirectory(folder.resolve("first"));
    Path second = Files.createDirectory(folder.resolve("second"));
    SearchPath path = new SearchPath(List.of(first, second));
    assertEquals(Optional.empty(), path.find("local.u"));
    Path late = Files.createFile(second.resolve("local.u"));
    assertEquals(Optional.of(late), path.find("local.u"));
    Path early = Files.createFile(first.resolve("local.u"));
    assertEquals(Optional.of(early), path.find("local.u"));
  }
}
