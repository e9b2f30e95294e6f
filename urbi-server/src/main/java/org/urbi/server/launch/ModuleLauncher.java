package org.urbi.server.launch;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.urbi.server.cli.SearchPath;
import org.urbi.server.cli.UrbiCommand;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import org.urbi.server.tools.ServerAddress;
import urbi.ServerConnection;
import urbi.UModule;
import urbi.UModuleException;
import urbi.remote.RemoteProgram;
import urbi.rtp.RtpOptions;
import urbi.spi.ModuleFiles;

/**
 * Runs UObjects in a process of their own that is connected to a server, or plugged into one
 * (manual, sections 21.5 and 21.6): the programs {@code urbi-launch} and {@code urbi-launch-java}.
 */
final class ModuleLauncher {
  private static final String SEPARATOR = "--";
  private static final String CUSTOMIZE = "With --start: run FILE as the server, and not urbi.";

  private final Kind kind;
  private final String name;
  private final PrintStream out;
  private final PrintStream err;
  private List<String> moduleOptions = List.of();

  /** What the program is for. */
  enum Kind {
    /** Libraries, and whatever else can be loaded. */
    ANY,
    /** Jars. */
    JAVA
  }

  ModuleLauncher(Kind kind, PrintStream out, PrintStream err) {
    this.kind = kind;
    this.name = kind == Kind.JAVA ? "urbi-launch-java" : "urbi-launch";
    this.out = out;
    this.err = err;
  }

  int run(String... args) {
    return run(Arrays.asList(args));
  }

  private int run(List<String> words) {
    int separator = words.indexOf(SEPARATOR);
    List<String> own = separator < 0 ? words : words.subList(0, separator);
    moduleOptions = separator < 0 ? List.of() : words.subList(separator + 1, words.size());
    Program program =
        new Program(
            name,
            (kind == Kind.JAVA ? "Runs UObjects written in Java" : "Runs UObjects")
                + ", in a process of their own or plugged into a server.");
    if (kind == Kind.JAVA) {
      declareJava(program);
    } else {
      declareAny(program);
    }
    program
        .flag("Show the root folder of this installation and exit.", "--print-root")
        .option(
            "LEVEL",
            "How much is said: NONE, LOG, TRACE, DEBUG or DUMP (default: GD_LEVEL, or LOG).",
            "-d",
            "--debug")
        .flag(
            "Have a running server load each MODULE, as loadModule(\"MODULE\") does.",
            "-p",
            "--plugin")
        .flag("Run in this process, connected to a server; the default.", "-r", "--remote")
        .flag(
            "Start a server with each MODULE plugged in; MODULE-OPTIONs are options of urbi.",
            "-s",
            "--start")
        .option(
            "ADDRESS",
            "Address of the server (default: 127.0.0.1), or with a / the file of its socket; with"
                + " --start where it listens.",
            "-H",
            "--host")
        .option(
            "PORT",
            "Port of the server (default: %d); with --start where it listens, if anywhere."
                .formatted(ServerAddress.DEFAULT_PORT),
            "-P",
            "--port")
        .option(
            "FILE",
            "The port is written in FILE; with --start: write it there.",
            "-w",
            "--port-file");
    ServerAddress.trustOptions(ServerAddress.waitOption(program))
        .arguments(
            "MODULE... [-- MODULE-OPTION...]",
            (kind == Kind.JAVA ? "Jars, or folders of classes" : "Shared libraries, or jars")
                + ", looked for in URBI_UOBJECT_PATH. What follows -- is for"
                + " the modules, or with --start for urbi.");
    return program.run(own.toArray(String[]::new), out, err, this::launch);
  }

  private static void declareJava(Program program) {
    program
        .option("FILE", CUSTOMIZE, "--customize")
        .flag("Exit with status 0 if UObjects in Java can be used.", "-C", "--check")
        .option(
            "PATH",
            "Jars and folders, with colons between them, of classes that the modules refer to.",
            "-c",
            "--classpath");
  }

