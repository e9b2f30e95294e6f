/**
 * The kernel's side of UObjects in other processes: requests of such a process are passed to a
 * context, and requests of the context are sent to the process (docs/protocol.md).
 */
@NullMarked
package org.urbi.kernel.remote;

import org.jspecify.annotations.NullMarked;
