package org.urbi.kernel.observe;

/**
 * A name that somebody may be about to type.
 *
 * @param signature how it is called, if it is declared by the library; empty otherwise
 * @param doc what it is or does, in a sentence; empty if nothing is declared
 */
public record Proposal(String name, String signature, String doc) {}
