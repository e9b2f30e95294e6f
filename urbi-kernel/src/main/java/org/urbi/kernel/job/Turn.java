package org.urbi.kernel.job;

/**
 * A turn that a job had: from when it could go on until it let others run.
 *
 * @param job the number of the job
 * @param waker the number of the job that has made it runnable: itself after a {@code ;}; 0 for the
 *     time, or something outside
 * @param begin of the machine's time, in nanoseconds
 * @param end of the machine's time, in nanoseconds
 * @param before what it had waited for
 * @param ended whether it was its last turn
 */
public record Turn(long job, long waker, long begin, long end, Wait before, boolean ended) {}
