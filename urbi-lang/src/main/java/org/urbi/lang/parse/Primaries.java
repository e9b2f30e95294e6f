package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiLexer;
import org.urbi.lang.grammar.UrbiParser.*;
import org.urbi.lang.source.Span;

/** Trees of what expressions are made of: literals, names, declarations and functions. */
final class Primaries {
  private final Errors errors;
  private final Statements statements;
  private final Expressions expressions;

  /** How many functions are open: {@code call} needs one. */
  private int functions;

  Primaries(Errors errors, Statements statements, Expressions expressions) {
    this.errors = errors;
    this.statements = statements;
    this.expressions = expressions;
  }

  Ast primary(PrimaryContext context) {
    Span span = errors.span(context);
    return switch (context) {
      case FloatLiteralContext c -> new Ast.FloatLiteral(span, Literals.number(c.getText()));
      case AngleLiteralContext c -> new Ast.FloatLiteral(span, Literals.angle(c.getText()));
      case DurationLiteralContext c -> new Ast.FloatLiteral(span, Literals.duration(c.DURATION()));
      case StringLiteralContext c -> new Ast.StringLiteral(span, Literals.string(c.STRING()));
      case ThisPrimaryContext c -> new Ast.This(span);
      case CallPrimaryContext c -> call(span);
      case NamePrimaryContext c -> name(c.getStart(), null);
      case DerivativePrimaryContext c -> slot(span, null, c.getStart());
      case AccessPrimaryContext c ->
          new Ast.SlotAccess(span, null, Literals.name(c.identifier().getStart()));
      case ParenthesesContext c -> parentheses(c, span);
      case BracketsContext c -> brackets(c, span);
      case NewPrimaryContext c ->
          new Ast.Message(
              span,
              path(c.path()),
              "new",
              c.arguments() == null ? null : expressions.arguments(c.arguments().argumentList()),
              errors.span(c.NEW().getSymbol()));
      case DeclarationContext c -> declaration(c, span);
      case FunctionPrimaryContext c -> function(c, span);
      case DoPrimaryContext c ->
          new Ast.Do(
              span,
              c.expression() == null ? null : expressions.value(c.expression()),
              scope(c.scope()));
      case WatchPrimaryContext c -> new Ast.Watch(span, expressions.value(c.expression()));
      case ScopePrimaryContext c -> scope(c.scope());
      default -> throw new IllegalStateException(context.getText());
    };
  }

  private Ast call(Span span) {
    if (functions == 0) {
      errors.add(span, "call: used outside any function");
    }
    return new Ast.CallMessage(span);
  }

  /** {@code target.name}; {@code name'd} is the slot {@code 'd} of the slot {@code name}. */
  Ast.Message slot(Span span, Ast target, Token token) {
    Span written = errors.span(token);
    String text = token.getText();
    if (token.getType() != UrbiLexer.DERIVATIVE) {
      return new Ast.Message(span, target, Literals.name(token), null, written);
    }
    int prime = text.indexOf('\'');
    int at = written.begin() + prime;
    Span first = errors.span(written.begin(), at);
    Ast variable =
        new Ast.Message(
            target == null ? first : errors.span(span.begin(), at),
            target,
            text.substring(0, prime),
            null,
            first);
    return new Ast.Message(
        span, variable, text.substring(prime), null, errors.span(at, written.end()));
  }

  private Ast.Message name(Token token, Ast target) {
    Span name = errors.span(token);
    Span span = target == null ? name : target.span().to(name);
    return slot(span, target, token);
  }

  /** {@code a.b.c}. */
  Ast path(PathContext context) {
    Ast path =
        switch (context.getStart().getType()) {
          case UrbiLexer.THIS -> new Ast.This(errors.span(context.getStart()));
          case UrbiLexer.CALL -> call(errors.span(context.getStart()));
          default -> name(context.getStart(), null);
        };
    for (SelectorContext selector : context.selector()) {
      if (selector.getStart() != context.getStart()) {
        path = name(selector.getStart(), path);
      }
    }
    return path;
  }

  /** A path that something is to be stored at. */
  Ast.Message place(PathContext context) {
    Ast path = path(context);
    if (path instanceof Ast.Message message) {
      return message;
    }
    errors.add(path.span(), context.getText() + " is not a valid lvalue");
    return new Ast.Message(path.span(), null, context.getText(), null, path.span());
  }

  private Ast parentheses(ParenthesesContext context, Span span) {
    ArgumentListContext list = context.argumentList();
    List<Ast> elements = expressions.arguments(list);
    boolean one = elements.size() == 1 && list.COMMA().isEmpty();
    return one ? elements.getFirst() : new Ast.TupleLiteral(span, elements);
  }

