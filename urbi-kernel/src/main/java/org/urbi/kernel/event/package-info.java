/** Events, and what waits for events and conditions. */
@NullMarked
package org.urbi.kernel.event;

import org.jspecify.annotations.NullMarked;
