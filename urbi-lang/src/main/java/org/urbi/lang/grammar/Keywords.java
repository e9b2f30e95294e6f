package org.urbi.lang.grammar;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Set;

/** What each word means to the scanner (manual, "Keywords"). */
public final class Keywords {
  private static final Map<String, Integer> TOKENS =
      Map.ofEntries(
          entry("and", UrbiscriptLexer.AND_AND),
          entry("and_eq", UrbiscriptLexer.AND_EQ),
          entry("assert", UrbiscriptLexer.ASSERT),
          entry("at", UrbiscriptLexer.AT),
          entry("bitand", UrbiscriptLexer.BITAND),
          entry("bitor", UrbiscriptLexer.BITOR),
          entry("break", UrbiscriptLexer.BREAK),
          entry("call", UrbiscriptLexer.CALL),
          entry("case", UrbiscriptLexer.CASE),
          entry("catch", UrbiscriptLexer.CATCH),
          entry("class", UrbiscriptLexer.CLASS),
          entry("closure", UrbiscriptLexer.CLOSURE),
          entry("compl", UrbiscriptLexer.COMPL),
          entry("const", UrbiscriptLexer.CONST),
          entry("continue", UrbiscriptLexer.CONTINUE),
          entry("default", UrbiscriptLexer.DEFAULT),
          entry("do", UrbiscriptLexer.DO),
          entry("else", UrbiscriptLexer.ELSE),
          entry("emit", UrbiscriptLexer.EMIT),
          entry("enum", UrbiscriptLexer.ENUM),
          entry("every", UrbiscriptLexer.EVERY),
          entry("external", UrbiscriptLexer.EXTERNAL),
          entry("finally", UrbiscriptLexer.FINALLY),
          entry("for", UrbiscriptLexer.FOR),
          entry("foreach", UrbiscriptLexer.FOR),
          entry("freezeif", UrbiscriptLexer.FREEZEIF),
          entry("function", UrbiscriptLexer.FUNCTION),
          entry("get", UrbiscriptLexer.GET),
          entry("if", UrbiscriptLexer.IF),
          entry("import", UrbiscriptLexer.IMPORT),
          entry("in", UrbiscriptLexer.IN),
          entry("loop", UrbiscriptLexer.LOOP),
          entry("loopn", UrbiscriptLexer.FOR),
          entry("new", UrbiscriptLexer.NEW),
          entry("not", UrbiscriptLexer.NOT),
          entry("not_eq", UrbiscriptLexer.NOT_EQUAL),
          entry("onleave", UrbiscriptLexer.ONLEAVE),
          entry("or", UrbiscriptLexer.OR_OR),
          entry("or_eq", UrbiscriptLexer.OR_EQ),
          entry("package", UrbiscriptLexer.PACKAGE),
          entry("return", UrbiscriptLexer.RETURN),
          entry("set", UrbiscriptLexer.SET),
          entry("stopif", UrbiscriptLexer.STOPIF),
          entry("switch", UrbiscriptLexer.SWITCH),
          entry("this", UrbiscriptLexer.THIS),
          entry("throw", UrbiscriptLexer.THROW),
          entry("timeout", UrbiscriptLexer.TIMEOUT),
          entry("try", UrbiscriptLexer.TRY),
          entry("var", UrbiscriptLexer.VAR),
          entry("waituntil", UrbiscriptLexer.WAITUNTIL),
          entry("watch", UrbiscriptLexer.WATCH),
          entry("whenever", UrbiscriptLexer.WHENEVER),
          entry("while", UrbiscriptLexer.WHILE),
          entry("xor", UrbiscriptLexer.XOR),
          entry("xor_eq", UrbiscriptLexer.XOR_ASSIGN));

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

  private Keywords() {}

  /** All of them, in no order. */
  public static Set<String> all() {
    return TOKENS.keySet();
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
