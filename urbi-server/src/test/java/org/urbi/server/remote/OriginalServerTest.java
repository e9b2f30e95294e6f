package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import urbi.UModule;
import urbi.remote.RemoteProgram;

/** Our remote programs and a server of the SDK of Urbi 2.7, which answers as was recorded. */
class OriginalServerTest {
  /** It takes what it does not know for urbiscript: a string is shown. */
  private static String serve(ServerSocket listener) {
    StringBuilder heard = new StringBuilder();
    try (Socket client = listener.accept()) {
      client.getOutputStream().write("[00000011] *** Hello\n".getBytes(StandardCharsets.US_ASCII));
      BufferedReader in =
          new BufferedReader(
              new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        heard.append(line).append('\n');
        String value = line.replaceFirst(";$", "");
        client
            .getOutputStream()
            .write(("[00000012] " + value + "\n").getBytes(StandardCharsets.ISO_8859_1));
      }
    } catch (IOException e) {
      heard.append(e);
    }
    return heard.toString();
  }

  @Test
  void programReportsAnOtherServerInOneLine() throws Exception {
    try (ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      CompletableFuture<String> heard = CompletableFuture.supplyAsync(() -> serve(listener));
      ByteArrayOutputStream said = new ByteArrayOutputStream();
      PrintStream out = new PrintStream(said, true, StandardCharsets.UTF_8);
      String port = String.valueOf(listener.getLocalPort());
      String[] words = {"--host", "127.0.0.1", "--port", port};
      int status = new RemoteProgram().run(words, new UModule("program"), out, out);
      assertEquals(
          "urbi.UMain: the server does not speak the UObject protocol: one of another kind, such as those"
              + " of the SDK of Urbi 2.7, takes components that are linked with that\n",
          said.toString(StandardCharsets.UTF_8));
      assertEquals(1, status);
      assertEquals("\"urbi-uobject 1 1\";\n", heard.get());
    }
  }
}
