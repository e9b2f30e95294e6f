package org.urbi.kernel.library.object;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** The root of the packages: {@code package a.b {…}} makes {@code 'package'.a.b}. */
@UrbiType(value = "package", doc = "The root of the packages.", needs = Permission.NOTHING)
final class PackageType {
  private PackageType() {}
}
