package org.urbi.kernel.library.machine;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.library.file.UrbiInputStream;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ChildProcess;

/** A program of the machine, to be run once (manual, "Process"). */
final class UrbiProcess extends UrbiObject {
  private List<String> command = List.of();
  private boolean started;
  private @Nullable Running running;

  /** A program that was started, and its streams. */
  record Running(
      ChildProcess program, UrbiObject stdin, UrbiInputStream stdout, UrbiInputStream stderr) {}

  UrbiProcess(Shape shape) {
    super(shape);
  }

  /** The program and its arguments, as Java strings. */
  List<String> command() {
    return command;
  }

  void setCommand(List<String> other) {
    command = other;
  }

  /** Whether its start has begun. */
  boolean isStarted() {
    return started;
  }

  void setStarted(boolean value) {
    started = value;
  }

  /** The program, also when it has ended; null before it is started. */
  @Nullable Running running() {
    return running;
  }

  void start(Running program) {
    running = program;
  }

  @Override
  public UrbiObject cloned() {
    UrbiProcess copy = new UrbiProcess(cloneShape());
    copy.command = command;
    return copy;
  }
}
