package urbi;

/**
 * A port of a {@link UObject} into which urbiscript leads variables: {@code camera.&val >>
 * tracker.&input} (manual, "Data-flow based programming: InputPort"). Bind it by {@link
 * UObject#UBindVar}, and be told of what comes by {@link UObject#UNotifyChange}.
 */
public class InputPort extends UVar {
  /** A port to be bound by {@link UObject#UBindVar}. */
  public InputPort() {}

  /** The port that is a slot of an object. */
  public InputPort(UObject owner, String slot) {
    super(owner, slot);
  }

  @Override
  USlot open(UContext context, String full) {
    return context.inputPort(full);
  }
}
