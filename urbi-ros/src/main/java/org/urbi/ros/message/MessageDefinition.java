package org.urbi.ros.message;

import java.util.List;

/**
 * What one file says: the fields of a message in the order in which they are sent.
 *
 * @param text the file itself
 */
public record MessageDefinition(
    TypeName name, Dialect dialect, List<Field> fields, List<Constant> constants, String text) {
  public MessageDefinition {
    fields = List.copyOf(fields);
    constants = List.copyOf(constants);
  }
}
