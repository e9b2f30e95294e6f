package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.atn.PredictionMode;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.grammar.LexicalError;
import org.urbi.lang.grammar.NestingException;
import org.urbi.lang.grammar.TextStream;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;
import org.urbi.lang.text.Sources;

/**
 * Turns a text into a syntax tree (manual, "Syntax").
 *
 * <p>Bad input of any kind and any size yields errors, never an exception.
 */
public final class UrbiParser {
  private UrbiParser() {}

  /**
   * Parses a complete text, the last statement of which needs no separator.
   *
   * @param file the name that locations show, or null
   * @return a {@link Ast.Sequence}, or errors
   */
  public static ParseResult parse(String text, @Nullable String file) {
    return parse(Sources.of(text, file), 0, text.length());
  }

  /**
   * Parses a complete text, the last statement of which needs no separator.
   *
   * @param file the name that locations show, or null
   * @param checkpoint called again and again, to end the parsing by an exception
   * @return a {@link Ast.Sequence}, or errors
   */
  public static ParseResult parse(String text, @Nullable String file, Runnable checkpoint) {
    return parse(Sources.of(text, file), 0, text.length(), false, checkpoint);
  }

  /** Parses a part of a text as if it were a complete one. */
  public static ParseResult parse(Source source, int begin, int end) {
    return parse(source, begin, end, false, () -> {});
  }

  /**
   * Parses a part of a text that must be exactly one statement and its separator.
   *
   * @param checkpoint called again and again, to end the parsing by an exception
   */
  public static ParseResult parseStatement(Source source, int begin, int end, Runnable checkpoint) {
    return parse(source, begin, end, true, checkpoint);
  }

  private static ParseResult parse(
      Source source, int begin, int end, boolean single, Runnable checkpoint) {
    Checkpoint passed = new Checkpoint(checkpoint);
    QuickParser.Quick quick = QuickParser.parse(source, begin, end, single, passed);
    return quick == null
        ? byGrammar(source, begin, end, single, passed)
        : new ParseResult(quick.tree(), quick.separator(), List.of(), List.of());
  }

  /** What the grammar says, which is the judge of any other way to parse. */
  static ParseResult byGrammar(
      Source source, int begin, int end, boolean single, Checkpoint checkpoint) {
    return new Run(source, begin, end, single, checkpoint).parse();
  }

  /** One text being parsed. */
  private static final class Run {
    private final Source source;
    private final boolean single;
    private final UrbiscriptLexer lexer;
    private final CommonTokenStream tokens;
    private final List<SyntaxWarning> warnings = new ArrayList<>();
    private final Checkpoint checkpoint;
    private Ast.@Nullable Flavor separator;

    Run(Source source, int begin, int end, boolean single, Checkpoint checkpoint) {
      this.source = source;
      this.single = single;
      this.checkpoint = checkpoint;
      this.lexer = new UrbiscriptLexer(new TextStream(source.text(), begin, end));
      lexer.setCheckpoint(this.checkpoint);
      this.tokens = new CommonTokenStream(lexer);
    }

    ParseResult parse() {
      tokens.fill();
      List<SyntaxError> errors = new ArrayList<>();
      for (LexicalError issue : lexer.issues()) {
        Span span = new Span(source, issue.begin(), issue.end());
        if (issue.warning()) {
          warnings.add(new SyntaxWarning(span, issue.problem(), issue.text()));
        } else {
          errors.add(new SyntaxError(span, issue.problem(), issue.text()));
        }
      }
      Ast tree = null;
      if (errors.isEmpty()) {
        try {
          tree = tree();
        } catch (SyntaxErrorException failure) {
          errors.add(failure.error());
        } catch (NestingException tooDeep) {
          Span at = TokenNames.span(source, tooDeep.token());
          errors.add(SyntaxError.of(at, SyntaxProblem.NESTING_TOO_DEEP));
        } catch (ParseCancellationException stop) {
          errors.add(UnexpectedToken.error(source, stop));
        }
      }
      return new ParseResult(tree, separator, List.copyOf(errors), List.copyOf(warnings));
    }

    private Ast tree() {
      try {
        return tree(PredictionMode.SLL);
      } catch (ParseCancellationException stop) {
        // Either an error, or one of the rare texts for which the fast mode is not enough.
        warnings.clear();
        lexer.issues().stream()
            .map(
                i -> new SyntaxWarning(new Span(source, i.begin(), i.end()), i.problem(), i.text()))
            .forEach(warnings::add);
        return tree(PredictionMode.LL);
      }
    }

    private Ast tree(PredictionMode mode) {
      tokens.seek(0);
      var parser = new UrbiscriptParser(tokens);
      parser.setErrorHandler(new FirstErrorStrategy());
      parser.removeErrorListeners();
      parser.setCheckpoint(checkpoint);
      parser.setInterpreter(new PreciseErrorSimulator(parser, mode));
      var builder = new TreeBuilder(source, warnings, checkpoint);
      if (!single) {
        return builder.statements.sequence(parser.program().sequence());
      }
      var item = parser.item();
      separator = item.COMMA() == null ? Ast.Flavor.SEMICOLON : Ast.Flavor.COMMA;
      return item.pipe() == null
          ? new Ast.Noop(builder.span(item))
          : builder.statements.pipe(item.pipe());
    }
  }
}
