package org.urbi.kernel.observe;

/**
 * A tag as it is.
 *
 * @param number by which it is controlled
 */
public record TagRow(long number, String name, boolean frozen, boolean blocked) {}
