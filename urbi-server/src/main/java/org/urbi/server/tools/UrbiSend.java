package org.urbi.server.tools;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.urbi.kernel.log.FailureLog;
import org.urbi.server.net.OperatorRequest;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import org.urbi.server.source.Inputs;
import urbi.ServerConnection;

/**
 * The program {@code urbi-send}: sends urbiscript to a running server, and shows what it answers
 * until it hangs up (manual, section 21.8).
 */
public final class UrbiSend {
  private static final int ANSWER_MILLISECONDS = 5000;

  private final Inputs inputs = new Inputs();
  private final PrintStream out;
  private final PrintStream err;

  private UrbiSend(PrintStream out, PrintStream err) {
    this.out = out;
    this.err = err;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new UrbiSend(out, err).run(args);
  }

  private int run(String[] args) {
    Program program = new Program("urbi-send", "Sends urbiscript to a running Urbi server.");
    inputs.declare(program);
    ServerAddress.options(program)
        .each("MODULE", "Load the UObject MODULE.", inputs::addModule, "-m", "--module")
        .flag(
            "Disconnect once the commands have been executed, like -e 'quit;' at the end.",
            "-Q",
            "--quit")
        .flag(
            "Interrupt what holds the server, or the lobby that is named, although the server"
                + " answers nobody; tell what was done.",
            "--interrupt")
        .arguments("[LOBBY]", "The name of a lobby for --interrupt, as Lobby_3.");
    return program.run(args, out, err, this::send);
  }

  private int send(Arguments arguments) {
    ServerAddress target = ServerAddress.of(arguments, arguments.value("--host", "127.0.0.1"));
    if (arguments.has("--interrupt")) {
      return interrupt(target, arguments.rest());
    }
    if (!arguments.rest().isEmpty()) {
      throw Failure.usage("unexpected argument: " + arguments.rest().getFirst());
    }
    boolean quit = arguments.has("--quit");
    String text = inputs.text() + (quit ? "quit;\n" : "");
    try (ServerConnection server = target.connect()) {
      // Writes while reading: a server whose answers are not read stops reading.
      FailureLog.THREADS
          .platform("urbi-send", () -> write(server, text), defect -> end(server))
          .start();
      if (!quit) {
        err.println("urbi-send: connected, hit Ctrl-C to end the connection.");
      }
      server.in().transferTo(out);
      out.flush();
      return 0;
    } catch (IOException e) {
      throw Failure.of("connection lost: " + e.getMessage());
    }
  }

  /** The network thread of the server answers; the kernel need not. */
  private int interrupt(ServerAddress target, List<String> lobby) {
    if (lobby.size() > 1) {
      throw Failure.usage("--interrupt takes one lobby");
    }
    try (ServerConnection server = target.connect()) {
      server.setReadTimeout(ANSWER_MILLISECONDS);
      OutputStream to = server.out();
      to.write(OperatorRequest.bytes(lobby.isEmpty() ? "" : lobby.getFirst()));
      to.flush();
      BufferedReader from =
          new BufferedReader(new InputStreamReader(server.in(), StandardCharsets.ISO_8859_1));
      for (String line = from.readLine(); line != null; line = from.readLine()) {
        int answer = line.indexOf(OperatorRequest.ANSWER);
        if (answer >= 0) {
          String told = line.substring(answer + OperatorRequest.ANSWER.length());
          out.println(told);
          return told.startsWith("interrupted") ? 0 : 1;
        }
      }
      throw Failure.of("the server hung up");
    } catch (IOException e) {
      throw Failure.of("no answer: " + e.getMessage());
    }
  }

  /** Whoever reads gets to know that nothing more is sent. */
  private static void end(ServerConnection server) {
    try {
      server.close();
    } catch (IOException e) {
      // It is closed, or will be.
    }
  }

  private static void write(ServerConnection server, String text) {
    try {
      OutputStream to = server.out();
      to.write(text.getBytes(StandardCharsets.ISO_8859_1));
      to.flush();
    } catch (IOException e) {
      // The reader gets the same error and reports it.
    }
  }
}
