package org.urbi.ros.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.ros.Awaited;
import org.urbi.ros.Lines;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.two.TwoNode;
import org.urbi.ros.two.TwoSettings;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** A node of ROS 2, its clients of rosbridge, and those who are none. */
class BridgeTest {
  private static final Path PEERS = Path.of("../.build/ros-peers").toAbsolutePath().normalize();
  private static final Path ORACLES = Path.of("src/test/oracles").toAbsolutePath();

  /** Where test_msgs are. */
  private static final Path TYPES =
      Path.of("src/test/resources/org/urbi/ros").toAbsolutePath().normalize();

  /** What a page sees of arrays that come in CBOR. */
  private static final List<String> SHAPES =
      List.of(
          "cbor bool Array false,true,false",
          "cbor byte Uint8Array 0,1,255",
          "cbor char Uint8Array 0,1,127",
          "cbor float32 Float32Array 1.125,0,-1.125",
          "cbor float64 Float64Array 3.1415,0,-3.1415",
          "cbor int8 Int8Array 0,127,-128",
          "cbor uint8 Uint8Array 0,1,255",
          "cbor int16 Int16Array 0,32767,-32768",
          "cbor uint16 Uint16Array 0,1,65535",
          "cbor int32 Int32Array 0,2147483647,-2147483648",
          "cbor uint32 Uint32Array 0,1,4294967295",
          "cbor int64 BigInt64Array 0,9223372036854775807,-9223372036854775808",
          "cbor uint64 BigUint64Array 0,1,18446744073709551615",
          "cbor string Array ,max value,min value",
          "cbor [{\"bool_value\":true,\"byte_value\":0,\"char_value\":0,\"float32_value\":0,"
              + "\"float64_value\":0.5,\"int8_value\":0,\"uint8_value\":0,\"int16_value\":-300,"
              + "\"uint16_value\":0,\"int32_value\":0,\"uint32_value\":0,\"int64_value\":-24,"
              + "\"uint64_value\":1099511627776}]");

  private static final String KEY = "dGhlIHNhbXBsZSBub25jZQ==";
  private static final String TOKEN = "a token that is long enough";
  private static final BlockingQueue<String> told = new LinkedBlockingQueue<>();
  private static final BlockingQueue<String> said = new LinkedBlockingQueue<>();
  private static Neighbourhood domain;
  private static TwoNode node;
  private static final BlockingQueue<ActionServer.Goal> given = new LinkedBlockingQueue<>();
  private static final BlockingQueue<ActionServer.Goal> cancelled = new LinkedBlockingQueue<>();
  private static ServiceType setBool;
  private static ActionType fibonacci;
  private static BridgeServer bridge;
  private static BridgeServer guarded;

  @BeforeAll
  static void open() throws IOException {
    domain = new Neighbourhood();
    Map<String, String> environment =
        Map.of("ROS_DOMAIN_ID", "" + domain.domain(), "AMENT_PREFIX_PATH", TYPES.toString());
    node = TwoNode.start(TwoSettings.of(environment, "bridge", Map.of()), told::add);
    bridge = BridgeServer.open(node, "localhost", 0, Set.of("https://good.example"), "", told::add);
    guarded = BridgeServer.open(node, "localhost", 0, Set.of(), TOKEN, told::add);
    MessageType string = node.definitions().message("std_msgs/String");
    Publisher chatter =
        node.advertise("/chatter", string, Qos.LATCHED, new Publisher.Listener() {});
    chatter.publish(Templates.of(string).with("data", "hel\"lo\n\u00e4\u20ac"));
    publishShapes();
    setBool = node.definitions().service("std_srvs/SetBool");
    node.serve(
        "/flip",
        setBool,
        request ->
            CompletableFuture.completedFuture(
                Templates.of(setBool.response())
                    .with("success", request.get("data").doubleValue() == 0)
                    .with("message", "flipped")));
    fibonacci = node.definitions().action("test_msgs/Fibonacci");
    node.actions().serve("/count", fibonacci, new Counting());
    node.subscribe(
        "/said", string, Qos.DEFAULT, message -> said.add(message.get("data").stringValue()));
  }

