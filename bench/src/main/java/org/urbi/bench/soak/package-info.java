/** A server that many clients come to, use, misuse and leave, for a long time. */
@NullMarked
package org.urbi.bench.soak;

import org.jspecify.annotations.NullMarked;
