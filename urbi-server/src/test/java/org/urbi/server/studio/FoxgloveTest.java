package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;

/** What programs that speak Foxglove's protocol are answered at the studio's port. */
class FoxgloveTest {
  private static final String PROTOCOL = "foxglove.sdk.v1";
  private static final String FRIEND = "https://friend.example";

  /** Waits for that, for ten seconds at most. */
  private static final String NOBODY_IS_CALLED =
      """
      var tries = 0|;
      while (!System.jobs.filter(function (var j) { j.name.split("_").front == "called" }).empty && tries < 500)
      {
        tries++;
        sleep(20ms);
      };
      tries < 500;
      """;

  private static Kernel kernel;
  private static StudioServer studio;

  @BeforeAll
  static void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    kernel.eval(
        """
        var Global.ball = Object.new|;
        UVar.new(ball, "x")|; ball.x = 1|;
        UVar.new(ball, "text")|; ball.text = "a"|;
        UVar.new(ball, "picture")|; ball.picture = Binary.new("rgb 1 1", "abc")|;
        var Global.seen = Event.new|; var Global.payload = nil|;
        at (seen?(var p)) Global.payload = p;
        """);
    studio = serve(AccessPolicy.ALL);
  }

  @AfterAll
  static void stop() {
    assertEquals(3.0, kernel.eval("1 + 2"));
    studio.close();
    kernel.close();
  }

  private static StudioServer serve(AccessPolicy policy) throws IOException {
    return Served.of(kernel, policy, new Shown(List.of(), Set.of(FRIEND)), Folders.NONE);
  }

  /**
   * A program's end of the stream. A binary message is heard as the number of its subscription and
   * its text. In what is sent and awaited, ' stands for ".
   */
  private static final class Program extends StreamClient {
    private final ByteArrayOutputStream pieces = new ByteArrayOutputStream();

    /** The last message, as it was written. */
    private volatile byte[] message = {};

    Program(StudioServer studio, String query, String protocol) {
      super(studio, "/" + query, protocol);
    }

    Program() {
      this(studio, "", PROTOCOL);
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
      byte[] piece = new byte[data.remaining()];
      data.get(piece);
      pieces.writeBytes(piece);
      if (last) {
        ByteBuffer in = ByteBuffer.wrap(pieces.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
        pieces.reset();
        if (in.get() == 1) {
          int subscription = in.getInt();
          assertTrue(in.getLong() > 1_600_000_000_000_000_000L, "nanoseconds since the Epoch");
          message = new byte[in.remaining()];
          in.duplicate().get(message);
          heard.add(subscription + ": " + StandardCharsets.UTF_8.decode(in));
        } else if (in.get(0) == 3) {
          int call = in.getInt(5);
          in.position(13 + in.getInt(9));
          heard.add("call " + call + ": " + StandardCharsets.UTF_8.decode(in));
        }
      }
      from.request(1);
      return null;
    }

    @Override
    void send(String text) {
      super.send(text.replace('\'', '"'));
    }

    @Override
    String await(String part) throws InterruptedException {
      return super.await(part.replace('\'', '"'));
    }

    void send(byte[] bytes) {
      socket.sendBinary(ByteBuffer.wrap(bytes), true).join();
    }

    /** A message to one of its own channels. */
    void publish(int channel, String json) {
      byte[] content = json.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
      ByteBuffer frame = ByteBuffer.allocate(5 + content.length).order(ByteOrder.LITTLE_ENDIAN);
      frame.put((byte) 1).putInt(channel).put(content);
      send(frame.array());
    }

    /** Calls a service. */
    void call(int service, int call, String encoding, String json) {
      byte[] form = encoding.getBytes(StandardCharsets.UTF_8);
      byte[] content = json.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
      ByteBuffer frame =
          ByteBuffer.allocate(13 + form.length + content.length).order(ByteOrder.LITTLE_ENDIAN);
      frame.put((byte) 2).putInt(service).putInt(call).putInt(form.length).put(form).put(content);
      send(frame.array());
    }

    /** The number of the channel of that topic. */
    int channel(String topic) throws InterruptedException {
      String message = await("'topic':'" + topic + "'");
      Matcher channel =
          Pattern.compile("\"id\":(\\d+),\"topic\":\"" + topic + "\"").matcher(message);
      assertTrue(channel.find(), message);
      return Integer.parseInt(channel.group(1));
    }
  }

  @Test
  void bothProtocolsAreSpoken() throws Exception {
    for (String protocol : List.of("foxglove.websocket.v1", PROTOCOL)) {
      try (Program program = new Program(studio, "", protocol)) {
        assertEquals(protocol, program.socket.getSubprotocol());
        assertTrue(program.await("'serverInfo'").contains("\"clientPublish\""));
        int x = program.channel("/ball/x");
        program.send("{'op':'subscribe','subscriptions':[{'id':7,'channelId':" + x + "}]}");
        program.await("7: {'value':");
        kernel.eval("ball.x = 42|");
        program.await("7: {'value':42.0}");
        program.send("{'op':'unsubscribe','subscriptionIds':[7]}");
        program.send("{'op':'getParameters','parameterNames':['ball.x'],'id':'a'}");
        program.await("'parameters':[{'name':'ball.x','value':42.0,'type':'float64'}],'id':'a'");
      }
    }
  }

  /** A number that is nil is no message of ROS: it is left out, and those behind it are told. */
  @Test
  void messagesOfRosAreToldToWhoAsksForThem() throws Exception {
    try (Program program = new Program(studio, "?messages=ros2", PROTOCOL)) {
      String channels = program.await("'topic':'/ball/x'");
      assertTrue(
          channels.contains(
              "\"topic\":\"/ball/x\",\"encoding\":\"cdr\",\"schemaName\":\"urbi/msg/Number\","
                  + "\"schema\":\"float64 value\\n\",\"schemaEncoding\":\"ros2msg\""),
          channels);
      Matcher channel = Pattern.compile("\"id\":(\\d+),\"topic\":\"/ball/x\"").matcher(channels);
      assertTrue(channel.find(), channels);
      program.send(
          "{'op':'subscribe','subscriptions':[{'id':7,'channelId':" + channel.group(1) + "}]}");
      program.await("7: ");
      kernel.eval("ball.x = nil|; ball.x = 43|");
      byte[] wanted =
          ByteBuffer.allocate(12)
              .order(ByteOrder.LITTLE_ENDIAN)
              .put(new byte[] {0, 1, 0, 0})
              .putDouble(43)
              .array();
      while (!Arrays.equals(wanted, program.message)) {
        program.await("7: ");
      }
    }
  }

  @Test
  void unknownKindOfMessagesIsToldAndTheyAreJson() throws Exception {
    try (Program program = new Program(studio, "?messages=xml", PROTOCOL)) {
      program.await("messages: json or ros2 expected, not xml; they are json");
      assertTrue(program.await("'topic':'/ball/x'").contains("\"urbi.Number\""));
    }
  }

  @Test
  void imagesAreJpegFiles() throws Exception {
    try (Program program = new Program()) {
      int picture = program.channel("/ball/picture");
      program.send("{'op':'subscribe','subscriptions':[{'id':1,'channelId':" + picture + "}]}");
      String message = program.await("1: {");
      assertTrue(
          message.contains("\"format\":\"jpeg\"") && message.contains("\"data\":\"/9j/"), message);
      kernel.eval("ball.picture = Binary.new(\"rgb 100 100\", \"too short\")|");
      program.await("'data':''");
      kernel.eval("ball.picture = Binary.new(\"rgb 1 1\", \"abc\")|");
    }
  }

  @Test
  void parametersAreSetAndToldWhenTheyChange() throws Exception {
    try (Program program = new Program();
        Program other = new Program()) {
      other.channel("/ball/x");
      other.send("{'op':'subscribeParameterUpdates','parameterNames':['ball.x']}");
      program.channel("/ball/x");
      program.send(
          "{'op':'setParameters','id':'s','parameters':[{'name':'ball.x','value':3},"
              + "{'name':'none','value':1}]}");
      program.await("none: no such slot: none");
      program.await("{'name':'ball.x','value':3.0,'type':'float64'},{'name':'none'}],'id':'s'");
      other.await("'parameters':[{'name':'ball.x','value':3.0");
      other.send("{'op':'unsubscribeParameterUpdates','parameterNames':['ball.x']}");
    }
  }

  @Test
  void whatIsPublishedIsAssignedOrEmitted() throws Exception {
    try (Program program = new Program()) {
      program.send(
          "{'op':'advertise','channels':[{'id':1,'topic':'/seen','encoding':'json'},"
              + "{'id':2,'topic':'/ball/x','encoding':'json'},"
              + "{'id':3,'topic':'/x','encoding':'ros1'},{'id':1,'topic':'/y','encoding':'json'}]}");
      program.await("encoding: json expected, not ros1");
      program.await("there is a channel of that number: 1");
      program.publish(1, "{'value':['hello']}");
      program.publish(2, "{'value':8}");
      program.publish(2, "no JSON");
      program.await("no JSON: ");
      program.publish(3, "{}");
      program.await("no such channel of yours: 3");
      program.send("{'op':'unadvertise','channelIds':[2,9]}");
      program.await("no such channel of yours: 9");
      assertEquals("hello", kernel.eval("waituntil (payload); payload"));
      assertEquals(8.0, kernel.eval("waituntil (ball.x == 8); ball.x"));
    }
  }

  @Test
  void whatMakesNoSenseIsAnsweredAndDoesNothing() throws Exception {
    try (Program program = new Program()) {
      int x = program.channel("/ball/x");
      List<List<String>> mistakes =
          List.of(
              List.of("{", "no JSON: "),
              List.of("[1]", "a JSON object expected"),
              List.of("{} {}", "one JSON object expected"),
              List.of("{'op':'dance'}", "op: not offered by this server: dance"),
              List.of("{'op':'fetchAsset'}", "op: not offered by this server: fetchAsset"),
              List.of("{'op':'subscribe'}", "subscriptions: a list expected"),
              List.of("{'op':'subscribe','subscriptions':[1]}", "subscriptions: objects expected"),
              List.of(
                  "{'op':'subscribe','subscriptions':[{'id':1.5,'channelId':1}]}",
                  "id: a whole number expected"),
              List.of(
                  "{'op':'subscribe','subscriptions':[{'id':1,'channelId':99999}]}",
                  "no such channel: 99999"),
              List.of(
                  "{'op':'subscribe','subscriptions':[{'id':1,'channelId':1e15}]}",
                  "no such channel: 1000000000000000"),
              List.of("{'op':'unsubscribe','subscriptionIds':[5]}", "no such subscription: 5"),
              List.of("{'op':'getParameters','parameterNames':[1]}", "parameterNames: strings"),
              List.of("{'op':'setParameters','parameters':[{'name':'ball.x'}]}", "value: expected"),
              List.of("[".repeat(1000), "a JSON object expected"),
              List.of("{'a':" + "[".repeat(1000), "no JSON: "),
              List.of("{'a':" + "9".repeat(100) + "}", "no JSON: "));
      for (List<String> mistake : mistakes) {
        program.send(mistake.getFirst());
        String error = program.await("'status','level':2");
        assertTrue(error.contains(mistake.getLast()), mistake.getFirst() + " -> " + error);
      }
      program.send(new byte[] {1, 2});
      program.await("a message to a channel of yours expected");
      program.send(new byte[] {9, 0, 0, 0, 0, 1});
      program.await("a message to a channel of yours expected");
      // One that makes sense is heard beside one that does not.
      program.send(
          "{'op':'subscribe','subscriptions':[{'id':1,'channelId':99999},{'id':2,'channelId':"
              + x
              + "}]}");
      program.await("no such channel: 99999");
      program.await("2: {'value':");
    }
  }

  @Test
  void floodsAndLongMessagesEndOnlyTheirOwnConnection() throws Exception {
    try (Program good = new Program();
        Program bad = new Program();
        Program longWinded = new Program()) {
      bad.await("'serverInfo'");
      try {
        for (int i = 0; i < 5000; i++) {
          bad.send("{'op':'getParameters','parameterNames':['ball.x']}");
        }
      } catch (RuntimeException e) {
        // It has been closed meanwhile.
      }
      bad.await("too many requests");
      longWinded.await("'serverInfo'");
      longWinded.send("x".repeat(300_000));
      assertThrows(AssertionError.class, () -> longWinded.await("never"));
      good.channel("/ball/x");
      good.send("{'op':'getParameters','parameterNames':['ball.x'],'id':'still'}");
      good.await("'id':'still'");
    }
  }

  private static final String UPGRADE =
      "GET / HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
          + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
          + "Sec-WebSocket-Protocol: other, "
          + PROTOCOL
          + "\r\n";

  /** The first line that is answered to the handshake of a page of that site. */
  private static String handshake(String origin) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), studio.port())) {
      String request = UPGRADE + (origin.isEmpty() ? "" : "Origin: " + origin + "\r\n") + "\r\n";
      socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
      return new String(socket.getInputStream().readNBytes(12), StandardCharsets.US_ASCII);
    }
  }

  @Test
  void pagesOfOtherSitesNeedPermission() throws Exception {
    assertEquals("HTTP/1.1 101", handshake(""));
    assertEquals("HTTP/1.1 101", handshake(FRIEND));
    assertEquals("HTTP/1.1 403", handshake("https://elsewhere.example"));
    assertEquals("HTTP/1.1 403", handshake("null"));
  }

  @Test
  void programThatDoesNotReadLosesValuesAndDelaysNobody() throws Exception {
    try (Socket slow = new Socket(InetAddress.getLoopbackAddress(), studio.port());
        Program program = new Program()) {
      int channel = program.channel("/ball/text");
      slow.getOutputStream().write((UPGRADE + "\r\n").getBytes(StandardCharsets.US_ASCII));
      slow.getInputStream().readNBytes(12);
      String text =
          "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":5,\"channelId\":"
              + ownChannel(slow)
              + "}]}";
      byte[] frame = new byte[6 + text.length()];
      frame[0] = (byte) 0x81;
      frame[1] = (byte) (0x80 | text.length());
      System.arraycopy(text.getBytes(StandardCharsets.US_ASCII), 0, frame, 6, text.length());
      slow.getOutputStream().write(frame);
      program.send("{'op':'subscribe','subscriptions':[{'id':5,'channelId':" + channel + "}]}");
      program.await("5: {");
      // More than the buffers of a connection hold.
      kernel.eval("var big = \"x\" * 1000|; for (var i: 30000) { ball.text = big };");
      kernel.eval("ball.text = \"last\"|");
      // The other program may have lost some as well, but not the last one.
      program.await("5: {'value':'last'}");
      assertTrue(text(slow.getInputStream(), "values were left out"), "it is told");
    }
  }

  private static int ownChannel(Socket slow) throws IOException {
    InputStream in = slow.getInputStream();
    StringBuilder heard = new StringBuilder();
    Pattern wanted = Pattern.compile("\"id\":(\\d+),\"topic\":\"/ball/text\"");
    while (true) {
      heard.append((char) in.read());
      Matcher found = wanted.matcher(heard);
      if (heard.charAt(heard.length() - 1) == '}' && found.find()) {
        return Integer.parseInt(found.group(1));
      }
    }
  }

  /** Whether that text comes before the end. */
  private static boolean text(InputStream in, String wanted) throws IOException {
    int matched = 0;
    for (int next = in.read(); next >= 0; next = in.read()) {
      matched = next == wanted.charAt(matched) ? matched + 1 : 0;
      if (matched == wanted.length()) {
        return true;
      }
    }
    return false;
  }

  @Test
  void tokensGiveRoles() throws Exception {
    Tokens tokens = Tokens.single("0123456789abcdef", Role.OBSERVER, "visitor");
    try (StudioServer guarded = serve(new AccessPolicy(tokens, null));
        Program without = new Program(guarded, "", PROTOCOL)) {
      without.await("put ?token=TOKEN behind the address");
      without.await("closed");
      try (Program observer = new Program(guarded, "?token=0123456789abcdef", PROTOCOL)) {
        String info = observer.await("'serverInfo'");
        assertTrue(info.contains("\"role\":\"observer\"") && !info.contains("clientPublish"), info);
        observer.channel("/ball/x");
        observer.send("{'op':'setParameters','parameters':[{'name':'ball.x','value':3}]}");
        observer.await("needs the role user");
        assertTrue(!info.contains("services"), info);
        observer.call(1, 1, "json", "{'function':'ball.setSlot','arguments':['x',3]}");
        assertTrue(observer.await("'callId':1").contains("needs the role user"));
      }
      try (Program wrong = new Program(guarded, "?token=fedcba9876543210", PROTOCOL)) {
        wrong.await("wrong token");
      }
    }
  }

  @Test
  void functionsAreCalled() throws Exception {
    kernel.eval(
        """
        function Global.sum(a, b) { sleep(10ms) | a + b }|;
        function ball.twice() { [x * 2, nil, Object] }|;
        function Global.wait() { sleep(1h) }|;
        """);
    try (Program program = new Program()) {
      program.await("{'id':1,'name':'/call','type':'urbi.Call'");
      program.call(1, 7, "json", "{'function':'sum','arguments':[1,2.5]}");
      program.await("call 7: {'value':3.5}");
      program.call(1, 8, "json", "{'function':'sum','arguments':['ü','x']}");
      program.await("call 8: {'value':'üx'}");
      program.call(1, 9, "json", "{'function':'ball.twice'}");
      assertTrue(program.await("call 9: ").contains(",null,\"Object\"]"));
      program.call(1, 10, "json", "{'function':'sum','arguments':[1]}");
      program.await("'callId':10,'message':'sum: expected 2 arguments, given 1");
      program.call(1, 11, "json", "{'function':'nobody.there'}");
      program.await("'callId':11,'message':'no such slot: nobody.there");
      program.call(1, 12, "json", "{'function':3}");
      program.await("'callId':12,'message':'function: the path of a slot expected");
      program.call(1, 13, "json", "{'function':'sum','arguments':3}");
      program.await("'callId':13,'message':'arguments: a list expected");
      program.call(1, 14, "json", "nonsense");
      program.await("'callId':14,'message':'no JSON");
      program.call(1, 15, "ros1", "");
      program.await("'callId':15,'message':'encoding: json expected, not ros1");
      program.call(2, 16, "json", "{}");
      program.await("'serviceId':2,'callId':16,'message':'no such service: 2");
      program.send(new byte[] {2, 1, 0, 0, 0, 1, 0, 0, 0, -1, -1, -1, -1});
      program.await("'callId':1,'message':'encoding: longer than the message");
      program.send(new byte[] {2, 1});
      program.await("a call of a service expected");
      program.call(1, 17, "json", "{'function':'wait'}");
      program.call(1, 18, "json", "{'function':'sum','arguments':[4,5]}");
      program.await("call 18: {'value':9.0}");
    }
    assertEquals(true, kernel.eval(NOBODY_IS_CALLED), "what was called has ended with its caller");
  }

  @Test
  void jobsAreToldWhenTheyChange() throws Exception {
    try (Program program = new Program()) {
      int jobs = program.channel("/jobs");
      program.send("{'op':'subscribe','subscriptions':[{'id':3,'channelId':" + jobs + "}]}");
      program.await("3: {'total':");
      kernel.eval(
          "var Global.busy = Tag.new(\"busy\")|; detach({busy: waituntil (ball.x == 1h)})|;");
      String told = program.await("'busy']");
      assertTrue(told.contains("\"waits\":\"condition\",\"frozen\":false"), told);
      program.send("{'op':'subscribe','subscriptions':[{'id':4,'channelId':" + jobs + "}]}");
      program.await("4: {'total':");
      kernel.eval("busy.freeze");
      program.await("'frozen':true");
      program.send("{'op':'unsubscribe','subscriptionIds':[3,4]}");
      kernel.eval("busy.stop");
      program.send("{'op':'subscribe','subscriptions':[{'id':5,'channelId':" + jobs + "}]}");
      assertTrue(!program.await("5: {'total':").contains("\"busy\""), "it has ended");
    }
  }

  @Test
  void whatIsNoProgramOfThisKindIsNoGuest() {
    assertThrows(CompletionException.class, () -> new Program(studio, "", "chat").close());
  }
}
