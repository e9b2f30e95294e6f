/**
 * The messages that come into a kernel from outside: pure data, which can be recorded and replayed.
 */
@NullMarked
package org.urbi.kernel.message;

import org.jspecify.annotations.NullMarked;
