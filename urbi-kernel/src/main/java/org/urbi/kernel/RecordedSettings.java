package org.urbi.kernel;

import java.nio.file.Path;
import java.util.List;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.outside.Confinement;

/** Converts the configuration of a kernel to and from the first entry of a recording. */
final class RecordedSettings {
  private RecordedSettings() {}

  /** The settings of a kernel that is to be recorded. */
  static Entry.RunStarted of(KernelBuilder builder, double startTime) {
    return new Entry.RunStarted(
        String.valueOf(Kernel.class.getPackage().getImplementationVersion()),
        builder.virtualTime,
        startTime,
        builder.seed,
        builder.stackSize,
        builder.searchPath.stream().map(Path::toString).toList(),
        builder.library == null ? null : builder.library.toString(),
        builder.moduleSearchPath.stream().map(Path::toString).toList(),
        builder.programName,
        builder.arguments,
        builder.logLevel.name(),
        builder.confinement.isConfined() ? builder.confinement.workingDirectory().toString() : null,
        builder.users.allowsFiles() ? builder.users.workingDirectory().toString() : null,
        builder.confinement.workingDirectory().toString(),
        builder.onReboot != null);
  }

  /** Configures a kernel as the recorded one was. */
  static void restore(Entry.RunStarted begun, KernelBuilder builder) {
    builder.seed = begun.seed();
    builder.stackSize = begun.stackSize();
    builder.searchPath = paths(begun.searchPath());
    builder.library = begun.library() == null ? null : Path.of(begun.library());
    builder.moduleSearchPath = paths(begun.modulePath());
    builder.commandLine(begun.programName(), begun.arguments());
    builder.logLevel = LogLevel.of(begun.logLevel());
    builder.confinement = Confinement.recorded(begun.confinedTo(), begun.workingDirectory());
    builder.users =
        begun.userDirectory() == null
            ? Confinement.total()
            : Confinement.recorded(begun.userDirectory(), begun.userDirectory());
    builder.onReboot = begun.reboots() ? () -> {} : null;
  }

  private static List<Path> paths(List<String> names) {
    return names.stream().map(Path::of).toList();
  }
}
