package org.urbi.builtins;

/** The kernel's classes, which this module knows by name only. */
final class Kernel {
  static final String OBJECT = "org.urbi.kernel.object.UrbiObject";
  static final String WORLD = "org.urbi.kernel.object.World";
  static final String FRAME = "org.urbi.kernel.node.Frame";
  static final String CALL_SITE = "org.urbi.kernel.node.CallSite";
  static final String TABLE = "org.urbi.kernel.builtin.BuiltinTable";
  static final String ARGUMENTS = "org.urbi.kernel.builtin.Arguments";

  static final String ROLE = "org.urbi.kernel.trust.Role";

  /** The package and the name of the generated list of all tables. */
  static final String INDEX_PACKAGE = "org.urbi.kernel.library";

  static final String INDEX_NAME = "LibraryTables";

  private Kernel() {}
}
