package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** A page of another site, which tries to command the robot of whoever looks at it. */
final class ForeignPage {
  private static final String LISTENING = "listening on 127.0.0.1:";

  /**
   * All that a page can do with the ports of this machine. It notes what it has been answered by
   * any of them, and how many of its attempts are over.
   */
  private static final String ATTACK =
      """
      const ports = [%s];
      const code = String.raw`
      */}])>;
      ;Global.setSlot("stolen", 1);
      `;
      window.answered = [];
      window.over = 0;
      const end = (name, good) => { over++; if (good) answered.push(name) };
      const fetched = (name, promise) => promise.then(() => end(name, true), () => end(name, false));
      for (const port of ports) {
        const http = 'http://localhost:' + port + '/';
        for (let i = 0; i < 30; i++) {
          fetched('read ' + port, fetch(http + i));
          fetched('put ' + port, fetch(http, {method: 'PUT', body: code}));
          fetch(http, {method: 'POST', mode: 'no-cors', body: code}).then(() => over++, () => over++);
          navigator.sendBeacon(http, code);
        }
        // The browser delays further ones.
        for (let i = 0; i < 5; i++) {
          const socket = new WebSocket('ws://localhost:' + port + '/stream');
          socket.onopen = () => answered.push('stream ' + port);
          socket.onclose = () => over++;
        }
        const frame = document.createElement('iframe');
        frame.name = 'frame' + port;
        const form = document.createElement('form');
        form.action = http;
        form.method = 'POST';
        form.enctype = 'text/plain';
        form.target = frame.name;
        const field = document.createElement('textarea');
        field.name = code;
        form.append(field);
        document.body.append(frame, form);
        form.submit();
      }
      """;

  private ForeignPage() {}

  /** Does so, while another client of the console is answered. */
  static void attack(Browser browser, JavaProcess urbi, String studio) throws Exception {
    String line = urbi.awaitText(LISTENING);
    int console = Integer.parseInt(line.substring(line.indexOf(LISTENING) + LISTENING.length()));
    HttpServer site = site();
    try (ConsoleClient client = new ConsoleClient(console)) {
      browser.open("http://localhost:" + site.getAddress().getPort() + "/");
      String ports = console + ", " + studio.replaceAll("\\D", "");
      browser.evaluate(ATTACK.formatted(ports));
      for (int i = 0; i < 20; i++) {
        assertEquals(List.of(), client.answers("1|;"));
      }
      browser.await("the end of all attempts", "return over", "190"::equals);
      assertEquals("", browser.evaluate("return answered.join()"));
      List<String> stolen = client.answers("[Global.hasLocalSlot(\"stolen\")];");
      assertEquals("[false]", stolen.getFirst().replaceFirst("\\S+ ", ""));
    } finally {
      site.stop(0);
    }
  }

  private static HttpServer site() throws IOException {
    HttpServer site =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    byte[] page = "<!DOCTYPE html><title>Kittens</title>".getBytes(StandardCharsets.US_ASCII);
    site.createContext(
        "/",
        exchange -> {
          try (exchange) {
            exchange.sendResponseHeaders(200, page.length);
            exchange.getResponseBody().write(page);
          }
        });
    site.start();
    return site;
  }
}
