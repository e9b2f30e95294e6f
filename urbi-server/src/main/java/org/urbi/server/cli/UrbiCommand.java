package org.urbi.server.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.bridge.NativeThreads;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.lobby.ErrorStyle;
import org.urbi.server.Trace;
import org.urbi.server.console.ErrorOutput;
import org.urbi.server.make.NewComponent;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import org.urbi.server.source.Inputs;
import org.urbi.server.source.SourceText;
import org.urbi.server.studio.Shown;
import org.urbi.server.trust.AccessOptions;

/** The program {@code urbi}: runs an Urbi server (manual, section 21.3). */
public final class UrbiCommand {
  private static final int MAX_PORT = 65_535;

  private static final Duration WATCHDOG = Duration.ofSeconds(60);

  /** The default of {@code --max-hold} for a server. */
  private static final Duration MAX_HOLD = Duration.ofSeconds(5);

  /** {@code urbi new} makes a project; a script that is called so is {@code ./new}. */
  private static final String NEW = "new";

  private final Inputs inputs = new Inputs();
  private final List<String> modules = new ArrayList<>();
  private final List<String> watched = new ArrayList<>();
  private final PrintStream out;
  private final PrintStream err;
  private final OutputStream errors;

  UrbiCommand(PrintStream out, PrintStream err) {
    this(out, err, err);
  }

  /**
   * @param errors where a server writes its messages; they end up where those to {@code err} do
   */
  private UrbiCommand(PrintStream out, PrintStream err, OutputStream errors) {
    this.out = out;
    this.err = err;
    this.errors = errors;
  }

  public static void main(String[] args) {
    // Who writes to System.err locks it, even if that takes for ever.
    OutputStream errors = new FileOutputStream(FileDescriptor.err);
    int status = new UrbiCommand(System.out, System.err, errors).run(RawArguments.of(args));
    System.out.flush();
    System.err.flush();
    // Everything is closed already; an orderly exit would first load the JDK's loggers.
    NativeThreads.halt(status);
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new UrbiCommand(out, err).run(args);
  }

  int run(String... args) {
    if (args.length > 0 && args[0].equals(NEW)) {
      return NewComponent.run(Arrays.copyOfRange(args, 1, args.length), out, err);
    }
    return program().run(args, out, err, this::start);
  }

  /** What each option is for, by each of its names. */
  static Map<String, String> optionTexts() {
    return new UrbiCommand(System.out, System.err).program().optionTexts();
  }

