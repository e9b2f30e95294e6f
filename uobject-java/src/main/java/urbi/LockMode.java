package urbi;

/** Which threaded calls exclude one another (manual, "Asynchronous binding"). */
public enum LockMode {
  /** None do. */
  LOCK_NONE,

  /** Calls of the same function; for notifications, those about the same variable. */
  LOCK_FUNCTION,

  /** Calls of any function of the same object. */
  LOCK_INSTANCE,

  /** Calls of any function of any object of the same class. */
  LOCK_CLASS,

  /** Calls of any function of the same module: a jar, or a shared library. */
  LOCK_MODULE
}
