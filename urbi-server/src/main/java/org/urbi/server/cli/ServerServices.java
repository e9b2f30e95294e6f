package org.urbi.server.cli;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.library.system.HostServices;
import org.urbi.server.options.Failure;
import org.urbi.server.studio.RecordedFile;
import org.urbi.server.studio.StudioServer;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.studio.mcap.McapRecorder;
import org.urbi.web.Annexes;

/** What one run of {@code urbi} does besides its consoles: the studio, and files of variables. */
final class ServerServices implements HostServices, AutoCloseable {
  private final Settings settings;
  private final RecordedFile recorded = new RecordedFile();
  private @Nullable Kernel kernel;
  private @Nullable StudioServer studio;
  private @Nullable McapRecorder recorder;
  private boolean closed;

  ServerServices(Settings settings) {
    this.settings = settings;
  }

  /** The kernel that it serves has been started. */
  synchronized void begin(Kernel started) {
    kernel = started;
  }

  private Kernel kernel() throws IOException {
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
  public synchronized void startMcap(Path file) throws IOException {
    McapRecorder present = recorder;
    if (present != null && present.goesOn()) {
      throw new IOException("variables are being recorded already, to " + present.path());
    }
    Kernel observed = kernel();
    endRecording();
    try {
      McapRecorder begun =
          new McapRecorder(
              file,
              client -> observed.connect(client, false),
              settings.shown().paths(),
              !settings.fast(),
              settings.trace()::log,
              () -> recorded.change(""));
      recorder = begun;
      recorded.change(file.toString());
      // The disk may have ended it before that was told.
      if (!begun.goesOn()) {
        recorded.change("");
      }
    } catch (IOException e) {
      String reason =
          e instanceof NoSuchFileException ? "no such directory" : String.valueOf(e.getMessage());
      throw new IOException("cannot write the recording " + file + ": " + reason, e);
    }
  }

  @Override
  public synchronized void stopMcap() throws IOException {
    if (recorder == null) {
      throw new IOException("no variables are being recorded");
    }
    endRecording();
  }

  /** Completes the file of variables, if there is one. */
  synchronized void endRecording() {
    if (recorder != null) {
      recorder.close();
      recorder = null;
      recorded.change("");
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    endRecording();
    if (studio != null) {
      studio.close();
    }
  }
}
