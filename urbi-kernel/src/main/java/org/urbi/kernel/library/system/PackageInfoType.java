package org.urbi.kernel.library.system;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Need;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/**
 * The Urbi SDK whose language and library these are (manual, "System.PackageInfo"); {@code
 * lobby.copyright} tells of this software.
 */
@UrbiType(
    value = "System.PackageInfo",
    doc = "The Urbi SDK, whose language this is.",
    needs = Need.NOTHING)
final class PackageInfoType {
  private PackageInfoType() {}

  @Builtin(doc = "Who holds the copyright of the Urbi SDK, which defined the language.")
  static String copyrightHolder(UrbiObject self) {
    return "Gostai S.A.S.";
  }

  @Builtin(doc = "The years of that copyright.")
  static String copyrightYears(UrbiObject self) {
    return "2004-2012";
  }
}
