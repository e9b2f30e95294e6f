package urbi;

/** Handles the messages that a client receives. */
@FunctionalInterface
public interface UMessageHandler {
  /** Takes a message, and says whether it wants more. */
  UCallbackAction onMessage(UMessage message);
}
