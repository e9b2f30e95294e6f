package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.QuickTokens;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.source.Span;

/** Expressions, for {@link QuickParser}. */
final class QuickExpressions {
  private final QuickCursor cursor;
  private final QuickTokens tokens;
  private final QuickStatements statements;

  QuickExpressions(QuickCursor cursor, QuickStatements statements) {
    this.cursor = cursor;
    this.tokens = cursor.tokens();
    this.statements = statements;
  }

  // ------------------------------------------------------------------------------ operators

  /** An expression that may be a declaration. */
  Ast expression() {
    int height = cursor.height();
    Ast tree = climb(0);
    cursor.leave(height);
    if (cursor.isName()) {
      // A modifier, or an error.
      throw QuickCursor.unusual();
    }
    return tree;
  }

  /** An expression that may not be a declaration. */
  Ast value() {
    return noDeclaration(expression());
  }

  private static Ast noDeclaration(Ast tree) {
    if (tree instanceof Ast.Declaration) {
      throw QuickCursor.unusual();
    }
    return tree;
  }

  private Ast climb(int minimum) {
    cursor.enter();
    int begin = cursor.begin();
    Ast left = operand();
    for (Operators operator = operator(); operator != null; operator = operator()) {
      if (operator.precedence < minimum) {
        break;
      }
      cursor.enter();
      int nameBegin = cursor.begin();
      cursor.next();
      if (operator == Operators.NOT_IN) {
        cursor.expect(UrbiscriptParser.IN);
      }
      Span name = cursor.span(nameBegin);
      noDeclaration(left);
      Ast right =
          noDeclaration(
              climb(operator.rightAssociative ? operator.precedence : operator.precedence + 1));
      left = combine(operator, cursor.span(begin), left, right, name);
      Operators following = operator();
      if (!operator.chainable && following != null && following.precedence == operator.precedence) {
        throw QuickCursor.unusual();
      }
    }
    return left;
  }

  private @Nullable Operators operator() {
    int type = cursor.type();
    return type < 0 ? null : Operators.binary(type);
  }

  private static Ast combine(Operators operator, Span span, Ast left, Ast right, Span name) {
    return switch (operator) {
      case AND -> new Ast.And(span, left, right);
      case OR -> new Ast.Or(span, left, right);
      case IN, NOT_IN -> new Ast.Message(span, right, operator.text, List.of(left), name);
      default -> new Ast.Message(span, left, operator.text, List.of(right), name);
    };
  }

  private Ast operand() {
    int begin = cursor.begin();
    return switch (cursor.type()) {
      case UrbiscriptParser.PLUS,
          UrbiscriptParser.MINUS,
          UrbiscriptParser.BANG,
          UrbiscriptParser.NOT,
          UrbiscriptParser.COMPL,
          UrbiscriptParser.TILDE -> {
        Operators operator = Operators.prefix(cursor.type());
        Span name = cursor.token(cursor.next());
        Ast target = noDeclaration(climb(operator.precedence));
        yield new Ast.Message(cursor.span(begin), target, operator.text, List.of(), name);
      }
      case UrbiscriptParser.CONST, UrbiscriptParser.VAR -> declaration(begin);
      default -> assignment(begin, postfix());
    };
  }

  // ------------------------------------------------------------------------------ assignments

  private Ast declaration(int begin) {
    boolean constant = cursor.skip(UrbiscriptParser.CONST);
    cursor.expect(UrbiscriptParser.VAR);
    Ast.Message name = lvalue(outsidePattern(this::postfix));
    Span span = cursor.span(begin);
    Ast value = null;
    if (cursor.skip(UrbiscriptParser.ASSIGN)) {
      value = assigned();
      span = cursor.span(begin);
    }
    return new Ast.Declaration(
        span, name.target(), name.name(), value, constant, null, name.nameSpan());
  }

  /** The name that something is given. */
  static Ast.Message lvalue(Ast tree) {
    if (tree instanceof Ast.Message message && message.arguments() == null) {
      return message;
    }
    throw QuickCursor.unusual();
  }

  private Ast assignment(int begin, Ast target) {
    String operator =
        switch (cursor.type()) {
          case UrbiscriptParser.ASSIGN -> "=";
          case UrbiscriptParser.PLUS_ASSIGN -> "+=";
          case UrbiscriptParser.MINUS_ASSIGN -> "-=";
          case UrbiscriptParser.TIMES_ASSIGN -> "*=";
          case UrbiscriptParser.DIVIDE_ASSIGN -> "/=";
          case UrbiscriptParser.MODULO_ASSIGN -> "%=";
          case UrbiscriptParser.XOR_ASSIGN -> "^=";
          default -> null;
        };
    if (operator == null) {
      return target;
    }
    cursor.next();
    if (operator.equals("=")) {
      if (target instanceof Ast.SlotAccess || target instanceof Ast.Emit) {
        throw QuickCursor.unusual();
      }
      Ast value = assigned();
      return new Ast.Assignment(cursor.span(begin), target, value);
    }
    checkChanged(target);
    Ast value = assigned();
    return new Ast.OperatorAssignment(cursor.span(begin), target, operator, value);
  }

