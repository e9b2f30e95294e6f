package org.urbi.kernel.node;

import java.util.function.Supplier;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobGroup;
import org.urbi.kernel.object.UrbiObject;

/**
 * The jobs that a piece of code starts, and waits for before it is over. Whatever leaves one of
 * them ({@code return}, {@code break}, an exception) leaves the code which started it.
 */
final class Background implements AutoCloseable {
  private final JobGroup group;

  Background(Job parent) {
    group = new JobGroup(parent);
  }

  /** Starts a statement, with a copy of the variables except for those in cells. */
  void start(Frame frame, Node statement) {
    frame.job.checkInterrupted();
    ForkedCode branch = branch(statement);
    branch.runWith(frame.fork(group.start(branch), true));
  }

  /**
   * Starts a statement with its own value of a loop variable, as if called at that site.
   *
   * @param from the innermost call shown in backtraces
   * @param by the frame of the call around that
   */
  void start(
      Frame frame,
      Node statement,
      Variables.Place variable,
      UrbiObject value,
      CallSite from,
      Frame by) {
    frame.job.checkInterrupted();
    ForkedCode branch = branch(statement);
    Frame forked = frame.forkThrough(group.start(branch), from, by);
    variable.declare(forked, value);
    branch.runWith(forked);
  }

  /** A statement in a job of its own. */
  private static ForkedCode branch(Node statement) {
    return new ForkedCode(frame -> {
      UrbiObject value = statement.execute(frame);
      if (frame.completion != null) {
        switch (frame.completion) {
          case RETURN -> throw new NonLocalExit.Return(frame.activation, value);
          case BREAK -> throw new NonLocalExit.Break();
          case CONTINUE -> {}
        }
      }
    });
  }

  /** Executes the code that runs beside the background jobs. */
  UrbiObject guard(Supplier<UrbiObject> code) {
    try {
      return code.get();
    } catch (RuntimeException e) {
      throw group.translate(e);
    }
  }

  /** Waits for all. */
  void join() {
    try {
      group.join();
    } catch (RuntimeException e) {
      throw group.translate(e);
    }
  }

  @Override
  public void close() {
    group.leave();
  }
}
