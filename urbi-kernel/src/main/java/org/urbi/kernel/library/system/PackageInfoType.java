package org.urbi.kernel.library.system;

import java.util.Map;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/**
 * The Urbi SDK whose language and library these are (manual, "System.PackageInfo"); {@code
 * lobby.copyright} tells of this software.
 */
@UrbiType(
    value = "System.PackageInfo",
    doc = "The Urbi SDK, whose language this is.",
    needs = Permission.NOTHING)
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

  @Builtin(doc = "The version of the Urbi SDK whose language this is: System.version.")
  static String version(UrbiObject self) {
    return Dialect.VERSION;
  }

  @Builtin(doc = "The first number of that version.")
  static double major(UrbiObject self) {
    return part(0);
  }

  @Builtin(doc = "The second number of that version.")
  static double minor(UrbiObject self) {
    return part(1);
  }

  @Builtin(doc = "The third number of that version.")
  static double subMinor(UrbiObject self) {
    return part(2);
  }

  @Builtin(doc = "How many changes there were since that version: none.")
  static double patch(UrbiObject self) {
    return 0;
  }

  private static double part(int index) {
    return Integer.parseInt(Dialect.VERSION.split("\\.")[index]);
  }

  @Builtin(doc = "The name and the version, on one line.")
  static String banner(UrbiObject self) {
    return "Urbi SDK version " + Dialect.VERSION;
  }

  @Builtin(doc = "Who holds the copyright, and since when, on one line.")
  static String copyright(UrbiObject self) {
    return "Copyright (C) " + copyrightYears(self) + " " + copyrightHolder(self);
  }

  @Builtin(doc = "The packages of which the Urbi SDK consists, by their names: itself.")
  static UrbiObject components(Frame frame, UrbiObject self) {
    Values values = frame.interpreter().values();
    return values.dictionary(Map.of(DictionaryKey.of(frame, values.string("Urbi SDK")), self));
  }
}
