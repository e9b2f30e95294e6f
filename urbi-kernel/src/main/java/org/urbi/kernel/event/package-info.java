/** Events, and the statements that wait for events and conditions. */
@NullMarked
package org.urbi.kernel.event;

import org.jspecify.annotations.NullMarked;
