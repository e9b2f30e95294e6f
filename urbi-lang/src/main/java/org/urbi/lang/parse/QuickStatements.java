package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.ast.LocalNames;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.grammar.QuickTokens;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.source.Span;

/** Composition and flow control, for {@link QuickParser}. */
final class QuickStatements {
  private final QuickCursor cursor;
  private final QuickTokens tokens;
  private final Checkpoint checkpoint;
  private final QuickExpressions expressions;
  private final QuickDefinitions definitions;

  QuickStatements(QuickCursor cursor, Checkpoint checkpoint) {
    this.cursor = cursor;
    this.tokens = cursor.tokens();
    this.checkpoint = checkpoint;
    this.expressions = new QuickExpressions(cursor, this);
    this.definitions = new QuickDefinitions(cursor, this, expressions);
  }

  QuickDefinitions definitions() {
    return definitions;
  }

  // ------------------------------------------------------------------------------ composition

  /** Statements between {@code ;} and {@code ,}, as far as there are any. */
  Ast.Sequence sequence() {
    int begin = cursor.begin();
    List<Ast> statements = new ArrayList<>();
    List<Flavor> separators = new ArrayList<>();
    while (true) {
      boolean separator =
          cursor.is(UrbiscriptParser.SEMICOLON) || cursor.is(UrbiscriptParser.COMMA);
      if (!separator) {
        // A pipe that begins with "|" is an error.
        if (statements.size() > separators.size() || cursor.isEndOfStatement()) {
          break;
        }
        statements.add(pipe());
      } else {
        if (statements.size() == separators.size()) {
          statements.add(new Ast.Noop(cursor.nothing(cursor.begin())));
        }
        separators.add(separator(cursor.next()));
      }
    }
    return new Ast.Sequence(
        statements.isEmpty() ? cursor.nothing(begin) : cursor.span(begin),
        List.copyOf(statements),
        List.copyOf(separators));
  }

  Flavor separator(int token) {
    return tokens.types()[token] == UrbiscriptParser.SEMICOLON ? Flavor.SEMICOLON : Flavor.COMMA;
  }

  Ast pipe() {
    int begin = cursor.begin();
    Ast first = parallel();
    return cursor.is(UrbiscriptParser.PIPE) ? composition(begin, first, Flavor.PIPE) : first;
  }

  private Ast parallel() {
    int begin = cursor.begin();
    Ast first = statement();
    return cursor.is(UrbiscriptParser.AND) ? composition(begin, first, Flavor.AND) : first;
  }

  /** Statements between {@code |} or {@code &}: a missing one is an empty scope. */
  private Ast composition(int begin, Ast first, Flavor flavor) {
    int separator = flavor == Flavor.PIPE ? UrbiscriptParser.PIPE : UrbiscriptParser.AND;
    List<Ast> statements = new ArrayList<>();
    List<Flavor> separators = new ArrayList<>();
    statements.add(first);
    while (cursor.is(separator)) {
      if (statements.size() == separators.size()) {
        statements.add(missing(cursor.begin()));
      }
      cursor.next();
      separators.add(flavor);
      if (!cursor.isEndOfStatement()) {
        statements.add(flavor == Flavor.PIPE ? parallel() : statement());
      }
    }
    if (statements.size() == separators.size()) {
      statements.add(missing(cursor.end()));
    }
    return new Ast.Sequence(cursor.span(begin), List.copyOf(statements), List.copyOf(separators));
  }

  private Ast missing(int offset) {
    Span span = cursor.nothing(offset);
    return new Ast.Scope(span, new Ast.Sequence(span, List.of(), List.of()));
  }

  /** A scope whose declarations make slots of an object. */
  Ast.Scope slots() {
    int begin = cursor.begin();
    cursor.expect(UrbiscriptParser.LBRACE);
    Ast.Sequence body = sequence();
    cursor.expect(UrbiscriptParser.RBRACE);
    return new Ast.Scope(cursor.span(begin), body);
  }

