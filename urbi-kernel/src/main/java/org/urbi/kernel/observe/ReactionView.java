package org.urbi.kernel.observe;

import java.util.List;

/**
 * What has changed of the reactions and events since somebody looked last.
 *
 * @param anew whether it is the first that is told: what was told before, in an earlier time in
 *     which somebody wanted to see them, is to be forgotten
 * @param total how many reactions there are, as far as they contain the text that is wanted
 * @param reactions that are new, or have changed
 * @param gone the numbers of those that are no longer shown
 * @param eventTotal how many events are known
 * @param events that are new, or have changed
 * @param eventsGone the numbers of the events that are no longer shown
 */
public record ReactionView(
    boolean anew,
    int total,
    List<ReactionRow> reactions,
    List<Long> gone,
    int eventTotal,
    List<EventRow> events,
    List<Long> eventsGone) {}
