package org.urbi.lang.highlight;

/**
 * A piece of a text.
 *
 * @param begin the offset of its first character
 * @param end the offset after its last one
 */
public record Piece(Kind kind, int begin, int end) {}