  /** What an operator changes is a variable, a slot, an element or a property. */
  private static void checkChanged(Ast target) {
    boolean fine =
        target instanceof Ast.Message m && (m.arguments() == null || m.name().equals("[]"))
            || target instanceof Ast.Property;
    if (!fine) {
      throw QuickCursor.unusual();
    }
  }

  private Ast assigned() {
    if (cursor.isName() && cursor.typeAfter() == UrbiscriptParser.COLON) {
      // The modifier of a trajectory.
      throw QuickCursor.unusual();
    }
    return outsidePattern(this::value);
  }

  <T> T inPattern(Supplier<T> read) {
    return with(true, read);
  }

  <T> T outsidePattern(Supplier<T> read) {
    return with(false, read);
  }

  private <T> T with(boolean inside, Supplier<T> read) {
    boolean outer = cursor.pattern;
    cursor.pattern = inside;
    // If something is unusual, all is given up.
    T tree = read.get();
    cursor.pattern = outer;
    return tree;
  }

  // ------------------------------------------------------------------------------ messages

  /** An operand with what is said to it. */
  Ast postfix() {
    int begin = cursor.begin();
    boolean name = QuickCursor.isIdentifier(cursor.type()) || cursor.is(UrbiscriptParser.NEW);
    int height = cursor.height();
    Ast tree = primary(begin);
    for (Ast next = suffix(begin, tree, name); next != null; next = suffix(begin, tree, false)) {
      cursor.enter();
      tree = next;
      name = false;
    }
    cursor.leave(height);
    return tree;
  }

  /** What is said to a target; null if nothing. */
  private @Nullable Ast suffix(int begin, Ast target, boolean name) {
    return switch (cursor.type()) {
      case UrbiscriptParser.DOT -> {
        cursor.next();
        int slot = cursor.name();
        Span nameSpan = cursor.token(slot);
        List<Ast> arguments = cursor.is(UrbiscriptParser.LPAREN) ? arguments() : null;
        yield new Ast.Message(cursor.span(begin), target, tokens.string(slot), arguments, nameSpan);
      }
      case UrbiscriptParser.LPAREN -> {
        int open = cursor.begin();
        List<Ast> arguments = arguments();
        yield name && target instanceof Ast.Message m && m.arguments() == null
            ? new Ast.Message(cursor.span(begin), m.target(), m.name(), arguments, m.nameSpan())
            : new Ast.Message(cursor.span(begin), target, "()", arguments, cursor.span(open));
      }
      case UrbiscriptParser.LBRACKET -> {
        int open = cursor.begin();
        cursor.next();
        List<Ast> arguments = outsidePattern(() -> values(UrbiscriptParser.RBRACKET));
        yield new Ast.Message(cursor.span(begin), target, "[]", arguments, cursor.span(open));
      }
      case UrbiscriptParser.BANG -> {
        cursor.next();
        List<Ast> arguments = cursor.is(UrbiscriptParser.LPAREN) ? arguments() : null;
        yield new Ast.Emit(cursor.span(begin), target, arguments, null);
      }
      case UrbiscriptParser.INCREMENT, UrbiscriptParser.DECREMENT -> {
        checkChanged(target);
        String operator = tokens.text(cursor.next());
        yield new Ast.Postfix(cursor.span(begin), target, operator);
      }
      case UrbiscriptParser.ARROW -> {
        Ast.Message slot = lvalue(target);
        cursor.next();
        String property = tokens.string(cursor.name());
        yield new Ast.Property(cursor.span(begin), slot.target(), slot.name(), property);
      }
      case UrbiscriptParser.DOT_AND -> {
        cursor.next();
        String slot = tokens.string(cursor.name());
        yield new Ast.SlotAccess(cursor.span(begin), target, slot);
      }
      default -> null;
    };
  }

  private List<Ast> arguments() {
    cursor.next();
    return outsidePattern(() -> values(UrbiscriptParser.RPAREN));
  }

  /** Expressions between commas, up to what closes them. */
  private List<Ast> values(int closing) {
    List<Ast> values = new ArrayList<>();
    while (cursor.isMore(values.isEmpty(), closing)) {
      values.add(value());
    }
    return List.copyOf(values);
  }

  // ------------------------------------------------------------------------------ operands

