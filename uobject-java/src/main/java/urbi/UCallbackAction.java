package urbi;

/** What is to become of a callback that has been called. */
public enum UCallbackAction {
  /** It is called again for the next message. */
  URBI_CONTINUE,
  /** It is never called again. */
  URBI_REMOVE
}
