package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;

/** Who gets the files to which variables were recorded, and which. */
class StudioDownloadTest {
  private static final String TOKEN = "0123456789abcdef";
  private static final byte[] CONTENT = {1, 2, 3};

  @TempDir Path folder;

  private final RecordedFiles recorded = new RecordedFiles();
  private final HttpClient client = HttpClient.newHttpClient();
  private Kernel kernel;
  private StudioServer studio;

  @BeforeEach
  void serve() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    AccessPolicy owners = new AccessPolicy(Tokens.single(TOKEN, Role.OWNER, "one"), null);
    studio = Served.of(kernel, owners, Shown.VARIABLES, new Folders(folder, null), recorded);
  }

  @AfterEach
  void close() {
    client.shutdownNow();
    studio.close();
    kernel.close();
  }

  private StreamClient owner() {
    return new StreamClient(studio, "/stream?token=" + TOKEN);
  }

  private static String ask(StreamClient page, int recording) throws InterruptedException {
    page.send("{\"type\":\"download\",\"id\":1,\"recording\":" + recording + "}");
    return page.await("\"done\"");
  }

  private static String address(StreamClient page, int recording) throws InterruptedException {
    String answer = ask(page, recording);
    String pattern = ".*\"error\":\"\",\"address\":\"(/download/[0-9a-f]{32})\".*";
    assertTrue(answer.matches(pattern), answer);
    return answer.replaceFirst(pattern, "$1");
  }

  private HttpRequest request(String path) {
    return HttpRequest.newBuilder(URI.create("http://localhost:" + studio.port() + path)).build();
  }

  private String refused(String path) throws Exception {
    HttpResponse<String> answer = client.send(request(path), BodyHandlers.ofString());
    assertEquals(404, answer.statusCode(), answer.body());
    return answer.body();
  }

  private Path record(String name) throws IOException {
    Path file = Files.write(folder.resolve(name), CONTENT);
    recorded.begin(file);
    return file;
  }

  @Test
  void anOwnerGetsWhatWasRecorded() throws Exception {
    try (StreamClient page = owner()) {
      page.await("\"finished\":[]");
      Path file = record("a.mcap");
      assertTrue(ask(page, 1).contains("a.mcap is still being written: stop it first"));
      recorded.end();
      page.await("\"finished\":[{\"number\":1,\"file\":\"" + file + "\"}]");
      String address = address(page, 1);
      HttpResponse<byte[]> answer = client.send(request(address), BodyHandlers.ofByteArray());
      assertEquals(200, answer.statusCode());
      assertArrayEquals(CONTENT, answer.body());
      assertEquals(
          "attachment; filename*=UTF-8''a.mcap",
          answer.headers().firstValue("content-disposition").orElse(""));
      assertTrue(refused(address).contains("it is offered once, for a minute"));
      assertTrue(refused("/download/").contains("404"));
      assertTrue(refused("/download/a.mcap?token=" + TOKEN).contains("404"));
    }
  }

  @Test
  void whatIsNotThereIsTold() throws Exception {
    try (StreamClient page = owner()) {
      Path file = record("a.mcap");
      record("b.mcap");
      record("a.mcap");
      recorded.end();
      assertTrue(ask(page, 1).contains("this recording was overwritten, or is too old"));
      assertTrue(ask(page, 4).contains("this recording was overwritten, or is too old"));
      String offered = address(page, 3);
      Files.delete(file);
      assertTrue(ask(page, 3).contains("a.mcap is not there any more"));
      assertTrue(refused(offered).contains("the file cannot be read"));
      address(page, 2);
    }
  }

  @Test
  void othersGetNothing() throws Exception {
    record("a.mcap");
    recorded.end();
    for (Role role : new Role[] {Role.OBSERVER, Role.USER}) {
      AccessPolicy policy = new AccessPolicy(Tokens.single(TOKEN, role, "one"), null);
      try (StudioServer other =
              Served.of(kernel, policy, Shown.VARIABLES, new Folders(folder, null), recorded);
          StreamClient page = new StreamClient(other, "/stream?token=" + TOKEN)) {
        page.await("\"recording\",\"file\":\"\",\"finished\":[]");
        assertTrue(ask(page, 1).contains("only an owner may download recordings"));
      }
    }
    try (StreamClient unknown = new StreamClient(studio, "/stream")) {
      unknown.await("\"refused\"");
    }
  }

  /** A gigabyte, of which the browser takes nothing before others have been served. */
  @Test
  void aSlowBrowserDelaysNobody() throws Exception {
    long size = 1L << 30;
    Path file = record("a.mcap");
    try (RandomAccessFile made = new RandomAccessFile(file.toFile(), "rw")) {
      made.setLength(size);
    }
    recorded.end();
    try (StreamClient page = owner()) {
      HttpResponse<InputStream> slow =
          client.send(request(address(page, 1)), BodyHandlers.ofInputStream());
      try (InputStream content = slow.body()) {
        assertEquals(1, content.read());
        assertEquals(3.0, kernel.eval("1 + 2"));
        page.send("{\"type\":\"complete\",\"id\":2,\"text\":\"Sys\"}");
        page.await("\"done\",\"id\":2");
        content.skipNBytes(size - 1);
        assertEquals(-1, content.read());
      }
    }
  }
}
