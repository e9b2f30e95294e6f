package org.urbi.kernel.library.reference;

import static java.util.Objects.requireNonNull;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Writes the page of a type: the signatures and sentences of its builtins, and the text about it.
 */
final class TypePage {
  private final TypeDeclaration type;
  private final StringBuilder out = new StringBuilder();

  private TypePage(TypeDeclaration type) {
    this.type = type;
  }

  /** The page of the type of that name, one of all types. */
  static String markdown(String name, Map<String, TypeDeclaration> all) {
    TypePage page = new TypePage(requireNonNull(all.get(name), "declared"));
    page.write(name, all.keySet());
    return page.out.toString();
  }

  private void write(String name, Set<String> pages) {
    paragraph("# " + name);
    paragraph(type.doc());
    if (!type.protos().isEmpty()) {
      paragraph(
          type.protos().stream()
              .map(proto -> pages.contains(proto) ? "[" + proto + "](" + proto + ".md)" : proto)
              .collect(joining(", ", "Prototypes: ", ".")));
    }
    List<String> left = new ArrayList<>(type.names());
    for (TypeText.Part part : TypeText.of(name).map(TypeText::parts).orElse(List.of())) {
      if (!part.names().isEmpty()) {
        paragraph(part.names().stream().map(TypePage::code).collect(joining(", ", "### ", "")));
        slots(part.names());
        left.removeAll(part.names());
      }
      paragraph(part.markdown());
    }
    slots(left);
    out.setLength(out.length() - 1);
  }

  /** The signatures, those of one method beside each other, and what they do. */
  private void slots(List<String> names) {
    Map<String, List<String>> signatures =
        names.stream()
            .map(type.slots()::get)
            .filter(Objects::nonNull)
            .collect(
                groupingBy(
                    TypeDeclaration.Slot::doc,
                    LinkedHashMap::new,
                    mapping(slot -> code(slot.signature()), toList())));
    String bullet = signatures.size() > 1 ? "* " : "";
    paragraph(
        signatures.entrySet().stream()
            .map(slot -> bullet + String.join(", ", slot.getValue()) + ": " + slot.getKey())
            .collect(joining("\n")));
  }

  private void paragraph(String text) {
    if (!text.isEmpty()) {
      out.append(text).append("\n\n");
    }
  }

  private static String code(String text) {
    return "`" + text + "`";
  }
}
