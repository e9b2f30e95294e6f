package org.urbi.ros.message;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A message of ROS 1 and all that it consists of in one text, as publishers send it to those who
 * have no file of the type.
 */
public final class FullText {
  private static final String SEPARATOR = "=".repeat(80);
  private static final String HEADING = "MSG: ";

  private FullText() {}

  /** The text of a type. */
  public static String write(MessageType type) {
    Set<TypeName> order = new LinkedHashSet<>();
    order(type.definition(), type, order);
    StringBuilder text = new StringBuilder(type.definition().text()).append('\n');
    for (TypeName name : order) {
      text.append(SEPARATOR).append('\n').append(HEADING).append(name.in(Dialect.ROS_1));
      text.append('\n').append(type.definition(name).text()).append('\n');
    }
    text.setLength(text.length() - 1);
    return text.toString();
  }

  private static void order(MessageDefinition definition, MessageType within, Set<TypeName> order) {
    for (Field field : definition.fields()) {
      FieldType element =
          field.type() instanceof FieldType.Array array ? array.element() : field.type();
      if (element instanceof FieldType.Nested(TypeName name) && order.add(name)) {
        order(within.definition(name), within, order);
      }
    }
  }

  /**
   * Reads such a text.
   *
   * @throws DefinitionException if it is not right, or something is missing in it
   */
  public static MessageType read(TypeName name, String text) {
    List<List<String>> parts = new ArrayList<>(List.of(new ArrayList<>()));
    for (String line : text.split("\n", -1)) {
      if (line.startsWith(SEPARATOR)) {
        parts.add(new ArrayList<>());
      } else {
        parts.getLast().add(line);
      }
    }
    Map<TypeName, MessageDefinition> found = new HashMap<>();
    for (List<String> part : parts.subList(1, parts.size())) {
      if (part.isEmpty() || !part.getFirst().startsWith(HEADING)) {
        throw new DefinitionException("the definition of " + name + " has a part without a name");
      }
      String heading = part.getFirst().substring(HEADING.length());
      TypeName own = TypeName.parse(heading, TypeName.Kind.MESSAGE);
      found.put(own, read(own, part.subList(1, part.size())));
    }
    return Definitions.link(
        read(name, parts.getFirst()),
        wanted -> {
          MessageDefinition definition = found.get(wanted);
          if (definition == null) {
            throw new DefinitionException(
                "the definition of " + name + " says nothing of " + wanted.in(Dialect.ROS_1));
          }
          return definition;
        });
  }

  private static MessageDefinition read(TypeName name, List<String> lines) {
    return DefinitionReader.read(name, Dialect.ROS_1, String.join("\n", lines));
  }
}