  private static void declareAny(Program program) {
    program
        .option("FILE", CUSTOMIZE, "-c", "--customize")
        .flag("Show what each MODULE declares, and exit.", "--describe");
  }

  private int launch(Arguments arguments) {
    if (arguments.has("--print-root")) {
      out.println(SearchPath.root());
      return 0;
    }
    if (arguments.has("--check")) {
      // The running Java is new enough, and has the classes.
      return 0;
    }
    List<String> modes =
        List.of("--plugin", "--remote", "--start").stream().filter(arguments::has).toList();
    if (modes.size() > 1) {
      throw Failure.usage("choose one of " + String.join(", ", modes));
    }
    if (arguments.has("--customize") && !arguments.has("--start")) {
      throw Failure.usage("--customize needs --start");
    }
    if (arguments.has("--wait") && arguments.has("--start")) {
      throw Failure.usage("--wait is for --plugin and --remote: --start has no server to wait for");
    }
    if (arguments.has("--plugin") && arguments.has("--debug")) {
      throw Failure.usage("--debug is for --start and --remote");
    }
    if (arguments.has("--classpath")) {
      System.setProperty("urbi.classpath", arguments.value("--classpath", ""));
    }
    if (arguments.has("--start")) {
      return start(arguments);
    }
    if (arguments.rest().isEmpty()) {
      throw Failure.usage("no MODULE: which UObjects are to be run?");
    }
    if (arguments.has("--describe")) {
      return describe(arguments);
    }
    return arguments.has("--plugin")
        ? new PluginRequest(name, err).load(arguments)
        : remote(arguments);
  }

  private int describe(Arguments arguments) {
    ModulePath path = ModulePath.ofEnvironment();
    for (String word : arguments.rest()) {
      Path file = path.find(word);
      try {
        UModule module = ModuleFiles.load(file);
        out.println(file);
        module.hubs().forEach(hub -> out.println("  hub " + hub.name()));
        module.classes().forEach(type -> out.println("  class " + type.name()));
      } catch (UModuleException e) {
        throw Failure.of(e.getMessage());
      }
    }
    return 0;
  }

  private int start(Arguments arguments) {
    List<String> options = new ArrayList<>();
    for (String option : List.of("--host", "--port", "--port-file", "--debug")) {
      String value = arguments.value(option);
      if (value != null) {
        boolean file = option.equals("--host") && ServerConnection.isFile(value);
        options.addAll(List.of(file ? "--socket" : option, value));
      }
    }
    ModulePath path = ModulePath.ofEnvironment();
    for (String module : arguments.rest()) {
      String found = module.equals(RtpOptions.MODULE) ? module : path.findJar(module).toString();
      options.addAll(List.of("--module", found));
    }
    options.addAll(moduleOptions);
    String other = arguments.value("--customize");
    return other == null
        ? UrbiCommand.run(options.toArray(String[]::new), out, err)
        : runProcess(other, options);
  }

  private static int runProcess(String program, List<String> options) {
    List<String> command = new ArrayList<>();
    command.add(program);
    command.addAll(options);
    try {
      return new ProcessBuilder(command).inheritIO().start().waitFor();
    } catch (IOException e) {
      throw Failure.of("cannot run " + program + ": " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw Failure.of("interrupted");
    }
  }

  private int remote(Arguments arguments) {
    ModulePath path = ModulePath.ofEnvironment();
    ServerAddress server = ServerAddress.of(arguments, arguments.value("--host", "127.0.0.1"));
    if (arguments.has("--wait")) {
      server.await();
    }
    List<String> words =
        new ArrayList<>(List.of("--host", server.host(), "--port", String.valueOf(server.port())));
    String given = arguments.value("--debug");
    String level = given == null ? System.getenv("GD_LEVEL") : given;
    if (level != null) {
      words.addAll(List.of("--debug", level));
    }
    for (String module : arguments.rest()) {
      words.add(module.equals(RtpOptions.MODULE) ? module : path.find(module).toString());
    }
    words.addAll(moduleOptions);
    return new RemoteProgram().run(words.toArray(String[]::new), null, out, err);
  }
}
