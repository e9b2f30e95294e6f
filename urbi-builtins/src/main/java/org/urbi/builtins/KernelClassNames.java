package org.urbi.builtins;

/** The names of the kernel's classes, on which this module does not depend. */
final class KernelClassNames {
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

  private KernelClassNames() {}
}
