/** The kernel itself and what it was started with (manual, "System", "Platform"). */
package org.urbi.kernel.library.system;
