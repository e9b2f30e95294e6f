package org.urbi.kernel.library.system;

import java.util.Locale;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.Outside;

/** The machine on which the server runs (manual, "System.Platform"). */
@UrbiType(
    value = "System.Platform",
    doc = "The machine on which the server runs.",
    needs = Permission.NOTHING)
final class PlatformType {
  private final Outside outside;

  PlatformType(Outside outside) {
    this.outside = outside;
  }

  private String os() {
    return outside.property("os.name").toLowerCase(Locale.ROOT);
  }

  private boolean isMac() {
    return os().startsWith("mac");
  }

  @Builtin(doc = "The type of the machine: CPU, vendor, system.")
  String host(UrbiObject self) {
    return hostCpu(self) + "-" + hostVendor(self) + "-" + hostOs(self);
  }

  @Builtin(doc = "A name for this type of machine; empty.")
  static String hostAlias(UrbiObject self) {
    return "";
  }

  @Builtin(doc = "The type of its CPU.")
  String hostCpu(UrbiObject self) {
    String arch = outside.property("os.arch");
    return switch (arch) {
      case "amd64" -> "x86_64";
      case "x86" -> "i386";
      default -> arch;
    };
  }

  @Builtin(doc = "The type of its operating system.")
  String hostOs(UrbiObject self) {
    if (isWindows(self)) {
      return "mingw32";
    }
    return isMac()
        ? "darwin" + outside.property("os.version")
        : os().equals("linux") ? "linux-gnu" : os().replace(" ", "");
  }

  @Builtin(doc = "The vendor of the machine: apple, pc or unknown.")
  String hostVendor(UrbiObject self) {
    return isMac() ? "apple" : isWindows(self) ? "pc" : "unknown";
  }

  @Builtin(doc = "Whether it is Windows.")
  boolean isWindows(UrbiObject self) {
    return os().startsWith("windows");
  }

  @Builtin(doc = "WIN32 under Windows, otherwise POSIX.")
  String kind(UrbiObject self) {
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
