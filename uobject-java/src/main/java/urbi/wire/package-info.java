/**
 * Values as bytes, and the frames in which a process with UObjects and a kernel talk to each other
 * (docs/protocol.md).
 */
@NullMarked
package urbi.wire;

import org.jspecify.annotations.NullMarked;
