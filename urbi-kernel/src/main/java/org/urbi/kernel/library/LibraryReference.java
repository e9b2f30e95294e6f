package org.urbi.kernel.library;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.kernel.builtin.BuiltinTable;

/** The reference page of the library, made from the tables of builtins. */
public final class LibraryReference {
  private final StringBuilder out = new StringBuilder();
  private final Map<String, StringBuilder> slotsByType = new LinkedHashMap<>();

  private LibraryReference() {}

  /** The page, in Markdown. */
  public static String markdown() {
    LibraryReference reference = new LibraryReference();
    reference.write(Library.declarations());
    return reference.out.toString();
  }

  private void write(List<BuiltinTable> tables) {
    out.append("# The library\n\n");
    out.append("Generated from the declarations of the builtins; do not edit. ");
    out.append("Arguments with `?` may be left out, `...` stands for any number of them.\n");
    for (BuiltinTable table : tables) {
      slotsByType.computeIfAbsent(table.type(), type -> new StringBuilder());
      appendSlots(slotsByType.get(table.type()), table);
    }
    for (BuiltinTable table : tables) {
      if (!table.isPart()) {
        appendType(table);
      }
    }
  }

  private void appendType(BuiltinTable table) {
    out.append("\n## ").append(table.type()).append("\n\n").append(table.doc()).append('\n');
    if (table.protos().length > 0) {
      out.append("Prototypes: ").append(String.join(", ", table.protos())).append(".\n");
    }
    StringBuilder slots = slotsByType.get(table.type());
    if (slots != null && !slots.isEmpty()) {
      out.append('\n').append(slots);
    }
  }

  private static void appendSlots(StringBuilder slots, BuiltinTable table) {
    Set<String> assignable = new LinkedHashSet<>();
    for (int i = 0; i < table.size(); i++) {
      if (table.isSetter(i)) {
        assignable.add(table.name(i));
      }
    }
    for (int i = 0; i < table.size(); i++) {
      if (table.isSetter(i)) {
        continue;
      }
      slots.append("* ").append(slot(table, i));
      boolean canBeAssigned = assignable.contains(table.name(i));
      while (i + 1 < table.size() && isSame(table, i, i + 1)) {
        i++;
        slots.append(", ").append(slot(table, i));
      }
      slots.append(": ").append(table.doc(i));
      slots.append(canBeAssigned ? " It can be assigned.\n" : "\n");
    }
  }

  private static String slot(BuiltinTable table, int index) {
    return "`" + table.name(index) + table.formals(index) + "`";
  }

  /** Whether two entries are two names of one method. */
  private static boolean isSame(BuiltinTable table, int i, int j) {
    return !table.isSetter(j)
        && table.doc(i).equals(table.doc(j))
        && table.formals(i).equals(table.formals(j));
  }
}
