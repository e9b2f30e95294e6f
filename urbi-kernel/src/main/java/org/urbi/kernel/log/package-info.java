/** What the administrator of a kernel is told (manual, "Logger"). */
@NullMarked
package org.urbi.kernel.log;

import org.jspecify.annotations.NullMarked;
