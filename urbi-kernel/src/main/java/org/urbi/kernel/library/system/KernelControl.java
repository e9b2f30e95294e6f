package org.urbi.kernel.library.system;

import java.nio.file.Path;
import java.util.List;
import org.urbi.kernel.library.code.LoadedFiles;
import org.urbi.kernel.library.lobby.LogLevel;
import org.urbi.kernel.library.machine.Environment;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.uobject.PluggedContext;

/** What the library needs of the kernel around it. */
public interface KernelControl {
  /** Ends the kernel after this tick, with that exit status. */
  void requestShutdown(int status);

  /** Where source files are looked for, first to last. */
  List<Path> searchPath();

  /** The folder of the library's own source files; null when there is none. */
  Path library();

  /** Where modules with UObjects are looked for, first to last. */
  List<Path> moduleSearchPath();

  /** The UObjects of the kernel. */
  PluggedContext uobjects();

  /** The lobbies of all connections, and those made by programs. */
  List<UrbiLobby> lobbies();

  /** A lobby without a connection of its own: its output goes where that of another one does. */
  UrbiLobby createLobby(UrbiLobby creator);

  /** The path under which the server was called. */
  String programName();

  /** The arguments of the user's script. */
  List<String> arguments();

  /** The source files that were loaded. */
  LoadedFiles loadedFiles();

  /** The variables of the environment. */
  Environment environment();

  /** The rest of the machine. */
  Outside outside();

  /** Ends the whole program at once, with that exit status; nothing is closed. */
  void halt(int status);

  /** Ends the kernel and starts another one in its place; false when nobody would do that. */
  boolean requestReboot();

  /** How much of the log is shown. */
  LogLevel logLevel();

  /** Shows a line of the log to the administrator. */
  void log(String line);

  /** The kernel in which code runs. */
  static KernelControl of(Frame frame) {
    return (KernelControl) frame.interpreter().host();
  }
}
