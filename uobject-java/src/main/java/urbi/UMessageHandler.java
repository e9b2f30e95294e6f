package urbi;

/** Takes the messages of a client's server. */
@FunctionalInterface
public interface UMessageHandler {
  /** Takes a message, and says whether it wants more. */
  UCallbackAction onMessage(UMessage message);
}