  private static void publishShapes() {
    MessageType shapes = node.definitions().message("test_msgs/UnboundedSequences");
    UDictionary basic =
        Templates.of(node.definitions().message("test_msgs/BasicTypes"))
            .with("bool_value", true)
            .with("float64_value", 0.5)
            .with("int16_value", -300)
            .with("int64_value", -24)
            .with("uint64_value", 1L << 40);
    UDictionary message = Templates.of(shapes);
    message.put("basic_types_values", new UValue(UList.of(new UValue(basic))));
    node.advertise("/shapes", shapes, Qos.LATCHED, new Publisher.Listener() {}).publish(message);
  }

  private static UDictionary sequence(double... numbers) {
    UList list = new UList();
    for (double each : numbers) {
      list.add(new UValue(each));
    }
    return new UDictionary().with("sequence", new UValue(list));
  }

  /** Reaches goals below 100 at once; of others it only tells how far it is. */
  private static final class Counting implements ActionServer.Handler {
    @Override
    public CompletionStage<Boolean> goal(ActionServer.Goal goal) {
      double order = goal.request().get("order").doubleValue();
      CompletableFuture<Boolean> accepted = CompletableFuture.completedFuture(order >= 0);
      accepted.thenAcceptAsync(good -> {
        if (!good) {
          return;
        }
        goal.feedback(sequence(0));
        given.add(goal);
        if (order < 100) {
          goal.end(GoalStatus.SUCCEEDED, sequence(0, order));
        }
      });
      return accepted;
    }

    @Override
    public void cancel(ActionServer.Goal goal) {
      cancelled.add(goal);
      goal.end(GoalStatus.CANCELED, sequence(7));
    }
  }

  @AfterAll
  static void close() throws IOException {
    bridge.close();
    guarded.close();
    node.close();
    domain.close();
  }

  // ------------------------------------------------------------------ those who are meant

  private static void talks(Consumer<List<String>> more, String... command) throws Exception {
    assumeTrue(Files.exists(Path.of(command[0])), "no client: scripts/ros-peers.sh gets it");
    Process client =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    try {
      Lines lines = new Lines(client.inputReader(StandardCharsets.UTF_8));
      List<String> all = new ArrayList<>();
      while (all.isEmpty() || !all.getLast().equals("ready")) {
        all.add(lines.next());
      }
      assertEquals("topic std_msgs/msg/String", all.get(0));
      assertEquals("services true", all.get(1).toLowerCase(java.util.Locale.ROOT));
      assertEquals("none hel\"lo", all.get(2));
      assertEquals("png hel\"lo", all.get(4));
      assertEquals("\u00e4\u20ac", all.get(5));
      assertEquals("flip {\"success\":false,\"message\":\"flipped\"}", all.get(6));
      assertTrue(
          all.get(7).contains("date: std_srvs/srv/SetBool_Request has no such field"),
          all::toString);
      assertEquals("goal {\"sequence\":[0,1]} 1", all.get(8));
      assertTrue(all.get(9).endsWith(" 2") && all.get(9).contains("7"), all.get(9));
      assertTrue(all.get(10).contains("/count refuses the goal"), all.get(10));
      assertEquals("by a page", Awaited.next(said, all));
      try (ServiceClient page = Awaited.value(node.client("/page", setBool, false))) {
        assertEquals(
            "a page",
            Awaited.value(page.request(Templates.of(setBool.request()).with("data", true)))
                .get("message")
                .stringValue());
      }
      more.accept(all);
    } finally {
      client.destroyForcibly().waitFor();
    }
    Awaited.until("the client is gone", () -> bridge.clients() == 0);
  }

  /** A page pursues goals of others. */
  private static void pursues() {
    try (ActionClient client = Awaited.value(node.actions().client("/page_count", fibonacci))) {
      BlockingQueue<UDictionary> steps = new LinkedBlockingQueue<>();
      ActionClient.Listener listener =
          new ActionClient.Listener() {
            @Override
            public void feedback(UDictionary feedback) {
              steps.add(feedback);
            }
          };
      ActionClient.Outcome reached =
          Awaited.value(client.send(new UDictionary().with("order", 3), listener).outcome());
      assertEquals(new ActionClient.Outcome(GoalStatus.SUCCEEDED, sequence(0, 3)), reached);
      assertEquals(
          GoalStatus.ABORTED,
          Awaited.value(client.send(new UDictionary().with("order", -1), listener).outcome())
              .status());
      ActionClient.Goal waiting = client.send(new UDictionary().with("order", 100), listener);
      assertTrue(Awaited.value(waiting.cancel()));
      assertEquals(
          new ActionClient.Outcome(GoalStatus.CANCELED, sequence(7)),
          Awaited.value(waiting.outcome()));
    }
  }

