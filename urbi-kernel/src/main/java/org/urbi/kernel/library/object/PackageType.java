package org.urbi.kernel.library.object;

import org.urbi.builtins.Need;
import org.urbi.builtins.UrbiType;

/** The root of the packages: {@code package a.b {…}} makes {@code 'package'.a.b}. */
@UrbiType(value = "package", doc = "The root of the packages.", needs = Need.NOTHING)
final class PackageType {
  private PackageType() {}
}
