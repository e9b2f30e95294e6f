package org.urbi.server.cli;

import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The options of {@code urbi} for a Unix domain socket.
 *
 * @param file where to listen; null for nowhere
 * @param permissions of the file
 */
record SocketOptions(@Nullable Path file, Set<PosixFilePermission> permissions) {
  private static final int OCTAL = 8;

  /** Adds the options to a program. */
  static void declare(Program program) {
    program
        .option(
            "FILE", "Listen on a Unix domain socket: who may write FILE may connect.", "--socket")
        .option(
            "MODE",
            "The permissions of the socket, in octal digits (default: 600, this user only).",
            "--socket-permissions");
  }

  /**
   * What the options say.
   *
   * @throws Failure if they make no sense
   */
  static SocketOptions of(Arguments arguments) {
    String file = arguments.value("--socket");
    if (file == null && arguments.has("--socket-permissions")) {
      throw Failure.usage("--socket-permissions needs --socket");
    }
    if (file != null && file.isEmpty()) {
      throw Failure.usage("--socket wants the name of a file");
    }
    return new SocketOptions(
        file == null ? null : Path.of(file),
        permissions(arguments.value("--socket-permissions", "600")));
  }

  private static Set<PosixFilePermission> permissions(String mode) {
    if (!mode.matches("0?[0-7]{3}")) {
      throw Failure.usage("--socket-permissions is three octal digits, as 660, not " + mode);
    }
    int bits = Integer.parseInt(mode, OCTAL);
    PosixFilePermission[] all = PosixFilePermission.values();
    Set<PosixFilePermission> permissions = EnumSet.noneOf(PosixFilePermission.class);
    for (PosixFilePermission each : all) {
      if ((bits >> (all.length - 1 - each.ordinal()) & 1) != 0) {
        permissions.add(each);
      }
    }
    return permissions;
  }
}
