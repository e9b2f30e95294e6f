package org.urbi.ros.message;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the texts of {@code .msg} files, and the parts of {@code .srv} and {@code .action}. */
public final class DefinitionReader {
  /** So long is no file that a person has written. */
  private static final int MAX_TEXT = 1 << 20;

  private static final Pattern LINE = Pattern.compile("(\\S+)\\s+([a-zA-Z]\\w*)\\s*(.*)");
  private static final Pattern SEPARATOR = Pattern.compile("(?m)^---.*$");

  private final TypeName name;
  private final Dialect dialect;
  private final TypeReader types;
  private final List<Field> fields = new ArrayList<>();
  private final List<Constant> constants = new ArrayList<>();
  private final Set<String> names = new HashSet<>();

  private DefinitionReader(TypeName name, Dialect dialect) {
    this.name = name;
    this.dialect = dialect;
    this.types = new TypeReader(dialect, name.pack());
  }

  /**
   * Reads the definition of a message.
   *
   * @throws DefinitionException if a line is not right: which one, and why
   */
  public static MessageDefinition read(TypeName name, Dialect dialect, String text) {
    if (text.length() > MAX_TEXT) {
      throw new DefinitionException(name.in(dialect) + " is longer than " + MAX_TEXT);
    }
    DefinitionReader reader = new DefinitionReader(name, dialect);
    int number = 0;
    for (String line : text.lines().toList()) {
      number++;
      try {
        reader.line(line);
      } catch (DefinitionException | ValueException e) {
        throw new DefinitionException(
            name.in(dialect) + ", line " + number + ": " + e.getMessage());
      }
    }
    return new MessageDefinition(name, dialect, reader.fields, reader.constants, text);
  }

  /**
   * The parts of the text of a service or an action.
   *
   * @throws DefinitionException if there are not so many
   */
  static List<String> parts(TypeName name, String text, int count) {
    List<String> parts = List.of(SEPARATOR.split(text, -1));
    if (parts.size() != count) {
      throw new DefinitionException(
          name + " has " + parts.size() + " parts between lines ---, not " + count);
    }
    return parts.stream().map(part -> part.startsWith("\n") ? part.substring(1) : part).toList();
  }

  private void line(String raw) {
    String line = withoutComment(raw).strip();
    if (line.isEmpty()) {
      return;
    }
    Matcher form = LINE.matcher(line);
    if (!form.matches()) {
      throw new DefinitionException("a type and a name expected, not '" + line + "'");
    }
    FieldType type = types.read(form.group(1));
    String field = form.group(2);
    String rest = form.group(3);
    if (!names.add(field)) {
      throw new DefinitionException("there is a '" + field + "' already");
    }
    if (rest.startsWith("=")) {
      String value = rest.substring(1).strip();
      if (dialect == Dialect.ROS_1 && type instanceof FieldType.Text) {
        // There are no comments behind the strings of ROS 1.
        value = raw.substring(raw.indexOf('=') + 1).strip();
      }
      if (type instanceof FieldType.Array || type instanceof FieldType.Nested) {
        throw new DefinitionException("a constant is a number or a string");
      }
      constants.add(new Constant(field, type, LiteralReader.read(type, value, dialect), value));
    } else if (rest.isEmpty()) {
      fields.add(new Field(field, type, null));
    } else if (dialect == Dialect.ROS_2) {
      fields.add(new Field(field, type, LiteralReader.read(type, rest, dialect)));
    } else {
      throw new DefinitionException("what is '" + rest + "'?");
    }
  }

  private static String withoutComment(String line) {
    for (int i = 0; i < line.length(); i++) {
      if (line.charAt(i) == '#') {
        return line.substring(0, i);
      }
      i = LiteralReader.skipString(line, i);
    }
    return line;
  }
}
