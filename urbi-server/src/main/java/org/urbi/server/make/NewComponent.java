package org.urbi.server.make;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.urbi.kernel.Kernel;
import org.urbi.server.Version;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The program {@code urbi new}: makes the project of a component, which builds, tests itself and
 * runs. Nothing that is there is touched, and half a project is never left behind.
 */
public final class NewComponent {
  private static final String NAME = "urbi-new";
  private static final Pattern ALLOWED = Pattern.compile("[A-Za-z][A-Za-z0-9_]{0,63}");

  /** Of each file of a project in Java, which template it is made from. */
  private static final Map<String, String> JAVA =
      Map.of(
          "pom.xml", "java/pom.xml",
          "src/main/java/{{CLASS}}.java", "java/Component.java",
          "src/test/java/{{CLASS}}Test.java", "java/ComponentTest.java",
          "src/test/urbi/{{NAME}}.u", "test.u",
          "README.md", "java/README.md",
          ".gitignore", "java/ignore");

  /** Of each file of a project in C++, which template it is made from. */
  private static final Map<String, String> CXX =
      Map.of(
          "CMakeLists.txt", "cxx/CMakeLists.txt",
          "src/{{NAME}}.cc", "cxx/component.cc",
          "test/{{NAME}}.u", "test.u",
          "README.md", "cxx/README.md",
          ".gitignore", "cxx/ignore");

  private final PrintStream out;

  private NewComponent(PrintStream out) {
    this.out = out;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new Program(NAME, "Makes the project of a new component.")
        .flag("A component in Java, built by Maven; the default.", "--java")
        .flag("A component in C++, built by CMake.", "--cxx")
        .arguments(
            "NAME",
            "The folder to make. Its last part is the name of the component: letters of English,"
                + " digits and underscores.")
        .run(args, out, err, new NewComponent(out)::make);
  }

  private int make(Arguments arguments) {
    if (arguments.rest().size() != 1) {
      throw Failure.usage("one NAME is wanted: how is the component called?");
    }
    if (arguments.has("--java") && arguments.has("--cxx")) {
      throw Failure.usage("choose one of --java, --cxx");
    }
    Path folder = Path.of(arguments.rest().getFirst()).toAbsolutePath().normalize();
    String name = Objects.requireNonNullElse(folder.getFileName(), folder).toString();
    String type = checked(name);
    if (Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      throw Failure.of(folder + " is there already; nothing was changed");
    }
    boolean java = !arguments.has("--cxx");
    write(folder, java ? JAVA : CXX, values(name, type));
    out.println(
        "made "
            + folder
            + ": "
            + (java
                ? "mvn verify"
                : "cmake -B build && cmake --build build && ctest --test-dir build")
            + " there builds and tests it; README.md says more");
    return 0;
  }

  /** The name of the class; what urbiscript, Java or the SDK call so would be hidden. */
  private static String checked(String name) {
    if (!ALLOWED.matcher(name).matches()) {
      throw Failure.usage(
          "invalid NAME: "
              + name
              + " (a letter of English, then letters, digits and underscores, 64 at most)");
    }
    String type = name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    if (isClass("java.lang." + type) || isClass("urbi." + type) || isGlobal(type)) {
      throw Failure.usage(
          "invalid NAME: "
              + type
              + " is the name of something else, in urbiscript or Java: choose another one");
    }
    return type;
  }

  private static boolean isClass(String name) {
    try {
      Class.forName(name, false, NewComponent.class.getClassLoader());
      return true;
    } catch (ClassNotFoundException | LinkageError e) {
      // A name that differs from a class's in capitals alone is that of another one.
      return false;
    }
  }

  private static boolean isGlobal(String name) {
    try (Kernel kernel = Kernel.builder().virtualTime(true).start()) {
      return Boolean.TRUE.equals(kernel.eval("Global.hasSlot(\"" + name + "\")"));
    }
  }

  private static Map<String, String> values(String name, String type) {
    String root = System.getProperty("urbi.root", "");
    Map<String, String> values = new LinkedHashMap<>();
    values.put("NAME", name);
    values.put("CLASS", type);
    values.put("ROOT", root);
    values.put("ROOT_XML", root.replace("&", "&amp;").replace("<", "&lt;"));
    values.put("VERSION", Version.number());
    values.put("MAJOR", Version.number().split("\\.", 2)[0]);
    values.put("JAVA", String.valueOf(Runtime.version().feature()));
    return values;
  }

  private static void write(Path folder, Map<String, String> files, Map<String, String> values) {
    Path part = folder.resolveSibling("." + folder.getFileName() + ".part");
    if (Files.exists(part, LinkOption.NOFOLLOW_LINKS)) {
      throw Failure.of(part + " is in the way: another urbi new is at work, or was killed");
    }
    try {
      Files.createDirectories(folder.getParent());
      Files.createDirectory(part);
    } catch (IOException e) {
      throw Failure.of("cannot make " + folder + ": " + e);
    }
    try {
      for (Map.Entry<String, String> file : files.entrySet()) {
        Path target = part.resolve(filled(file.getKey(), values));
        Files.createDirectories(target.getParent());
        Files.writeString(target, filled(template(file.getValue()), values));
      }
      Files.move(part, folder);
    } catch (IOException e) {
      remove(part);
      throw Failure.of("cannot make " + folder + ": " + e);
    } catch (RuntimeException | Error e) {
      remove(part);
      throw e;
    }
  }

  private static String filled(String template, Map<String, String> values) {
    String text = template;
    for (Map.Entry<String, String> value : values.entrySet()) {
      text = text.replace("{{" + value.getKey() + "}}", value.getValue());
    }
    return text;
  }

  private static String template(String name) throws IOException {
    try (InputStream in = NewComponent.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static void remove(Path folder) {
    try (Stream<Path> all = Files.walk(folder)) {
      List<Path> deepestFirst = all.sorted(Comparator.reverseOrder()).toList();
      for (Path each : deepestFirst) {
        Files.deleteIfExists(each);
      }
    } catch (IOException | UncheckedIOException e) {
      throw Failure.of("cannot remove " + folder + ", which is half made: " + e);
    }
  }
}
