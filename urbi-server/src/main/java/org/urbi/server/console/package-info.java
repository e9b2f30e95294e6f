/**
 * The lobby at the program's own terminal, or at its standard input and output (manual, section
 * 21.3). The only place that knows JLine.
 */
package org.urbi.server.console;
