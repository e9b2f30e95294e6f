/** What the administrator of a kernel is told (manual, "Logger"). */
package org.urbi.kernel.log;
