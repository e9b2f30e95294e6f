/**
 * Processes, sockets and the environment of the machine (manual, "Process", "Socket", "Server").
 */
@NullMarked
package org.urbi.kernel.library.machine;

import org.jspecify.annotations.NullMarked;
