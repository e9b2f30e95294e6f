/**
 * The lobby at the program's own terminal, or at its standard input and output (manual, section
 * 21.3). The only place that knows JLine.
 */
@NullMarked
package org.urbi.server.console;

import org.jspecify.annotations.NullMarked;
