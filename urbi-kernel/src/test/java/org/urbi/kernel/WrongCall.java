package org.urbi.kernel;

import java.util.List;
import org.urbi.kernel.builtin.BuiltinTable;

/** A call of a builtin, of whatever target with whatever arguments; all of them as source text. */
record WrongCall(BuiltinTable table, int index, String target, List<String> arguments) {
  String name() {
    return table.name(index);
  }

  /** The value at a place: 0 is the target. */
  String value(int place) {
    return place == 0 ? target : arguments.get(place - 1);
  }

  boolean hasWrongArity() {
    return arguments.size() < table.minArguments(index)
        || arguments.size() > table.maxArguments(index);
  }

  /** The call in urbiscript, to reproduce it. */
  String source() {
    StringBuilder call = new StringBuilder();
    if (table.isSetter(index)) {
      return "(" + target + ")." + name() + " = " + String.join(", ", arguments);
    }
    call.append(table.type()).append(".getSlot(\"").append(name()).append("\").apply([");
    call.append(target);
    arguments.forEach(argument -> call.append(", ").append(argument));
    return call.append("])").toString();
  }
}
