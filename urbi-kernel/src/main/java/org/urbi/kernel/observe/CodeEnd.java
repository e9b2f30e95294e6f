package org.urbi.kernel.observe;

/**
 * What has become of a text that somebody has run.
 *
 * @param error why it did not come to its end, for people; empty when it did
 * @param goesOn whether something that it has begun is still there: jobs, or an {@code at}
 */
public record CodeEnd(String error, boolean goesOn) {}
