package org.urbi.lang.parse;

import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ListTokenSource;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.PredictionMode;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.ParserBase;
import org.urbi.lang.grammar.UrbiLexer;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** From text to tree. */
public final class UrbiParser {
  /**
   * What a text is.
   *
   * @param program empty when there are errors
   */
  public record Parsed(Ast.Sequence program, List<SyntaxError> errors) {}

  private static final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1;
    private final transient Token token;

    Failure(Token token) {
      super("syntax error", null, false, false);
      this.token = token;
    }
  }

  private static final BaseErrorListener FAIL =
      new BaseErrorListener() {
        @Override
        public void syntaxError(
            Recognizer<?, ?> recognizer,
            Object symbol,
            int line,
            int column,
            String message,
            RecognitionException e) {
          throw new Failure((Token) symbol);
        }
      };

  private UrbiParser() {}

  /** Rules inside each other that any thread's stack has room for. */
  private static final int SHALLOW = 500;

  /** Rules inside each other that there may be, and the bytes of stack for them. */
  private static final int DEEP = 8000;

  private static final long STACK = 64L << 20;

  /** Parses a whole text; never throws. */
  public static Parsed parse(Source source) {
    try {
      return parse(source, SHALLOW);
    } catch (ParserBase.TooDeep e) {
      return parseDeep(source);
    }
  }

  /** What nests deeply is parsed where there is room for it. */
  private static Parsed parseDeep(Source source) {
    var parsed = new AtomicReference<Parsed>();
    Runnable work =
        () -> {
          try {
            parsed.set(parse(source, DEEP));
          } catch (ParserBase.TooDeep e) {
            var errors = new Errors(source);
            errors.add(errors.span(e.token()), "nesting too deep");
            parsed.set(failed(source, errors));
          }
        };
    var thread = new Thread(null, work, "urbi-parser", STACK);
    thread.setDaemon(true);
    thread.start();
    boolean interrupted = false;
    while (parsed.get() == null && thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    return parsed.get();
  }

  private static Parsed parse(Source source, int limit) {
    var errors = new Errors(source);
    List<? extends Token> tokens = tokens(source, errors);
    if (!errors.isEmpty()) {
      return failed(source, errors);
    }
    TokenFilter.filter(tokens);
    try {
      var stream = new CommonTokenStream(new ListTokenSource(tokens));
      var parser = new org.urbi.lang.grammar.UrbiParser(stream);
      parser.limit(limit);
      parser.removeErrorListeners();
      parser.addErrorListener(FAIL);
      var program = program(parser);
      Ast.Sequence sequence = new Statements(errors).sequence(program.sequence());
      if (errors.isEmpty()) {
        return new Parsed(sequence, List.of());
      }
    } catch (Failure failure) {
      unexpected(failure.token, tokens, errors);
    } catch (Expressions.TooLong e) {
      errors.add(e.span(), "nesting too deep");
    }
    return failed(source, errors);
  }

  /** The fast prediction first; what it refuses, the complete one decides. */
  private static org.urbi.lang.grammar.UrbiParser.ProgramContext program(
      org.urbi.lang.grammar.UrbiParser parser) {
    try {
      parser.getInterpreter().setPredictionMode(PredictionMode.SLL);
      return parser.program();
    } catch (Failure e) {
      parser.reset();
      parser.getInterpreter().setPredictionMode(PredictionMode.LL);
      return parser.program();
    }
  }

  private static Parsed failed(Source source, Errors errors) {
    return new Parsed(
        new Ast.Sequence(new Span(source, 0, 0), List.of(), List.of()), errors.sorted());
  }

  private static List<? extends Token> tokens(Source source, Errors errors) {
    var lexer = new UrbiLexer(CharStreams.fromString(source.text()));
    lexer.removeErrorListeners();
    List<? extends Token> tokens = lexer.getAllTokens();
    for (Token token : tokens) {
      Span span = errors.span(token);
      switch (token.getType()) {
        case UrbiLexer.BAD_TOKEN -> errors.add(span, "invalid token: `" + token.getText() + "'");
        case UrbiLexer.BAD_CHARACTER ->
            errors.add(span, "invalid character: `" + visible(token.getText().charAt(0)) + "'");
        case UrbiLexer.BAD_STRING -> errors.add(span, "unterminated string");
        case UrbiLexer.RESERVED -> errors.add(span, "reserved symbol: `" + token.getText() + "'");
        case UrbiLexer.STRING -> Escapes.check(token.getText(), span, errors);
        default -> {}
      }
    }
    return tokens;
  }

  private static String visible(char c) {
    return c >= ' ' && c < 127 ? String.valueOf(c) : String.format("\\x%02x", (int) c);
  }

  private static void unexpected(Token token, List<? extends Token> tokens, Errors errors) {
    Token at = token;
    int index = tokens.indexOf(token);
    // Two names in a row could be a type and a variable: what follows is wrong.
    if (index > 0
        && token.getType() == UrbiLexer.IDENTIFIER
        && tokens.get(index - 1).getType() == UrbiLexer.IDENTIFIER
        && index + 1 < tokens.size()) {
      at = tokens.get(index + 1);
    }
    errors.add(
        errors.span(at),
        at.getType() == Token.EOF ? "unexpected end of command" : "unexpected " + at.getText());
  }
}
