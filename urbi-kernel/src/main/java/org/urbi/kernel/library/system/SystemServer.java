package org.urbi.kernel.library.system;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Properties;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.date.UrbiDate;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.machine.Environment;
import org.urbi.kernel.library.machine.ProcessType;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.ChildProcess;
import org.urbi.kernel.outside.Network;
import org.urbi.kernel.outside.Outside;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.print.Printer;

/** The server as a program among others (manual, "System"). */
@UrbiTypePart(value = "System", needs = Permission.NOTHING)
final class SystemServer {
  private static final int STATUS_SHIFT = 8;

  private final CommandLine commandLine;
  private final ShutdownControl kernelEnd;
  private final Lobbies lobbies;
  private final Outside outside;
  private final Environment environment;

  SystemServer(
      CommandLine commandLine,
      ShutdownControl kernelEnd,
      Lobbies lobbies,
      Outside outside,
      Environment environment) {
    this.commandLine = commandLine;
    this.kernelEnd = kernelEnd;
    this.lobbies = lobbies;
    this.outside = outside;
    this.environment = environment;
  }

  // ------------------------------------------------------------------ what it is

  @Builtin(doc = "The arguments of the user's script.")
  List<UrbiString> arguments(Frame frame, UrbiObject self) {
    return commandLine.arguments().stream()
        .map(text -> frame.interpreter().values().string(Utf8Text.toUrbi(text)))
        .toList();
  }

  @Builtin(doc = "The path under which the server was called.")
  String programName(Frame frame, UrbiObject self) {
    return Utf8Text.toUrbi(commandLine.programName());
  }

  @Builtin(doc = "The version of the Urbi SDK whose language this is: numbers with periods.")
  static String version(UrbiObject self) {
    return Dialect.VERSION;
  }

  @Builtin(doc = "The version of this implementation: numbers separated by periods.")
  static String implementationVersion(UrbiObject self) {
    return Version.NUMBER;
  }

  /** The version, read when somebody asks for it. */
  private static final class Version {
    static final String NUMBER = number();

    private static String number() {
      Properties properties = new Properties();
      try (InputStream in = SystemServer.class.getResourceAsStream("version.properties")) {
        properties.load(in);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      // A build that is not a release yet has a suffix.
      return properties.getProperty("version").replaceFirst("-.*", "");
    }
  }

  @Builtin(doc = "The name of this machine.")
  String hostName(Frame frame, UrbiObject self) {
    try {
      return Utf8Text.toUrbi(Network.localHostName(outside, frame.job()));
    } catch (IOException e) {
      return "localhost";
    }
  }

  @Builtin(doc = "The date at which System.time was 0.")
  static UrbiObject timeReference(Frame frame, UrbiObject self) {
    UrbiObject prototype = frame.interpreter().world().prototype("Date");
    double seconds = frame.job().scheduler().clock().startTime();
    return new UrbiDate(prototype.cloneShape(), Math.round(seconds * 1e6));
  }

  // ------------------------------------------------------------------ its end

  @Builtin(
      doc = "Ends the server at once, with that exit status; nothing is closed.",
      needs = Permission.OWNER)
  void _exit(Frame frame, UrbiObject self, int status) {
    // Output sent before is still delivered.
    for (UrbiLobby lobby : lobbies.all()) {
      lobby.output().flush();
    }
    kernelEnd.halt(status);
    frame.job().waitForWake();
  }

  @Builtin(doc = "Starts the server anew.", needs = Permission.OWNER)
  void reboot(Frame frame, CallSite site, UrbiObject self) {
    if (!kernelEnd.requestReboot()) {
      throw frame.error(site, Problem.NOT_POSSIBLE);
    }
    frame.job().waitForWake();
  }

  @Builtin(doc = "Ends the code that runs for each connection.", needs = Permission.OWNER)
  void stopall(Frame frame, UrbiObject self) {
    Job here = frame.job();
    for (UrbiLobby lobby : lobbies.all()) {
      lobby.connectionTag().state().stop(here.scheduler(), frame.interpreter().values().voidObject);
    }
    here.checkInjected();
  }

  // ------------------------------------------------------------------ other programs

  @Builtin(
      doc = "Has the shell of the machine run a command, and returns its exit status.",
      needs = Permission.OWNER)
  double system(Frame frame, CallSite site, UrbiObject self, String command) {
    if (command.indexOf('\0') >= 0) {
      throw frame.error(site, Problem.INVALID_COMMAND);
    }
    try {
      int status =
          ChildProcess.run(
              outside,
              frame.job(),
              List.of("/bin/sh", "-c", Utf8Text.toJava(command)),
              FileAccess.anyPath(frame).working().path(),
              environment.variables());
      int signal = ChildProcess.signal(status);
      return signal != 0 ? signal : status << STATUS_SHIFT;
    } catch (IOException e) {
      throw ProcessType.cannotRun(frame, site, "/bin/sh", e);
    }
  }

  // ------------------------------------------------------------------ assertions

  @Builtin(
      value = "assert",
      lazy = true,
      min = 1,
      max = 1,
      doc = "Throws an error, which shows the expression, unless the expression is true.")
  static void assertTrue(Frame frame, CallSite site, UrbiObject self) {
    if (frame.interpreter().assertionsDisabled()) {
      return;
    }
    Node claim = site.argumentNodes()[0];
    if (!Truth.of(frame, claim.execute(frame))) {
      throw failed(frame, shown(frame, claim));
    }
  }

  private static RuntimeException failed(Frame frame, String claim) {
    return frame.interpreter().errors().of(Problem.ASSERTION_FAILED, claim).build();
  }

  /** Code as urbiscript shows it. */
  private static String shown(Frame frame, Node claim) {
    if (!claim.isWritten()) {
      return "?";
    }
    String text = claim.span().text();
    ParseResult parsed = UrbiParser.parse(text, null, frame.job()::checkInterrupted);
    return parsed.errors().isEmpty() ? Printer.print(parsed.sequence()) : text;
  }

  @Builtin(doc = "Throws an error unless an operator holds between two values; use assert.")
  static void assert_op(
      Frame frame, UrbiObject self, String operator, UrbiObject lhs, UrbiObject rhs) {
    if (!frame.interpreter().assertionsDisabled()
        && !Truth.of(frame, frame.interpreter().send(frame, lhs, operator, rhs))) {
      throw failed(
          frame,
          frame.interpreter().asPrintable(frame, lhs)
              + " "
              + operator
              + " "
              + frame.interpreter().asPrintable(frame, rhs));
    }
  }
}
