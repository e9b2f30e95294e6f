package org.urbi.lang.problem;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The text of a message, in which <code>{name}</code> stands for what is known only when the
 * message is needed. The names are only for readers; the values are given in order.
 */
public final class Template {
  private final String text;

  /**
   * What is before, between and behind the placeholders; null until it is needed. A list that
   * cannot be modified may be passed on to other threads without more ado.
   */
  private @Nullable List<String> pieces;

  public Template(String text) {
    this.text = text;
  }

  /** The text with its placeholders. */
  public String text() {
    return text;
  }

  /** The names of the placeholders, in the order of the text. */
  public List<String> places() {
    List<String> names = new ArrayList<>();
    for (int open = open(0); open >= 0; open = open(open + 1)) {
      names.add(text.substring(open + 1, text.indexOf('}', open)));
    }
    return List.copyOf(names);
  }

  /**
   * The text with everything filled in.
   *
   * @param values one for each placeholder
   * @throws IllegalArgumentException if there are more or fewer
   */
  public String fill(Object... values) {
    List<String> around = pieces();
    if (values.length != around.size() - 1) {
      String wrong = values.length < around.size() ? "too few" : "too many";
      throw new IllegalArgumentException(wrong + " values for: " + text);
    }
    if (values.length == 0) {
      return text;
    }
    StringBuilder filled = new StringBuilder(text.length() + 16 * values.length);
    filled.append(around.get(0));
    for (int i = 0; i < values.length; i++) {
      filled.append(values[i]).append(around.get(i + 1));
    }
    return filled.toString();
  }

  private List<String> pieces() {
    List<String> known = pieces;
    if (known == null) {
      List<String> found = new ArrayList<>();
      int from = 0;
      for (int open = open(0); open >= 0; open = open(from)) {
        found.add(text.substring(from, open));
        from = text.indexOf('}', open) + 1;
      }
      found.add(text.substring(from));
      known = List.copyOf(found);
      pieces = known;
    }
    return known;
  }

  /** The index of the next placeholder; a brace without a letter behind it is plain text. */
  private int open(int from) {
    int at = text.indexOf('{', from);
    while (at >= 0 && !(at + 1 < text.length() && Character.isLetter(text.charAt(at + 1)))) {
      at = text.indexOf('{', at + 1);
    }
    return at;
  }

  @Override
  public String toString() {
    return text;
  }
}
