package org.urbi.kernel.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UValue;

/** What a process of the SDK of Urbi 2.7 sends, as it was recorded, and what it is answered. */
class ExternalProcessTest {
  private static final String DECLARATION =
      """
      class %1$s{}|
      external object %1$s|
      external function (0) %1$s.update from %1$s|
      if (!isdef(%1$s.load)) var %1$s.load|
      external var %1$s.load from %1$s|
      %1$s.getSlot("load").update_timed(1, 30246574549)|external function (2) %1$s.add from %1$s|
      if (!isdef(%1$s.a)) var %1$s.a|external var %1$s.a from %1$s|
      ;
      """;

  private static final String BINARY_MODE = "binaryMode(1, \"remotecontext_setmode\");\n";

  /** Somebody at the other end of a connection. */
  private static final class Peer implements Client {
    private final Role role;
    private final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private boolean binary;
    private final Connection connection;

    Peer(Kernel kernel, Role role) {
      this.role = role;
      connection = kernel.connect(this, false);
    }

    @Override
    public void output(String bytes) {
      bytes.lines().map(line -> line.replaceFirst("^\\[\\d{8}", "[")).forEach(heard::add);
    }

    @Override
    public void closed() {
      heard.add("closed");
    }

    @Override
    public void binary() {
      binary = true;
    }

    @Override
    public Role role() {
      return role;
    }

    void send(String bytes) {
      connection.send(bytes);
    }

    String next() throws InterruptedException {
      return heard.take();
    }
  }

  private Kernel kernel;
  private Peer process;
  private Peer console;

  @BeforeEach
  void start() {
    kernel = Kernel.builder().virtualTime(true).log(line -> {}).start();
    process = new Peer(kernel, Role.OWNER);
    console = new Peer(kernel, Role.OWNER);
  }

  @AfterEach
  void end() {
    kernel.close();
  }

  private static String hex(String digits) {
    StringBuilder bytes = new StringBuilder();
    for (String each : digits.strip().split("\\s+")) {
      bytes.append((char) Integer.parseInt(each, 16));
    }
    return bytes.toString();
  }

  /** A message with urbiscript. */
  private static String code(String text) {
    return "\u000b" + (char) (text.length() >> 8) + (char) (text.length() & 0xff) + text;
  }

  private void declareInBinaryMode() throws InterruptedException {
    process.send(DECLARATION.formatted("Dev") + BINARY_MODE);
    assertEquals("[:remotecontext_setmode] true", process.next());
    assertTrue(process.binary);
    process.send(hex("02 04 08 08") + code(";\n"));
  }

  @Test
  void aCallInTextMode() throws InterruptedException {
    process.send(DECLARATION.formatted("Dev") + "1;");
    assertEquals("[] 1", process.next());
    console.send("Dev.add(1, [\"a\", 2.5]);");
    assertEquals(
        "[:__ExternalMessage__] [0, \"Dev.add__2\", \"_1\", 1, [\"a\", 2.5]]", process.next());
    process.send("Global.UObject.funCall(\"_1\", [1, \"q\"]),;");
    assertEquals("[] [1, \"q\"]", console.next());
  }

  /** Neither what has no text, nor what contains itself. */
  @Test
  void valuesThatCannotTravel() throws InterruptedException {
    process.send("var dumb = Object.new| do (dumb) { function asString { 1.dumb } }|;");
    process.send("var endless = []| endless << endless|; 1;");
    assertEquals("[] 1", process.next());
    for (String value : new String[] {"dumb", "endless", "[dumb]"}) {
      process.send("UObject.funCall(\"_1\", " + value + ");");
      String error = process.next();
      assertTrue(error.endsWith(": funCall: this value cannot be sent to a remote process"), error);
      process.send("2;UObject.syncGet(\"" + value + "\", \"tag\"); 3;");
      assertEquals("[] 2", skipTo("[] 2"));
      String answer = process.next();
      assertTrue(answer.startsWith("[:tag] !!! "), answer);
      assertEquals("[] 3", process.next());
    }
  }

  private String skipTo(String line) throws InterruptedException {
    String next = process.next();
    while (!next.equals(line)) {
      next = process.next();
    }
    return next;
  }

  @Test
  void theBytesOfAWriteAndOfAResult() throws InterruptedException {
    declareInBinaryMode();
    console.send("at (Dev.a->changed?(var v)) echo(v);1;");
    assertEquals("[] 1", console.next());
    process.send(
        hex("01 00 05") + "Dev.a" + hex("02 00 00 00 00 00 00 f0 3f 12 34 56 78 00 00 00 07"));
    assertEquals("[] *** 1", console.next());
    console.send("Dev.add(1, 2);");
    assertEquals("[:__ExternalMessage__] [0, \"Dev.add__2\", \"_1\", 1, 2]", process.next());
    process.send(hex("0a 00 02") + "_1" + hex("02 00 00 00 00 00 00 08 40"));
    assertEquals("[] 3", console.next());
  }

  @Test
  void theBytesOfAnEventAndOfAnImage() throws InterruptedException {
    declareInBinaryMode();
    process.send(code("try{var Dev.e2 = Event.new()} catch(var e) {}|"));
    process.send(code("1;"));
    assertEquals("[] 1", process.next());
    console.send("at (Dev.e2?(var x, var y)) echo([x, y]);1;");
    assertEquals("[] 1", console.next());
    process.send(
        hex("02 00 06")
            + "Dev.e2"
            + hex("00 00 00 02 02 00 00 00 00 00 00 14 40 05 00 03")
            + "two");
    assertEquals("[] *** [5, \"two\"]", console.next());
    process.send(
        hex("01 00 05")
            + "Dev.a"
            + hex("00 00 07")
            + "rgb 2 1"
            + hex("00 00 00 06")
            + "abcdef"
            + "\0".repeat(8)
            + code("1;"));
    assertEquals("[] 1", process.next());
    console.send("Dev.a;");
    assertEquals("[] BIN 6 rgb 2 1", console.next());
    assertEquals("abcdef", console.next());
  }

