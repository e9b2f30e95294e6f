package urbi;

import java.lang.StackWalker.Option;

/** Finds out to which context the code of a thread belongs. */
final class CurrentContext {
  private static final ThreadLocal<UContext> OF_THREAD = new ThreadLocal<>();
  private static final StackWalker CALLERS = StackWalker.getInstance(Option.RETAIN_CLASS_REFERENCE);

  private CurrentContext() {}

  static UContext enter(UContext context) {
    UContext before = OF_THREAD.get();
    if (before != context) {
      if (context == null) {
        OF_THREAD.remove();
      } else {
        OF_THREAD.set(context);
      }
    }
    return before;
  }

  static UContext get() {
    UContext own = OF_THREAD.get();
    if (own == null) {
      // A thread that the user has made: its code tells whose it is.
      own =
          CALLERS.walk(frames ->
              frames
                  .map(frame -> UModule.contextOf(frame.getDeclaringClass().getClassLoader()))
                  .filter(context -> context != null)
                  .findFirst()
                  .orElse(null));
    }
    if (own == null) {
      throw new IllegalStateException(
          "this code belongs to no kernel: let a kernel or urbi-launch-java load it,"
              + " or give it a UContext");
    }
    return own;
  }
}
