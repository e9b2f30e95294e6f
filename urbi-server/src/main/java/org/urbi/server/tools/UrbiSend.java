package org.urbi.server.tools;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import org.urbi.server.source.Inputs;

/**
 * The program {@code urbi-send}: sends urbiscript to a running server, and shows what it answers
 * until it hangs up (manual, section 21.8).
 */
public final class UrbiSend {
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
    Target.options(program)
        .each("MODULE", "Load the UObject MODULE.", inputs::addModule, "-m", "--module")
        .flag(
            "Disconnect once the commands have been executed, like -e 'quit;' at the end.",
            "-Q",
            "--quit");
    return program.run(args, out, err, this::send);
  }

  private int send(Arguments arguments) {
    Target target = Target.of(arguments, arguments.value("--host", "127.0.0.1"));
    boolean quit = arguments.has("--quit");
    String text = inputs.text() + (quit ? "quit;\n" : "");
    try (Socket socket = target.connect()) {
      // Written beside reading: a server that waits for its answers to be read stops reading.
      Thread.ofPlatform().daemon().start(() -> write(socket, text));
      if (!quit) {
        err.println("urbi-send: connected, hit Ctrl-C to end the connection.");
      }
      socket.getInputStream().transferTo(out);
      out.flush();
      return 0;
    } catch (IOException e) {
      throw Failure.of("connection lost: " + e.getMessage());
    }
  }

  private static void write(Socket socket, String text) {
    try {
      OutputStream to = socket.getOutputStream();
      to.write(text.getBytes(StandardCharsets.ISO_8859_1));
      to.flush();
    } catch (IOException e) {
      // The reader sees the same, and says so.
    }
  }
}
