package urbi;

/** The context's side of one {@link UEvent}. */
@FunctionalInterface
public interface UEmitter {
  /** Emits the event; does not wait for its handlers. */
  void emit(UValue... payload);
}
