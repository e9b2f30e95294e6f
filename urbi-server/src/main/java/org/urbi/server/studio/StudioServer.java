package org.urbi.server.studio;

import io.netty.channel.WriteBufferWaterMark;
import io.netty.handler.ssl.SslContext;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.function.Function;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.Trace;
import org.urbi.server.net.TlsGate;
import org.urbi.server.studio.access.Admission;
import org.urbi.server.studio.access.AnnexGate;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.studio.foxglove.ProgramHandler;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.web.Annexes;
import org.urbi.web.Entrance;
import org.urbi.web.Guests;
import org.urbi.web.Page;
import org.urbi.web.PagePort;

/**
 * Serves the studio to browsers, with one thread for all. A slow browser is told less often; none
 * delays the kernel.
 */
public final class StudioServer implements AutoCloseable {
  private static final Page PAGE =
      new Page(StudioServer.class, Request.LONGEST, 10, new WriteBufferWaterMark(1 << 18, 1 << 20));

  private final PagePort port;
  private final AccessPolicy accessPolicy;
  private final SyntaxCheck syntax = new SyntaxCheck();
  private final Worker fileWorker = new Worker("urbi-studio-files");

  /**
   * Begins to serve.
   *
   * @param address where; port 0 is any that is free
   * @param lobbies makes the lobby of a browser that has been let in
   * @param accessPolicy who is let in, and as what
   * @param shown what programs that speak Foxglove's protocol are shown, and who they may be
   * @param folders the files that people edit
   * @param annexes the pages of the components in this server
   * @param recorded the files to which variables are recorded
   * @throws IOException if it cannot listen there, or TLS cannot be had; the message says why
   */
  public StudioServer(
      InetSocketAddress address,
      Function<Client, Connection> lobbies,
      AccessPolicy accessPolicy,
      Shown shown,
      Folders folders,
      Annexes annexes,
      RecordedFiles recorded,
      Trace trace)
      throws IOException {
    this.accessPolicy = accessPolicy;
    SslContext tls =
        accessPolicy.identity() == null ? null : TlsGate.context(accessPolicy.identity());
    port = new PagePort("urbi-studio", accessPolicy.defaultRole() != null);
    String instance = ProcessHandle.current().pid() + "-" + new SystemClock().startTime();
    Admission admission = new Admission(accessPolicy, trace, port.places());
    Guests programs =
        new Guests(
            ProgramHandler.SUBPROTOCOLS,
            shown.origins(),
            ProgramHandler.LONGEST,
            () -> new ProgramHandler(admission, lobbies, shown.paths()));
    try {
      port.listen(
          address,
          tls,
          PAGE,
          () ->
              new Viewer(
                  admission,
                  lobbies,
                  syntax,
                  folders,
                  fileWorker,
                  annexes,
                  recorded,
                  port.downloads(),
                  instance),
          programs,
          new Entrance(annexes, annex -> new AnnexGate(admission, annex)));
    } catch (IOException e) {
      throw new IOException(
          "cannot serve the studio on "
              + address.getHostString()
              + ":"
              + address.getPort()
              + ": "
              + e.getMessage(),
          e);
    }
  }

  /** The port on which it listens. */
  public int port() {
    return port.port();
  }

  /**
   * What to give to a browser; a token is still to be put behind {@code ?token=}, if one is asked
   * for.
   */
  public String url() {
    return port.url() + (accessPolicy.defaultRole() == null ? "?token=TOKEN" : "");
  }

  /** Leaves all browsers alone, and frees the port. */
  @Override
  public void close() {
    port.close();
    syntax.close();
    fileWorker.close();
  }
}
