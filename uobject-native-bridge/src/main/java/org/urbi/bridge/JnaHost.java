package org.urbi.bridge;

import com.sun.jna.Callback;

/** The Java function that libraries call, as a JNA callback. */
public interface JnaHost extends Callback {
  /** Carries out what the {@link Exchange} at an address asks for. */
  long request(long exchange);
}