  @Test
  void textThatIsCutGoesOn() throws InterruptedException {
    declareInBinaryMode();
    String name = "n".repeat(8180);
    String text = "var lobby." + name + " = 4|" + name + ";\n";
    process.send(code(text.substring(0, 8192)) + code(text.substring(8192)));
    assertEquals("[] 4", process.next());
  }

  @Test
  void anObjectThatIsNotMadeInTime() throws InterruptedException {
    process.send(DECLARATION.formatted("Dev") + "1;");
    assertEquals("[] 1", process.next());
    console.send("Dev.new(5);");
    assertTrue(process.next().matches("\\[:__ExternalMessage__] \\[4, \"Dev_\\w+\", \"Dev\"]"));
    String answer = console.next();
    assertTrue(answer.contains("has not made the object in 10 s"), answer);
    // What has been made all the same is to go.
    assertTrue(process.next().matches("\\[:__ExternalMessage__] \\[5, \"Dev_\\w+\"]"));
  }

  @Test
  void rtpIsLeftOut() throws InterruptedException {
    process.send("var _rtp_object_name = \"URTP_HOST_1\"|;" + DECLARATION.formatted("Dev"));
    process.send("Dev.getSlot(\"a\").rtp = true|;1;");
    assertEquals("[] 1", process.next());
    console.send("Dev.a = Binary.new(\"raw\", \"abc\");");
    assertTrue(process.next().startsWith("[:__ExternalMessage__] [1, \"Dev.a\", BIN 3 raw"));
  }

  @ParameterizedTest
  @EnumSource(
      value = Role.class,
      names = {"OBSERVER", "USER"})
  void onlyOwnersBringObjects(Role role) throws InterruptedException {
    Peer guest = new Peer(kernel, role);
    guest.send("class Dev{}|external object Dev|;binaryMode(1, \"t\");1;");
    String refusal = guest.next();
    assertTrue(refusal.contains("needs the role owner"), refusal);
    assertFalse(guest.binary);
    guest.connection.close();
  }

  @Test
  void declarationsThatMakeNoSense() throws InterruptedException {
    for (String wrong :
        new String[] {
          "external object Nobody;",
          "external object Dev.a;",
          "external function (2) Nobody.f from Nobody;",
          "external function (2) f from f;",
          "external function (999) Dev.f from Dev;",
          "external function Dev.f from Dev;",
          "external var Nobody.v from Nobody;",
          "external var v from Nobody;",
          "external event (1) Nobody.e from Nobody;",
          "external event (1) Dev.a from Dev;",
          "external nonsense Dev;",
        }) {
      process.send(wrong);
      String error = process.next();
      assertTrue(error.startsWith("[:error] !!! "), wrong + ": " + error);
      assertFalse(error.contains("internal"), wrong + ": " + error);
      while (!error.contains("[] 7")) {
        process.send("7;");
        error = process.next();
      }
    }
  }

  @Test
  void bytesAreReadOnceHoweverTheyCome() throws InterruptedException {
    declareInBinaryMode();
    String keywords = "x".repeat(100);
    String message =
        hex("01 00 05")
            + "Dev.a"
            + hex("03 00 00 00 02 02 00 00 00 00 00 00 f0 3f 00 00 64")
            + keywords
            + hex("00 00 00 03")
            + "abc"
            + "\0".repeat(8)
            + code("Dev.a[1].data;");
    for (char each : message.toCharArray()) {
      process.send(String.valueOf(each));
    }
    assertEquals("[] \"abc\"", process.next());
  }

  @Test
  void aResultIsTakenWhileAStatementWaitsForIt() throws InterruptedException {
    declareInBinaryMode();
    process.send(code("echo(Dev.add(1, 2));"));
    assertEquals("[:__ExternalMessage__] [0, \"Dev.add__2\", \"_1\", 1, 2]", process.next());
    process.send(
        code("echo(\"next\");") + hex("0a 00 02") + "_1" + hex("02 00 00 00 00 00 00 08 40"));
    assertEquals("[] *** 3", process.next());
    assertEquals("[] *** next", process.next());
  }

  @Test
  void keywordsWithALineEndAreNone() throws InterruptedException {
    declareInBinaryMode();
    process.send(hex("01 00 05") + "Dev.a" + hex("00 00 03 61 0a 62 00 00 00 00"));
    assertTrue(process.next().contains("does not keep to the protocol"));
    assertEquals("closed", process.next());
    console.send("Dev;");
    assertTrue(console.next().contains("lookup failed: Dev"));
  }

  @Test
  void valuesAsTheyAreRead() {
    assertEquals("1.0E300", ValueText.of(new UValue(1e300)));
    assertEquals("1099511627776", ValueText.of(new UValue(1099511627776.0)));
    assertEquals("-inf", ValueText.of(new UValue(Double.NEGATIVE_INFINITY)));
    assertEquals("nil", ValueText.of(new UValue()));
    assertEquals("\"a\\n\\\"b\\xc3\\xa9\\x00\"", ValueText.of(new UValue("a\n\"b\u00e9\0")));
    assertEquals("[ => ]", ValueText.of(new UValue(new UDictionary())));
    assertEquals(
        "BIN 3 raw 1\nabc",
        ValueText.of(
            new UValue(new UBinary("raw 1", "abc".getBytes(StandardCharsets.ISO_8859_1)))));
  }
}
