/**
 * The network console: one lobby for each TCP client (manual, sections 2 and 21.3).
 *
 * <p>Netty's thread never runs urbiscript: what comes in is posted to the kernel's inbox, what goes
 * out waits in a queue, each with a limit. The kernel's thread reads from the socket of a remote
 * process only while it has nothing to do but to wait for its answer; what it reads is posted to
 * the inbox as well.
 */
@NullMarked
package org.urbi.server.net;

import org.jspecify.annotations.NullMarked;
