package org.urbi.kernel.library.system;

/** Which urbiscript this is; the software has a version of its own. */
public final class Dialect {
  /** The version of Urbi whose urbiscript is spoken, and whose protocol, for clients. */
  public static final String VERSION = "2.7.5";

  private Dialect() {}
}