  private Ast primary(int begin) {
    int type = cursor.type();
    if (QuickCursor.isIdentifier(type)) {
      int name = cursor.next();
      Span span = cursor.token(name);
      return new Ast.Message(span, null, tokens.string(name), null, span);
    }
    return switch (type) {
      case UrbiscriptParser.NUMBER -> {
        double number = tokens.number(cursor.next());
        yield new Ast.FloatLiteral(cursor.span(begin), number);
      }
      case UrbiscriptParser.DURATION -> duration(begin);
      case UrbiscriptParser.STRING -> string(begin);
      case UrbiscriptParser.THIS -> {
        cursor.next();
        yield new Ast.This(cursor.span(begin));
      }
      case UrbiscriptParser.LPAREN -> parentheses(begin);
      case UrbiscriptParser.LBRACKET -> list(begin);
      case UrbiscriptParser.LBRACE -> outsidePattern(statements::scope);
      case UrbiscriptParser.FUNCTION, UrbiscriptParser.CLOSURE ->
          outsidePattern(() -> statements.definitions().function(begin));
      default -> rarePrimary(begin, type);
    };
  }

  private Ast rarePrimary(int begin, int type) {
    cursor.next();
    switch (type) {
      case UrbiscriptParser.CALL -> {
        if (cursor.enclosingFunctions > 0) {
          return new Ast.CallMessage(cursor.span(begin));
        }
      }
      case UrbiscriptParser.NEW -> {
        // Not the deprecated "new Object".
        if (!cursor.isName() && !cursor.is(UrbiscriptParser.THIS)) {
          Span span = cursor.span(begin);
          return new Ast.Message(span, null, "new", null, span);
        }
      }
      case UrbiscriptParser.AND -> {
        String slot = tokens.string(cursor.name());
        return new Ast.SlotAccess(cursor.span(begin), null, slot);
      }
      case UrbiscriptParser.WATCH -> {
        Ast watched = parenthesized();
        return new Ast.Watch(cursor.span(begin), watched);
      }
      case UrbiscriptParser.DO -> {
        Ast target = cursor.is(UrbiscriptParser.LPAREN) ? parenthesized() : null;
        Ast.Scope body = outsidePattern(statements::slots);
        return new Ast.Do(cursor.span(begin), target, body);
      }
      default -> {}
    }
    throw QuickCursor.unusual();
  }

  /** A value in parentheses that belong to what is before. */
  Ast parenthesized() {
    cursor.expect(UrbiscriptParser.LPAREN);
    Ast value = outsidePattern(this::value);
    cursor.expect(UrbiscriptParser.RPAREN);
    return value;
  }

  private Ast duration(int begin) {
    double sum = 0;
    while (cursor.is(UrbiscriptParser.DURATION)) {
      sum += tokens.number(cursor.next());
    }
    return new Ast.FloatLiteral(cursor.span(begin), sum);
  }

  private Ast string(int begin) {
    String text = tokens.string(cursor.next());
    if (cursor.is(UrbiscriptParser.STRING)) {
      StringBuilder glued = new StringBuilder(text);
      while (cursor.is(UrbiscriptParser.STRING)) {
        glued.append(tokens.string(cursor.next()));
      }
      text = glued.toString();
    }
    return new Ast.StringLiteral(cursor.span(begin), text);
  }

  /** An expression in parentheses is itself; several, or one and a comma, are a tuple. */
  private Ast parentheses(int begin) {
    cursor.next();
    List<Ast> elements = new ArrayList<>();
    boolean comma = false;
    while (cursor.isMore(elements.isEmpty(), UrbiscriptParser.RPAREN)) {
      elements.add(element());
      comma = cursor.is(UrbiscriptParser.COMMA);
    }
    return elements.size() == 1 && !comma
        ? elements.get(0)
        : new Ast.TupleLiteral(cursor.span(begin), List.copyOf(elements));
  }

  private Ast list(int begin) {
    cursor.next();
    if (cursor.skip(UrbiscriptParser.FAT_ARROW)) {
      cursor.expect(UrbiscriptParser.RBRACKET);
      return new Ast.DictionaryLiteral(cursor.span(begin), List.of());
    }
    List<Ast> keys = new ArrayList<>();
    List<Ast.Entry> entries = new ArrayList<>();
    while (cursor.isMore(keys.isEmpty(), UrbiscriptParser.RBRACKET)) {
      Ast key = element();
      keys.add(key);
      if (cursor.skip(UrbiscriptParser.FAT_ARROW)) {
        entries.add(new Ast.Entry(key, element()));
      }
    }
    if (entries.isEmpty()) {
      return new Ast.ListLiteral(cursor.span(begin), List.copyOf(keys));
    }
    if (entries.size() < keys.size()) {
      throw QuickCursor.unusual();
    }
    return new Ast.DictionaryLiteral(cursor.span(begin), List.copyOf(entries));
  }

  private Ast element() {
    Ast element = expression();
    return cursor.pattern ? element : noDeclaration(element);
  }
}
