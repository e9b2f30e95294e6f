package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** The state of a job in nested calls between urbiscript and the Java code of UObjects. */
final class JavaCallState {
  private static final JobLocal<JavaCallState> OF_JOB = new JobLocal<>();

  /** The activation that has called the running Java code; null if none runs. */
  @Nullable Frame caller;

  /** The urbiscript object whose Java code that is; null if that is not known. */
  @Nullable UrbiObject self;

  /** The exception that unwinds the job, even if Java code has caught it; usually null. */
  @Nullable ControlFlowException unwinding;

  static JavaCallState of(Job job) {
    JavaCallState known = OF_JOB.get(job);
    if (known == null) {
      known = new JavaCallState();
      OF_JOB.set(job, known);
    }
    return known;
  }
}
