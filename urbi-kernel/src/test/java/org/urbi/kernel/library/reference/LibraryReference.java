package org.urbi.kernel.library.reference;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.library.Library;

/** The pages of the reference of the library, in Markdown: one for each type, and an index. */
final class LibraryReference {
  private static final String ITEM = "* ";

  private static final String LOADED =
      """


      ## Libraries to be loaded

      They are written in urbiscript, in `share/urbi`.

      """;

  private LibraryReference() {}

  /** What is declared about each type, by its name. */
  static Map<String, TypeDeclaration> types() {
    Map<String, TypeDeclaration> types = new TreeMap<>();
    for (BuiltinTable table : Library.declarations()) {
      types.computeIfAbsent(table.type(), name -> new TypeDeclaration()).add(table);
    }
    return types;
  }

  /** The pages of all types and of the libraries to be loaded, by the names of their files. */
  static Map<String, String> pages() {
    Map<String, String> pages = new LinkedHashMap<>();
    Map<String, TypeDeclaration> types = types();
    types.keySet().forEach(name -> pages.put(name + ".md", TypePage.markdown(name, types)));
    pages.put(HelpTexts.KEYWORDS + ".md", keywords());
    ScriptPage.all().forEach(page -> pages.put(page.name(), page.markdown()));
    return pages;
  }

  /** The page about the words of the language; nobody declares these but the grammar. */
  private static String keywords() {
    return TypeText.resource(HelpTexts.KEYWORDS + ".md").orElseThrow();
  }

  /** The page with a line for each type, by topics. */
  static String index() {
    Map<String, TypeDeclaration> types = types();
    String listed =
        topics()
            .lines()
            .map(line -> line.startsWith(ITEM) ? item(line.substring(ITEM.length()), types) : line)
            .collect(Collectors.joining("\n"));
    return ScriptPage.all().stream()
        .map(ScriptPage::item)
        .collect(Collectors.joining("\n", listed + LOADED, "\n"));
  }

  private static String item(String name, Map<String, TypeDeclaration> types) {
    TypeDeclaration type = types.get(name);
    if (type == null) {
      throw new IllegalArgumentException("the index has a type that nobody declares: " + name);
    }
    return ITEM + "[" + name + "](library/" + name + ".md): " + type.doc();
  }

  /** The index before the sentences are filled in: a line {@code * NAME} for each type. */
  static String topics() {
    return TypeText.resource("index.md").orElseThrow();
  }
}
