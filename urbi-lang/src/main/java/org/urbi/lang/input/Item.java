package org.urbi.lang.input;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.SyntaxWarning;

/** One top-level piece of interactive input. */
public sealed interface Item {
  /** What to tell in any case. */
  List<SyntaxWarning> warnings();

  /**
   * A statement to run.
   *
   * @param separator {@link Ast.Flavor#SEMICOLON} or {@link Ast.Flavor#COMMA}
   */
  record Statement(Ast tree, Ast.@Nullable Flavor separator, List<SyntaxWarning> warnings)
      implements Item {}

  /** What would have been a statement. */
  record Invalid(List<SyntaxError> errors, List<SyntaxWarning> warnings) implements Item {}
}
