package org.urbi.ros.rtps;

/**
 * Which sample of which writer: a reply names its request by it.
 *
 * @param writer who wrote it (or, in a request, the reader that waits for the reply)
 * @param sequence its number, from 1
 */
public record SampleIdentity(Guid writer, long sequence) {}
