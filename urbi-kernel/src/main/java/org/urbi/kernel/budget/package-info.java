/** What a lobby may have at a time, and what it has. */
@NullMarked
package org.urbi.kernel.budget;

import org.jspecify.annotations.NullMarked;
