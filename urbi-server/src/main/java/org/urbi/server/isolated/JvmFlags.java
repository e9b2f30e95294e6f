package org.urbi.server.isolated;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.regex.Pattern;

/**
 * What the JVM of a module's process has in common with that of the kernel: what urbi's launcher
 * gives to every JVM (scripts/flags.sh), with the garbage collector that the user has chosen. Sizes
 * of memory and debuggers are the kernel's own.
 */
final class JvmFlags {
  private static final Pattern COMMON =
      Pattern.compile(
          "--add-opens=.*|--enable-native-access=.*|-Xlog:disable|-Djdk\\.trackAllThreads=.*"
              + "|-XX:\\+Use(Serial|Parallel|G1|Z|Shenandoah|Epsilon)GC"
              + "|-XX:[+-](UseCompactObjectHeaders|UsePerfData|ProfileExceptionHandlers"
              + "|UnlockExperimentalVMOptions)");

  private JvmFlags() {}

  /** Whether this JVM has a start-up cache, which whoever started it found to fit the jars. */
  static boolean haveCache() {
    return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .anyMatch(flag -> flag.startsWith("-XX:AOTCache="));
  }

  /** The flags of this JVM that processes which it starts get, too. */
  static List<String> inherited() {
    return common(ManagementFactory.getRuntimeMXBean().getInputArguments());
  }

  /** Of all flags that a JVM was started with, those for children. */
  static List<String> common(List<String> flags) {
    return flags.stream().filter(flag -> COMMON.matcher(flag).matches()).toList();
  }
}
