package org.urbi.kernel.lobby;

import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;

/** The environment of one connection (manual, "Lobby"): {@code this} at its top level. */
public final class UrbiLobby extends UrbiObject implements SlotUpdate.Redefinable {
  private final UrbiTag connectionTag;
  private Output output;
  private Shell shell;

  /**
   * @param connectionTag labels all the code executed for this lobby
   */
  public UrbiLobby(Shape shape, UrbiTag connectionTag) {
    super(shape);
    this.connectionTag = connectionTag;
  }

  /** The tag of all the code that is executed for this lobby. */
  public UrbiTag connectionTag() {
    return connectionTag;
  }

  public void attach(Output to) {
    output = to;
  }

  public void attach(Shell of) {
    shell = of;
  }

  /** Where its output goes; null for the prototype. */
  public Output output() {
    return output;
  }

  /** Executes its input; null when it has none. */
  public Shell shell() {
    return shell;
  }
}
