package org.urbi.server.cli;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.library.system.HostServices;
import org.urbi.server.options.Failure;
import org.urbi.server.studio.RecordedFiles;
import org.urbi.server.studio.StudioServer;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.studio.mcap.McapRecorder;
import org.urbi.web.Annexes;

/** What one run of {@code urbi} does besides its consoles: the studio, and files of variables. */
final class ServerServices implements HostServices, AutoCloseable {
  private final Settings settings;
  private final RecordedFiles recorded = new RecordedFiles();
  private final VariablesFile variables = new VariablesFile(recorded);
  private @Nullable Kernel kernel;
  private @Nullable StudioServer studio;
  private boolean closed;

  ServerServices(Settings settings) {
    this.settings = settings;
  }

  /** The kernel that it serves has been started. */
  synchronized void begin(Kernel started) {
    kernel = started;
  }

  private synchronized Kernel kernel() throws IOException {
    if (closed) {
      throw new IOException("the server ends");
    }
    return requireNonNull(kernel, "it has been started");
  }

  @Override
  public synchronized String openStudio(int port) throws IOException {
    StudioServer present = studio;
    if (present != null) {
      return present.url();
    }
    Kernel served = kernel();
    int wanted = port == USUAL_PORT ? Settings.STUDIO_PORT : port;
    InetSocketAddress address = new InetSocketAddress(settings.host(), wanted);
    if (address.isUnresolved()) {
      throw new IOException("unknown host: " + settings.host());
    }
    try {
      String warning = settings.access().checkAddress(address);
      if (warning != null && !settings.hasPort()) {
        settings.trace().log(warning);
      }
    } catch (Failure e) {
      throw new IOException(e.getMessage(), e);
    }
    StudioServer opened =
        new StudioServer(
            address,
            client -> served.connect(client, false),
            settings.access().accessPolicy(),
            settings.shown(),
            new Folders(Path.of(""), settings.access().userDirectory()),
            Annexes.of(served.uobjects()),
            recorded,
            settings.trace());
    settings.trace().log("studio: " + opened.url());
    studio = opened;
    return opened.url();
  }

  @Override
  public void startMcap(Path file) throws IOException {
    Kernel observed = kernel();
    variables.begin(
        file,
        () ->
            new McapRecorder(
                file,
                client -> observed.connect(client, false),
                settings.shown().paths(),
                !settings.fast(),
                settings.trace()::log,
                recorded::end));
  }

  @Override
  public void stopMcap() throws IOException {
    variables.complete();
  }

  /** Completes the file of variables, if there is one, for the end of the process. */
  void endRecording() {
    variables.end();
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (studio != null) {
      studio.close();
    }
  }
}
