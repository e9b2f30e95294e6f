package org.urbi.kernel.observe;

import java.util.List;

/**
 * A job as it is.
 *
 * @param number by which it is controlled
 * @param name as urbiscript shows it
 * @param starter the number of the job that was running when it was started, which may have ended
 *     since; 0 when there was none
 * @param lobby the name of the lobby for which it runs
 * @param waits what it waits for, in the words of the manual; {@code running} when it can run
 * @param frozen whether it is suspended
 * @param place where in the source it is; empty when nobody knows
 * @param code the beginning of that line of the source
 * @param tags the numbers of the tags under which it runs, outermost first
 * @param share of the kernel's time that it took since it was last looked at, in thousandths
 */
public record JobRow(
    long number,
    String name,
    long starter,
    String lobby,
    String waits,
    boolean frozen,
    String place,
    String code,
    List<Long> tags,
    int share) {}
