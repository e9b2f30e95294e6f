package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;
import org.urbi.web.Annex;
import org.urbi.web.Annexes;
import org.urbi.web.Page;

/** What browsers, and others that come to the studio's port, are answered. */
class StudioServerTest {
  @TempDir static Path folder;
  private static Kernel kernel;
  private static final RecordedFiles RECORDED = new RecordedFiles();
  private static StudioServer studio;

  @BeforeAll
  static void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    studio = serve(AccessPolicy.ALL);
  }

  @AfterAll
  static void stop() {
    assertEquals(3.0, kernel.eval("1 + 2"));
    studio.close();
    kernel.close();
  }

  private static StudioServer serve(AccessPolicy policy) throws IOException {
    return Served.of(kernel, policy, Shown.VARIABLES, new Folders(folder, null), RECORDED);
  }

  /** A browser's end of the stream. */
  private static final class Browser extends StreamClient {
    Browser(StudioServer studio, String query) {
      super(studio, "/stream" + query);
    }
  }

  /** What is answered to some bytes, until the connection is closed. */
  private static String answer(String request) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), studio.port())) {
      socket.getOutputStream().write(request.getBytes(StandardCharsets.ISO_8859_1));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static String get(String path, String... headers) throws IOException {
    return answer(
        "GET "
            + path
            + " HTTP/1.1\r\nConnection: close\r\n"
            + String.join("\r\n", headers)
            + "\r\n\r\n");
  }

  private static final String HOST = "Host: localhost";

  private static final String[] UPGRADE = {
    HOST,
    "Upgrade: websocket",
    "Sec-WebSocket-Version: 13",
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    "Origin: http://elsewhere.example"
  };

  private static final String HANDSHAKE =
      "GET /stream HTTP/1.1\r\nConnection: Upgrade\r\n"
          + String.join("\r\n", Arrays.copyOf(UPGRADE, 4))
          + "\r\n\r\n";

  @Test
  void pagesAreServedAndNothingElse() throws Exception {
    String page = get("/", HOST);
    assertTrue(page.startsWith("HTTP/1.1 200 OK"), page);
    assertTrue(page.contains("default-src 'self'") && page.contains("nosniff"), page);
    assertTrue(page.contains("<title>Urbi studio</title>"), page);
    for (String file :
        List.of(
            "studio.css",
            "studio.js",
            "rooms.js",
            "jobs-room.js",
            "jobs.css",
            "libraries/uPlot.esm.js",
            "libraries/codemirror.js")) {
      assertTrue(get("/" + file, HOST).startsWith("HTTP/1.1 200"), file);
    }
    for (String path :
        List.of(
            "/Viewer.class",
            "/../net/x",
            "/%2e%2e/banner",
            "//etc/passwd",
            "/stream/../x",
            "/../studio/studio.js",
            "/x/../studio.js",
            "//studio.js",
            "/none.js")) {
      assertTrue(get(path, HOST).matches("(?s)HTTP/1.1 40[0-9].*"), path);
    }
    assertTrue(answer("POST / HTTP/1.1\r\nHost: localhost\r\n\r\n").startsWith("HTTP/1.1 405"));
    assertTrue(answer("nonsense\r\n\r\n").startsWith("HTTP/1.1 400"));
    assertTrue(get("/", HOST, "X: " + "x".repeat(20_000)).startsWith("HTTP/1.1 400"));
  }

  private static Set<String> found(String pattern, String text) {
    return Pattern.compile(pattern)
        .matcher(text)
        .results()
        .map(each -> each.group(1))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Otherwise a browser learns of each file only by the one before. */
  @Test
  void pageNamesAllThatItsFirstRoomNeeds() throws Exception {
    Set<String> needed = new TreeSet<>();
    Deque<String> open = new ArrayDeque<>(List.of("studio.js", "jobs-room.js"));
    while (!open.isEmpty()) {
      String module = open.remove();
      if (needed.add(module)) {
        open.addAll(found("import .* from \"./(.*?)\"", get("/" + module, HOST)));
      }
    }
    String page = get("/", HOST);
    assertEquals(needed, found("(?:modulepreload\" href|module\" src)=\"(.*?)\"", page));
    assertEquals(Set.of("studio.css", "jobs.css"), found("stylesheet\" href=\"(.*?)\"", page));
  }

  @Test
  void pagesOfOtherSitesAreRefused() throws Exception {
    assertTrue(get("/", "Host: elsewhere.example").startsWith("HTTP/1.1 403"));
    assertTrue(get("/", HOST, "Origin: http://elsewhere.example").startsWith("HTTP/1.1 403"));
    assertTrue(get("/", "X: 1").startsWith("HTTP/1.1 403"));
    assertTrue(get("/stream", UPGRADE).startsWith("HTTP/1.1 403"));
  }

  @Test
  void whatMakesNoSenseIsAnsweredAndDoesNothing() throws Exception {
    try (Browser page = new Browser(studio, "")) {
      page.await("\"hello\"");
      List<List<String>> mistakes =
          List.of(
              List.of("{", "no JSON: "),
              List.of("[1]", "a JSON object expected"),
              List.of("{\"type\":1}", "type: a string expected"),
              List.of("{\"type\":\"dance\"}", "type: interest, steer, reactions, emit, variables"),
              List.of("{\"type\":\"interest\",\"selected\":\"x\"}", "selected: a whole number"),
              List.of(
                  "{\"type\":\"interest\",\"selected\":0,\"traced\":[\"x\"]}",
                  "traced: whole numbers expected"),
              List.of("{\"type\":\"steer\",\"action\":\"kill\"}", "action: stop, freeze"),
              List.of(
                  "{\"type\":\"steer\",\"action\":\"stop\",\"kind\":\"cat\"}", "kind: job or tag"),
              List.of("{\"type\":\"reactions\",\"filter\":7}", "filter: a string expected"),
              List.of("{\"type\":\"emit\",\"id\":1}", "event: a whole number expected"),
              List.of(
                  "{\"type\":\"emit\",\"id\":1,\"event\":2,\"payload\":[3]}",
                  "payload: a string expected"),
              List.of("{\"type\":\"variables\",\"objects\":[1]}", "objects: strings expected"),
              List.of("{\"type\":\"variables\",\"objects\":1}", "objects: a list of strings"),
              List.of("{\"type\":\"plot\",\"ways\":[\"Global\"]}", "id: a whole number"),
              List.of("{\"type\":\"plot\",\"id\":1,\"ways\":[1]}", "ways: strings expected"),
              List.of("{\"type\":\"assign\",\"id\":1,\"way\":\"x\"}", "value: a string expected"),
              List.of("{\"type\":\"show\",\"id\":1}", "way: a string expected"),
              List.of("{\"type\":\"run\",\"id\":1,\"file\":\"x\"}", "code: a string expected"),
              List.of("{\"type\":\"stop\",\"id\":1,\"run\":5000000000}", "run: no such number"),
              List.of("{\"type\":\"check\",\"code\":\"1\"}", "id: a whole number expected"),
              List.of(
                  "{\"type\":\"save\",\"id\":1,\"name\":\"x.u\",\"text\":\"\"}",
                  "version: a string expected"),
              List.of(
                  "{\"type\":\"complete\",\"id\":1,\"text\":\"" + "x".repeat(9000) + "\"}",
                  "text: at most 8192 characters, not 9000"),
              List.of("[".repeat(1000), "a JSON object expected"),
              List.of("{\"a\":" + "[".repeat(1000), "no JSON: "),
              List.of("{\"a\":" + "9".repeat(100) + "}", "no JSON: "),
              List.of("{\"type\":\"interest\"} {}", "one JSON object expected"));
      for (List<String> mistake : mistakes) {
        String request = mistake.getFirst();
        page.send(request);
        // Who waits for the answer to a question is not left waiting; a plot is none.
        boolean awaited = request.contains("\"id\":1") && !request.contains("plot");
        String error = page.await(awaited ? "{\"type\":\"done\",\"id\":1," : "\"error\",");
        assertTrue(error.contains(mistake.getLast()), request + " -> " + error);
      }
      page.send(
          "{\"type\":\"steer\",\"id\":7,\"action\":\"stop\",\"kind\":\"job\",\"target\":99999}");
      assertEquals(
          "{\"type\":\"done\",\"id\":7,\"error\":\"no such job any more: 99999\"}",
          page.await("\"done\""));
      page.send("{\"type\":\"emit\",\"id\":8,\"event\":99999,\"payload\":\"1\"}");
      assertEquals(
          "{\"type\":\"done\",\"id\":8,\"error\":\"no such event any more: 99999\"}",
          page.await("\"done\""));
    }
  }

  @Test
  void variablesAreToldPlottedAndAssigned() throws Exception {
    kernel.eval("var Global.plotted = 1.25|");
    kernel.eval("var Global.picture = Binary.new(\"jpeg 2 1\", \"abc\")|");
    try (Browser page = new Browser(studio, "")) {
      assertFalse(page.await("\"complete\":true").contains("\"variables\""));
      page.send("{\"type\":\"variables\",\"objects\":[\"Global\",\"gone\"]}");
      String view = page.await("\"variables\"");
      assertTrue(view.contains("\"name\":\"plotted\",\"type\":\"Float\",\"value\":\"1.25\""), view);
      assertTrue(view.contains("{\"way\":\"gone\",\"anew\":true,\"found\":false"), view);
      page.send("{\"type\":\"plot\",\"id\":3,\"ways\":[\"Global\\n.plotted\",\"gone\"]}");
      String sample = page.await("\"sample\"");
      assertTrue(sample.matches(".*\"id\":3,\"time\":[\\d.E]+,\"values\":\\[1.25,null].*"), sample);
      page.send("{\"type\":\"plot\",\"id\":4}");
      page.send("{\"type\":\"assign\",\"id\":5,\"way\":\"Global\\n.plotted\",\"value\":\"2 + 3\"}");
      assertEquals("{\"type\":\"done\",\"id\":5,\"error\":\"\"}", page.await("\"done\""));
      assertEquals(5.0, kernel.eval("Global.plotted"));
      page.send("{\"type\":\"assign\",\"id\":6,\"way\":\"Global\\n.no\",\"value\":\"1\"}");
      assertTrue(page.await("\"done\"").contains("no such slot any more: Global.no"));
      page.send("{\"type\":\"show\",\"id\":7,\"way\":\"Global\\n.picture\"}");
      assertTrue(page.await("\"done\"").contains("\"keywords\":\"jpeg 2 1\",\"bytes\":\"YWJj\""));
      page.send("{\"type\":\"show\",\"id\":8,\"way\":\"Global\\n.plotted\"}");
      assertTrue(page.await("\"done\"").contains("no image or sound any more"));
    }
  }

  /** It does not read what it asks for, which is large: only few of that may wait for it. */
  @Test
  void oneImageAfterTheOtherIsShown() throws Exception {
    kernel.eval("var Global.large = Binary.new(\"wav\", \"x\" * 4000000)|");
    int wishes = 30;
    try (StreamClient page =
        new StreamClient(studio, "/stream") {
          @Override
          public void onOpen(WebSocket from) {
            // It begins to read later.
          }
        }) {
      for (int i = 1; i <= wishes; i++) {
        page.send("{\"type\":\"show\",\"id\":" + i + ",\"way\":\"Global\\n.large\"}");
      }
      page.socket.request(1);
      int shown = 0;
      for (int i = 1; i <= wishes; i++) {
        String answer = page.await("\"done\"");
        if (answer.contains("\"keywords\":\"wav\"")) {
          shown++;
        } else {
          assertTrue(answer.contains("one image or sound after the other"), answer);
        }
      }
      assertTrue(shown >= 1 && shown < wishes / 2, shown + " were shown");
      page.send("{\"type\":\"show\",\"id\":99,\"way\":\"Global\\n.large\"}");
      assertTrue(page.await("\"id\":99").contains("\"keywords\":\"wav\""));
    }
  }

  private static String code(String type, int id, String code) {
    return "{\"type\":\""
        + type
        + "\",\"id\":"
        + id
        + ",\"file\":\"code\",\"code\":\""
        + code
        + "\"}";
  }

  @Test
  void codeRunsAndIsStopped() throws Exception {
    try (Browser page = new Browser(studio, "")) {
      assertTrue(page.await("\"hello\"").contains("\"whenever\""), "the keywords");
      page.send(code("run", 1, "echo(\\\"gr\u00fcn\\\"); 20 + 3"));
      assertEquals(
          "{\"type\":\"begun\",\"id\":1,\"run\":1,\"tag\":\"run_1\"}", page.await("\"begun\""));
      String said = "";
      while (!said.contains("] 23") || !said.contains("\"done\"")) {
        said += page.await(any -> true);
      }
      assertTrue(said.contains("*** gr\u00fcn"), said);
      assertTrue(said.contains("\"done\",\"id\":1,\"error\":\"\",\"goesOn\":false}"), said);
      page.send(code("run", 2, "while| (true) {}"));
      page.await("\"begun\"");
      page.send("{\"type\":\"stop\",\"id\":3,\"run\":2}");
      assertTrue(page.await("\"id\":2,").contains("it was stopped before its end"));
    }
    assertEquals(3.0, kernel.eval("1 + 2"));
  }

  @Test
  void textsAreCheckedAndCompleted() throws Exception {
    try (Browser page = new Browser(studio, "")) {
      page.await("\"hello\"");
      page.send(code("check", 1, "echo(\\\"gr\u00fcn\\\"); 1 +* 2"));
      String mistakes = page.await("\"done\"");
      assertTrue(mistakes.contains("{\"begin\":17,\"end\":18,\"text\":\"syntax error: "), mistakes);
      page.send(code("check", 2, "1 + 2"));
      assertEquals(
          "{\"type\":\"done\",\"id\":2,\"error\":\"\",\"mistakes\":[]}", page.await("\"done\""));
      page.send(code("check", 3, "[".repeat(Request.LONGEST_CODE)));
      String bomb = page.await("\"id\":3");
      assertTrue(bomb.contains("syntax error") || bomb.contains("too much to be checked"), bomb);
      page.send(code("run", 4, "x".repeat(Request.LONGEST_CODE + 1)));
      assertTrue(page.await("\"id\":4").contains("code: at most 131072 characters"));
      page.send("{\"type\":\"complete\",\"id\":5,\"text\":\"Mutex.unloc\"}");
      assertTrue(
          page.await("\"id\":5").contains("\"proposals\":[{\"name\":\"unlock\",\"signature\""));
    }
  }

  @Test
  void oneTextIsCheckedAtATime() throws Exception {
    try (Browser page = new Browser(studio, "");
        Browser other = new Browser(studio, "")) {
      page.await("\"hello\"");
      other.await("\"hello\"");
      String large = "f(1 + 2 * 3);\\n".repeat(5000);
      for (int i = 1; i <= 20; i++) {
        page.send(code("check", i, large));
      }
      other.send(code("check", 1, "1 +"));
      assertTrue(other.await("\"done\"").contains("syntax error"));
      page.await("one text is checked at a time");
    }
  }

  @Test
  void filesAreListedOpenedAndSaved() throws Exception {
    Files.writeString(folder.resolve("walk.u"), "walk;");
    try (Browser page = new Browser(studio, "");
        Browser other = new Browser(studio, "")) {
      other.await("\"hello\"");
      page.await("\"hello\"");
      page.send("{\"type\":\"files\",\"id\":1}");
      assertTrue(page.await("\"id\":1,").contains("\"files\":[\"walk.u\"]"));
      page.send("{\"type\":\"open\",\"id\":2,\"name\":\"walk.u\"}");
      String opened = page.await("\"id\":2,");
      assertTrue(opened.contains("\"text\":\"walk;\""), opened);
      String save =
          "{\"type\":\"save\",\"id\":3,\"name\":\"walk.u\",\"text\":\"run;\",\"version\":\""
              + opened.replaceFirst(".*\"version\":\"(\\w+)\".*", "$1")
              + "\"}";
      page.send(save);
      assertTrue(page.await("\"id\":3,").contains("\"error\":\"\",\"version\":"));
      assertEquals("run;", Files.readString(folder.resolve("walk.u")));
      other.send(save);
      assertTrue(other.await("\"id\":3,").contains("walk.u has been changed meanwhile"));
      page.send("{\"type\":\"open\",\"id\":4,\"name\":\"../x.u\"}");
      assertTrue(page.await("\"id\":4,").contains("only files below the directory"));
      String rest =
          "\",\"version\":\"\",\"text\":\"" + "x".repeat(Request.LONGEST_CODE + 1) + "\"}";
      page.send("{\"type\":\"save\",\"id\":5,\"name\":\"long.u" + rest);
      assertTrue(page.await("\"id\":5,").contains("text: at most 131072 characters, not 131073"));
      page.send("{\"type\":\"files\",\"id\":6}");
      assertTrue(page.await("\"id\":6,").contains("\"files\":[\"walk.u\"]"));
    }
  }

  @Test
  void allAreToldToWhichFileVariablesAreRecorded() throws Exception {
    try (Browser page = new Browser(studio, "")) {
      page.await("{\"type\":\"recording\",\"file\":\"\"");
      RECORDED.begin(Path.of("run.mcap"));
      page.await("{\"type\":\"recording\",\"file\":\"run.mcap\"");
      try (Browser later = new Browser(studio, "")) {
        later.await("{\"type\":\"recording\",\"file\":\"run.mcap\"");
      }
      RECORDED.end();
      page.await("{\"type\":\"recording\",\"file\":\"\"");
    }
  }

  @Test
  void reactionsAreToldOnlyToThoseWhoWantThem() throws Exception {
    kernel.eval("wanted: at (true && 1 == 2) 1|");
    try (Browser page = new Browser(studio, "")) {
      assertFalse(page.await("\"complete\":true").contains("\"reactions\""));
      page.send("{\"type\":\"reactions\",\"filter\":\"1 == 2\"}");
      assertTrue(page.await("\"reactions\"").contains("at (true && 1 == 2) 1"));
      page.send("{\"type\":\"reactions\"}");
      page.await(message -> !message.contains("\"reactions\""));
    } finally {
      kernel.eval("wanted.stop");
    }
  }

  @Test
  void floodsEndOnlyTheirOwnConnection() throws Exception {
    try (Browser good = new Browser(studio, "");
        Browser bad = new Browser(studio, "")) {
      bad.await("\"hello\"");
      try {
        for (int i = 0; i < 500; i++) {
          bad.send("{}");
        }
      } catch (RuntimeException e) {
        // It has been closed meanwhile.
      }
      bad.await("too many requests");
      bad.await("closed"::equals);
      assertEquals("too many requests: at most 40 in a second", bad.reason);
      good.heard.clear();
      good.await("\"complete\":true");
    }
  }

  @Test
  void halfRequestsAndSlowReadersLockNobodyOut() throws Exception {
    List<Socket> halves = new ArrayList<>();
    try (Browser page = new Browser(studio, "");
        Socket slow = new Socket(InetAddress.getLoopbackAddress(), studio.port())) {
      // It never reads what it is sent.
      slow.getOutputStream().write(HANDSHAKE.getBytes(StandardCharsets.ISO_8859_1));
      for (int i = 0; i < 100; i++) {
        Socket half = new Socket(InetAddress.getLoopbackAddress(), studio.port());
        half.getOutputStream().write("GET / HT".getBytes(StandardCharsets.ISO_8859_1));
        halves.add(half);
      }
      for (int i = 0; i < 5; i++) {
        kernel.eval("many: for& (2000) sleep(100ms)");
      }
      page.heard.clear();
      page.await("\"complete\":true");
      assertTrue(get("/", HOST).startsWith("HTTP/1.1 200"));
    } finally {
      for (Socket half : halves) {
        half.close();
      }
    }
  }

  @Test
  void tokensGiveRoles() throws Exception {
    Tokens tokens = Tokens.single("0123456789abcdef", Role.OBSERVER, "visitor");
    try (StudioServer guarded = serve(new AccessPolicy(tokens, null));
        Browser without = new Browser(guarded, "")) {
      assertTrue(guarded.url().endsWith("/?token=TOKEN"), guarded.url());
      assertTrue(without.await("\"refused\"").contains("put ?token=TOKEN behind the address"));
      without.await("closed"::equals);
      try (Browser observer = new Browser(guarded, "?token=0123456789abcdef")) {
        assertTrue(observer.await("\"hello\"").contains("\"role\":\"observer\""));
        kernel.eval("guarded: detach(sleep(1h))|");
        String view = observer.await("\"name\":\"guarded\"");
        String number = view.replaceFirst("(?s).*\"number\":(\\d+),\"name\":\"guarded\".*", "$1");
        observer.send(
            "{\"type\":\"steer\",\"id\":1,\"action\":\"stop\",\"kind\":\"tag\",\"target\":"
                + number
                + "}");
        assertTrue(observer.await("\"done\"").contains("needs the role owner"));
        kernel.eval("guarded.stop");
        observer.send(code("run", 2, "echo(1)"));
        assertTrue(observer.await("\"id\":2,\"error\"").contains("needs the role user"));
        observer.send("{\"type\":\"open\",\"id\":3,\"name\":\"walk.u\"}");
        assertTrue(observer.await("\"id\":3,").contains("the role observer has no files"));
        observer.send(
            "{\"type\":\"save\",\"id\":4,\"name\":\"x.u\",\"text\":\"1\",\"version\":\"\"}");
        assertTrue(observer.await("\"id\":4,").contains("the role observer has no files"));
        kernel.eval("var Global.kept = 3|");
        observer.send("{\"type\":\"variables\",\"objects\":[\"Global\"]}");
        observer.await("\"name\":\"kept\"");
        observer.send(
            "{\"type\":\"assign\",\"id\":5,\"way\":\"Global\\n.kept\",\"value\":\"Global.kept = 7\"}");
        assertTrue(observer.await("\"id\":5,").contains("needs the role owner"));
        assertEquals(3.0, kernel.eval("Global.kept"));
      }
      try (Browser wrong = new Browser(guarded, "?token=fedcba9876543210")) {
        assertTrue(wrong.await("\"refused\"").contains("wrong token"));
      }
    }
  }

  /** Tells a browser whether it may intervene, and repeats what it says. */
  private static final class Echo extends SimpleChannelInboundHandler<TextWebSocketFrame> {
    private final String refusal;

    Echo(String refusal) {
      this.refusal = refusal;
    }

    @Override
    public void userEventTriggered(ChannelHandlerContext context, Object event) {
      context.writeAndFlush(new TextWebSocketFrame("refusal: " + refusal));
    }

    @Override
    protected void channelRead0(ChannelHandlerContext context, TextWebSocketFrame frame) {
      context.writeAndFlush(frame.retain());
    }
  }

  @Test
  void pagesOfComponentsAreServedByRole() throws Exception {
    Annexes annexes = Annexes.of(kernel);
    Page files = new Page(StudioServer.class, 1000, 10, new WriteBufferWaterMark(1 << 16, 1 << 18));
    try (Browser looks = new Browser(studio, "")) {
      looks.await("{\"type\":\"worlds\",\"worlds\":[]}");
      annexes.put("robot", new Annex("A robot", files, Echo::new));
      looks.await("\"worlds\":[{\"name\":\"robot\",\"title\":\"A robot\"}]");
      String page = get("/annex/robot/", HOST);
      assertTrue(page.contains("frame-ancestors 'self'"), page);
      assertTrue(get("/", HOST).contains("frame-ancestors 'none'"));
      assertTrue(get("/annex/robot/studio.js", HOST).startsWith("HTTP/1.1 200"));
      for (String path : List.of("/annex/nobody/", "/annex/robot/../x.js", "/annex/robot/x.js")) {
        assertTrue(get(path, HOST).matches("(?s)HTTP/1.1 40[0-9].*"), path);
      }
      assertTrue(get("/annex/robot/stream", UPGRADE).startsWith("HTTP/1.1 403"));
      comeByRole();
      annexes.remove("robot");
      looks.await("{\"type\":\"worlds\",\"worlds\":[]}");
    }
  }

  private static void comeByRole() throws Exception {
    Tokens tokens = Tokens.single("0123456789abcdef", Role.OBSERVER, "visitor");
    try (StudioServer guarded = serve(new AccessPolicy(tokens, Role.OWNER));
        StreamClient owner = new StreamClient(guarded, "/annex/robot/stream");
        StreamClient observer =
            new StreamClient(guarded, "/annex/robot/stream?token=0123456789abcdef");
        StreamClient wrong = new StreamClient(guarded, "/annex/robot/stream?token=nonsense")) {
      owner.await("refusal: "::equals);
      owner.send("hello");
      owner.await("hello"::equals);
      observer.await("refusal: You are an observer, who sees and cannot change."::equals);
      wrong.await("closed"::equals);
      assertEquals(4003, wrong.status);
    }
  }
}
