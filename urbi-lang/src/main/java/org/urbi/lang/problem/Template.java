package org.urbi.lang.problem;

import java.util.ArrayList;
import java.util.List;

/**
 * The text of a message, in which <code>{name}</code> stands for what is known only when the
 * message is needed. The names are only for readers; the values are given in order.
 */
public record Template(String text) {
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
    int from = 0;
    int used = 0;
    StringBuilder filled = new StringBuilder(text.length() + 16 * values.length);
    for (int open = open(0); open >= 0; open = open(from)) {
      if (used == values.length) {
        throw new IllegalArgumentException("too few values for: " + text);
      }
      filled.append(text, from, open).append(values[used++]);
      from = text.indexOf('}', open) + 1;
    }
    if (used < values.length) {
      throw new IllegalArgumentException("too many values for: " + text);
    }
    return from == 0 ? text : filled.append(text, from, text.length()).toString();
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
