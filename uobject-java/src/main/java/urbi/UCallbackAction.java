package urbi;

/** What to do with a callback after its call. */
public enum UCallbackAction {
  /** It is called again for the next message. */
  URBI_CONTINUE,
  /** It is never called again. */
  URBI_REMOVE
}
