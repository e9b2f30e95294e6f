/**
 * The rest of the machine: threads that wait for it, pipes, processes, connections, directories.
 * Nothing here knows urbiscript; what happens is told to the kernel through its inbox.
 */
@NullMarked
package org.urbi.kernel.outside;

import org.jspecify.annotations.NullMarked;
