package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;

/** Binaries to and from a kernel over TCP: every byte arrives, and none is taken for something. */
class BinaryOverTcpTest {
  private Kernel kernel;
  private ConsoleServer server;
  private Socket socket;
  private DataInputStream in;

  @BeforeEach
  void connect() throws IOException {
    kernel = Kernel.builder().start();
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> kernel.connect(client, false),
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
    socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    socket.setTcpNoDelay(true);
    in = new DataInputStream(socket.getInputStream());
  }

  @AfterEach
  void disconnect() throws IOException {
    socket.close();
    kernel.close();
    server.close();
  }

  /** What telnet, the lexer or a line reader could stumble on. */
  private static byte[] allBytes() {
    var bytes = new ByteArrayOutputStream();
    for (int i = 0; i < 256; i++) {
      bytes.write(i);
    }
    bytes.writeBytes(new byte[] {'\r', 0, '\r', '\n', (byte) 255, (byte) 244, '"', '\\', ';', '}'});
    bytes.writeBytes("/* BIN 3;\n[00000001] *** BIN 5 x\n".getBytes(StandardCharsets.US_ASCII));
    return bytes.toByteArray();
  }

  private static byte[] statement(String before, byte[] data, String after) {
    var bytes = new ByteArrayOutputStream();
    bytes.writeBytes(before.getBytes(StandardCharsets.US_ASCII));
    bytes.writeBytes(data);
    bytes.writeBytes(after.getBytes(StandardCharsets.US_ASCII));
    return bytes.toByteArray();
  }

  private void send(byte... bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  private void expect(String label, String header, byte[] data) throws IOException {
    expectLine(label + "BIN " + data.length + header);
    byte[] got = new byte[data.length + 1];
    in.readFully(got);
    assertArrayEquals(Arrays.copyOf(data, got.length - 1), Arrays.copyOf(got, got.length - 1));
    assertEquals('\n', got[data.length]);
  }

  private void expectLine(String expected) throws IOException {
    var line = new StringBuilder();
    for (int c = in.read(); c != '\n' && c >= 0; c = in.read()) {
      line.append((char) c);
    }
    assertEquals(expected, line.toString().replaceFirst("^\\[\\d{8}", "["));
  }

  @Test
  void aBinaryIsEchoedWithAllItsBytes() throws IOException {
    byte[] data = allBytes();
    send(statement("var x = BIN " + data.length + " my key-words=1.5;", data, ";1;"));
    expect("[] ", " my key-words=1.5", data);
    expectLine("[] 1");
    send(statement("var y = (BIN " + data.length + ";", data, ") |; 2;"));
    expectLine("[] 2");
    send("x.data == y.data; Channel.new(\"tag\") << x;\n".getBytes(StandardCharsets.US_ASCII));
    expectLine("[] true");
    expect("[:tag] ", " my key-words=1.5", data);
  }

  @Test
  void escapeInAStringTakesAllBytes() throws IOException {
    byte[] data = allBytes();
    send(statement("Binary.new(\"a; b\", \"\\B(" + data.length + ")(", data, ")\");3;"));
    expect("[] ", " a; b", data);
    expectLine("[] 3");
  }

  @Test
  void aPacketMayEndAnywhere() throws IOException {
    byte[] data = {0, (byte) 255, (byte) 250, ';', '\r', 0, '"', '\\', '(', '\n', (byte) 128};
    byte[] bin = statement("(BIN 11 a b;", data, ");");
    byte[] escape = statement("Binary.new(\"a b\", \"\\\\\\B(11)(", data, ")\");");
    for (int split = 1; split < bin.length; split++) {
      send(Arrays.copyOf(bin, split));
      Thread.yield();
      send(Arrays.copyOfRange(bin, split, bin.length));
      expect("[] ", " a b", data);
    }
    byte[] withBackslash = statement("\\", data, "");
    for (int split = 1; split < escape.length; split++) {
      send(Arrays.copyOf(escape, split));
      Thread.yield();
      send(Arrays.copyOfRange(escape, split, escape.length));
      expect("[] ", " a b", withBackslash);
    }
    for (byte b : bin) {
      send(b);
    }
    expect("[] ", " a b", data);
    for (byte b : escape) {
      send(b);
    }
    expect("[] ", " a b", withBackslash);
  }

  @Test
  void imageGoesToTheProcessAndBack() throws IOException {
    byte[] image = new byte[640 * 480 * 3];
    new Random(7).nextBytes(image);
    for (int i = 0; i < 3; i++) {
      send(statement("BIN " + image.length + " rgb 640 480;", image, ";"));
      expect("[] ", " rgb 640 480", image);
    }
  }

  @Test
  void listsHoldBinaries() throws IOException {
    byte[] data = {(byte) 255, 10, ']'};
    send(statement("[1, BIN 3 a;", data, ", BIN 0;, \"\u0001\"];"));
    expectLine("[] [1, BIN 3 a");
    byte[] rest = new byte[3];
    in.readFully(rest);
    assertArrayEquals(data, rest);
    expectLine(", BIN 0");
    expectLine(", \"\\x01\"]");
  }

  @Test
  void atTopLevelTheDataEndTheStatement() throws IOException {
    send("var z = BIN 2;ab1+1;".getBytes(StandardCharsets.US_ASCII));
    expect("[] ", "", new byte[] {'a', 'b'});
    expectLine("[] 2");
  }

  @Test
  void invalidHeaderIsAnError() throws IOException {
    send("BIN x;1;\n".getBytes(StandardCharsets.US_ASCII));
    expectLine("[:error] !!! 1.5: syntax error: unexpected identifier");
    expectLine("[] 1");
  }
}
