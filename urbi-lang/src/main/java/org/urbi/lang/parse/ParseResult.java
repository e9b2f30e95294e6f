package org.urbi.lang.parse;

import static java.util.Objects.requireNonNull;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;

/**
 * The result of parsing: a tree, or errors.
 *
 * @param tree null when there are errors
 * @param separator what ended the statement; null when the text was not read as one statement
 * @param errors in the order of the text
 * @param warnings in the order of the text
 */
public record ParseResult(
    @Nullable Ast tree,
    Ast.@Nullable Flavor separator,
    List<SyntaxError> errors,
    List<SyntaxWarning> warnings) {
  /** Whether there is a tree. */
  public boolean valid() {
    return errors.isEmpty();
  }

  /** The tree of a complete text without errors. */
  public Ast.Sequence sequence() {
    return (Ast.Sequence) requireNonNull(tree, "a text with errors has no tree");
  }
}
