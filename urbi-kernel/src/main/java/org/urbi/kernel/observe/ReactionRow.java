package org.urbi.kernel.observe;

import java.util.List;

/**
 * A reaction as it is: code that is executed each time something happens.
 *
 * @param number that it has for the one who looks
 * @param kind its word of the language: {@code at}, {@code whenever}, {@code every} …
 * @param lobby the name of the lobby for which it runs
 * @param place where in the source it is; empty when nobody knows
 * @param code the beginning of that line of the source
 * @param frozen whether a tag suspends it
 * @param tags the numbers of the tags under which it is, outermost first
 * @param times how often its code was executed
 * @param last when that was last, in nanoseconds since the start of the kernel; negative if never
 * @param event the number of the event that it waits for, or emits; 0 for none
 * @param read the names of what its condition has read when it was last evaluated
 */
public record ReactionRow(
    long number,
    String kind,
    String lobby,
    String place,
    String code,
    boolean frozen,
    List<Long> tags,
    long times,
    long last,
    long event,
    List<String> read) {}
