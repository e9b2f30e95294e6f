package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;
import org.urbi.kernel.node.Frame;

/** Where a job stands between urbiscript and the Java code of UObjects, which call each other. */
final class JavaCallState {
  private static final JobLocal<JavaCallState> OF_JOB = new JobLocal<>();

  /** The activation that has called Java code, while that code runs; else null. */
  @Nullable Frame caller;

  /** What unwinds the job although Java code may have caught it; usually null. */
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
