package org.urbi.kernel.library;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Keeps docs/library.md what the tables of builtins say; {@code -Drenew=true} writes it anew. */
class LibraryReferenceTest {
  private static final Path PAGE = Path.of("..", "docs", "library.md");

  @Test
  void pageIsUpToDate() throws IOException {
    String page = LibraryReference.markdown();
    if (Boolean.getBoolean("renew")) {
      Files.writeString(PAGE, page);
    }
    assertEquals(
        page,
        Files.readString(PAGE),
        "docs/library.md is stale: mvn -pl urbi-kernel -am test -Dtest=LibraryReferenceTest"
            + " -Dsurefire.failIfNoSpecifiedTests=false -Drenew=true");
  }
}
