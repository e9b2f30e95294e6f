/**
 * Jobs, tags, events and what jobs wait for (manual, "Job", "Tag", "Event", "Mutex", "Semaphore",
 * "Barrier", "Timeout", "PubSub").
 */
@NullMarked
package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.NullMarked;
