package org.urbi.lang.grammar;

/**
 * What the scanner has to say about a piece of text.
 *
 * @param begin offset of its first character
 * @param end offset after its last character
 * @param warning whether the text is understood nevertheless
 */
public record LexicalIssue(int begin, int end, String message, boolean warning) {}
