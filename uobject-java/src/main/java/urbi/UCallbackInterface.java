package urbi;

/** A callback as a class; {@link UMessageHandler} as a lambda does the same. */
public abstract class UCallbackInterface implements UMessageHandler {
  public UCallbackInterface() {}

  @Override
  public abstract UCallbackAction onMessage(UMessage message);
}
