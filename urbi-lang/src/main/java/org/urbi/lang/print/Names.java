package org.urbi.lang.print;

import java.util.HashSet;
import java.util.Set;
import org.urbi.lang.grammar.UrbiLexer;

/** Names as they are written: between quotes when they are no identifiers. */
final class Names {
  private static final Set<String> KEYWORDS = keywords();

  private Names() {}

  /** A name, quoted if it must. */
  static String name(String name) {
    boolean plain =
        !name.isEmpty()
            && !Character.isDigit(name.charAt(0))
            && name.chars().allMatch(Names::isWord)
            && (!KEYWORDS.contains(name) || name.equals("new"));
    return plain ? name : '\'' + StringEscape.escape(name, '\'') + '\'';
  }

  private static boolean isWord(int c) {
    return c == '_' || c < 128 && Character.isLetterOrDigit(c);
  }

  private static Set<String> keywords() {
    Set<String> keywords = new HashSet<>();
    for (int i = 1; i <= UrbiLexer.VOCABULARY.getMaxTokenType(); i++) {
      String literal = UrbiLexer.VOCABULARY.getLiteralName(i);
      if (literal != null) {
        keywords.add(literal.substring(1, literal.length() - 1));
      }
    }
    keywords.addAll(
        Set.of("and", "foreach", "not", "not_eq", "or", "private", "protected", "public", "xor"));
    return Set.copyOf(keywords);
  }
}
