package org.urbi.kernel.error;

import org.jspecify.annotations.Nullable;

/** How a problem is reported: as an exception of one of the manual's types, or only as a text. */
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

  /** Sent on the channel {@code warning}. */
  WARNING(null),

  /** A line of its own, on the channel {@code error} or in the log. */
  LINE(null),

  /** Part of another message, such as the reason in it. */
  PART(null);

  private final @Nullable String type;

  ProblemKind(@Nullable String type) {
    this.type = type;
  }

  /** The type of the exception; null if it is not reported as one. */
  public @Nullable String type() {
    return type;
  }
}
