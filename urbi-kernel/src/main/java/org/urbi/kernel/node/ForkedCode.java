package org.urbi.kernel.node;

import java.util.function.Consumer;
import org.urbi.kernel.job.Job;

/** The body of a job that runs with a copy of the variables of the code that started it. */
public final class ForkedCode implements Job.Body {
  private final Consumer<Frame> code;

  // Set after the job was created, because the copy refers to the job, and before the job runs.
  @SuppressWarnings("NullAway.Init")
  private Frame frame;

  /**
   * @param code called with the copy
   */
  public ForkedCode(Consumer<Frame> code) {
    this.code = code;
  }

  /** Sets the copy, once the job has been created. */
  public void runWith(Frame forked) {
    frame = forked;
  }

  @Override
  public void run(Job job) {
    code.accept(frame);
  }
}
