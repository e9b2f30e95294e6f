package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.QuickTokens;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.source.Span;

/** Classes and functions, for {@link QuickParser}. */
final class QuickDefinitions {
  private final QuickCursor cursor;
  private final QuickTokens tokens;
  private final QuickStatements statements;
  private final QuickExpressions expressions;

  QuickDefinitions(QuickCursor cursor, QuickStatements statements, QuickExpressions expressions) {
    this.cursor = cursor;
    this.tokens = cursor.tokens();
    this.statements = statements;
    this.expressions = expressions;
  }

  Ast classDefinition(int begin) {
    Ast.Message name = QuickExpressions.lvalue(expressions.postfix());
    List<Ast> protos = new ArrayList<>();
    if (cursor.skip(UrbiscriptParser.COLON)) {
      do {
        protos.add(expressions.value());
      } while (cursor.skip(UrbiscriptParser.COMMA));
    }
    Ast.Scope body = cursor.is(UrbiscriptParser.LBRACE) ? statements.slots() : null;
    return new Ast.ClassDefinition(cursor.span(begin), name, List.copyOf(protos), body);
  }

  /** A function, or the definition of one. */
  Ast function(int begin) {
    boolean closure = cursor.type() == UrbiscriptParser.CLOSURE;
    cursor.next();
    boolean named = cursor.isName() || cursor.is(UrbiscriptParser.THIS);
    Ast.Message name = named ? path() : null;
    List<Ast.Formal> formals = cursor.is(UrbiscriptParser.LPAREN) ? formals() : null;
    if (closure && formals == null) {
      throw QuickCursor.unusual();
    }
    Ast.Scope body = functionBody(closure);
    Span span = cursor.span(begin);
    Ast.Function function = new Ast.Function(span, closure, formals, body);
    return name == null ? function : new Ast.FunctionDefinition(span, name, function);
  }

  private Ast.Scope functionBody(boolean closure) {
    int loops = cursor.enclosingLoops;
    int catches = cursor.enclosingCatches;
    cursor.enclosingFunctions++;
    cursor.enclosingCatches = 0;
    // A closure may be what a loop calls.
    cursor.enclosingLoops = closure ? 1 : 0;
    Ast.Scope body = statements.scope();
    cursor.enclosingFunctions--;
    cursor.enclosingLoops = loops;
    cursor.enclosingCatches = catches;
    return body;
  }

  private Ast.Message path() {
    int begin = cursor.begin();
    Ast tree = null;
    if (cursor.is(UrbiscriptParser.THIS)) {
      tree = new Ast.This(cursor.token(cursor.next()));
      cursor.expect(UrbiscriptParser.DOT);
    }
    int height = cursor.height();
    do {
      cursor.enter();
      int name = cursor.name();
      tree =
          new Ast.Message(cursor.span(begin), tree, tokens.string(name), null, cursor.token(name));
    } while (cursor.skip(UrbiscriptParser.DOT));
    cursor.leave(height);
    return QuickExpressions.lvalue(tree);
  }

  private List<Ast.Formal> formals() {
    cursor.next();
    List<Ast.Formal> formals = new ArrayList<>();
    while (cursor.isMore(formals.isEmpty(), UrbiscriptParser.RPAREN)) {
      Ast.Formal last = formals.isEmpty() ? null : formals.getLast();
      Ast.Formal formal = formal();
      boolean bare = formal.defaultValue() == null && !formal.variadic();
      if (last != null && (last.variadic() || last.defaultValue() != null && bare)) {
        throw QuickCursor.unusual();
      }
      formals.add(formal);
    }
    return List.copyOf(formals);
  }

  private Ast.Formal formal() {
    int begin = cursor.begin();
    cursor.skip(UrbiscriptParser.VAR);
    String name = tokens.string(cursor.name());
    boolean variadic = cursor.skip(UrbiscriptParser.LBRACKET);
    if (variadic) {
      cursor.expect(UrbiscriptParser.RBRACKET);
    }
    Ast type = cursor.skip(UrbiscriptParser.COLON) ? expressions.postfix() : null;
    Ast value = cursor.skip(UrbiscriptParser.ASSIGN) ? expressions.value() : null;
    return new Ast.Formal(cursor.span(begin), name, value, variadic, type);
  }
}
