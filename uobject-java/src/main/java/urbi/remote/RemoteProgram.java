package urbi.remote;

import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import urbi.RemoteRunner;
import urbi.ServerConnection;
import urbi.UAbstractClient;
import urbi.UClientException;
import urbi.UModule;
import urbi.UModuleException;
import urbi.rtp.RtpOptions;
import urbi.spi.Failure;
import urbi.spi.ModuleFiles;

/**
 * Implements {@link urbi.UMain} and {@code UObject.main}: parses the options and runs the UObjects.
 */
public final class RemoteProgram implements RemoteRunner {
  private static final String USAGE =
      """
      usage: java -cp liburbijava.jar urbi.UMain [OPTIONS] JAR... [-- [OPTIONS]]

      Options:
        -h, --help            output this message and exit successfully
        -H, --host ADDRESS    address of the server (default: 127.0.0.1); with a / the file of its socket
        -P, --port PORT       port of the server (default: 54000)
            --port-file FILE  take the port from FILE
            --tls             connect by TLS (default: URBI_TLS)
            --tls-ca FILE     connect by TLS, and trust the certificate in FILE (default: URBI_TLS_CA, or
                              those that Java trusts)
            --reconnect       connect again whenever the connection is lost
        -d, --debug LEVEL     how much is said: NONE (errors alone), LOG (the default; what is started),
                              TRACE, DEBUG or DUMP (each call of a function as well)

      JARs, or folders of classes, hold UObjects; they are looked for in the folders of URBI_UOBJECT_PATH.
      urbi/rtp as one of them has binaries sent in datagrams, if the server has loaded it, too.
      """;

  private static final int RECONNECT_MILLISECONDS = 1000;

  private static final List<String> LEVELS = List.of("NONE", "LOG", "TRACE", "DEBUG", "DUMP");
  private static final int LOG = 1;

  private final Runnable onRunning;

  /** Made by the service loader. */
  public RemoteProgram() {
    this(() -> {});
  }

  /**
   * @param onRunning called when the UObjects run, each time that they are connected
   */
  public RemoteProgram(Runnable onRunning) {
    this.onRunning = onRunning;
  }

  @Override
  public int run(String[] arguments, @Nullable UModule program, PrintStream out, PrintStream err) {
    try {
      Run run = new Run(program, onRunning, out, err);
      return run.parse(arguments) ? run.run() : 0;
    } catch (UModuleException | UClientException | IllegalArgumentException e) {
      err.println("urbi.UMain: " + e.getMessage());
      return 1;
    }
  }

  /** One run of it. */
  private static final class Run {
    private final @Nullable UModule program;
    private final Runnable onRunning;
    private final PrintStream out;
    private final PrintStream err;
    private final List<String> jars = new ArrayList<>();
    private String host = UAbstractClient.default_host();
    private int port = UAbstractClient.URBI_PORT;
    private int level = LOG;
    private boolean reconnect;
    private boolean rtp;

    Run(@Nullable UModule program, Runnable onRunning, PrintStream out, PrintStream err) {
      this.program = program;
      this.onRunning = onRunning;
      this.out = out;
      this.err = err;
    }

    private boolean parse(String[] arguments) {
      for (int i = 0; i < arguments.length; i++) {
        switch (arguments[i]) {
          case "-h", "--help" -> {
            out.print(USAGE);
            return false;
          }
          case "-H", "--host" -> host = value(arguments, ++i);
          case "-P", "--port" -> port = port(value(arguments, ++i));
          case "--port-file" -> port = portFrom(value(arguments, ++i));
          case "-d", "--debug" -> level = level(value(arguments, ++i));
          case "--tls" -> System.setProperty(ServerConnection.TLS_PROPERTY, "1");
          case "--tls-ca" -> ServerConnection.trust(value(arguments, ++i));
          case "--reconnect" -> reconnect = true;
          case "--" -> {}
          default -> {
            if (arguments[i].startsWith("-")) {
              throw new IllegalArgumentException("unknown option " + arguments[i] + ", see --help");
            }
            if (arguments[i].equals(RtpOptions.MODULE)) {
              rtp = true;
            } else {
              jars.add(arguments[i]);
            }
          }
        }
      }
      return true;
    }

