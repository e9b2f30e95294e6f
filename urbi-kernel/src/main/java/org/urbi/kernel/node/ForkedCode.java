package org.urbi.kernel.node;

import java.util.function.Consumer;
import org.urbi.kernel.job.Job;

/** What a job does with a copy of the variables of the code that has started it. */
public final class ForkedCode implements Job.Body {
  private final Consumer<Frame> code;

  // The copy is made for the job, so it is not there before; and the job does not run before it is.
  @SuppressWarnings("NullAway.Init")
  private Frame frame;

  /**
   * @param code given the copy
   */
  public ForkedCode(Consumer<Frame> code) {
    this.code = code;
  }

  /** Says which copy it is, when the job has been started. */
  public void runWith(Frame forked) {
    frame = forked;
  }

  @Override
  public void run(Job job) {
    code.accept(frame);
  }
}
