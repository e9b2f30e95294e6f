package org.urbi.kernel.lobby;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** The channel of warnings (manual, "Channel", {@code warning}). */
public final class WarningChannel {
  public static final String NAME = "warning";

  private WarningChannel() {}

  /** Whether nothing is sent on it: {@code warning.enabled = false}. */
  public static boolean isOff(World world) {
    UrbiObject channel = world.prototype("Channel").lookup(world.symbol(NAME));
    return channel != null && channel.lookup(world.symbol("enabled")) == world.values().falseObject;
  }
}
