package org.urbi.kernel.uobject;

/** An object that may go without anybody having destroyed it. */
public interface Perishable {
  /** Why it has gone, for those who call its functions all the same; null for no special reason. */
  String whyGone();
}
