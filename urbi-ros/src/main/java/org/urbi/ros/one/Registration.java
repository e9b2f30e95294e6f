package org.urbi.ros.one;

import java.util.concurrent.CompletableFuture;

/** Something that the master is to know of: it is told again whenever there is another master. */
abstract class Registration {
  private final String key;

  /** Whether this master knows of it; used by the thread of {@link MasterWatch} only. */
  private boolean known;

  /**
   * @param key what it is, among all of this node
   */
  Registration(String key) {
    this.key = key;
  }

  String key() {
    return key;
  }

  /** Tells a master. */
  abstract CompletableFuture<?> register(Api master);

  /** Tells it that there is no such thing any more. */
  abstract CompletableFuture<?> unregister(Api master);

  boolean isKnown() {
    return known;
  }

  void setKnown(boolean yes) {
    known = yes;
  }
}
