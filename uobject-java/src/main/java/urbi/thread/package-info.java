/** Threads that never end in silence, and what is logged and said of a defect of ours. */
@NullMarked
package urbi.thread;

import org.jspecify.annotations.NullMarked;
