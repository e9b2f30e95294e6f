package org.urbi.kernel.library.machine;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.InputStreamType;
import org.urbi.kernel.library.file.OutputStreamType;
import org.urbi.kernel.library.file.UrbiInputStream;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.ChildProcess;
import org.urbi.kernel.outside.Outside;

/** Programs of the machine (manual, "Process"). */
@UrbiType(
    value = "Process",
    doc = "A program that the operating system runs.",
    needs = Permission.OWNER)
public final class ProcessType {
  private final Outside outside;
  private final Environment environment;

  ProcessType(Outside outside, Environment environment) {
    this.outside = outside;
    this.environment = environment;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiProcess(world.values().object.cloneShape());
  }

  @Builtin(doc = "Makes it the program of that name with these arguments; it does not run yet.")
  static UrbiProcess init(
      Frame frame, CallSite site, UrbiProcess self, UrbiObject name, UrbiList arguments) {
    FileAccess.checkNotPrototype(frame, site, self, "Process");
    List<String> command = new ArrayList<>();
    command.add(
        Utf8Text.toJava(
            name instanceof UrbiPath path ? path.text() : Arguments.text(frame, site, 1, name)));
    for (UrbiObject argument : List.copyOf(arguments.elements())) {
      command.add(Utf8Text.toJava(frame.interpreter().asString(frame, argument)));
    }
    if (command.getFirst().isEmpty() || command.stream().anyMatch(w -> w.indexOf('\0') >= 0)) {
      throw frame.error(site, Problem.INVALID_COMMAND);
    }
    self.setCommand(List.copyOf(command));
    return self;
  }

  @Builtin(doc = "The process itself.")
  static UrbiProcess asProcess(UrbiProcess self) {
    return self;
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "Process, and the name of the program.")
  static String asString(UrbiProcess self) {
    return self.command().isEmpty() ? "Process" : "Process " + name(self);
  }

  @Builtin(doc = "The name of the program, without its directory.")
  static String name(UrbiProcess self) {
    if (self.command().isEmpty()) {
      return "Process";
    }
    String program = self.command().getFirst();
    return Utf8Text.toUrbi(program.substring(program.lastIndexOf('/') + 1));
  }

  // ------------------------------------------------------------------ running

  @Builtin(doc = "Starts the program; once.")
  void run(Frame frame, CallSite site, UrbiProcess self) {
    if (self.command().isEmpty()) {
      throw frame.error(site, Problem.PROCESS_WITHOUT_PROGRAM);
    }
    if (self.isStarted()) {
      throw frame.error(site, Problem.PROCESS_RUN);
    }
    self.setStarted(true);
    try {
      ChildProcess program =
          ChildProcess.start(
              outside,
              frame.job(),
              self.command(),
              FileAccess.anyPath(frame).working().path(),
              environment.variables());
      self.start(
          new UrbiProcess.Running(
              program,
              OutputStreamType.stream(frame, program.in()),
              InputStreamType.stream(frame, program.out()),
              InputStreamType.stream(frame, program.err())));
    } catch (IOException e) {
      self.setStarted(false);
      throw cannotRun(frame, site, self.command().getFirst(), e);
    }
  }

  /** Why a program cannot be run, without what the JDK has to say of itself. */
  public static UrbiException cannotRun(
      Frame frame, CallSite site, String program, IOException failure) {
    return frame.error(
        site,
        Problem.CANNOT_RUN,
        Utf8Text.toUrbi(program),
        FileAccess.lowered(FileAccess.inParentheses(failure)));
  }

  @Builtin(doc = "Runs the program, and gives what it writes to that function, line by line.")
  void runTo(Frame frame, CallSite site, UrbiProcess self, UrbiObject target) {
    run(frame, site, self);
    UrbiInputStream out = running(frame, site, self).stdout();
    UrbiObject end = frame.interpreter().values().voidObject;
    UrbiObject line = InputStreamType.getLine(frame, site, out);
    while (line != end) {
      frame.interpreter().call(frame, site, target, self, line);
      line = InputStreamType.getLine(frame, site, out);
    }
    join(frame, site, self);
  }

  private static UrbiProcess.Running running(Frame frame, CallSite site, UrbiProcess self) {
    UrbiProcess.Running running = self.running();
    if (running == null) {
      throw frame.error(site, Problem.PROCESS_NOT_RUN);
    }
    return running;
  }

  @Builtin(doc = "Waits until the program has ended.")
  static void join(Frame frame, CallSite site, UrbiProcess self) {
    running(frame, site, self).program().join(frame.job());
  }

  @Builtin(
      doc =
          "Ends the program, unless it has ended, and the programs that it has begun; they are not"
              + " asked.")
  static void kill(Frame frame, CallSite site, UrbiProcess self) {
    ChildProcess program = running(frame, site, self).program();
    if (program.isRunning()) {
      program.kill();
    }
  }

  @Builtin(doc = "Whether the program has ended.")
  static boolean done(UrbiProcess self) {
    return self.running() != null && !self.running().program().isRunning();
  }

  @Builtin(doc = "Whether the program runs, has run or not, and how it has ended.")
  static UrbiObject status(Frame frame, UrbiProcess self) {
    UrbiProcess.Running running = self.running();
    return ProcessStatusType.of(frame, running == null ? null : running.program());
  }

  // ------------------------------------------------------------------ its streams

  @Builtin(doc = "The standard input of the program, to write to.")
  static UrbiObject stdin(Frame frame, CallSite site, UrbiProcess self) {
    return running(frame, site, self).stdin();
  }

  @Builtin(doc = "The standard output of the program, to read from.")
  static UrbiInputStream stdout(Frame frame, CallSite site, UrbiProcess self) {
    return running(frame, site, self).stdout();
  }

  @Builtin(doc = "The standard error of the program, to read from.")
  static UrbiInputStream stderr(Frame frame, CallSite site, UrbiProcess self) {
    return running(frame, site, self).stderr();
  }
}
