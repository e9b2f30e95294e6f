/** The top level of a connection: its input, its output. */
@NullMarked
package org.urbi.kernel.lobby;

import org.jspecify.annotations.NullMarked;
