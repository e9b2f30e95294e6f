package org.urbi.server.tools;

import java.io.IOException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import urbi.ServerConnection;
import urbi.TokenLine;
import urbi.UClientException;
import urbi.USyncClient;
import urbi.remote.NoServerHint;

/**
 * The address of the server that a tool connects to, and how long it waits for that server: options
 * {@code --host}, {@code --port}, {@code --port-file}, {@code --wait}.
 */
public final class ServerAddress {
  /** The usual port of an Urbi server. */
  public static final int DEFAULT_PORT = 54000;

  private static final int CONNECT_MILLISECONDS = 10_000;

  /** How long {@code --wait} waits. */
  private static final String WAIT = "30s";

  private static final int MAX_PORT = 65_535;

  private final String host;
  private final @Nullable String portFile;
  private final Patience patience;
  private int port;

  private ServerAddress(String host, int port, @Nullable String portFile, Patience patience) {
    this.host = host;
    this.port = port;
    this.portFile = portFile;
    this.patience = patience;
  }

  public String host() {
    return host;
  }

  /** The port; if it is that of a file, as the last look has found it. */
  public int port() {
    return port;
  }

  /**
   * Waits until the server listens, for as long as {@code --wait} says.
   *
   * @throws Failure if it does not listen by then
   */
  public void await() {
    try {
      connect().close();
    } catch (IOException e) {
      throw Failure.of("connection lost: " + e.getMessage());
    }
  }

  /** Adds the options to a program. */
  public static Program options(Program program) {
    program
        .option(
            "HOST",
            "Address to connect to (default: 127.0.0.1); with a / the file of a Unix socket.",
            "-H",
            "--host")
        .option("PORT", "Port to connect to (default: " + DEFAULT_PORT + ").", "-P", "--port")
        .option("FILE", "Connect to the port that is written in FILE.", "--port-file");
    return trustOptions(waitOption(program));
  }

  /** Adds the option that says how long to wait for the server. */
  public static Program waitOption(Program program) {
    return program.optional(
        "TIME",
        WAIT,
        "Wait for the server, and its port file, for TIME at most (default: "
            + WAIT
            + "), as 500ms or 5s.",
        "--wait");
  }

  /** Adds those of them that say who trusts whom, and why. */
  public static Program trustOptions(Program program) {
    return program
        .option(
            "FILE",
            "Show the server the token that is in FILE (default: that in URBI_TOKEN).",
            "--token")
        .flag("Connect by TLS (default: URBI_TLS).", "--tls")
        .option(
            "FILE",
            "Connect by TLS, and trust the certificate in FILE (default: URBI_TLS_CA, or those that"
                + " Java trusts).",
            "--tls-ca");
  }

  /**
   * What the options say.
   *
   * @throws Failure if they make no sense, or the port's file cannot be read
   */
  public static ServerAddress of(Arguments arguments, String host) {
    useToken(arguments.value("--token"));
    useTls(arguments);
    var patience =
        new Patience(
            new SystemClock(),
            TimeUnit.NANOSECONDS::sleep,
            arguments.duration("--wait", Duration.ZERO));
    String file = arguments.value("--port-file");
    if (file == null) {
      int port = arguments.number("--port", DEFAULT_PORT, 1, MAX_PORT);
      return new ServerAddress(host, port, null, patience);
    }
    if (arguments.has("--port")) {
      throw Failure.usage("give either --port or --port-file");
    }
    return new ServerAddress(host, portIn(file, patience), file, patience);
  }

  private static int portIn(String file, Patience patience) {
    while (true) {
      try {
        String text = Files.readString(Path.of(file)).strip();
        // Who writes it may have made it only.
        if (!text.isEmpty() || !patience.again()) {
          return Arguments.number("port in " + file, text, 1, MAX_PORT);
        }
      } catch (IOException e) {
        if (!patience.again()) {
          throw Failure.of("cannot read the port file " + file + ": is the server running?");
        }
      }
    }
  }

  /** Shows that token to every server that this process connects to. */
  private static void useToken(@Nullable String file) {
    if (file != null) {
      try {
        System.setProperty(TokenLine.PROPERTY, Files.readString(Path.of(file)).strip());
      } catch (IOException e) {
        throw Failure.of("cannot read the token file " + file);
      }
    }
  }

  /** Whatever this process connects to is connected to by TLS from now on, if that is wanted. */
  private static void useTls(Arguments arguments) {
    // An end of the output that somebody else has made is not taken for that of the server.
    System.setProperty("com.sun.net.ssl.requireCloseNotify", "true");
    if (arguments.has("--tls")) {
      System.setProperty(ServerConnection.TLS_PROPERTY, "1");
    }
    String trusted = arguments.value("--tls-ca");
    if (trusted != null) {
      ServerConnection.trust(trusted);
    }
  }

  /**
   * Connects a client that can wait for answers.
   *
   * @throws Failure if nobody answers
   */
  public USyncClient client() {
    while (true) {
      try {
        return USyncClient.connect(host, port, Duration.ofMillis(CONNECT_MILLISECONDS));
      } catch (UClientException e) {
        if (!patience.again()) {
          throw Failure.of(e.getMessage() + hint());
        }
        lookAgain();
      }
    }
  }

  /** The file may be that of a server that has ended: the next one will write another port. */
  private void lookAgain() {
    if (portFile != null) {
      port = portIn(portFile, patience);
    }
  }

  private String hint() {
    if (portFile != null) {
      return " (is the server running? the port is from "
          + portFile
          + ", which one that was killed leaves behind)";
    }
    return NoServerHint.text(host, port);
  }

  @Override
  public String toString() {
    return ServerConnection.name(host, port);
  }

  /**
   * Connects.
   *
   * @throws Failure if nobody answers
   */
  public ServerConnection connect() {
    while (true) {
      try {
        return ServerConnection.open(host, port, CONNECT_MILLISECONDS);
      } catch (UnknownHostException e) {
        throw Failure.of("unknown host: " + host);
      } catch (IOException e) {
        if (!patience.again()) {
          throw Failure.of("cannot connect to %s: %s%s".formatted(this, e.getMessage(), hint()));
        }
        lookAgain();
      }
    }
  }
}