  private Program program() {
    Program program =
        new Program(
            "urbi", "Runs an Urbi server: a script, an interactive session, a network port.");
    program
        .flag("Show the root folder of this installation and exit.", "--print-root")
        .option(
            "LEVEL",
            "How much the server says of itself: NONE, LOG, TRACE, DEBUG or DUMP"
                + " (default: GD_LEVEL, or LOG).",
            "-d",
            "--debug")
        .flag("Simulate time: as fast as possible, nobody really sleeps.", "-F", "--fast")
        .option(
            "SIZE",
            "How deep a job may recurse, in KiB of stack (default: URBI_STACK_SIZE).",
            "-s",
            "--stack-size")
        .option(
            "STYLE",
            "How the console tells of errors: plain, explained (with the line of the source and a"
                + " hint) or coloured (default: coloured at a terminal, explained there with"
                + " NO_COLOR, otherwise plain).",
            "--errors")
        .flag("Do not send the welcome banner to clients.", "-q", "--quiet")
        .option(
            "ADDRESS",
            "Listen on ADDRESS (default: 127.0.0.1, this machine only; 0.0.0.0 is all).",
            "-H",
            "--host")
        .option(
            "PORT",
            "Listen on PORT; 0 takes any free one, -1 (the default) does not listen.",
            "-P",
            "--port")
        .option(
            "TIME",
            "End a job that holds the kernel for longer without letting others run, as 500ms or 5s;"
                + " 0: none (default: 5s with a port or socket, otherwise none).",
            "--max-hold")
        .option(
            "TIME",
            "With a port or socket, end the process when kernel or network have not turned for so long; 0:"
                + " never (default: 60s).",
            "--watchdog")
        .option(
            "LIMITS",
            "What the lobby of each client of the network may have, as"
                + " jobs=1000,timers=100,processes=5,output=1M,input=64k,time=50% (default: no"
                + " limits).",
            "--budget")
        .option(
            "MIB",
            "Of the output that all clients together have not read, keep so much"
                + " (default: a quarter of the memory).",
            "--max-output")
        .option(
            "NUMBER",
            "Serve so many clients at a time; 0 (the default): any number.",
            "--max-connections")
        .option(
            "FILE", "Write the number of the port to FILE once it is open.", "-w", "--port-file")
        .optional(
            "PORT",
            String.valueOf(Settings.STUDIO_PORT),
            "Serve the studio, for browsers, on PORT (default: "
                + Settings.STUDIO_PORT
                + "; 0 takes any free one).",
            "--studio");
    SocketOptions.declare(program);
    AccessOptions.declare(program)
        .option(
            "SITE",
            "Let pages of SITE, as https://app.foxglove.dev, connect to the studio's port by"
                + " Foxglove's protocol; several are separated by commas.",
            "--studio-origin")
        .each(
            "PATH",
            "Show the slot PATH, as robot.body.x, to Foxglove and in the MCAP file, besides all"
                + " variables with hooks.",
            watched::add,
            "--watch")
        .option(
            "FILE",
            "Record variables, jobs and the log to FILE, an MCAP file for Foxglove.",
            "--mcap")
        .option("FILE", "Record the run to FILE, so that it can be replayed.", "--record")
        .option(
            "FILE", "Replay the run that FILE is a recording of, and do nothing else.", "--replay");
    inputs.declare(program);
    program
        .flag("Read a session from the terminal; the default without input.", "-i", "--interactive")
        .flag(
            "Exit with 1 after an error that nobody handled, even if the script says shutdown.",
            "--strict")
        .each("MODULE", "Load the UObject MODULE.", modules::add, "-m", "--module")
        .flag(
            "Run each MODULE in a process of its own: a crash there costs its objects alone.",
            "--isolate")
        .arguments("[FILE [ARGUMENT]...]", "A script, and what it sees as System.arguments.")
        .stopAtArgument();
    return program;
  }

  private int start(Arguments arguments) {
    if (arguments.has("--print-root")) {
      out.println(SearchPath.root());
      return 0;
    }
    String replay = arguments.value("--replay");
    if (replay != null) {
      if (!arguments.rest().isEmpty()
          || !inputs.isEmpty()
          || arguments.has("--record")
          || arguments.has("--mcap")) {
        throw Failure.usage("--replay runs what is recorded, and nothing else");
      }
      return new ReplayedRun(replay, out, err).run();
    }
    int port = arguments.number("--port", Settings.NO_PORT, Settings.NO_PORT, MAX_PORT);
    SocketOptions socket = SocketOptions.of(arguments);
    if (!serves(port, socket, arguments)) {
      return new Server(settings(arguments, port, socket, err), out, err, () -> {}).run();
    }
    PrintStream before = System.err;
    try (ErrorOutput output = new ErrorOutput(errors)) {
      PrintStream messages = output.messages();
      if (err == before) {
        System.setErr(messages);
      }
      Settings settings = settings(arguments, port, socket, messages);
      return new Server(settings, out, messages, output::drain).run();
    } finally {
      System.setErr(before);
    }
  }

  private static boolean serves(int port, SocketOptions socket, Arguments arguments) {
    return port != Settings.NO_PORT || socket.file() != null || arguments.has("--studio");
  }

