/**
 * The network console: one lobby for each TCP client (manual, sections 2 and 21.3).
 *
 * <p>The only place that knows Netty. Its thread never runs urbiscript and the kernel's never waits
 * for a socket: bytes cross in both directions through queues, each with a limit.
 */
package org.urbi.server.net;