  @Test
  void roslib() throws Exception {
    Path library = PEERS.resolve("roslib");
    assumeTrue(Files.exists(library), "no roslib: scripts/ros-peers.sh gets it");
    talks(
        all -> {
          assertEquals(SHAPES, all.stream().filter(each -> each.startsWith("cbor")).toList());
          assertTrue(
              all.contains("raw 000100000d00000068656c226c6f0ac3a4e282ac00000000 true"),
              all::toString);
          pursues();
        },
        "/usr/bin/node",
        ORACLES.resolve("page.mjs").toString(),
        library.toString(),
        port());
  }

  @Test
  void roslibpy() throws Exception {
    talks(all -> {}, PEERS + "/bridge/bin/python", ORACLES.resolve("page.py").toString(), port());
  }

  private static String port() {
    return String.valueOf(bridge.port());
  }

  // ------------------------------------------------------------------ those who are not

  /** A client that sends what it likes. */
  private static final class Raw implements AutoCloseable {
    final Socket socket;
    final DataInputStream in;
    final OutputStream out;

    Raw(BridgeServer server) throws IOException {
      socket = new Socket("localhost", server.port());
      in = new DataInputStream(socket.getInputStream());
      out = socket.getOutputStream();
    }

    /** The status with which a request is answered. */
    String request(String target, String... headers) throws IOException {
      StringBuilder text = new StringBuilder("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n");
      for (String each : headers) {
        text.append(each).append("\r\n");
      }
      out.write(text.append("\r\n").toString().getBytes(StandardCharsets.ISO_8859_1));
      StringBuilder answer = new StringBuilder();
      while (answer.indexOf("\r\n\r\n") < 0) {
        answer.append((char) in.readByte());
      }
      return answer.substring(9, 12);
    }

    String upgrade(String target, String... more) throws IOException {
      List<String> headers = new ArrayList<>(List.of(more));
      headers.addAll(
          List.of(
              "Upgrade: websocket",
              "Connection: keep-alive, Upgrade",
              "Sec-WebSocket-Version: 13",
              "Sec-WebSocket-Key: " + KEY));
      return request(target, headers.toArray(String[]::new));
    }

    void frame(int first, long length, byte[] payload) throws IOException {
      out.write(
          ByteBuffer.allocate(14 + payload.length)
              .put((byte) first)
              .put((byte) 0xFF)
              .putLong(length)
              .putInt(0)
              .put(payload)
              .array());
    }

    void text(String text) throws IOException {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      frame(0x81, bytes.length, bytes);
    }

