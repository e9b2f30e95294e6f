package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;

/**
 * What a reader received.
 *
 * @param identity who wrote it, and its number
 * @param sourceTime nanoseconds since 1970 at the writer, 0 if it did not say
 * @param payload with its encapsulation header; it belongs to whoever takes the sample
 * @param related the sample that this one answers
 * @param key which instance it is about, where the writer says so
 * @param disposed whether it says that its instance is no more; the payload then has only the key,
 *     or nothing
 */
public record Sample(
    SampleIdentity identity,
    long sourceTime,
    ByteBuffer payload,
    @Nullable SampleIdentity related,
    @Nullable Guid key,
    boolean disposed) {}
