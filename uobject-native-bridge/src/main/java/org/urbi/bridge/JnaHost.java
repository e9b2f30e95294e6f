package org.urbi.bridge;

import com.sun.jna.Callback;

/** The function of this side that libraries call, as JNA sees it. */
public interface JnaHost extends Callback {
  /** Carries out what the {@link Exchange} at an address asks for. */
  long request(long exchange);
}