    /** The next message; of a good-bye the status. */
    String answer() throws IOException {
      int kind = in.readUnsignedByte() & 0xF;
      int length = in.readUnsignedByte();
      length =
          length == 126 ? in.readUnsignedShort() : length == 127 ? (int) in.readLong() : length;
      byte[] payload = in.readNBytes(length);
      return kind == 8
          ? "closed " + ByteBuffer.wrap(payload).getShort()
          : new String(payload, StandardCharsets.UTF_8);
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  private static void isAnswered(String text, String... parts) throws IOException {
    try (Raw client = new Raw(bridge)) {
      assertEquals("101", client.upgrade("/"));
      client.text(text);
      String answer = client.answer();
      for (String part : parts) {
        assertTrue(answer.contains(part), answer);
      }
    }
  }

  @Test
  void whoIsLetIn() throws IOException {
    for (String origin : List.of("https://evil.example", "null", "http://localhost.evil.example")) {
      try (Raw client = new Raw(bridge)) {
        assertEquals("403", client.upgrade("/", "Origin: " + origin));
      }
    }
    for (String origin :
        List.of("https://good.example", "http://localhost:8080", "http://127.0.0.1")) {
      try (Raw client = new Raw(bridge)) {
        assertEquals("101", client.upgrade("/", "Origin: " + origin));
      }
    }
    try (Raw client = new Raw(bridge)) {
      assertEquals("426", client.request("/"));
    }
    try (Raw client = new Raw(bridge)) {
      client.out.write("1 + 2;\r\n\r\n".getBytes(StandardCharsets.UTF_8));
      assertEquals("HTTP/1.1 400", new String(client.in.readNBytes(12), StandardCharsets.UTF_8));
    }
    try (Raw client = new Raw(guarded)) {
      assertEquals("401", client.upgrade("/?token=wrong"));
    }
    try (Raw client = new Raw(guarded)) {
      assertEquals("101", client.upgrade("/", "Authorization: Bearer " + TOKEN));
    }
    assertThrows(
        RosException.class, () -> BridgeServer.open(node, "0.0.0.0", 0, Set.of(), "", told::add));
    assertThrows(
        RosException.class,
        () -> BridgeServer.open(node, "localhost", 0, Set.of(), "short", told::add));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{\"op\":\"fly\",\"id\":7}|fly: there is no such operation|\"id\":7",
        "{}|'op' is missing|error",
        "[1]|no JSON at character|error",
        "{\"op\":|a value expected|error",
        "{\"op\":\"publish\"}|publish: 'topic' is missing|error",
        "{\"op\":\"publish\",\"topic\":\"/nowhere\",\"msg\":{}}|there is no topic /nowhere|error",
        "{\"op\":\"advertise\",\"topic\":\"/a b\",\"type\":\"std_msgs/String\"}|invalid name|error",
        "{\"op\":\"advertise\",\"topic\":\"/a\",\"type\":\"std_msgs/Strong\"}|no type std_msgs/|error",
        "{\"op\":\"unsubscribe\",\"topic\":\"/a\"}|/a is not subscribed|error",
        "{\"op\":\"call_service\",\"service\":\"/rosapi/fly\",\"id\":\"x\"}|no service /rosapi/fly|\"result\":false",
        "{\"op\":\"call_service\",\"service\":\"/flip\",\"args\":[true,1]}|1 arguments expected|\"result\":false",
        "{\"op\":\"call_service\",\"service\":\"/flip\",\"args\":[\"x\"]}|data: a number expected|\"result\":false",
        "{\"op\":\"call_service\",\"service\":\"/flip\",\"args\":[false]}|flipped|\"result\":true",
        "{\"op\":\"service_response\",\"id\":\"x\"}|nobody waits|error",
        "{\"op\":\"send_action_goal\",\"action\":\"/count\"}|'id' is missing|error",
        "{\"op\":\"send_action_goal\",\"action\":\"/count\",\"id\":\"g\",\"args\":{\"n\":1}}|n: test_msgs/action/Fibonacci_Goal has no such field|\"result\":false",
        "{\"op\":\"send_action_goal\",\"action\":\"/count\",\"id\":\"g\",\"action_type\":\"x/Y\"}|no type x/action/Y|\"status\":0",
        "{\"op\":\"send_action_goal\",\"action\":\"/nowhere\",\"id\":\"g\"}|there is no action /nowhere|\"result\":false",
        "{\"op\":\"send_action_goal\",\"action\":\"/count\",\"id\":\"g\",\"args\":{\"order\":1}}|[0,1]|\"status\":4",
        "{\"op\":\"cancel_action_goal\",\"action\":\"/count\",\"id\":\"g\"}|there is no goal 'g'|error",
        "{\"op\":\"unadvertise_action\",\"action\":\"/count\"}|/count is not offered|error",
        "{\"op\":\"action_feedback\",\"id\":\"g\"}|nobody waits for the goal 'g'|error",
        "{\"op\":\"action_result\",\"id\":\"g\",\"status\":4}|nobody waits for the goal 'g'|error",
        "{\"op\":\"call_service\",\"service\":\"/rosapi/action_servers\"}|/count|\"result\":true",
        "{\"op\":\"set_level\",\"level\":\"loud\"}|info, warning, error, none|error",
        "{\"op\":\"fragment\",\"id\":\"f\",\"num\":3,\"total\":2}|'num' below 'total'|error",
        "{\"op\":\"fragment\",\"id\":\"f\",\"num\":0,\"total\":1,\"data\":\"{}\"}|'op' is missing|error",
      })
  void whatIsWrongIsAnswered(String text, String first, String second) throws IOException {
    isAnswered(text, first, second);
  }

  @Test
  void nestingHasAnEnd() throws IOException {
    isAnswered("{\"op\":" + "[".repeat(100_000), "levels");
  }

  private static void isLetGo(int status, int first, long length, byte[] payload)
      throws IOException {
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      client.frame(first, length, payload);
      assertEquals("closed " + status, client.answer());
    }
  }