  /** A scope whose declarations make local variables, each once. */
  Ast.Scope scope() {
    Ast.Scope scope = slots();
    Set<String> names = new HashSet<>();
    for (LocalNames.Named named : LocalNames.in(scope.body())) {
      if (!names.add(named.name())) {
        throw QuickCursor.unusual();
      }
    }
    return scope;
  }

  /** What a control structure governs; there is a warning if it is missing. */
  private Ast body() {
    if (cursor.isEndOfStatement()) {
      throw QuickCursor.unusual();
    }
    return statement();
  }

  private Ast loopBody() {
    cursor.enclosingLoops++;
    Ast body = body();
    cursor.enclosingLoops--;
    return body;
  }

  /** A list of statements as a condition: alone, a statement stands for itself. */
  private Ast condition() {
    cursor.expect(UrbiscriptParser.LPAREN);
    Ast.Sequence sequence = sequence();
    cursor.expect(UrbiscriptParser.RPAREN);
    if (sequence.statements().isEmpty()) {
      throw QuickCursor.unusual();
    }
    return sequence.statements().size() == 1 ? sequence.statements().get(0) : sequence;
  }

  // ------------------------------------------------------------------------------ statements

  Ast statement() {
    checkpoint.pass();
    int height = cursor.height();
    cursor.enter();
    int begin = cursor.begin();
    int type = cursor.type();
    Ast tree;
    if (type == UrbiscriptParser.WORD && cursor.typeAfter() == UrbiscriptParser.COLON) {
      tree = tagged(begin);
    } else if (UrbiscriptParser.ASSERT <= type && type <= UrbiscriptParser.PACKAGE) {
      tree = keyword(begin, type);
    } else {
      tree = expressions.expression();
    }
    cursor.leave(height);
    return tree;
  }

  private Ast tagged(int begin) {
    int name = cursor.next();
    Span span = cursor.token(name);
    Ast tag = new Ast.Message(span, null, tokens.string(name), null, span);
    cursor.next();
    Ast body = body();
    return new Ast.Tagged(cursor.span(begin), tag, body);
  }

  private Ast keyword(int begin, int type) {
    switch (type) {
      case UrbiscriptParser.CALL,
          UrbiscriptParser.CLOSURE,
          UrbiscriptParser.CONST,
          UrbiscriptParser.DO,
          UrbiscriptParser.FUNCTION,
          UrbiscriptParser.NEW,
          UrbiscriptParser.NOT,
          UrbiscriptParser.THIS,
          UrbiscriptParser.VAR,
          UrbiscriptParser.WATCH -> {
        return expressions.expression();
      }
      case UrbiscriptParser.GET, UrbiscriptParser.SET -> {
        // A function of that name may be called, or a variable changed; an accessor has a name.
        if (cursor.isBeforeName()) {
          throw QuickCursor.unusual();
        }
        return expressions.expression();
      }
      default -> cursor.next();
    }
    return switch (type) {
      case UrbiscriptParser.IF -> conditional(begin);
      case UrbiscriptParser.WHILE -> {
        Flavor flavor = flavor(Flavor.SEMICOLON, Flavor.AND);
        Ast condition = condition();
        Ast body = loopBody();
        yield new Ast.While(cursor.span(begin), flavor, condition, body);
      }
      case UrbiscriptParser.LOOP -> {
        Flavor flavor = flavor(Flavor.SEMICOLON, Flavor.AND);
        Ast body = loopBody();
        yield new Ast.Loop(cursor.span(begin), flavor, body);
      }
      case UrbiscriptParser.EVERY -> {
        Flavor flavor = flavor(Flavor.COMMA, Flavor.AND);
        Ast period = expressions.parenthesized();
        Ast body = loopBody();
        yield new Ast.Every(cursor.span(begin), flavor, period, body);
      }
      case UrbiscriptParser.FOR -> forLoop(begin);
      case UrbiscriptParser.SWITCH -> choice(begin);
      case UrbiscriptParser.TRY -> attempt(begin);
      case UrbiscriptParser.ASSERT -> claim(begin);
      case UrbiscriptParser.CLASS -> definitions.classDefinition(begin);
      case UrbiscriptParser.THROW,
          UrbiscriptParser.RETURN,
          UrbiscriptParser.BREAK,
          UrbiscriptParser.CONTINUE ->
          jump(begin, type);
      default -> event(begin, type);
    };
  }

