/**
 * UObjects in a process of their own: the context that they live in there, and the protocol by
 * which it talks to the kernel (docs/protocol.md).
 */
@NullMarked
package urbi.remote;

import org.jspecify.annotations.NullMarked;
