package org.urbi.kernel.node;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** A pattern that a value can be matched against (manual, "Structural Pattern Matching"). */
public abstract class Pattern {
  /** Whether the value matches; binds the variables of the pattern on the way. */
  public abstract boolean matches(Frame frame, UrbiObject value);

  /** What a pattern consists of. */
  public interface Parts {
    void variable(Variables.Place place);

    void code(Node node);
  }

  /** Tells what the pattern consists of. */
  public abstract void tell(Parts parts);

  /** {@code var x}: matches anything. */
  public static final class Binding extends Pattern {
    private final Variables.Place place;

    public Binding(Variables.Place place) {
      this.place = place;
    }

    @Override
    public void tell(Parts parts) {
      parts.variable(place);
    }

    @Override
    public boolean matches(Frame frame, UrbiObject value) {
      place.declare(frame, value);
      return true;
    }
  }

  /** Any other expression: matches values that are equal to its value. */
  public static final class Equal extends Pattern {
    private final Node expression;
    private @Nullable SlotLookup equality;

    public Equal(Node expression) {
      this.expression = expression;
    }

    @Override
    public void tell(Parts parts) {
      parts.code(expression);
    }

    @Override
    public boolean matches(Frame frame, UrbiObject value) {
      if (expression instanceof Literals.Number literal) {
        if (frame.interpreter.comparesLiterals()) {
          return value instanceof UrbiFloat number && number.value() == literal.value();
        }
      } else if (expression instanceof Literals.Text literal
          && frame.interpreter.comparesLiterals()) {
        return value instanceof UrbiString text && text.value().equals(literal.value());
      }
      UrbiObject expected = expression.execute(frame);
      if (value == expected) {
        return true;
      }
      if (value == frame.interpreter.values().voidObject) {
        return false;
      }
      if (equality == null) {
        equality = new SlotLookup(frame.interpreter.world(), frame.interpreter.symbols().equals);
      }
      return frame.interpreter.isEqual(frame, equality, expected, value);
    }
  }

  /** A list, or a tuple, of patterns. */
  public static final class Elements extends Pattern {
    private final Pattern[] patterns;
    private final boolean tuple;

    public Elements(Pattern[] patterns, boolean tuple) {
      this.patterns = patterns;
      this.tuple = tuple;
    }

    @Override
    public void tell(Parts parts) {
      for (Pattern pattern : patterns) {
        pattern.tell(parts);
      }
    }

    @Override
    public boolean matches(Frame frame, UrbiObject value) {
      List<UrbiObject> elements;
      if (tuple) {
        elements = Tuples.members(frame, value);
      } else {
        elements = value instanceof UrbiList other ? other.elements() : null;
      }
      if (elements == null || elements.size() != patterns.length) {
        return false;
      }
      for (int i = 0; i < patterns.length; i++) {
        if (!patterns[i].matches(frame, elements.get(i))) {
          return false;
        }
      }
      return true;
    }
  }

  /** A dictionary of patterns: the value may have more entries. */
  public static final class Entries extends Pattern {
    private final Node[] keys;
    private final Pattern[] patterns;

    public Entries(Node[] keys, Pattern[] patterns) {
      this.keys = keys;
      this.patterns = patterns;
    }

    @Override
    public void tell(Parts parts) {
      for (Node key : keys) {
        parts.code(key);
      }
      for (Pattern pattern : patterns) {
        pattern.tell(parts);
      }
    }

    @Override
    public boolean matches(Frame frame, UrbiObject value) {
      if (!(value instanceof UrbiDictionary dictionary)) {
        return false;
      }
      Map<UrbiDictionary.Key, UrbiObject> entries = dictionary.entries();
      for (int i = 0; i < keys.length; i++) {
        UrbiObject found = entries.get(DictionaryKey.of(frame, keys[i].execute(frame)));
        if (found == null || !patterns[i].matches(frame, found)) {
          return false;
        }
      }
      return true;
    }
  }
}
