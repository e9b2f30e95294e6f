/** The log of a kernel, for its administrator (manual, "Logger"). */
@NullMarked
package org.urbi.kernel.log;

import org.jspecify.annotations.NullMarked;
