package org.urbi.server.make;

import java.io.File;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.urbi.server.Version;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The program {@code umake-java}: compiles UObjects written in Java, and packs them into a jar
 * (manual, "The umake-java and urbi-launch-java tools" and section 21.10).
 */
public final class UmakeJava {
  private static final String FLAGS = "EXTRA_JAVACFLAGS";
  private static final String SOURCE_PATH = "VPATH";
  private static final String DEFAULT_OUTPUT = "uobject.jar";

  private final PrintStream out;
  private final PrintStream err;
  private final List<String> extraFlags = new ArrayList<>();
  private final List<Path> sourcePath = new ArrayList<>();

  private UmakeJava(PrintStream out, PrintStream err) {
    this.out = out;
    this.err = err;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new UmakeJava(out, err).run(args);
  }

  private int run(String[] args) {
    Program program =
        new Program(
            "umake-java", "Compiles UObjects written in Java into a jar that Urbi can load.");
    program
        .option(
            "FILE",
            "The jar to make (default: " + DEFAULT_OUTPUT + "); without a suffix .jar is added.",
            "-o",
            "--output")
        .option(
            "PATH",
            "Jars and folders of classes that the sources refer to, and that are not packed.",
            "--classpath")
        .flag("Produce no output except errors.", "-q", "--quiet")
        .flag("Report on what is done.", "-v", "--verbose")
        .flag("Show how the compiler is called.", "--debug")
        .flag("Show the version and exit.", "-V")
        .flag("Compile everything anew, as it always does.", "-c", "--clean")
        .flag("Remove the building folders, of which there are none, and exit.", "--deep-clean")
        .option("JOBS", "Accepted: the compiler decides itself.", "-j", "--jobs")
        .arguments(
            "[FILE|FOLDER|NAME=VALUE]...",
            "Sources (.java), classes and jars, or folders in which to look for them (default: the"
                + " current one). EXTRA_JAVACFLAGS=… are more options for the compiler, VPATH=… more"
                + " folders to look into; both may be environment variables as well.");
    return program.run(args, out, err, this::make);
  }

  private int make(Arguments arguments) {
    if (arguments.has("-V")) {
      out.print(Version.text("umake-java"));
      return 0;
    }
    arguments.number("--jobs", 1, 1, Integer.MAX_VALUE);
    if (arguments.has("--deep-clean")) {
      return 0;
    }
    assign(FLAGS, System.getenv(FLAGS));
    assign(SOURCE_PATH, System.getenv(SOURCE_PATH));
    Path output = output(arguments);
    List<String> names = arguments.rest().stream().filter(word -> !isAssignment(word)).toList();
    ModuleInputs ingredients = ModuleInputs.gather(names, sourcePath, output);

    ModuleJar jar = new ModuleJar();
    compile(ingredients, arguments, jar);
    ingredients.classes().forEach(jar::addClass);
    jar.addResources(ingredients.others(), ingredients.sources());
    ingredients.libraries().forEach(jar::addLibrary);
    jar.write(output);
    report(jar, output, arguments);
    return 0;
  }

  private void compile(ModuleInputs ingredients, Arguments arguments, ModuleJar jar) {
    if (ingredients.sources().isEmpty()) {
      return;
    }
    List<Path> classPath = ingredients.classPath(paths(arguments.value("--classpath", "")));
    List<String> options = SourceCompiler.options(classPath, sourcePath, extraFlags);
    if (!arguments.has("--quiet")) {
      say("compiling " + count(ingredients.sources().size(), "file"));
    }
    if (arguments.has("--verbose")) {
      ingredients.sources().forEach(source -> say("  " + source));
    }
    if (arguments.has("--debug")) {
      say("javac " + String.join(" ", options));
    }
    SourceCompiler compiler = new SourceCompiler(err, !arguments.has("--quiet"));
    jar.add(compiler.compile(ingredients.sources(), options));
  }

  private void report(ModuleJar jar, Path output, Arguments arguments) {
    List<String> uobjects = jar.uobjects();
    if (uobjects.isEmpty()) {
      err.println(
          "umake-java: warning: no class in "
              + output
              + " calls UStart, urbi-launch-java will say"
              + " that it has no UObject");
    }
    if (!arguments.has("--quiet")) {
      say(
          "made "
              + output
              + ": "
              + count(jar.classCount(), "class")
              + (uobjects.isEmpty() ? "" : ", UObjects: " + String.join(", ", uobjects)));
    }
  }

  /** Takes NAME=VALUE; an argument without an equals sign is a file. */
  private boolean isAssignment(String word) {
    int equals = word.indexOf('=');
    if (equals <= 0 || !word.substring(0, equals).matches("[A-Z_]+")) {
      return false;
    }
    String name = word.substring(0, equals);
    if (!assign(name, word.substring(equals + 1))) {
      throw Failure.usage(
          "unknown variable: " + name + " (there are " + FLAGS + " and " + SOURCE_PATH + ")");
    }
    return true;
  }

  private boolean assign(String name, String value) {
    if (!name.equals(FLAGS) && !name.equals(SOURCE_PATH)) {
      return false;
    }
    if (value != null && !value.isBlank()) {
      if (name.equals(FLAGS)) {
        extraFlags.addAll(Arrays.asList(value.strip().split("\\s+")));
      } else {
        sourcePath.addAll(paths(value));
      }
    }
    return true;
  }

  private static Path output(Arguments arguments) {
    String name = arguments.value("--output", DEFAULT_OUTPUT);
    if (name.isBlank() || name.endsWith(File.separator)) {
      throw Failure.usage("invalid --output: " + name + " (the name of a file)");
    }
    return Path.of(name.endsWith(".jar") || name.endsWith(".zip") ? name : name + ".jar");
  }

  private static List<Path> paths(String text) {
    return Stream.of(text.split(File.pathSeparator))
        .filter(part -> !part.isEmpty())
        .map(Path::of)
        .toList();
  }

  static String count(int number, String what) {
    String plural = what.endsWith("s") ? what + "es" : what + "s";
    return number + " " + (number == 1 ? what : plural);
  }

  private void say(String message) {
    out.println("umake-java: " + message);
  }
}
