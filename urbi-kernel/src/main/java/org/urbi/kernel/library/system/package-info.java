/** The kernel itself and what it was started with (manual, "System", "Platform"). */
@NullMarked
package org.urbi.kernel.library.system;

import org.jspecify.annotations.NullMarked;
