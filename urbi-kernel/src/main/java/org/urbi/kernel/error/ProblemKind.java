package org.urbi.kernel.error;

import org.jspecify.annotations.Nullable;

/** What becomes of a problem: an exception of one of the manual's types, or only a text. */
public enum ProblemKind {
  ARGUMENT("Exception.Argument"),
  ARGUMENT_TYPE("Exception.ArgumentType"),
  ARITY("Exception.Arity"),
  ASSERTION("Exception.Assertion"),
  BAD_INTEGER("Exception.BadInteger"),
  BAD_NUMBER("Exception.BadNumber"),
  CONSTNESS("Exception.Constness"),
  FILE_NOT_FOUND("Exception.FileNotFound"),
  IMPLICIT_TAG("Exception.ImplicitTagComponent"),
  KEY_ERROR("Dictionary.KeyError"),
  LOOKUP("Exception.Lookup"),
  MATCH_FAILURE("Exception.MatchFailure"),
  NEGATIVE_NUMBER("Exception.NegativeNumber"),
  NON_POSITIVE_NUMBER("Exception.NonPositiveNumber"),
  PRIMITIVE("Exception.Primitive"),
  PROPERTY_LOOKUP("Exception.PropertyLookup"),
  REDEFINITION("Exception.Redefinition"),
  SCHEDULING("Exception.Scheduling"),
  SYNTAX("Exception.Syntax"),
  TIME_OUT("Exception.TimeOut"),
  TYPE("Exception.Type"),
  UNEXPECTED_VOID("Exception.UnexpectedVoid"),

  /** Told on the channel {@code warning}. */
  WARNING(null),

  /** A line by itself, on the channel {@code error} or in the log. */
  LINE(null),

  /** Part of another message, such as the reason in it. */
  PART(null);

  private final @Nullable String type;

  ProblemKind(@Nullable String type) {
    this.type = type;
  }

  /** The type of exceptions it becomes; null when it is none. */
  public @Nullable String type() {
    return type;
  }
}
