package org.urbi.kernel.observe;

import java.util.List;

/**
 * A slot as it is.
 *
 * @param type of its value
 * @param value in one line
 * @param number the value, if it is a number; NaN if not
 * @param opens whether its value has slots to look at
 * @param least to what numbers are limited; NaN if they are not
 * @param most see least
 * @param constant whether it cannot be assigned
 * @param variable whether a UVar stands behind it
 * @param owner of a UVar that has one: the name of the object
 * @param times how often a UVar was written
 * @param last when that was last, in nanoseconds since the start of the kernel; negative if never
 * @param readers what reads it: conditions, connections, functions, for people
 * @param media what a Binary holds, if people can see or hear it: {@code image} or {@code sound}
 */
public record SlotRow(
    String name,
    String type,
    String value,
    double number,
    boolean opens,
    double least,
    double most,
    boolean constant,
    boolean variable,
    String owner,
    long times,
    long last,
    List<String> readers,
    String media) {}
