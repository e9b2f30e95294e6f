package urbi.spi;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Logs the stack traces of exceptions in components. The same exception at the same place is logged
 * once, even if a timer throws it again and again.
 */
public final class ComponentFailureLog {
  /** So many places are remembered; the oldest is forgotten first. */
  private static final int MAX_PLACES = 1000;

  private final Consumer<String> log;
  private final Set<Integer> told =
      Collections.synchronizedSet(
          Collections.newSetFromMap(
              new LinkedHashMap<>() {
                private static final long serialVersionUID = 1;

                @Override
                protected boolean removeEldestEntry(Map.Entry<Integer, Boolean> eldest) {
                  return size() > MAX_PLACES;
                }
              }));

  /**
   * @param log is given texts of several lines, from any thread
   */
  public ComponentFailureLog(Consumer<String> log) {
    this.log = log;
  }

  /**
   * Logs where something was thrown; nothing for what has no stack trace, as what was thrown in
   * another language or process.
   *
   * @param what has failed, for people
   */
  public void log(String what, Throwable failure) {
    Throwable cause = Failure.cause(failure);
    StackTraceElement[] trace = cause.getStackTrace();
    if (trace.length > 0 && told.add(Objects.hash(what, cause.getClass(), trace[0]))) {
      StringWriter text = new StringWriter();
      cause.printStackTrace(new PrintWriter(text));
      log.accept(what + ": " + text.toString().stripTrailing());
    }
  }
}
