/** Points in time and the spans between them (manual, "Date", "Duration"). */
package org.urbi.kernel.library.date;
