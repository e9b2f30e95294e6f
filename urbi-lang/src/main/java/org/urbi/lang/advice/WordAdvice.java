package org.urbi.lang.advice;

import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.Keywords;
import org.urbi.lang.grammar.LexicalError;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.text.StringDistance;

/** Words of other languages, mistyped keywords, and characters that no word has. */
final class WordAdvice {
  /** What other languages say, and what they mean. */
  private static final Map<String, String> FOREIGN =
      Map.ofEntries(
          Map.entry("def", "function"),
          Map.entry("fn", "function"),
          Map.entry("fun", "function"),
          Map.entry("func", "function"),
          Map.entry("sub", "function"),
          Map.entry("elif", "else if"),
          Map.entry("elsif", "else if"),
          Map.entry("elseif", "else if"),
          Map.entry("let", "var"),
          Map.entry("local", "var"),
          Map.entry("auto", "var"),
          Map.entry("int", "var"),
          Map.entry("float", "var"),
          Map.entry("double", "var"),
          Map.entry("bool", "var"),
          Map.entry("char", "var"),
          Map.entry("long", "var"),
          Map.entry("short", "var"),
          Map.entry("unsigned", "var"),
          Map.entry("struct", "class"),
          Map.entry("delete", "removeLocalSlot(\"…\")"),
          Map.entry("del", "removeLocalSlot(\"…\")"),
          Map.entry("global", "var Global.…"),
          Map.entry("with", "try { … } finally { … }"),
          Map.entry("typeof", "x.type"),
          Map.entry("instanceof", "x.isA(…)"),
          Map.entry("except", "catch"),
          Map.entry("raise", "throw"),
          Map.entry("until", "while (!…)"),
          Map.entry("when", "at (…)"),
          Map.entry("from", "import"),
          Map.entry("await", "waituntil (…)"),
          Map.entry("repeat", "loop"),
          Map.entry("wait", "sleep(…)"),
          Map.entry("is", "=="));

  /** Foreign words that do not only begin a statement. */
  private static final Set<String> WITHIN = Set.of("is", "until", "instanceof", "typeof");

  private static final Set<String> DECLARING = Set.of("var", "function", "class");

  private WordAdvice() {}

  /** Quotes of a word processor, umlauts, {@code 12abc}. */
  static @Nullable Advice characters(Surroundings around) {
    for (LexicalError issue : around.issues()) {
      String source = around.span(issue).source().text();
      String text = source.substring(issue.begin(), issue.end());
      switch (issue.problem()) {
        case INVALID_CHARACTER -> {
          // The bytes of curved quotes; a back quote.
          boolean quote = source.startsWith("\u00E2\u0080", issue.begin()) || text.startsWith("`");
          return Advice.of((quote ? SyntaxHint.QUOTES : SyntaxHint.ASCII).text());
        }
        case INVALID_NUMBER -> {
          return Advice.of(number(text).text());
        }
        case RESERVED_WORD -> {
          String meant = FOREIGN.get(text);
          return meant == null ? null : Advice.of(SyntaxHint.NO_WORD.text(text, meant));
        }
        default -> {}
      }
    }
    return null;
  }

  private static SyntaxHint number(String text) {
    if (text.matches("[0-9._]+(s|se|sec\\w*|m\\w+|h\\w+|d\\w+|u\\w*|n\\w*)")) {
      return SyntaxHint.UNITS;
    }
    return text.matches("[0-9._]+[fFlL]|0[bo][0-9_]+")
        ? SyntaxHint.NUMBERS
        : SyntaxHint.LETTER_FIRST;
  }

  /** Whether a word of another language may stand between two values. */
  static boolean joins(String word) {
    return WITHIN.contains(word);
  }

  /** {@code functon f(x) …}, {@code elif}, {@code const x = 1}, {@code if (…) then …}. */
  static @Nullable Advice keyword(Surroundings around) {
    int at = around.at();
    int first = around.statement(at);
    if (around.is(at, UrbiscriptLexer.WORD) && around.is(at - 1, UrbiscriptLexer.CONST)) {
      return Advice.of(SyntaxHint.CONSTANT.text(around.text(at)));
    }
    for (int index : new int[] {at, at - 1, at - 2, first}) {
      if (index < first || !around.is(index, UrbiscriptLexer.WORD)) {
        continue;
      }
      String word = around.text(index);
      boolean begins = index == first || around.is(index - 1, UrbiscriptLexer.RBRACE);
      if (word.equals("lambda")) {
        return Advice.of(SyntaxHint.LIKE_FUNCTION.text());
      }
      if (word.equals("then") && around.is(index - 1, UrbiscriptLexer.RPAREN)) {
        return Advice.of(SyntaxHint.NO_THEN.text());
      }
      String meant = begins || WITHIN.contains(word) ? FOREIGN.get(word) : null;
      if (meant != null) {
        return Advice.of(SyntaxHint.NO_WORD.text(word, meant));
      }
      String keyword = begins ? mistyped(word) : null;
      if (keyword != null) {
        return Advice.of(SyntaxHint.MISSPELLED.text(keyword));
      }
    }
    return null;
  }

  /** {@code var}, {@code def}, {@code functon}. */
  static boolean isToDeclare(String word) {
    String meant = FOREIGN.containsKey(word) ? FOREIGN.get(word) : mistyped(word);
    return DECLARING.contains(word) || meant != null && DECLARING.contains(meant);
  }

  private static @Nullable String mistyped(String word) {
    if (word.length() < 3) {
      return null;
    }
    var closest = new StringDistance.ClosestName(word);
    Keywords.all().stream().filter(keyword -> keyword.length() > 2).forEach(closest::consider);
    return closest.meant();
  }
}