  private Ast conditional(int begin) {
    Ast condition = condition();
    Ast then = body();
    Ast otherwise = cursor.skip(UrbiscriptParser.ELSE) ? body() : null;
    return new Ast.If(cursor.span(begin), condition, then, otherwise);
  }

  private Ast jump(int begin, int type) {
    boolean valued = type == UrbiscriptParser.THROW || type == UrbiscriptParser.RETURN;
    boolean alone = cursor.isEndOfStatement() || cursor.is(UrbiscriptParser.ELSE);
    Ast value = valued && !alone ? expressions.value() : null;
    int around =
        switch (type) {
          case UrbiscriptParser.THROW -> value == null ? cursor.enclosingCatches : 1;
          case UrbiscriptParser.RETURN -> cursor.enclosingFunctions;
          default -> cursor.enclosingLoops;
        };
    if (around == 0) {
      throw QuickCursor.unusual();
    }
    Span span = cursor.span(begin);
    return switch (type) {
      case UrbiscriptParser.THROW -> new Ast.Throw(span, value);
      case UrbiscriptParser.RETURN -> new Ast.Return(span, value);
      case UrbiscriptParser.BREAK -> new Ast.Break(span);
      default -> new Ast.Continue(span);
    };
  }

  // ------------------------------------------------------------------------------ loops

  /**
   * The flavor of a loop.
   *
   * @param otherwise what it is if nothing is written
   * @param forbidden what it must not be, or null
   */
  private Flavor flavor(Flavor otherwise, @Nullable Flavor forbidden) {
    Flavor flavor =
        switch (cursor.type()) {
          case UrbiscriptParser.SEMICOLON -> Flavor.SEMICOLON;
          case UrbiscriptParser.PIPE -> Flavor.PIPE;
          case UrbiscriptParser.COMMA -> Flavor.COMMA;
          case UrbiscriptParser.AND -> Flavor.AND;
          default -> null;
        };
    if (flavor == null) {
      return otherwise;
    }
    cursor.next();
    return refuse(flavor, forbidden);
  }

  private static Flavor refuse(Flavor flavor, @Nullable Flavor forbidden) {
    if (flavor == forbidden) {
      throw QuickCursor.unusual();
    }
    return flavor;
  }

  private Ast forLoop(int begin) {
    Flavor flavor = flavor(Flavor.SEMICOLON, null);
    cursor.expect(UrbiscriptParser.LPAREN);
    String name = null;
    if (cursor.is(UrbiscriptParser.VAR)) {
      int variable = cursor.next();
      if (cursor.isName()
          && (cursor.typeAfter() == UrbiscriptParser.COLON
              || cursor.typeAfter() == UrbiscriptParser.IN)) {
        name = tokens.string(cursor.next());
        cursor.next();
      } else {
        cursor.back(variable);
      }
    }
    if (name != null) {
      return forEach(begin, flavor, name, expressions.value());
    }
    Ast init = cursor.is(UrbiscriptParser.SEMICOLON) ? null : clause();
    if (init != null && cursor.is(UrbiscriptParser.RPAREN)) {
      if (init instanceof Ast.Sequence || init instanceof Ast.Declaration) {
        throw QuickCursor.unusual();
      }
      return forEach(begin, flavor, null, init);
    }
    cursor.expect(UrbiscriptParser.SEMICOLON);
    Ast test = cursor.is(UrbiscriptParser.SEMICOLON) ? null : clause();
    cursor.expect(UrbiscriptParser.SEMICOLON);
    Ast step = cursor.is(UrbiscriptParser.RPAREN) ? null : clause();
    cursor.expect(UrbiscriptParser.RPAREN);
    refuse(flavor, Flavor.AND);
    Ast body = loopBody();
    return new Ast.For(cursor.span(begin), flavor, init, test, step, body);
  }

