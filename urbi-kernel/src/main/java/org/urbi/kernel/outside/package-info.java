/**
 * The machine around the kernel: files, directories, pipes, processes, connections, and the threads
 * that wait for them. Nothing here knows urbiscript; events are posted to the kernel's inbox.
 */
@NullMarked
package org.urbi.kernel.outside;

import org.jspecify.annotations.NullMarked;
