package org.urbi.kernel.library;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Map;
import org.urbi.kernel.library.code.ScriptCode;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/**
 * Names that every Urbi 2.7.5 had, which its manual does not explain, and which programs used all
 * the same: other spellings of what there is, and slots of prototypes that nobody has set up.
 */
final class LegacyNames {
  /** A function in urbiscript. */
  private record Function(String type, String name, String text) {}

  private static final List<Function> FUNCTIONS =
      List.of(
          new Function("Object", "++", "function () { this + 1 }"),
          new Function("Object", "--", "function () { this - 1 }"),
          new Function("Float", "sgn", "function () { sign }"),
          new Function("Lazy", "val", "function () { value }"),
          new Function("Date", "yearSet", "function (v) { year = v }"),
          new Function("Date", "monthSet", "function (v) { month = v }"),
          new Function("Date", "daySet", "function (v) { day = v }"),
          new Function("Date", "hourSet", "function (v) { hour = v }"),
          new Function("Date", "minuteSet", "function (v) { minute = v }"),
          new Function("Date", "secondSet", "function (v) { second = v }"),
          new Function("Date", "microsecondSet", "function (v) { microsecond = v }"),
          new Function("Date", "usSet", "function (v) { us = v }"));

  private LegacyNames() {}

  /** Adds them to the types. */
  static void add(Interpreter interpreter, Map<String, UrbiObject> types) {
    for (Function function : FUNCTIONS) {
      add(
          type(types, function.type),
          function.name,
          new ScriptCode(interpreter.prototypes().code.cloneShape(), function.text));
    }
    Values values = interpreter.values();
    add(type(types, "Exception"), "location", values.nil);
    add(type(types, "StackFrame"), "name", values.string(""));
    add(type(types, "StackFrame"), "location", values.nil);
    add(type(types, "Lazy"), "code", values.nil);
    add(type(types, "Enumeration"), "name", values.string("Enumeration"));
    add(type(types, "Enumeration"), "values", values.list(List.of()));
    // The server says so when it listens.
    add(type(types, "System"), "listenPort", values.number(-1));
    add(type(types, "System"), "studio", values.nil);
    add(type(types, "Global"), "FunctionProfile", type(types, "Profile.Function"));
  }

  private static void add(UrbiObject type, String name, UrbiObject value) {
    type.addSlot(type.world().symbol(name), value);
  }

  private static UrbiObject type(Map<String, UrbiObject> types, String name) {
    return requireNonNull(types.get(name), "every type has been made before");
  }
}
