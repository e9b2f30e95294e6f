/** Points in time and the spans between them (manual, "Date", "Duration"). */
@NullMarked
package org.urbi.kernel.library.date;

import org.jspecify.annotations.NullMarked;
