package org.urbi.server.launch;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.source.SourceText;
import org.urbi.server.tools.ServerAddress;
import urbi.ServerConnection;

/** Asks a running server to load modules, and reports its answer. */
final class PluginRequest {
  private static final String ERROR = ":error] !!! ";

  /** The location of an error within the request, which is of no use to the user. */
  private static final String LOCATION = "^\\d+\\.\\d+(-[\\d.]+)?: ";

  private final String program;
  private final PrintStream err;

  /**
   * @param program whom errors come from
   */
  PluginRequest(String program, PrintStream err) {
    this.program = program;
    this.err = err;
  }

  /**
   * Loads them in their order.
   *
   * @return the exit status: 1 if one of them could not be loaded
   */
  int load(Arguments arguments) {
    ServerAddress server = ServerAddress.of(arguments, arguments.value("--host", "127.0.0.1"));
    try (ServerConnection connection = server.connect()) {
      StringBuilder text = new StringBuilder();
      boolean here = connection.address().isLoopbackAddress();
      for (String module : arguments.rest()) {
        text.append(SourceText.loadModule(here ? ownName(module) : module));
      }
      text.append("quit;\n");
      connection.out().write(text.toString().getBytes(StandardCharsets.ISO_8859_1));
      ByteArrayOutputStream answer = new ByteArrayOutputStream();
      connection.in().transferTo(answer);
      return report(answer.toString(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw Failure.of("connection lost: " + e.getMessage());
    }
  }

  /**
   * Makes a path absolute: a server on this machine may have been started in another folder, but
   * sees the same files.
   */
  private static String ownName(String module) {
    try {
      return ModulePath.ofEnvironment().findJar(module).toString();
    } catch (Failure e) {
      // The server may look in other folders.
      return module;
    }
  }

  private int report(String answer) {
    List<String> errors = answer.lines().filter(line -> line.contains(ERROR)).toList();
    for (String error : errors) {
      String message = error.substring(error.indexOf(ERROR) + ERROR.length());
      err.println(program + ": " + message.replaceFirst(LOCATION, ""));
    }
    return errors.isEmpty() ? 0 : 1;
  }
}
