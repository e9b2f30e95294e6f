package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.eclipse.jdt.core.compiler.batch.BatchCompiler;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/**
 * An Eclipse project as Eclipse reads it: {@code .project}, {@code .classpath}, and the launch
 * configuration of the same name.
 */
final class EclipseProject {
  private static final String CONTAINER = "org.eclipse.jdt.launching.JRE_CONTAINER/";
  private static final String LAUNCHING = "org.eclipse.jdt.launching.";

  private final Path folder;
  private final String name;
  private final List<Path> sources = new ArrayList<>();
  private final List<Path> libraries = new ArrayList<>();
  private final Map<String, String> launch;
  private String release;
  private Path output;

  /** Reads the project that is in a folder. */
  EclipseProject(Path folder) throws IOException {
    this.folder = folder;
    Element project = parse(".project").getDocumentElement();
    name = project.getElementsByTagName("name").item(0).getTextContent();
    NodeList entries = parse(".classpath").getElementsByTagName("classpathentry");
    for (int i = 0; i < entries.getLength(); i++) {
      Element entry = (Element) entries.item(i);
      addEntry(entry.getAttribute("kind"), entry.getAttribute("path"));
    }
    launch = attributes(parse(name + ".launch"));
  }

  private Document parse(String file) throws IOException {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(folder.resolve(file).toFile());
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(file, e);
    }
  }

  private void addEntry(String kind, String path) {
    switch (kind) {
      case "src" -> sources.add(folder.resolve(path));
      case "lib" -> libraries.add(folder.resolve(path).normalize());
      case "output" -> output = folder.resolve(path);
      case "con" -> {
        if (!path.startsWith(CONTAINER)) {
          throw new AssertionError("unknown container: " + path);
        }
        release = path.replaceFirst(".*JavaSE-", "");
      }
      default -> throw new AssertionError("unknown kind of entry: " + kind);
    }
  }

  private static Map<String, String> attributes(Document launch) {
    Map<String, String> attributes = new TreeMap<>();
    NodeList strings = launch.getElementsByTagName("stringAttribute");
    for (int i = 0; i < strings.getLength(); i++) {
      Element attribute = (Element) strings.item(i);
      attributes.put(attribute.getAttribute("key"), attribute.getAttribute("value"));
    }
    return attributes;
  }

  String name() {
    return name;
  }

  /** The jars that it is compiled with, where its files say they are. */
  List<Path> libraries() {
    return libraries;
  }

  /** Where the classes go. */
  Path output() {
    return output;
  }

  /** The attribute of the launch configuration, or an empty string. */
  String launch(String key) {
    return launch.getOrDefault(LAUNCHING + key, "");
  }

  /** The arguments of the program, with Eclipse's variables replaced. */
  List<String> programArguments() {
    String text =
        launch("PROGRAM_ARGUMENTS").replace("${project_loc:" + name + "}", folder.toString());
    return Stream.of(text.split(" "))
        .filter(word -> !word.isEmpty())
        .map(word -> word.replace("\"", ""))
        .toList();
  }

  /**
   * Compiles the project by Eclipse's compiler for the release that the project asks for.
   *
   * @param others what the compiler is given for the libraries
   * @return all that the compiler has to say, warnings included
   */
  String compile(List<Path> others) throws IOException {
    List<String> command =
        new ArrayList<>(List.of("--release", release, "-proc:none", "-encoding", "UTF-8"));
    command.addAll(List.of("-classpath", joined(others), "-d", output.toString()));
    for (Path source : sources) {
      command.add(source.toString());
    }
    StringWriter messages = new StringWriter();
    PrintWriter writer = new PrintWriter(messages);
    boolean compiled = BatchCompiler.compile(command.toArray(String[]::new), writer, writer, null);
    writer.flush();
    assertEquals(true, compiled, messages::toString);
    return messages.toString();
  }

  /** The class path of the running program. */
  String classPath(List<Path> others) {
    return output + File.pathSeparator + joined(others);
  }

  private static String joined(List<Path> paths) {
    return String.join(File.pathSeparator, paths.stream().map(Path::toString).toList());
  }

  /** Copies a project, so that what is made of it lies elsewhere. */
  static Path copy(Path from, Path to) throws IOException {
    try (Stream<Path> walk = Files.walk(from)) {
      for (Path file : walk.filter(Files::isRegularFile).toList()) {
        Path copy = to.resolve(from.relativize(file));
        if (!from.relativize(file).startsWith("bin")) {
          Files.createDirectories(copy.getParent());
          Files.copy(file, copy);
        }
      }
    }
    return to;
  }
}
