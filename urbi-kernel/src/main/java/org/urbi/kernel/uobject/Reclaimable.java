package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;

/**
 * An object that may end without having been destroyed, for instance because its process has
 * disconnected.
 */
public interface Reclaimable {
  /**
   * The reason why it has ended, shown to code that still calls its functions; null for no special
   * reason.
   */
  @Nullable String reclaimReason();
}