  private Ast brackets(BracketsContext context, Span span) {
    if (context.FAT_ARROW() != null) {
      return new Ast.DictionaryLiteral(span, List.of());
    }
    List<Ast> elements = new ArrayList<>();
    List<Ast.Entry> entries = new ArrayList<>();
    for (ElementContext element : context.element()) {
      Ast first = expressions.argument(element.argument(0));
      if (element.FAT_ARROW() == null) {
        elements.add(first);
      } else {
        entries.add(new Ast.Entry(first, expressions.argument(element.argument(1))));
      }
      if (!entries.isEmpty() && !elements.isEmpty()) {
        Token at =
            element.FAT_ARROW() == null ? element.getStop() : element.FAT_ARROW().getSymbol();
        errors.add(errors.span(at), "unexpected " + at.getText());
        break;
      }
    }
    return entries.isEmpty()
        ? new Ast.ListLiteral(span, List.copyOf(elements))
        : new Ast.DictionaryLiteral(span, List.copyOf(entries));
  }

  private Ast declaration(DeclarationContext context, Span span) {
    VariableContext variable = context.variable();
    Ast place = variable(variable);
    Ast value = context.expression() == null ? null : expressions.value(context.expression());
    if (value instanceof Ast.Declaration inner) {
      expressions.misplaced(inner);
    }
    Ast type = context.path() == null ? null : path(context.path());
    boolean constant = context.CONST() != null;
    if (place instanceof Ast.Message name && name.arguments() == null) {
      return new Ast.Declaration(
          span, name.target(), name.name(), value, constant, type, name.nameSpan());
    }
    Span at = errors.span(variable);
    if (place instanceof Ast.Message
        && variable.getChild(variable.getChildCount() - 1).getText().equals("]")) {
      errors.add(at, "declaration not allowed here");
    } else {
      errors.add(at, org.urbi.lang.print.Printer.print(place) + " is not a valid lvalue");
    }
    return new Ast.Declaration(span, null, variable.getText(), value, constant, type, at);
  }

  /** What stands after {@code var}; right only when it is a path. */
  private Ast variable(VariableContext context) {
    Ast place =
        context.getStart().getType() == UrbiLexer.THIS
            ? new Ast.This(errors.span(context.getStart()))
            : name(context.getStart(), null);
    Token before = null;
    for (int i = 1; i < context.getChildCount(); i++) {
      switch (context.getChild(i)) {
        case SelectorContext selector -> {
          boolean property = before != null && before.getType() == UrbiLexer.ARROW;
          if (property && place instanceof Ast.Message m && m.arguments() == null) {
            Span span = place.span().to(errors.span(selector));
            String name = Literals.name(selector.getStart());
            place = new Ast.Property(span, m.target(), m.name(), name);
          } else {
            place = name(selector.getStart(), place);
          }
        }
        case ArgumentsContext c -> {
          Span span = place.span().to(errors.span(c));
          List<Ast> arguments = expressions.arguments(c.argumentList());
          place =
              place instanceof Ast.Message m && m.arguments() == null
                  ? new Ast.Message(span, m.target(), m.name(), arguments, m.nameSpan())
                  : new Ast.Message(span, place, "()", arguments, errors.span(c));
        }
        case ArgumentListContext c -> {
          Span span = place.span().to(errors.span(c));
          place = new Ast.Message(span, place, "[]", expressions.arguments(c), errors.span(c));
        }
        case ParserRuleContext c -> {}
        case org.antlr.v4.runtime.tree.TerminalNode word -> before = word.getSymbol();
        default -> {}
      }
    }
    return place;
  }

  private Ast function(FunctionPrimaryContext context, Span span) {
    boolean closure = context.CLOSURE() != null;
    if (closure && context.formals() == null) {
      errors.add(span, "closure cannot be lazy");
    }
    Ast.Function function = function(span, closure, context.formals(), context.scope());
    return context.path() == null
        ? function
        : new Ast.FunctionDefinition(span, place(context.path()), function);
  }

  Ast.Function function(Span span, boolean closure, FormalsContext formals, ScopeContext body) {
    functions += closure ? 0 : 1;
    List<Ast.Formal> arguments = formals == null ? null : formals(formals);
    Ast.Scope scope = scope(body);
    functions -= closure ? 0 : 1;
    return new Ast.Function(span, closure, arguments, scope);
  }

  private List<Ast.Formal> formals(FormalsContext context) {
    List<Ast.Formal> formals = new ArrayList<>();
    boolean defaults = false;
    boolean list = false;
    for (FormalContext formal : context.formal()) {
      Ast value = formal.expression() == null ? null : expressions.value(formal.expression());
      boolean variadic = formal.LBRACKET() != null;
      if (list) {
        errors.add(errors.span(context), "argument after list-argument");
        break;
      } else if (defaults && value == null && !variadic) {
        errors.add(
            errors.span(context),
            "argument with no default value after arguments with default value");
        break;
      }
      list = variadic;
      defaults |= value != null;
      formals.add(
          new Ast.Formal(
              errors.span(formal),
              Literals.name(formal.identifier().getStart()),
              value,
              variadic,
              formal.type().isEmpty() ? null : type(formal.type(0))));
    }
    return List.copyOf(formals);
  }

  private Ast type(TypeContext context) {
    Ast type = primary(context.primary());
    for (SelectorContext selector : context.selector()) {
      type = name(selector.getStart(), type);
    }
    return type;
  }

  Ast.Scope scope(ScopeContext context) {
    return expressions.outside(
        () -> new Ast.Scope(errors.span(context), statements.sequence(context.sequence())));
  }
}