  private Ast forEach(int begin, Flavor flavor, @Nullable String name, Ast range) {
    cursor.expect(UrbiscriptParser.RPAREN);
    refuse(flavor, Flavor.COMMA);
    Ast body = loopBody();
    return new Ast.ForEach(cursor.span(begin), flavor, name, range, body);
  }

  private Ast clause() {
    int begin = cursor.begin();
    Ast first = expressions.expression();
    if (!cursor.is(UrbiscriptParser.PIPE)) {
      return first;
    }
    List<Ast> statements = new ArrayList<>();
    List<Flavor> separators = new ArrayList<>();
    statements.add(first);
    while (cursor.skip(UrbiscriptParser.PIPE)) {
      separators.add(Flavor.PIPE);
      statements.add(expressions.expression());
    }
    return new Ast.Sequence(cursor.span(begin), statements, separators);
  }

  // ------------------------------------------------------------------------------ choices

  private Ast choice(int begin) {
    Ast value = condition();
    cursor.expect(UrbiscriptParser.LBRACE);
    List<Ast.Case> cases = new ArrayList<>();
    for (int at = cursor.begin(); cursor.skip(UrbiscriptParser.CASE); at = cursor.begin()) {
      Ast pattern = expressions.inPattern(expressions::expression);
      Ast guard = cursor.skip(UrbiscriptParser.IF) ? expressions.value() : null;
      cursor.expect(UrbiscriptParser.COLON);
      Ast.Sequence body = sequence();
      cases.add(new Ast.Case(cursor.span(at), pattern, guard, body));
    }
    Ast.Sequence otherwise = null;
    if (cursor.skip(UrbiscriptParser.DEFAULT)) {
      cursor.expect(UrbiscriptParser.COLON);
      otherwise = sequence();
    }
    cursor.expect(UrbiscriptParser.RBRACE);
    return new Ast.Switch(cursor.span(begin), value, List.copyOf(cases), otherwise);
  }

  private Ast attempt(int begin) {
    Ast.Scope body = scope();
    List<Ast.Catch> catches = new ArrayList<>();
    for (int at = cursor.begin(); cursor.skip(UrbiscriptParser.CATCH); at = cursor.begin()) {
      if (!catches.isEmpty() && catches.getLast().pattern() == null) {
        throw QuickCursor.unusual();
      }
      Ast pattern = null;
      Ast guard = null;
      if (cursor.skip(UrbiscriptParser.LPAREN)) {
        pattern = expressions.inPattern(expressions::expression);
        guard = cursor.skip(UrbiscriptParser.IF) ? expressions.value() : null;
        cursor.expect(UrbiscriptParser.RPAREN);
      }
      cursor.enclosingCatches++;
      Ast.Scope handler = scope();
      cursor.enclosingCatches--;
      catches.add(new Ast.Catch(cursor.span(at), pattern, guard, handler));
    }
    if (cursor.is(UrbiscriptParser.ELSE)) {
      // It may be that of an "if" around.
      throw QuickCursor.unusual();
    }
    Ast.Scope last = cursor.skip(UrbiscriptParser.FINALLY) ? scope() : null;
    if (catches.isEmpty() && last == null) {
      throw QuickCursor.unusual();
    }
    return new Ast.Try(cursor.span(begin), body, List.copyOf(catches), null, last);
  }

