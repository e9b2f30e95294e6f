package org.urbi.kernel.library.system;

import java.util.Locale;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/** The machine on which the server runs (manual, "System.Platform"). */
@UrbiType(
    value = "System.Platform",
    doc = "The machine on which the server runs.",
    needs = Permission.NOTHING)
final class PlatformType {
  private PlatformType() {}

  private static String os() {
    return System.getProperty("os.name").toLowerCase(Locale.ROOT);
  }

  private static boolean isMac() {
    return os().startsWith("mac");
  }

  @Builtin(doc = "The type of the machine: CPU, vendor, system.")
  static String host(UrbiObject self) {
    return hostCpu(self) + "-" + hostVendor(self) + "-" + hostOs(self);
  }

  @Builtin(doc = "A name for this type of machine; empty.")
  static String hostAlias(UrbiObject self) {
    return "";
  }

  @Builtin(doc = "The type of its CPU.")
  static String hostCpu(UrbiObject self) {
    String arch = System.getProperty("os.arch");
    return switch (arch) {
      case "amd64" -> "x86_64";
      case "x86" -> "i386";
      default -> arch;
    };
  }

  @Builtin(doc = "The type of its operating system.")
  static String hostOs(UrbiObject self) {
    if (isWindows(self)) {
      return "mingw32";
    }
    return isMac()
        ? "darwin" + System.getProperty("os.version")
        : os().equals("linux") ? "linux-gnu" : os().replace(" ", "");
  }

  @Builtin(doc = "The vendor of the machine: apple, pc or unknown.")
  static String hostVendor(UrbiObject self) {
    return isMac() ? "apple" : isWindows(self) ? "pc" : "unknown";
  }

  @Builtin(doc = "Whether it is Windows.")
  static boolean isWindows(UrbiObject self) {
    return os().startsWith("windows");
  }

  @Builtin(doc = "WIN32 under Windows, otherwise POSIX.")
  static String kind(UrbiObject self) {
    return isWindows(self) ? "WIN32" : "POSIX";
  }

  @Builtin(doc = "How the server was built: release.")
  static String compilationMode(UrbiObject self) {
    return "release";
  }

  @Builtin(doc = "Whether the server was built to be debugged.")
  static boolean compilationModeDebug(UrbiObject self) {
    return false;
  }

  @Builtin(doc = "Whether the server was built to be small.")
  static boolean compilationModeSpace(UrbiObject self) {
    return false;
  }
}
