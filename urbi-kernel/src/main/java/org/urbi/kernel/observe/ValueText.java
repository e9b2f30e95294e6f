package org.urbi.kernel.observe;

import java.util.List;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;
import org.urbi.lang.print.FloatFormat;
import org.urbi.lang.print.StringEscape;

/**
 * Shows values in one line, without calling a function of urbiscript. What cannot be read back as
 * the same value, because it is only a part of it, has an ellipsis.
 */
final class ValueText {
  private static final int LONGEST = 100;
  private static final int MOST_ELEMENTS = 8;
  private static final int DEEPEST = 2;

  private ValueText() {}

  /** The value, or the beginning of it. */
  static String of(UrbiObject value) {
    String text = of(value, 0);
    return text.length() > LONGEST ? text.substring(0, LONGEST) + "…" : text;
  }

  private static String of(UrbiObject value, int depth) {
    Values values = value.world().values();
    if (value == values.nil) {
      return "nil";
    } else if (value == values.voidObject) {
      return "void";
    } else if (value == values.trueObject || value == values.falseObject) {
      return String.valueOf(value == values.trueObject);
    }
    return switch (value) {
      case UrbiFloat number -> FloatFormat.format(number.value());
      case UrbiString text ->
          Utf8Text.toJava(StringEscape.quote(text.part(0, Math.min(LONGEST, text.length()))));
      case UrbiList list -> elements("[", list.elements(), "]", depth);
      case UrbiTuple tuple -> elements("(", tuple.elements(), ")", depth);
      case UrbiDictionary dictionary -> entries(dictionary.entries().size());
      case UrbiBinary binary ->
          (binary.keywords().isBlank() ? "" : binary.keywords() + ", ")
              + binary.data().length()
              + " bytes";
      default -> type(value);
    };
  }

  private static String entries(int count) {
    return count == 1 ? "[1 entry]" : "[" + count + " entries]";
  }

  private static String elements(
      String opening, List<UrbiObject> elements, String closing, int depth) {
    StringBuilder text = new StringBuilder(opening);
    int shown = depth < DEEPEST ? Math.min(elements.size(), MOST_ELEMENTS) : 0;
    for (int i = 0; i < shown; i++) {
      UrbiObject element = elements.get(i);
      String shownElement = of(element, depth + 1);
      text.append(i == 0 ? "" : ", ").append(shownElement);
      if (!isWhole(element, shownElement)) {
        text.append('…');
      }
    }
    if (shown < elements.size()) {
      text.append(shown == 0 ? "" : ", ").append('…');
    }
    return text.append(closing).toString();
  }

  /** Not of a number that is rounded, or of an object of which there is the name of its type. */
  private static boolean isWhole(UrbiObject element, String text) {
    if (element instanceof UrbiFloat number) {
      return !Double.isFinite(number.value()) || Double.parseDouble(text) == number.value();
    }
    Values values = element.world().values();
    return element instanceof UrbiString
        || element instanceof UrbiList
        || element instanceof UrbiTuple
        || element == values.nil
        || element == values.voidObject
        || element == values.trueObject
        || element == values.falseObject;
  }

  /** The name of the type of a value. */
  static String type(UrbiObject value) {
    if (value instanceof UrbiEvent) {
      return "Event";
    } else if (value instanceof Code) {
      return "Code";
    }
    UrbiObject name = value.lookup(value.world().symbol("type"));
    return name instanceof UrbiString text ? Utf8Text.toJava(text.value()) : "Object";
  }
}
