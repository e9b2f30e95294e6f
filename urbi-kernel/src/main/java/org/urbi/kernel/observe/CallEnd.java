package org.urbi.kernel.observe;

import org.jspecify.annotations.Nullable;

/**
 * What has become of a function that somebody has called, or of a slot that was given a value.
 *
 * @param error why it was not done, for people; empty when it was
 * @param value what the function has returned, as {@link VariableListener#value} has it
 */
public record CallEnd(String error, @Nullable Object value) {}
