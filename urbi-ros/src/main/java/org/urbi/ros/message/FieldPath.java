package org.urbi.ros.message;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * Where a value is in a message: {@code linear.x}, {@code ranges[3]}, {@code header.stamp.sec};
 * with no text at all, the whole message.
 */
public final class FieldPath {
  private static final Pattern STEP = Pattern.compile("\\.?([a-zA-Z]\\w*)|\\[(\\d{1,9})\\]");

  private final String text;

  /** A key of a Dictionary each, or the index of an element. */
  private final List<Step> steps;

  private record Step(@Nullable String key, int index) {
    @Override
    public String toString() {
      return key == null ? "[" + index + "]" : key;
    }
  }

  private FieldPath(String text, List<Step> steps) {
    this.text = text;
    this.steps = steps;
  }

  /**
   * The path that is written so.
   *
   * @throws ValueException if it is none
   */
  public static FieldPath of(String text) {
    List<Step> steps = new ArrayList<>();
    Matcher matcher = STEP.matcher(text);
    int end = 0;
    while (end < text.length()) {
      boolean next = matcher.find(end) && matcher.start() == end;
      if (!next || end == 0 && text.startsWith(".")) {
        throw new ValueException("a field as linear.x or ranges[3] expected, not '" + text + "'");
      }
      String index = matcher.group(2);
      steps.add(new Step(matcher.group(1), index == null ? 0 : Integer.parseInt(index)));
      end = matcher.end();
    }
    return new FieldPath(text, List.copyOf(steps));
  }

  /**
   * Checks that messages of a type have such a field.
   *
   * @throws ValueException if they have not
   */
  public void check(MessageType type) {
    FieldType here = new FieldType.Nested(type.name());
    for (Step step : steps) {
      here = within(type, here, step);
    }
  }

  private FieldType within(MessageType type, FieldType here, Step step) {
    String key = step.key();
    if (key == null) {
      if (here instanceof FieldType.Array array
          && (array.length() == FieldType.Length.ANY || step.index() < array.size())) {
        return array.element();
      }
    } else if (here instanceof FieldType.Nested(TypeName name)) {
      for (Field field : type.definition(name).fields()) {
        if (field.name().equals(key)) {
          return field.type();
        }
      }
    } else if (here instanceof FieldType.Basic(Primitive primitive)
        && primitive.isInstant()
        && List.of(Templates.SECONDS, Templates.NANOSECONDS).contains(key)) {
      return new FieldType.Basic(Primitive.INT32);
    }
    throw new ValueException(
        text + ": " + type.name().in(type.dialect()) + " has no such field: " + step);
  }

  /**
   * The value in a message.
   *
   * @throws ValueException if it has none there: a list may be shorter
   */
  public UValue get(UDictionary message) {
    UValue here = new UValue(message);
    for (Step step : steps) {
      here = get(here, step);
    }
    return here;
  }

  private UValue get(UValue here, Step step) {
    UValue found = null;
    String key = step.key();
    int index = step.index();
    if (key != null) {
      if (here.getType() == UDataType.DATA_DICTIONARY) {
        found = here.udictionaryValue().get(key);
      }
    } else if (here.getType() == UDataType.DATA_LIST) {
      UList list = here.ulistValue();
      found = index < list.size() ? list.get(index) : null;
    } else if (here.getType() == UDataType.DATA_BINARY) {
      UBinary bytes = here.ubinaryValue();
      found = index < bytes.getSize() ? new UValue(bytes.getData()[index] & 0xFF) : null;
    }
    if (found == null) {
      throw new ValueException(text + ": this message has none: " + step);
    }
    return found;
  }

  /**
   * Puts a value into a message.
   *
   * @throws ValueException if it has no such place; whether the value fits is seen when the message
   *     is sent
   */
  public void put(UDictionary message, UValue value) {
    if (steps.isEmpty()) {
      if (value.getType() != UDataType.DATA_DICTIONARY) {
        throw new ValueException("a whole message expected, not " + Values.shown(value));
      }
      message.putAll(value.udictionaryValue());
      return;
    }
    UValue here = new UValue(message);
    for (Step step : steps.subList(0, steps.size() - 1)) {
      here = get(here, step);
    }
    Step last = steps.getLast();
    String key = last.key();
    get(here, last);
    if (key != null) {
      here.udictionaryValue().put(key, value);
    } else if (here.getType() == UDataType.DATA_LIST) {
      here.ulistValue().set(last.index(), value);
    } else {
      throw new ValueException(text + ": bytes are set together, as a Binary");
    }
  }

  @Override
  public String toString() {
    return text;
  }
}
