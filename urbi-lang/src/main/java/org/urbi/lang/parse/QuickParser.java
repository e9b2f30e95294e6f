package org.urbi.lang.parse;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.grammar.QuickTokens;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.source.Source;

/**
 * Parses usual texts by hand: a script is read once, in a process that has just begun, where the
 * parser that is made of the grammar takes four times as long. It knows most of the language, but
 * nothing of errors, warnings and what is deprecated: at anything unusual it gives up, and the
 * grammar decides. What it accepts, the grammar accepts with the same tree ({@code
 * QuickParserTest}).
 */
final class QuickParser {
  /** A tree, and the separator that ended it if it is a single statement. */
  record Quick(Ast tree, @Nullable Flavor separator) {}

  private QuickParser() {}

  /**
   * Parses a part of a text.
   *
   * @param single whether it must be one statement and its separator
   * @return null if there is something unusual in it
   */
  static @Nullable Quick parse(
      Source source, int begin, int end, boolean single, Checkpoint checkpoint) {
    QuickTokens tokens = QuickTokens.read(source.text(), begin, end, checkpoint);
    if (tokens == null) {
      return null;
    }
    QuickCursor cursor = new QuickCursor(source, tokens);
    QuickStatements statements = new QuickStatements(cursor, checkpoint);
    try {
      return single ? item(cursor, statements) : program(cursor, statements);
    } catch (QuickCursor.UnusualException unusual) {
      return null;
    }
  }

  private static Quick program(QuickCursor cursor, QuickStatements statements) {
    Ast tree = statements.sequence();
    cursor.expect(UrbiscriptParser.EOF);
    return new Quick(tree, null);
  }

  private static Quick item(QuickCursor cursor, QuickStatements statements) {
    if (cursor.isEndOfStatement()) {
      throw QuickCursor.unusual();
    }
    Ast tree = statements.pipe();
    boolean semicolon = cursor.is(UrbiscriptParser.SEMICOLON);
    if (!semicolon) {
      cursor.expect(UrbiscriptParser.COMMA);
    } else {
      cursor.next();
    }
    cursor.expect(UrbiscriptParser.EOF);
    return new Quick(tree, semicolon ? Flavor.SEMICOLON : Flavor.COMMA);
  }
}
