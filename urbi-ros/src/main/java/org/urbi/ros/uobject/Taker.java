package org.urbi.ros.uobject;

import urbi.UObject;
import urbi.UValue;

/** An object for which something comes from the network. */
interface Taker {
  /** The function of {@code Ros} by which the kernel comes to take it. */
  String TAKE = "__take";

  /** Has urbiscript see what has come; called by the kernel. */
  void take();

  /**
   * Has the kernel call {@link #take} of an object, soon; does not wait. The call takes a way that
   * is always there: the object may be destroyed by then.
   */
  static void soon(UObject taker) {
    taker.getUContext().call("Ros", TAKE, new UValue(taker.get__name()));
  }
}
