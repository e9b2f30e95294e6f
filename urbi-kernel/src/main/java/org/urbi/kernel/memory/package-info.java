/** What is done when the memory of the process runs out. */
@NullMarked
package org.urbi.kernel.memory;

import org.jspecify.annotations.NullMarked;
