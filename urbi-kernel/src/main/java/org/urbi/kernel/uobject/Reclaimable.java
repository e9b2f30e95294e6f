package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;

/** An object that may go without anybody having destroyed it. */
public interface Reclaimable {
  /** Why it has gone, for those who call its functions all the same; null for no special reason. */
  @Nullable String reclaimReason();
}