  private Ast claim(int begin) {
    if (cursor.is(UrbiscriptParser.LPAREN)) {
      Ast claim = expressions.parenthesized();
      return new Ast.Assert(cursor.span(begin), false, List.of(claim));
    }
    cursor.expect(UrbiscriptParser.LBRACE);
    List<Ast> claims = new ArrayList<>(sequence().statements());
    cursor.expect(UrbiscriptParser.RBRACE);
    claims.removeIf(Ast.Noop.class::isInstance);
    return new Ast.Assert(cursor.span(begin), true, List.copyOf(claims));
  }

  // ------------------------------------------------------------------------------ events

  private Ast event(int begin, int type) {
    boolean sync = type == UrbiscriptParser.AT && isSync();
    cursor.expect(UrbiscriptParser.LPAREN);
    switch (type) {
      case UrbiscriptParser.AT, UrbiscriptParser.WHENEVER -> {
        Ast.Condition condition = eventCondition();
        Ast body = body();
        boolean at = type == UrbiscriptParser.AT;
        boolean more = cursor.skip(at ? UrbiscriptParser.ONLEAVE : UrbiscriptParser.ELSE);
        Ast otherwise = more ? body() : null;
        return at
            ? new Ast.At(cursor.span(begin), sync, condition, body, otherwise)
            : new Ast.Whenever(cursor.span(begin), condition, body, otherwise);
      }
      case UrbiscriptParser.WAITUNTIL -> {
        Ast.Condition condition = eventCondition();
        return new Ast.WaitUntil(cursor.span(begin), condition);
      }
      case UrbiscriptParser.STOPIF -> {
        Ast.Condition condition = eventCondition();
        Ast body = body();
        return new Ast.StopIf(cursor.span(begin), condition, body);
      }
      case UrbiscriptParser.FREEZEIF -> {
        Ast.Condition condition = eventCondition();
        Ast body = body();
        return new Ast.FreezeIf(cursor.span(begin), condition, body);
      }
      case UrbiscriptParser.TIMEOUT -> {
        Ast duration = expressions.value();
        cursor.expect(UrbiscriptParser.RPAREN);
        Ast body = body();
        return new Ast.Timeout(cursor.span(begin), duration, body);
      }
      default -> throw QuickCursor.unusual();
    }
  }

  private boolean isSync() {
    if (cursor.is(UrbiscriptParser.LPAREN)) {
      return false;
    }
    String word = tokens.string(cursor.name());
    if (!word.equals("sync") && !word.equals("async")) {
      throw QuickCursor.unusual();
    }
    return word.equals("sync");
  }

  /** The condition and the parenthesis behind it, which is not a part of it. */
  private Ast.Condition eventCondition() {
    int begin = cursor.begin();
    Ast expression = expressions.value();
    if (!cursor.skip(UrbiscriptParser.QUESTION)) {
      Ast duration = cursor.skip(UrbiscriptParser.TILDE) ? expressions.value() : null;
      Span span = cursor.span(begin);
      cursor.expect(UrbiscriptParser.RPAREN);
      return new Ast.WhenTrue(span, expression, duration);
    }
    List<Ast> patterns =
        cursor.skip(UrbiscriptParser.LPAREN) ? expressions.inPattern(this::patterns) : null;
    Ast guard = cursor.skip(UrbiscriptParser.IF) ? expressions.value() : null;
    Ast duration = cursor.skip(UrbiscriptParser.TILDE) ? expressions.value() : null;
    Span span = cursor.span(begin);
    cursor.expect(UrbiscriptParser.RPAREN);
    return new Ast.WhenEmitted(span, expression, patterns, guard, duration);
  }

  private List<Ast> patterns() {
    List<Ast> patterns = new ArrayList<>();
    while (cursor.isMore(patterns.isEmpty(), UrbiscriptParser.RPAREN)) {
      patterns.add(expressions.expression());
    }
    return List.copyOf(patterns);
  }
}
