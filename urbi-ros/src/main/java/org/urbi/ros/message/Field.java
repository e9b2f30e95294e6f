package org.urbi.ros.message;

import org.jspecify.annotations.Nullable;
import urbi.UValue;

/**
 * A field of a message.
 *
 * @param initial what it is unless somebody sets it; null for zero, nothing, empty
 */
public record Field(String name, FieldType type, @Nullable UValue initial) {}
