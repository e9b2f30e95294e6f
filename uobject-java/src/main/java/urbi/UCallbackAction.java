package urbi;

/** What to do with a callback after its call. */
public enum UCallbackAction {
  /** The callback is called again for the next message. */
  URBI_CONTINUE,
  /** The callback is never called again. */
  URBI_REMOVE
}
