package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;

/**
 * What an installation knows of a type of services. There is no way in {@code rcl} to send the
 * bytes of a request: each becomes a message of C on its way.
 */
record ServiceSupport(MemorySegment handle, MessageSupport request, MessageSupport response) {}
