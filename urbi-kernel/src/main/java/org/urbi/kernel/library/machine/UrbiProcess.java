package org.urbi.kernel.library.machine;

import java.util.List;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ChildProcess;

/** A program of the machine, to be run once (manual, "Process"). */
final class UrbiProcess extends UrbiObject {
  private List<String> command = List.of();
  private boolean started;
  private ChildProcess running;
  private UrbiObject stdin;
  private UrbiObject stdout;
  private UrbiObject stderr;

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

  /** Whether somebody has begun to start it. */
  boolean isStarted() {
    return started;
  }

  void setStarted(boolean value) {
    started = value;
  }

  /** The running program, or what is left of it; null before. */
  ChildProcess running() {
    return running;
  }

  void start(ChildProcess program, UrbiObject in, UrbiObject out, UrbiObject err) {
    running = program;
    stdin = in;
    stdout = out;
    stderr = err;
  }

  UrbiObject stdin() {
    return stdin;
  }

  UrbiObject stdout() {
    return stdout;
  }

  UrbiObject stderr() {
    return stderr;
  }

  @Override
  public UrbiObject cloned() {
    UrbiProcess copy = new UrbiProcess(cloneShape());
    copy.command = command;
    return copy;
  }
}