  private Settings settings(
      Arguments arguments, int port, SocketOptions socket, PrintStream messages) {
    List<String> rest = arguments.rest();
    if (port == Settings.NO_PORT && arguments.has("--port-file")) {
      throw Failure.usage("--port-file needs --port (--port 0 takes any free one)");
    }
    boolean serves = serves(port, socket, arguments);
    Settings.Input input = Settings.Input.NONE;
    if (arguments.has("--interactive")
        || rest.isEmpty()
            && inputs.isEmpty()
            && modules.isEmpty()
            && !arguments.has("--port")
            && !arguments.has("--studio")
            && socket.file() == null) {
      input = Settings.Input.SESSION;
    } else if (!rest.isEmpty() && !Terminal.isStandardInput()) {
      input = Settings.Input.STREAM;
    }
    if (!rest.isEmpty()) {
      inputs.addFile(rest.getFirst());
    }
    StringBuilder text = new StringBuilder();
    for (String module : modules) {
      text.append(
          arguments.has("--isolate")
              ? SourceText.isolateModule(module)
              : SourceText.loadModule(module));
    }
    SourceText.append(text, inputs.text());
    String portFile = arguments.value("--port-file");
    return new Settings(
        trace(arguments, messages),
        SearchPath.of(System.getenv("URBI_PATH"), SearchPath.standard(SearchPath.root())),
        SearchPath.of(
            System.getenv("URBI_UOBJECT_PATH"), SearchPath.standardModules(SearchPath.root())),
        arguments.has("--fast"),
        stackSize(arguments),
        arguments.duration("--max-hold", serves ? MAX_HOLD : Duration.ZERO),
        arguments.duration("--watchdog", WATCHDOG),
        arguments.has("--quiet"),
        errorStyle(arguments),
        arguments.value("--host", "127.0.0.1"),
        port,
        portFile == null ? null : Path.of(portFile),
        arguments.number("--studio", Settings.NO_PORT, 0, MAX_PORT),
        shown(arguments),
        arguments.value("--mcap"),
        socket,
        AccessOptions.of(arguments),
        arguments.value("--record"),
        arguments.number("--max-connections", 0, 0, Integer.MAX_VALUE),
        (long) arguments.number("--max-output", 0, 1, 1 << 20) << 20,
        budget(arguments),
        arguments.has("--strict"),
        text.toString(),
        input,
        rest.isEmpty() ? List.of() : rest.subList(1, rest.size()),
        System.getProperty("urbi.program", SearchPath.root().resolve("urbi").toString()));
  }

  private Shown shown(Arguments arguments) {
    if (!watched.isEmpty() && !arguments.has("--studio") && !arguments.has("--mcap")) {
      throw Failure.usage("--watch needs --studio or --mcap, which show the slot");
    }
    String sites = arguments.value("--studio-origin");
    Set<String> origins = sites == null ? Set.of() : Set.copyOf(List.of(sites.split(",")));
    for (String site : origins) {
      if (!site.matches("https?://[^/]+")) {
        throw Failure.usage(
            "invalid --studio-origin: " + site + ": https://HOST or http://HOST:PORT expected");
      }
    }
    return new Shown(List.copyOf(watched), origins);
  }

  private static ErrorStyle errorStyle(Arguments arguments) {
    String style = arguments.value("--errors");
    if (style == null) {
      return Terminal.errorStyle();
    }
    return switch (style) {
      case "plain" -> ErrorStyle.PLAIN;
      case "explained" -> ErrorStyle.EXPLAINED;
      case "coloured", "colored" -> ErrorStyle.COLOURED;
      default -> throw Failure.usage("invalid --errors: " + style + ": plain, explained, coloured");
    };
  }

  private static String budget(Arguments arguments) {
    String limits = arguments.value("--budget", "");
    try {
      new Budget().setLimits(limits);
      return limits;
    } catch (IllegalArgumentException e) {
      throw Failure.usage("invalid --budget: " + e.getMessage());
    }
  }

  private static int stackSize(Arguments arguments) {
    String environment = System.getenv("URBI_STACK_SIZE");
    int otherwise =
        environment == null || environment.isEmpty()
            ? 0
            : Arguments.number("URBI_STACK_SIZE", environment, 1, Integer.MAX_VALUE);
    return arguments.number("--stack-size", otherwise, 1, Integer.MAX_VALUE);
  }

  /** Sets the log level of the kernel, of urbiscript's loggers and of the libraries. */
  private static Trace trace(Arguments arguments, PrintStream messages) {
    String level =
        arguments.has("--debug") ? arguments.value("--debug") : System.getenv("GD_LEVEL");
    try {
      Trace trace =
          new Trace(
              level == null || level.isEmpty() ? Trace.Level.LOG : Trace.Level.parse(level),
              messages);
      // The library reads it when it logs for the first time.
      System.setProperty("org.slf4j.simpleLogger.defaultLogLevel", trace.level().inLibraries());
      return trace;
    } catch (IllegalArgumentException e) {
      throw Failure.usage(e.getMessage());
    }
  }
}
