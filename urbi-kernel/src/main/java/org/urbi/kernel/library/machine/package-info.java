/**
 * Processes, sockets and the environment of the machine (manual, "Process", "Socket", "Server").
 */
package org.urbi.kernel.library.machine;
