package org.urbi.kernel.embed;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.lang.source.Location;

/**
 * An error in urbiscript that no urbiscript code has caught (manual, "Exceptions"), thrown to the
 * Java code which asked for the evaluation. Its Java stack trace begins with the urbiscript calls.
 */
public final class UrbiError extends RuntimeException {
  private static final long serialVersionUID = 1;

  /**
   * A call on the way to the error.
   *
   * @param location null when the call was made by Java code
   */
  public record Call(String name, @Nullable Location location) {
    /** As the manual shows it: {@code file.u:1.5-7: name}. */
    @Override
    public String toString() {
      return location == null ? name : location + ": " + name;
    }
  }

  private final transient @Nullable Location location;
  private final transient List<Call> backtrace;
  private final transient @Nullable Object value;
  private final @Nullable String hint;
  private final transient @Nullable UrbiException original;

  UrbiError(
      @Nullable String message,
      @Nullable Location location,
      List<Call> backtrace,
      @Nullable Object value,
      @Nullable String hint,
      @Nullable UrbiException original) {
    super(message);
    this.hint = hint;
    this.original = original;
    this.location = location;
    this.backtrace = List.copyOf(backtrace);
    this.value = value;
    setStackTrace(withCalls(getStackTrace()));
  }

  /** A copy of this error with the stack trace of the thread that waits for the evaluation. */
  UrbiError here() {
    UrbiError same = new UrbiError(getMessage(), location, backtrace, value, hint, original);
    if (getCause() != null) {
      same.initCause(getCause());
    }
    return same;
  }

  /** A hint at what to do about it; empty for what a program has thrown. */
  public Optional<String> hint() {
    return Optional.ofNullable(hint);
  }

  /** The urbiscript exception that it represents; null for a Java error. */
  @Nullable UrbiException original() {
    return original;
  }

  private StackTraceElement[] withCalls(StackTraceElement[] java) {
    StackTraceElement[] all = new StackTraceElement[backtrace.size() + java.length];
    for (int i = 0; i < backtrace.size(); i++) {
      Call call = backtrace.get(i);
      Location place = call.location();
      all[i] =
          new StackTraceElement(
              "urbiscript",
              call.name(),
              place == null || place.file() == null ? "input" : place.file(),
              place == null ? -1 : place.line());
    }
    System.arraycopy(java, 0, all, backtrace.size(), java.length);
    return all;
  }

  /** Where it was thrown, or where the source does not parse; null when that is not known. */
  public @Nullable Location location() {
    return location;
  }

  /** The urbiscript calls that led there, innermost first. */
  public List<Call> backtrace() {
    return backtrace;
  }

  /** What was thrown, as a Java value: for the errors of the language a {@link UrbiValue}. */
  public @Nullable Object value() {
    return value;
  }

  /** The error as the console shows it: {@code !!!} lines, without time stamps. */
  public String report() {
    var text = new StringBuilder(Diagnostics.marked(String.valueOf(getMessage())));
    for (Call call : backtrace) {
      text.append('\n').append(Diagnostics.marked(Problem.CALLED_FROM.text("", call)));
    }
    return text.toString();
  }
}