  @Test
  void framesThatAreNoneAreRefused() throws IOException {
    isLetGo(1009, 0x81, 1L << 40, new byte[0]);
    isLetGo(1002, 0x81, -1, new byte[0]);
    isLetGo(1002, 0xC1, 0, new byte[0]);
    isLetGo(1002, 0x80, 0, new byte[0]);
    isLetGo(1003, 0x82, 0, new byte[0]);
    isLetGo(1007, 0x81, 1, new byte[] {(byte) 0xFF});
    isLetGo(1002, 0x89, 200, new byte[200]);
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      client.out.write(new byte[] {(byte) 0x81, 1, 'x'});
      assertEquals("closed 1002", client.answer());
    }
  }

  @Test
  void whoGoesInTheMiddleLeavesNothing() throws Exception {
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      client.text(
          "{\"op\":\"advertise_service\",\"service\":\"/gone\",\"type\":\"std_srvs/SetBool\"}");
      client.frame(0x81, 1000, new byte[10]);
      Awaited.until("/gone", () -> Awaited.value(node.graph()).services().containsKey("/gone"));
    }
    Awaited.until(
        "no client, no service",
        () ->
            bridge.clients() == 0 && !Awaited.value(node.graph()).services().containsKey("/gone"));
  }

  @Test
  void halfRequestsLockNobodyOut() throws IOException {
    Deque<Raw> crowd = new ArrayDeque<>();
    try {
      for (int i = 0; i < 100; i++) {
        Raw half = new Raw(bridge);
        crowd.add(half);
        half.out.write("GET / HT".getBytes(StandardCharsets.UTF_8));
      }
      assertEquals(-1, crowd.removeFirst().in.read(), "the first one has made room");
      try (Raw client = new Raw(bridge)) {
        assertEquals("101", client.upgrade("/"));
      }
    } finally {
      for (Raw each : crowd) {
        each.close();
      }
    }
  }

  @Test
  void clientsHaveALimitThatIsTold() throws IOException {
    Deque<Raw> crowd = new ArrayDeque<>();
    try (BridgeServer full = BridgeServer.open(node, "localhost", 0, Set.of(), "", told::add)) {
      for (int i = 0; i < 64; i++) {
        crowd.add(new Raw(full));
        assertEquals("101", crowd.getLast().upgrade("/"));
      }
      crowd.add(new Raw(full));
      assertEquals("503", crowd.getLast().upgrade("/"));
      assertEquals(64, full.clients());
    } finally {
      for (Raw each : crowd) {
        each.close();
      }
    }
  }

  @Test
  void whoGoesWantsNothingAnyMore() throws Exception {
    given.clear();
    cancelled.clear();
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      client.text(
          "{\"op\":\"send_action_goal\",\"action\":\"/count\",\"id\":\"g\",\"args\":{\"order\":500}}");
      Awaited.next(given);
    }
    assertEquals(500, Awaited.next(cancelled).request().get("order").doubleValue());
  }

  @Test
  void whoGoesAbortsTheGoalsThatItPursues() throws Exception {
    CompletableFuture<ActionClient.Outcome> outcome;
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      client.text(
          "{\"op\":\"advertise_action\",\"action\":\"/fleeting\",\"type\":\"test_msgs/Fibonacci\"}");
      ActionClient ours = Awaited.value(node.actions().client("/fleeting", fibonacci));
      outcome =
          ours.send(new UDictionary().with("order", 1), new ActionClient.Listener() {}).outcome();
      String goal = client.answer();
      assertTrue(
          goal.contains("\"op\":\"send_action_goal\"") && goal.contains("\"order\":1"), goal);
      String id = goal.replaceFirst(".*\"id\":\"([^\"]*)\".*", "$1");
      client.text(
          "{\"op\":\"action_feedback\",\"id\":\"" + id + "\",\"values\":{\"sequence\":[1]}}");
    }
    // It is told, or the server has gone before: what is sure is that nobody waits for ever.
    GoalStatus status =
        Awaited.value(
            outcome.handle(
                (ended, failure) -> failure == null ? ended.status() : GoalStatus.ABORTED));
    assertEquals(GoalStatus.ABORTED, status);
  }

  @Test
  void whoDoesNotReadIsLetGo() throws Exception {
    try (Raw client = new Raw(bridge)) {
      client.upgrade("/");
      byte[] flood = "{\"op\":\"x\"}".getBytes(StandardCharsets.UTF_8);
      assertThrows(
          IOException.class,
          () -> {
            while (true) {
              client.frame(0x81, flood.length, flood);
            }
          });
    }
  }
}
