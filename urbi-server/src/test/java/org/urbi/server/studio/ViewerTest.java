package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;

/** What a page has to know so that it takes nothing for what it is not. */
class ViewerTest {
  @TempDir private Path folder;
  private Kernel kernel;
  private StudioServer studio;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    studio = serve();
  }

  @AfterEach
  void stop() {
    studio.close();
    kernel.close();
  }

  private StudioServer serve() throws IOException {
    return Served.of(
        kernel, AccessPolicy.ALL, Shown.VARIABLES, new Folders(folder, null), new RecordedFiles());
  }

  /** Numbers of jobs, tags and events mean nothing to another server. */
  @Test
  void pagesAreToldWhichServerItIs() throws Exception {
    try (StreamClient page = new StreamClient(studio, "/stream")) {
      String instance = page.await("\"hello\"").replaceFirst(".*(\"instance\":\"[^\"]+\").*", "$1");
      try (StudioServer another = serve();
          StreamClient again = new StreamClient(studio, "/stream");
          StreamClient elsewhere = new StreamClient(another, "/stream")) {
        assertTrue(again.await("\"hello\"").contains(instance), instance);
        assertFalse(elsewhere.await("\"hello\"").contains(instance), instance);
      }
    }
  }

  /** Else a page would take the time in which it has not looked for one in which a job waits. */
  @Test
  void pagesAreToldOfWhichJobsTheTurnsAre() throws Exception {
    kernel.eval("detach(sleep(1h))");
    try (StreamClient page = new StreamClient(studio, "/stream")) {
      String shown = page.await("{\"number\":");
      String number = shown.replaceFirst(".*?\\{\"number\":(\\d+).*", "$1");
      page.send("{\"type\":\"interest\",\"selected\":0,\"traced\":[" + number + "]}");
      page.await("\"traced\":[[" + number + ",");
      page.send("{\"type\":\"interest\",\"selected\":0,\"traced\":[]}");
      page.await("\"traced\":[]");
    }
  }
}
