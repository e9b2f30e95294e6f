package org.urbi.ros.bridge;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The request of HTTP with which a WebSocket begins, and what is answered. A browser says from
 * which page it comes: pages of other machines are refused unless they are named, since any page
 * could have the browser connect to this machine.
 */
final class Handshake {
  private static final int LONGEST = 8192;
  private static final String MAGIC = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  private static final Set<String> THIS_MACHINE = Set.of("localhost", "127.0.0.1", "[::1]");

  private final Map<String, String> headers = new HashMap<>();
  private String target = "";

  private Handshake() {}

  /**
   * Reads a request.
   *
   * @throws IOException if it is too long, or ends
   * @throws BridgeException if it is not HTTP
   */
  static Handshake read(InputStream in) throws IOException {
    StringBuilder text = new StringBuilder();
    while (text.indexOf("\r\n\r\n") < 0) {
      int next = in.read();
      if (next < 0) {
        throw new IOException("the request ends in the middle");
      }
      text.append((char) next);
      if (text.length() > LONGEST) {
        throw new BridgeException("431 Request Header Fields Too Large");
      }
    }
    String[] lines = text.toString().split("\r\n");
    String[] words = lines[0].split(" ");
    if (words.length != 3 || !words[0].equals("GET") || !words[2].startsWith("HTTP/1.")) {
      throw new BridgeException("400 Bad Request");
    }
    Handshake request = new Handshake();
    request.target = words[1];
    for (int i = 1; i < lines.length; i++) {
      int colon = lines[i].indexOf(':');
      if (colon > 0) {
        request.headers.put(
            lines[i].substring(0, colon).strip().toLowerCase(Locale.ROOT),
            lines[i].substring(colon + 1).strip());
      }
    }
    return request;
  }

  private String header(String name) {
    return headers.getOrDefault(name, "");
  }

  /**
   * Checks that it is what is served.
   *
   * @param origins pages that may connect, besides those of this machine
   * @param token empty if none is wanted
   * @throws BridgeException if it is refused; its message is the status of HTTP
   */
  void check(Set<String> origins, String token) {
    boolean upgrade =
        header("upgrade").equalsIgnoreCase("websocket")
            && header("connection").toLowerCase(Locale.ROOT).contains("upgrade")
            && !header("sec-websocket-key").isEmpty();
    if (!upgrade) {
      throw new BridgeException("426 Upgrade Required");
    }
    if (!header("sec-websocket-version").equals("13")) {
      throw new BridgeException("400 Bad Request");
    }
    String origin = header("origin");
    if (!origin.isEmpty() && !origins.contains(origin) && !isOfThisMachine(origin)) {
      throw new BridgeException("403 Forbidden");
    }
    if (!token.isEmpty() && !shows(token)) {
      throw new BridgeException("401 Unauthorized");
    }
  }

  private static boolean isOfThisMachine(String origin) {
    try {
      String host = URI.create(origin).getHost();
      return host != null && THIS_MACHINE.contains(host);
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** A page cannot set headers of the request: it has the token in the address. */
  private boolean shows(String token) {
    String shown = header("authorization").replaceFirst("^Bearer ", "");
    if (shown.isEmpty()) {
      shown = target.replaceFirst("^[^?]*\\?(?:[^&]*&)*?token=([^&]*).*$", "$1");
    }
    return MessageDigest.isEqual(
        shown.getBytes(StandardCharsets.UTF_8), token.getBytes(StandardCharsets.UTF_8));
  }

  /** The answer to one that is let in. */
  String accepted() {
    return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        + "Sec-WebSocket-Accept: "
        + accept(header("sec-websocket-key"))
        + "\r\n\r\n";
  }

  /** The answer to one that is not. */
  static String refused(String status) {
    return "HTTP/1.1 "
        + status
        + "\r\nSec-WebSocket-Version: 13\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";
  }

  private static String accept(String key) {
    try {
      byte[] hash =
          MessageDigest.getInstance("SHA-1")
              .digest((key + MAGIC).getBytes(StandardCharsets.ISO_8859_1));
      return Base64.getEncoder().encodeToString(hash);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-1", e);
    }
  }
}
