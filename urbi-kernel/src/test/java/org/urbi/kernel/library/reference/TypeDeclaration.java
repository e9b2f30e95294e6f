package org.urbi.kernel.library.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.trust.Role;

/** What the tables of builtins declare about a type. */
final class TypeDeclaration {
  /**
   * A slot with a builtin.
   *
   * @param signature its name, its arguments and the type of its result
   * @param doc what it does, in sentences
   */
  record Slot(String signature, String doc) {}

  private String doc = "";
  private List<String> protos = List.of();
  private final Map<String, Slot> slots = new LinkedHashMap<>();

  void add(BuiltinTable table) {
    if (!table.isPart()) {
      doc = table.doc();
      protos = List.of(table.protos());
    }
    List<String> assignable = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      if (table.isSetter(i)) {
        assignable.add(table.name(i));
      }
    }
    for (int i = 0; i < table.size(); i++) {
      if (!table.isSetter(i)) {
        String assigned = assignable.contains(table.name(i)) ? " It can be assigned." : "";
        String doc = table.doc(i) + assigned + needed(table.leastRole(i));
        slots.put(table.name(i), new Slot(table.signature(i), doc));
      }
    }
  }

  /** What must be said about the role that it needs: nothing, if all have it. */
  private static String needed(Role role) {
    return role == Role.OBSERVER
        ? ""
        : " It needs the role [" + role.text() + "](../networking.md#roles).";
  }

  /** What it is, in a sentence. */
  String doc() {
    return doc;
  }

  /** The names of the prototypes, in the order in which they are looked up. */
  List<String> protos() {
    return protos;
  }

  /** The names of its slots in the order of their declaration. */
  Set<String> names() {
    return slots.keySet();
  }

  /** The slots with builtins, by their names, in the order of their declaration. */
  Map<String, Slot> slots() {
    return slots;
  }
}
