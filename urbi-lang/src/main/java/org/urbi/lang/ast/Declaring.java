package org.urbi.lang.ast;

import org.urbi.lang.source.Span;

/** A piece of a tree that may declare a variable; it tells apart those of one name. */
public sealed interface Declaring permits Ast, Ast.Formal {
  /** Where it was written. */
  Span span();
}
