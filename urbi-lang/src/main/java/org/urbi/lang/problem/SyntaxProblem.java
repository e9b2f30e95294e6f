package org.urbi.lang.problem;

import static org.urbi.lang.problem.SyntaxProblem.Kind.ERROR;
import static org.urbi.lang.problem.SyntaxProblem.Kind.WARNING;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The catalogue of the parser's messages, in the words of the manual; the kernel has another one.
 * To find where a message comes from, search here for its text, and in the code for its name.
 */
public enum SyntaxProblem {
  // ------------------------------------------------------------------ characters and words

  RESERVED_WORD(ERROR, "reserved symbol: `{word}'", "in single quotes it is a name: 'word'"),
  INVALID_NUMBER(ERROR, "invalid token: `{text}'"),
  INVALID_CHARACTER(ERROR, "invalid character: `{character}'"),
  OPEN_COMMENT(ERROR, "unexpected end of file in a comment", "comments nest: each /* needs its */"),
  OPEN_STRING(ERROR, "unexpected end of file in a string", "a double quote ends it"),
  OPEN_NAME(ERROR, "unexpected end of file in a identifier", "a single quote ends it"),
  OPEN_BINARY(
      ERROR,
      "unexpected end of file in binary data",
      "after the semicolon come as many bytes as BIN says"),
  ESCAPED_CHARACTER(
      ERROR,
      "invalid character after \\-escape: `{character}'",
      "a backslash itself is written \\\\"),
  ESCAPED_NUMBER(
      ERROR, "invalid number after \\-escape: `{digits}'", "the largest is \\377, or \\xff"),
  ESCAPED_BLOB(ERROR, "invalid \\B(SIZE)(CONTENTS) escape: `{text}'"),
  OPEN_BLOB(
      ERROR,
      "unexpected '{character}' for closing \\B, expected ')'",
      "the contents are as long as the size says"),

  // ------------------------------------------------------------------ what stands where

  UNEXPECTED(ERROR, "unexpected {token}"),
  UNEXPECTED_INSTEAD(ERROR, "unexpected {token}, expecting {expected}"),
  UNEXPECTED_END(ERROR, "unexpected end of file", "`;' is missing at the end of the statement"),
  NESTING_TOO_DEEP(ERROR, "nesting too deep"),
  STATEMENT_TOO_LONG(ERROR, "statement longer than {maximum} characters"),
  NOT_AN_LVALUE(ERROR, "{expression} is not a valid lvalue", "only slots can be assigned to"),
  MISPLACED_DECLARATION(ERROR, "declaration not allowed here"),
  VARIABLE_REDEFINITION(
      ERROR, "variable redefinition: {name}", "without var, the variable gets another value"),
  BREAK_OUTSIDE(ERROR, "break: outside a loop", "a tag ends other code: t.stop ends t: { … }"),
  CONTINUE_OUTSIDE(
      ERROR, "continue: outside a loop", "it begins the next turn of for, while, loop or every"),
  RETURN_OUTSIDE(
      ERROR, "return: outside a function", "a tag ends other code: t.stop ends t: { … }"),
  THROW_OUTSIDE(ERROR, "throw: outside a catch", "what is thrown stands behind throw"),
  INVALID_FLAVOR(ERROR, "invalid flavor: {loop}{flavor}"),
  CAUGHT_ALREADY(
      ERROR,
      "catch: exception already caught by a previous clause",
      "a catch without a pattern comes last"),
  CALL_OUTSIDE_FUNCTION(ERROR, "call: used outside any function"),

  // ------------------------------------------------------------------ functions and events

  LAZY_CLOSURE(ERROR, "closure cannot be lazy", "its arguments are in parentheses: closure () {}"),
  ARGUMENT_AFTER_LIST(ERROR, "argument after list-argument", "the list-argument comes last"),
  ARGUMENT_WITHOUT_DEFAULT(
      ERROR,
      "argument with no default value after arguments with default value",
      "those with default values come last"),
  UNEXPECTED_KEYWORD(ERROR, "unexpected `{word}'", "at has sync and async"),
  DUPLICATE_KEYWORD(ERROR, "duplicate keyword: `{word}'"),
  INCOMPATIBLE_KEYWORDS(ERROR, "incompatible keywords: `{first}' and `{second}'"),

  // ------------------------------------------------------------------ warnings

  DEPRECATED(WARNING, "`{old}' is deprecated"),
  DEPRECATED_FOR(WARNING, "`{old}' is deprecated, use `{successor}'"),
  DEPRECATED_DERIVATIVE(WARNING, "`{old}' is deprecated, use `{successor}'."),
  DEPRECATED_EMIT(WARNING, "`emit event(x)' is deprecated, use `event!(x)'"),
  DEPRECATED_NEW(WARNING, "`new Obj(x)' is deprecated, use `Obj.new(x)'"),
  DEPRECATED_SELF(WARNING, "`self' is deprecated, use `this'"),
  EMPTY_STATEMENT(
      WARNING,
      "implicit empty statement, use `{}'",
      "the `;' ends the statement: what it is to do stands before the `;'"),
  MODIFIER_REDEFINED(WARNING, "modifier redefined: {name}");

  /** The severity. */
  public enum Kind {
    /** The text is invalid. */
    ERROR,
    /** The text is valid, but suspect. */
    WARNING
  }

  private final Kind kind;
  private final Template template;
  private final @Nullable String hint;

  SyntaxProblem(Kind kind, String text) {
    this(kind, text, null);
  }

  SyntaxProblem(Kind kind, String text, @Nullable String hint) {
    this.kind = kind;
    this.template = new Template(text);
    this.hint = hint;
  }

  public Kind kind() {
    return kind;
  }

  /** Its text, not filled in. */
  public Template template() {
    return template;
  }

  /** Its text; the values stand for its places, in their order. */
  public String text(Object... values) {
    return template.fill(values);
  }

  /** A hint at what to do about it. */
  public Optional<String> hint() {
    return Optional.ofNullable(hint);
  }
}
