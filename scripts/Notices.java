import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Writes the notices of what a distribution contains of others: Notices.java BOM FOLDER FILE. The
 * bill of materials tells which libraries there are and what their licences are; the texts are those
 * that the libraries' jars in the folder bring. Called by ./build.
 */
public final class Notices {
  /** Texts in a jar that its licence wants to be passed on. */
  private static final Pattern TEXT =
      Pattern.compile(
          "(?i)(META-INF/([^/]+/)*(LICEN[CS]E|NOTICE|COPYING|AL2\\.0|LGPL2\\.1)[^/]*"
              + "|.*/licenses/.*[^/])(?<!\\.class)");

  private static final String RULE = "=".repeat(100);

  private Notices() {}

  public static void main(String[] arguments) throws Exception {
    List<String> components = components(Path.of(arguments[0]));
    if (components.isEmpty()) {
      throw new IOException("no components: " + arguments[0]);
    }
    try (PrintStream out =
        new PrintStream(
            Files.newOutputStream(Path.of(arguments[2])), false, StandardCharsets.UTF_8)) {
      out.println("This distribution contains libraries of others, unchanged, under these licences:\n");
      components.forEach(out::println);
      for (Map.Entry<String, List<String>> each : texts(Path.of(arguments[1])).entrySet()) {
        out.println("\n" + RULE);
        each.getValue().forEach(out::println);
        out.println(RULE + "\n");
        out.println(each.getKey());
      }
    }
  }

  private static List<String> components(Path bom) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    Document document = factory.newDocumentBuilder().parse(bom.toFile());
    NodeList all = document.getElementsByTagName("component"); // those of the tools as well
    TreeSet<String> lines = new TreeSet<>();
    for (int i = 0; i < all.getLength(); i++) {
      Element component = (Element) all.item(i);
      String group = text(component, "group");
      boolean inside = component.getParentNode().getParentNode() == document.getDocumentElement();
      if (inside && !group.equals("org.urbi")) {
        lines.add(
            "%s:%s %s: %s%s"
                .formatted(
                    group,
                    text(component, "name"),
                    text(component, "version"),
                    licences(component),
                    source(component)));
      }
    }
    return new ArrayList<>(lines);
  }

  private static String licences(Element component) {
    NodeList licences = component.getElementsByTagName("license");
    List<String> names = new ArrayList<>();
    for (int i = 0; i < licences.getLength(); i++) {
      Element licence = (Element) licences.item(i);
      String id = text(licence, "id");
      names.add(id.isEmpty() ? text(licence, "name") : id);
    }
    return names.isEmpty() ? text(component, "expression") : String.join(" or ", names);
  }

  private static String source(Element component) {
    NodeList references = component.getElementsByTagName("reference");
    for (int i = 0; i < references.getLength(); i++) {
      Element reference = (Element) references.item(i);
      if (reference.getAttribute("type").equals("vcs")) {
        return " (" + text(reference, "url") + ")";
      }
    }
    return "";
  }

  private static String text(Element parent, String name) {
    NodeList found = parent.getElementsByTagName(name);
    return found.getLength() == 0 ? "" : found.item(0).getTextContent().strip();
  }

  /** Each text, with the names of those who bring it. */
  private static Map<String, List<String>> texts(Path folder) throws IOException {
    List<Path> jars;
    try (Stream<Path> files = Files.list(folder)) {
      jars =
          files
              .filter(file -> file.toString().endsWith(".jar"))
              .sorted(Comparator.comparing(Path::toString))
              .toList();
    }
    Map<String, List<String>> texts = new LinkedHashMap<>();
    for (Path jar : jars) {
      try (JarFile file = new JarFile(jar.toFile())) {
        for (JarEntry entry : Collections.list(file.entries())) {
          if (!entry.isDirectory() && TEXT.matcher(entry.getName()).matches()) {
            try (InputStream in = file.getInputStream(entry)) {
              String text = new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
              texts
                  .computeIfAbsent(text, key -> new ArrayList<>())
                  .add(jar.getFileName() + ": " + entry.getName());
            }
          }
        }
      }
    }
    return texts;
  }
}
