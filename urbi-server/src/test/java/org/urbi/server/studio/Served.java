package org.urbi.server.studio;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.web.Annexes;

/** The studio of a kernel, on any free port of this machine. */
final class Served {
  private static final Trace SILENT =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  private Served() {}

  static StudioServer of(Kernel kernel, AccessPolicy policy, Shown shown, Folders folders)
      throws IOException {
    return of(kernel, policy, shown, folders, new RecordedFiles());
  }

  static StudioServer of(
      Kernel kernel, AccessPolicy policy, Shown shown, Folders folders, RecordedFiles recorded)
      throws IOException {
    return of(kernel, client -> kernel.connect(client, false), policy, shown, folders, recorded);
  }

  /**
   * @param lobbies makes the lobby of somebody who has been let in
   */
  static StudioServer of(
      Kernel kernel,
      Function<Client, Connection> lobbies,
      AccessPolicy policy,
      Shown shown,
      Folders folders,
      RecordedFiles recorded)
      throws IOException {
    return new StudioServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        lobbies,
        policy,
        shown,
        folders,
        Annexes.of(kernel),
        recorded,
        SILENT);
  }
}
