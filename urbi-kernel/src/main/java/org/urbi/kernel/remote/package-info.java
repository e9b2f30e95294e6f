/**
 * UObjects that live in other processes, on the side of the kernel: for each such process, a
 * context is asked to do what the process asks for, and what the context asks for is sent there
 * (docs/protocol.md).
 */
@NullMarked
package org.urbi.kernel.remote;

import org.jspecify.annotations.NullMarked;
