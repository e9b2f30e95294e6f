package org.urbi.lang.advice;

import org.urbi.lang.source.Span;

/**
 * A place that has to do with a mistake.
 *
 * @param text what it is: {@code opened here}
 */
public record Note(Span span, String text) {}