    private static String value(String[] arguments, int index) {
      if (index >= arguments.length) {
        throw new IllegalArgumentException(arguments[index - 1] + " wants a value");
      }
      return arguments[index];
    }

    private static int level(String text) {
      int level = LEVELS.indexOf(text.toUpperCase(Locale.ROOT));
      if (level < 0) {
        throw new IllegalArgumentException(
            "no level of messages: " + text + " (" + String.join(", ", LEVELS) + ")");
      }
      return level;
    }

    private void say(String text) {
      if (level >= LOG) {
        out.println(text);
      }
    }

    private static int port(String text) {
      if (!text.matches("\\d{1,5}") || Integer.parseInt(text) > 65535) {
        throw new IllegalArgumentException("no port: " + text);
      }
      return Integer.parseInt(text);
    }

    private static int portFrom(String file) {
      try {
        return port(Files.readString(Path.of(file)).strip());
      } catch (IOException e) {
        throw new IllegalArgumentException(
            "cannot read the port file " + file + ": is the server running?", e);
      }
    }

    private List<UModule> load() {
      if (program != null) {
        return List.of(program);
      }
      if (jars.isEmpty()) {
        throw new IllegalArgumentException("no jar given, see --help");
      }
      List<UModule> modules = new ArrayList<>();
      for (String jar : jars) {
        modules.add(ModuleFiles.load(find(jar)));
      }
      return modules;
    }

    private static Path find(String jar) {
      String path = System.getenv("URBI_UOBJECT_PATH");
      for (String folder : (path == null ? "." : path).split(File.pathSeparator)) {
        Path found = Path.of(folder.isEmpty() ? "." : folder).resolve(jar);
        if (Files.isRegularFile(found)) {
          return found;
        }
        if (Files.isRegularFile(Path.of(found + ".jar"))) {
          return Path.of(found + ".jar");
        }
        if (Files.isDirectory(found)) {
          return found;
        }
      }
      throw new UModuleException(
          "JAR archive " + jar + " not found (is URBI_UOBJECT_PATH correctly set?)");
    }

    private int run() {
      while (true) {
        List<UModule> loaded = load();
        try {
          String why = serve(loaded);
          err.println("urbi.UMain: " + why);
          if (why.equals(RemoteContext.NO_OBJECT)) {
            return 0;
          }
        } catch (UClientException e) {
          if (!reconnect) {
            throw e;
          }
          err.println("urbi.UMain: " + e.getMessage());
        }
        if (!reconnect) {
          return 0;
        }
        try {
          Thread.sleep(RECONNECT_MILLISECONDS);
        } catch (InterruptedException e) {
          return 0;
        }
      }
    }

    /** Runs modules until the connection ends, and tells why it did. */
    private String serve(List<UModule> loaded) {
      try (RemoteContext context = connect()) {
        context.onOutput(text -> err.write(text, 0, text.length));
        if (level > LOG) {
          context.trace(text -> err.println("urbi.UMain: " + text));
        }
        if (rtp) {
          context.useRtp(RtpOptions.DEFAULT);
        }
        for (UModule module : loaded) {
          start(module, context);
          module.classes().forEach(type -> say("started " + type.name()));
        }
        context.endWithLastObject();
        say("running on " + ServerConnection.name(host, port));
        onRunning.run();
        String why = context.onClosed().join();
        loaded.forEach(module -> module.leave(context));
        return why;
      }
    }

    /** One that tries again and again does not say each time what can be done. */
    private RemoteContext connect() {
      try {
        return new RemoteContext(host, port);
      } catch (UClientException e) {
        if (reconnect || !(e.getCause() instanceof IOException)) {
          throw e;
        }
        throw new UClientException(e.getMessage() + NoServerHint.text(host, port), e.getCause());
      }
    }

    private static void start(UModule module, RemoteContext context) {
      try {
        module.startIn(context);
      } catch (UClientException e) {
        throw e;
      } catch (RuntimeException e) {
        throw new UModuleException(
            "exception caught while constructing the UObjects of "
                + module.name()
                + ": "
                + Failure.text(e),
            e);
      }
    }
  }
}
