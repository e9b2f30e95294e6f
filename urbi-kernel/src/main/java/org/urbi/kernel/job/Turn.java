package org.urbi.kernel.job;

import java.util.List;

/**
 * A turn that a job had: from when it could go on until it let others run.
 *
 * @param job the number of the job
 * @param wakers the number of the job that has made it runnable, itself after a {@code ;}, or that
 *     has started it; then that of the one that had started that job, and so on, a few in all:
 *     those first may have ended. Empty for the time, or something outside
 * @param begin of the machine's time, in nanoseconds
 * @param end of the machine's time, in nanoseconds
 * @param before what it had waited for
 * @param ended whether it was its last turn
 */
public record Turn(long job, List<Long> wakers, long begin, long end, Wait before, boolean ended) {}
