package org.urbi.lang.grammar;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** What each word means to the scanner (manual, "Keywords"). */
public final class Keywords {
  /**
   * The words of the grammar from ASSERT to OR_EQ, in its order; a test compares them. The lexer
   * knows them, too, but only after it has read all of its tables, which takes longer than to read
   * a short script.
   */
  private static final String[] WORDS =
      ("assert at break call case catch class closure const continue default do else"
              + " emit enum every external finally for freezeif function if in loop new not"
              + " onleave return stopif switch this throw timeout try var waituntil watch whenever"
              + " while get set import package bitand bitor compl and_eq or_eq")
          .split(" ");

  private static final Map<String, Integer> TOKENS = tokens();

  private static final Set<String> RESERVED =
      Set.of(
          "asm",
          "auto",
          "bool",
          "char",
          "const_cast",
          "delete",
          "double",
          "dynamic_cast",
          "explicit",
          "export",
          "extern",
          "float",
          "friend",
          "goto",
          "inline",
          "int",
          "long",
          "mutable",
          "namespace",
          "register",
          "reinterpret_cast",
          "short",
          "signed",
          "sizeof",
          "static_cast",
          "struct",
          "template",
          "typedef",
          "typeid",
          "typename",
          "union",
          "unsigned",
          "using",
          "virtual",
          "volatile",
          "wchar_t");

  private static final Set<String> IGNORED =
      Set.of("internal", "private", "protected", "public", "static");

  /** Words that are keywords in one place only, and may name anything elsewhere. */
  private static final Set<String> CONTEXTUAL = Set.of("get", "import", "new", "package", "set");

  /** Keywords after which a separator is a flavor, not the end of the statement. */
  private static final Set<String> FLAVORED =
      Set.of("at", "every", "for", "foreach", "loop", "loopn", "while");

  /** What can follow the first character of a word, which a digit cannot be. */
  private static final boolean[] IN_WORD = new boolean[128];

  static {
    for (char c = 0; c < IN_WORD.length; c++) {
      IN_WORD[c] = startsWord(c) || isDigit(c);
    }
  }

  private Keywords() {}

  /** Whether a word can begin with that character. */
  public static boolean startsWord(char c) {
    return 'a' <= c && c <= 'z' || 'A' <= c && c <= 'Z' || c == '_';
  }

  static boolean isDigit(char c) {
    return '0' <= c && c <= '9';
  }

  /** Whether a word can go on with that character. */
  public static boolean isInWord(char c) {
    return c < IN_WORD.length && IN_WORD[c];
  }

  /** The words of the grammar, and other spellings. */
  private static Map<String, Integer> tokens() {
    Map<String, Integer> tokens = new HashMap<>();
    for (int i = 0; i < WORDS.length; i++) {
      tokens.put(WORDS[i], UrbiscriptLexer.ASSERT + i);
    }
    tokens.put("foreach", UrbiscriptLexer.FOR);
    tokens.put("loopn", UrbiscriptLexer.FOR);
    tokens.put("and", UrbiscriptLexer.AND_AND);
    tokens.put("or", UrbiscriptLexer.OR_OR);
    tokens.put("not_eq", UrbiscriptLexer.NOT_EQUAL);
    tokens.put("xor", UrbiscriptLexer.XOR);
    tokens.put("xor_eq", UrbiscriptLexer.XOR_ASSIGN);
    return tokens;
  }

  /** All keywords, in no particular order. */
  public static Set<String> all() {
    return TOKENS.keySet();
  }

  /** The words that may not be used, or that have no effect, in no order. */
  static Set<String> refused() {
    Set<String> refused = new HashSet<>(RESERVED);
    refused.addAll(IGNORED);
    return refused;
  }

  /** The token type of a word. */
  static int token(String word) {
    return TOKENS.getOrDefault(word, UrbiscriptLexer.WORD);
  }

  /** Whether the word is kept for later and may not be used at all. */
  static boolean reserved(String word) {
    return RESERVED.contains(word);
  }

  /** Whether the word is accepted and has no effect. */
  static boolean ignored(String word) {
    return IGNORED.contains(word);
  }

  /** Whether a separator that follows the word is its flavor, as in {@code loop;}. */
  public static boolean flavored(String word) {
    return FLAVORED.contains(word);
  }

  /** Whether the word must be written between quotes to be an identifier. */
  public static boolean keyword(String word) {
    return (TOKENS.containsKey(word) && !CONTEXTUAL.contains(word))
        || RESERVED.contains(word)
        || IGNORED.contains(word);
  }
}
