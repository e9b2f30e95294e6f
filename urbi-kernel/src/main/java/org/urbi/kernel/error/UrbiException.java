package org.urbi.kernel.error;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.source.Span;

/**
 * The one exception that crosses the kernel: a thrown urbiscript value, where it was thrown, and
 * the urbiscript calls that led there (manual, "Exceptions").
 */
public final class UrbiException extends RuntimeException {
  /**
   * A call on the way to the error: the name called, and where.
   *
   * @param span null when it is not known
   */
  public record Call(String name, @Nullable Span span) {
    /** A placeholder for calls that are not shown. */
    public static Call leftOut(int count) {
      return new Call(Problem.LEFT_OUT.text(count), null);
    }
  }

  private final transient UrbiObject value;
  private final @Nullable String hint;
  private final boolean uncatchable;
  private final transient @Nullable SyntaxError syntaxError;
  private transient @Nullable Span span;
  private transient @Nullable List<Call> backtrace;

  public UrbiException(UrbiObject value) {
    this(value, null, null, false);
  }

  UrbiException(UrbiObject value, @Nullable String hint) {
    this(value, hint, null, false);
  }

  /** An exception that tells of an error in a text. */
  UrbiException(UrbiObject value, SyntaxError error) {
    this(value, error.problem().hint().orElse(null), error, false);
  }

  private UrbiException(
      UrbiObject value,
      @Nullable String hint,
      @Nullable SyntaxError syntaxError,
      boolean uncatchable) {
    super(null, null, false, false);
    this.value = value;
    this.hint = hint;
    this.syntaxError = syntaxError;
    this.uncatchable = uncatchable;
  }

  /** A copy of this exception that no code can catch, because the job must end. */
  UrbiException uncatchable() {
    return new UrbiException(value, hint, syntaxError, true);
  }

  /** Whether {@code catch} clauses ignore it. */
  public boolean isUncatchable() {
    return uncatchable;
  }

  /** Returns this exception if code may go on all the same, otherwise throws it again. */
  public UrbiException unlessUncatchable() {
    if (uncatchable) {
      throw this;
    }
    return this;
  }

  /** What was thrown. */
  public UrbiObject value() {
    return value;
  }

  /** A hint at what to do about it, if the catalogue of messages has one. */
  public Optional<String> hint() {
    return Optional.ofNullable(hint);
  }

  /** The error in a text of which it tells, or null. */
  public @Nullable SyntaxError syntaxError() {
    return syntaxError;
  }

  /** Whether it is known where it was thrown. */
  public boolean isLocated() {
    return backtrace != null;
  }

  /** Sets where it was thrown and its calls, innermost first. */
  public void locate(@Nullable Span where, List<Call> calls) {
    span = where;
    backtrace = calls;
  }

  /** Where it was thrown, or null. */
  public @Nullable Span span() {
    return span;
  }

  /** The calls, innermost first. */
  public List<Call> backtrace() {
    return backtrace == null ? List.of() : backtrace;
  }
}
