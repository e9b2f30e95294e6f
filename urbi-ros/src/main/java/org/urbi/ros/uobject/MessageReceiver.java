package org.urbi.ros.uobject;

import urbi.UObject;
import urbi.UValue;

/** An object for which messages come from the network. */
interface MessageReceiver {
  /** The function of {@code Ros} that the kernel calls to have them taken. */
  String TAKE = "__take";

  /** Shows urbiscript what has come; called by the kernel. */
  void take();

  /**
   * Has the kernel call {@link #take} of an object, soon; does not wait. The call takes a way that
   * is always there: the object may be destroyed by then.
   */
  static void soon(UObject taker) {
    taker.getUContext().call("Ros", TAKE, new UValue(taker.get__name()));
  }
}
