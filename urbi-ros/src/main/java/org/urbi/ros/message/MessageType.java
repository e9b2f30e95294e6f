package org.urbi.ros.message;

import java.util.SortedMap;

/**
 * A message with all that it consists of: what is needed to send and to understand it.
 *
 * @param referenced the definitions of the messages in it, and in those, however deep
 */
public record MessageType(
    MessageDefinition definition, SortedMap<TypeName, MessageDefinition> referenced) {
  public TypeName name() {
    return definition.name();
  }

  public Dialect dialect() {
    return definition.dialect();
  }

  /**
   * The definition of this message, or of one in it.
   *
   * @throws DefinitionException if no such message is in it
   */
  public MessageDefinition definition(TypeName wanted) {
    MessageDefinition found = wanted.equals(name()) ? definition : referenced.get(wanted);
    if (found == null) {
      throw new DefinitionException(wanted + " is no part of " + name());
    }
    return found;
  }

  /** A message in this one, as a type by itself. */
  public MessageType part(TypeName wanted) {
    return new MessageType(definition(wanted), referenced);
  }
}
