package org.urbi.kernel.observe;

import java.util.List;

/**
 * What has changed of an object since somebody looked last.
 *
 * @param way to it, as {@link Places} says
 * @param anew whether it is the first that is told: what was told before, in an earlier time in
 *     which somebody wanted to see the object, is to be forgotten
 * @param found whether it is there
 * @param type of it
 * @param total how many slots it has, functions left out
 * @param protos the types of its prototypes
 * @param slots that are new, or have changed
 * @param gone the names of those that are no longer shown
 */
public record ObjectView(
    String way,
    boolean anew,
    boolean found,
    String type,
    int total,
    List<String> protos,
    List<SlotRow> slots,
    List<String> gone) {}
